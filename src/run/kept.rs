//! A row as files keep it, a line each with a sum over its text: the flat facts, in nine digits,
//! without forces or mechanisms; for those who need these too, also the whole answer.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

use super::row::{Row, StrongerSide};
use crate::answer::{Bracket, Claim, Fact, Outcome, Status, Work};
use crate::fingerprint::Fingerprint;
use crate::mechanics::Crack;
use crate::number::nine_digits;
use crate::scene::{HeadJoints, Push};

/// The line of a journal. A row that was kept is the row that is read back, to the last bit.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct KeptRow {
    id: String,
    case: String,
    head_joints: String,
    push: String,
    method: String,
    parameters: Vec<(String, String)>,
    friction: Option<[f64; 2]>,
    blocks: usize,
    joints: usize,
    multiplier_unit: f64,
    status: String,
    claim: String,
    lower: Option<f64>,
    upper: Option<f64>,
    stated_error: Option<f64>,
    tan_beta: Option<f64>,
    c: Option<f64>,
    e: Option<f64>,
    sharp: bool,
    residual: Option<f64>,
    reason: String,
    refuted: bool,
    /// Blocks that were modelled as movable, linear programs, their iterations, block steps.
    work: [usize; 5],
    seconds: f64,
    /// What the flat facts leave out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    whole: Option<WholeAnswer>,
}

/// A row's answer with its forces, mechanisms and facts, to the last bit.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WholeAnswer {
    outcome: Outcome,
    stronger: Option<(Push, Outcome)>,
    residual: Option<f64>,
    seconds: f64,
}

impl From<&Row> for WholeAnswer {
    fn from(row: &Row) -> Self {
        let stronger = row.stronger.as_ref();
        Self {
            outcome: row.outcome.clone(),
            stronger: stronger.map(|side| (side.push, (*side.outcome).clone())),
            residual: row.residual,
            seconds: row.seconds,
        }
    }
}

impl WholeAnswer {
    /// The row of the flat facts with this answer.
    fn put_into(self, row: Row) -> Row {
        let side = |(push, outcome)| StrongerSide {
            push,
            outcome: Box::new(outcome),
        };
        Row {
            outcome: self.outcome,
            stronger: self.stronger.map(side),
            residual: self.residual,
            seconds: self.seconds,
            ..row
        }
    }
}

/// How much of a row a journal keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeps {
    /// The flat facts: what tables of many rows need.
    Numbers,
    /// The whole answer: what a record, a drawing and the judge need.
    Everything,
}

impl Keeps {
    /// What is left of a row, whether it was just answered or is read back.
    pub(super) fn of(self, row: Row) -> Row {
        match self {
            Keeps::Numbers => row.kept(),
            Keeps::Everything => row,
        }
    }

    /// The row as a line; `None` for one that would not be read back as it is, because JSON has no
    /// infinite numbers.
    pub(super) fn line(self, row: &Row) -> serde_json::Result<Option<String>> {
        let whole = match self {
            Keeps::Numbers => None,
            Keeps::Everything => Some(WholeAnswer::from(row)),
        };
        let kept = KeptRow {
            whole,
            ..row.clone().into()
        };
        let text = serde_json::to_string(&kept)?;
        let line = format!("{} {text}\n", sum(text.as_bytes()));
        let same = || {
            let read = read_line(line.trim_end().as_bytes());
            read.is_some_and(|read| format!("{read:?}") == format!("{row:?}"))
        };
        let kept = self == Keeps::Numbers || same();
        Ok(kept.then_some(line))
    }
}

/// Tells a line that is not the one that was written.
fn sum(text: &[u8]) -> String {
    let mut sum = Fingerprint::new();
    sum.add(text);
    sum.hex()
}

/// The row of a line without its end; `None` where a single character of it has changed.
pub(crate) fn read_line(line: &[u8]) -> Option<Row> {
    let (written, text) = line.split_at_checked(line.iter().position(|&byte| byte == b' ')?)?;
    let text = &text[1..];
    if sum(text).as_bytes() != written {
        return None;
    }
    serde_json::from_slice(text).ok()
}

/// Rows as the lines of a file.
///
/// # Errors
/// Those of the JSON writer; none is expected in memory.
pub(crate) fn lines(rows: &[Row]) -> serde_json::Result<String> {
    let lines = rows.iter().map(|row| Keeps::Numbers.line(row));
    let lines: serde_json::Result<Vec<Option<String>>> = lines.collect();
    Ok(lines?.into_iter().flatten().collect())
}

