//! Beyond one machine: the points of a sweep dealt out in shards, and their rows merged again.

use std::collections::BTreeMap;

use std::path::{Path, PathBuf};
use std::str::FromStr;

use thiserror::Error;

use crate::case::Complaint;
use crate::files::{Input, read_input, write_whole};
use crate::run::{Row, Task, lines, read_line};

/// The `index`-th of `count` shards, from 1.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("{index}/{count}")]
pub struct Shard {
    index: usize,
    count: usize,
}

/// Most shards: what job arrays take by default is 1001.
pub const MOST_SHARDS: usize = 1000;

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        let number = |part: &str| part.parse().ok().filter(|n| (1..=MOST_SHARDS).contains(n));
        let parts = parts.and_then(|(index, count)| Some((number(index)?, number(count)?)));
        match parts {
            Some((index, count)) if index <= count => Ok(Self { index, count }),
            _ => Err(format!(
                "write K/N with K from 1 to N and N up to {MOST_SHARDS}, such as `2/4`"
            )),
        }
    }
}

impl Shard {
    /// The points of this shard, in their order. Long and short points are dealt out evenly: one by
    /// one in the order of their expected time.
    pub fn deal<'a>(self, tasks: Vec<Task<'a>>) -> Vec<Task<'a>> {
        let turns = turns(&tasks);
        let mine = |turn: usize| turn % self.count == self.index - 1;
        let dealt = tasks.into_iter().zip(turns);
        dealt
            .filter(|(_, turn)| mine(*turn))
            .map(|(point, _)| point)
            .collect()
    }

    pub fn journal(self) -> String {
        format!("shard-{}-of-{}.journal", self.index, self.count)
    }

    /// Writes the rows of this shard, whole, for [`merge`].
    pub fn write(self, folder: &Path, rows: &[Row]) -> std::io::Result<PathBuf> {
        let text = lines(rows)?;
        let name = format!("shard-{}-of-{}.rows", self.index, self.count);
        let path = folder.join(name);
        write_whole(&path, &text)?;
        Ok(path)
    }

    /// The shard that a file of rows is of.
    fn of_file(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?;
        let numbers = name.strip_prefix("shard-")?.strip_suffix(".rows")?;
        let (index, count) = numbers.split_once("-of-")?;
        format!("{index}/{count}").parse().ok()
    }
}

/// For every point, when it is dealt out.
fn turns(points: &[Task]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let seconds = |index: usize| points[index].expected_seconds();
    order.sort_by(|&a, &b| seconds(b).total_cmp(&seconds(a)));
    let mut turns = vec![0; points.len()];
    for (turn, index) in order.into_iter().enumerate() {
        turns[index] = turn;
    }
    turns
}

/// The rows of all points, in their order, from the files of shards in a folder.
///
/// # Errors
/// Where a file is damaged or of another sweep, two files say different things about one point, or
/// rows are missing: then which.
pub fn merge(points: &[Task], folder: &Path) -> Result<Vec<Row>, Complaint> {
    let files = files(folder)?;
    let index = points.iter().enumerate().map(|(i, p)| (p.id(), i));
    let index: BTreeMap<&str, usize> = index.collect();
    let mut rows: Vec<Option<(Row, &Path)>> = points.iter().map(|_| None).collect();
    for (_, path) in &files {
        for row in read(path)? {
            let Some(&at) = index.get(row.id.as_str()) else {
                return Err(foreign(path, &row));
            };
            match &rows[at] {
                Some((other, first)) if !other.agrees(&row) => {
                    return Err(conflict(&points[at], first, path));
                }
                Some(_) => {}
                None => rows[at] = Some((row, path)),
            }
        }
    }
    let missing = rows.iter().enumerate().filter(|(_, row)| row.is_none());
    let missing: Vec<usize> = missing.map(|(index, _)| index).collect();
    if !missing.is_empty() {
        let shards: Vec<Shard> = files.iter().map(|(shard, _)| *shard).collect();
        return Err(incomplete(points, &missing, &shards, folder));
    }
    Ok(rows.into_iter().flatten().map(|(row, _)| row).collect())
}