impl From<Row> for KeptRow {
    fn from(row: Row) -> Self {
        let reason = row.outcome.reason();
        let refuted = row.outcome.is_refuted();
        let Outcome {
            status,
            claim,
            bracket,
            crack,
            stated_error,
            work,
            ..
        } = row.outcome;
        Self {
            head_joints: row.head_joints.name().to_owned(),
            push: row.push.name().to_owned(),
            status: status.name().to_owned(),
            claim: claim.name().to_owned(),
            lower: bracket.and_then(|b| rounded(b.lower)),
            upper: bracket.and_then(|b| rounded(b.upper)),
            stated_error,
            tan_beta: crack.and_then(|crack| rounded(crack.tan_beta)),
            c: crack.and_then(|crack| crack.c).and_then(rounded),
            e: crack.and_then(|crack| crack.e).and_then(rounded),
            sharp: crack.is_none_or(|crack| crack.sharp),
            residual: row.residual.and_then(rounded),
            reason,
            refuted,
            work: [
                work.modelled,
                work.programs,
                work.iterations,
                work.block_steps,
                work.fallbacks,
            ],
            seconds: rounded(row.seconds).unwrap_or(0.0),
            id: row.id,
            case: row.case,
            method: row.method,
            parameters: row.parameters,
            friction: row.friction,
            blocks: row.blocks,
            joints: row.joints,
            multiplier_unit: row.multiplier_unit,
            whole: None,
        }
    }
}

/// A word that a file has in the place of a status, a push or the like.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("no {what} is called `{word}`")]
struct UnknownWord {
    what: &'static str,
    word: String,
}

fn named<T: Copy>(
    what: &'static str,
    known: impl IntoIterator<Item = T>,
    name: impl Fn(T) -> &'static str,
    word: String,
) -> Result<T, UnknownWord> {
    let found = known.into_iter().find(|&known| name(known) == word);
    found.ok_or(UnknownWord { what, word })
}

impl TryFrom<KeptRow> for Row {
    type Error = UnknownWord;

    fn try_from(kept: KeptRow) -> Result<Self, UnknownWord> {
        let head_joints = [HeadJoints::Contact, HeadJoints::Open];
        let pushes = [Push::Right, Push::Left];
        let status = named("status", Status::ALL, Status::name, kept.status)?;
        let claim = named("claim", Claim::ALL, Claim::name, kept.claim)?;
        let whole = kept.whole;
        let [modelled, programs, iterations, block_steps, fallbacks] = kept.work;
        let ends = kept.lower.zip(kept.upper);
        let crack = kept.tan_beta.map(|tan_beta| Crack {
            c: kept.c,
            e: kept.e,
            tan_beta,
            sharp: kept.sharp,
        });
        let flat = Self {
            head_joints: named(
                "head joints",
                head_joints,
                HeadJoints::name,
                kept.head_joints,
            )?,
            push: named("push", pushes, Push::name, kept.push)?,
            outcome: Outcome {
                claim,
                bracket: ends.map(|(lower, upper)| Bracket { lower, upper }),
                crack,
                stated_error: kept.stated_error,
                work: Work {
                    modelled,
                    programs,
                    iterations,
                    block_steps,
                    fallbacks,
                },
                ..Outcome::without_number(
                    status,
                    if kept.refuted {
                        Fact::KeptRefutation(kept.reason)
                    } else {
                        Fact::Words(kept.reason)
                    },
                )
            },
            id: kept.id,
            case: kept.case,
            method: kept.method,
            parameters: kept.parameters,
            friction: kept.friction,
            blocks: kept.blocks,
            joints: kept.joints,
            multiplier_unit: kept.multiplier_unit,
            residual: kept.residual,
            seconds: kept.seconds,
            stronger: None,
            references: Vec::new(),
            verdict: None,
        };
        Ok(match whole {
            Some(whole) => whole.put_into(flat),
            None => flat,
        })
    }
}

impl Serialize for Row {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        KeptRow::from(self.clone()).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Row {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let kept = KeptRow::deserialize(deserializer)?;
        kept.try_into().map_err(D::Error::custom)
    }
}

impl Row {
    /// The row as it would be read back from a file.
    pub fn kept(self) -> Self {
        let kept = KeptRow::from(self);
        kept.try_into().expect("the words are the program's own")
    }

    /// Whether files keep the same of both rows, but for the time.
    pub fn agrees(&self, other: &Row) -> bool {
        let timeless = |row: &Row| KeptRow {
            seconds: 0.0,
            ..KeptRow::from(row.clone())
        };
        let text = |row: &Row| serde_json::to_string(&timeless(row)).ok();
        text(self) == text(other)
    }
}

fn rounded(value: f64) -> Option<f64> {
    nine_digits(value).parse().ok()
}