/// The files of shards in a folder, by name.
fn files(folder: &Path) -> Result<Vec<(Shard, PathBuf)>, Complaint> {
    let entries = std::fs::read_dir(folder).map_err(|error| {
        Complaint::new(format!("cannot read {}: {error}", folder.display()))
            .help("run the shards of the sweep first, with the same folder")
    })?;
    let paths = entries.flatten().map(|entry| entry.path());
    let mut files: Vec<(Shard, PathBuf)> = paths
        .filter_map(|path| Some((Shard::of_file(&path)?, path)))
        .collect();
    files.sort_by_key(|(shard, _)| (shard.count, shard.index));
    Ok(files)
}

fn read(path: &Path) -> Result<Vec<Row>, Complaint> {
    let damaged = |what: String| {
        Complaint::new(format!("{}: {what}", path.display()))
            .help("remove the file and run its shard again: the journal keeps what is finished")
    };
    let bytes = read_input(path, Input::Rows).map_err(|error| damaged(error.to_string()))?;
    let lines = bytes
        .split(|&byte| byte == b'\n')
        .filter(|line| !line.is_empty());
    let lines = lines.enumerate().map(|(index, line)| {
        let row = read_line(line);
        row.ok_or_else(|| damaged(format!("line {} is not as it was written", index + 1)))
    });
    lines.collect()
}

fn foreign(path: &Path, row: &Row) -> Complaint {
    let title = format!(
        "{} holds the point {} ({} {}), which is not in this sweep",
        path.display(),
        row.id,
        row.case,
        row.method
    );
    Complaint::new(title).help(
        "the sweep file, a case or the program has changed since: remove the shards' files \
         and run them again",
    )
}

fn conflict(point: &Task, first: &Path, second: &Path) -> Complaint {
    let title = format!(
        "{} and {} disagree about the point {} ({})",
        first.display(),
        second.display(),
        point.id(),
        point.describe()
    );
    Complaint::new(title).help("remove both files and run their shards again")
}

/// Missing points that are listed one by one.
const LISTED: usize = 10;

fn incomplete(points: &[Task], missing: &[usize], there: &[Shard], folder: &Path) -> Complaint {
    let listed = missing.iter().take(LISTED);
    let listed: Vec<String> = listed.map(|&index| points[index].describe()).collect();
    let more = if missing.len() > LISTED { ", …" } else { "" };
    let title = format!(
        "{} of {} points are missing in {}: {}{more}",
        missing.len(),
        points.len(),
        folder.display(),
        listed.join(", ")
    );
    let help = match there.last() {
        None => "there is no file of a shard; run shard 1/4 of the sweep and so on".into(),
        Some(&Shard { count, .. }) => {
            let turns = turns(points);
            let mut shards: Vec<usize> = missing.iter().map(|&i| turns[i] % count + 1).collect();
            shards.sort_unstable();
            shards.dedup();
            let shards: Vec<String> = shards.iter().map(|k| format!("{k}/{count}")).collect();
            format!("run the shards {} again", shards.join(", "))
        }
    };
    Complaint::new(title).help(help)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::sweep::Sweep;

    #[test]
    fn shards_are_written_as_k_of_n() {
        assert_eq!("2/4".parse(), Ok(Shard { index: 2, count: 4 }));
        for text in ["0/4", "5/4", "2", "2/0", "a/b", "1/2/3", "1/1001", "-1/4"] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
    }

    #[test]
    fn every_point_is_in_one_shard_and_long_ones_are_spread() {
        let sweep = Sweep::find("fig-7").expect("it is built in");
        let all: Vec<String> = sweep.tasks().iter().map(|p| p.id().to_owned()).collect();
        let mut dealt = Vec::new();
        for index in 1..=4 {
            let shard = Shard { index, count: 4 }.deal(sweep.tasks());
            let long = shard.iter().filter(|p| p.method().name() == "pushover");
            assert_eq!(long.count(), 20);
            dealt.extend(shard.iter().map(|p| p.id().to_owned()));
        }
        dealt.sort();
        let mut sorted = all.clone();
        sorted.sort();
        sorted.dedup();
        assert_eq!((dealt, sorted.len()), (sorted.clone(), all.len()));
    }
}
