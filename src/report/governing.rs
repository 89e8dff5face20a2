//! What a case comes to in one plain line: of its settings of the head joints and sides of the push the
//! one that governs, and what its λ means for the wall.

use serde_json::json;

use super::terms::{Terms, terms};
use crate::answer::{Bracket, Fact, is_same_multiplier};
use crate::judge::{Basis, Conclusion, governing};
use crate::mechanics::MovingPart;
use crate::number::{above, below, number, short};
use crate::run::{CaseResult, Value};
use crate::scene::{HeadJoints, JointClass, Reaction, Sense};

/// The conclusion that governs a case, and its answer in the terms of those who judge a wall.
pub(crate) struct Governing<'a> {
    pub(super) conclusion: &'a Conclusion,
    /// Whether its scene has head joints.
    has_head_joints: bool,
    /// Other settings and sides without a verified collapse, which may be weaker.
    unanswered: Vec<String>,
    pub(super) terms: Option<Terms>,
    /// Whether a search for collapse states ran.
    searched: bool,
    /// Whether it was asked whether any collapse state can exist, of a scene that has none known.
    asked: bool,
    /// The λ that the case demands.
    pub(super) demand: Option<f64>,
}

impl<'a> Governing<'a> {
    /// `None` where nothing ran.
    pub fn of(result: &'a CaseResult) -> Option<Self> {
        let conclusion = &result.conclusions[governing(&result.conclusions)?];
        let scene = result.side(conclusion.head_joints, conclusion.push);
        let mut joints = scene.joints().iter();
        let all = result.conclusions.iter();
        let all = all.flat_map(|of| [Some(of), of.other.as_deref()].into_iter().flatten());
        let without = all.filter(|of| {
            let basis = [Basis::UpperBound, Basis::NoneFound, Basis::Nothing];
            basis.contains(&of.basis) && !std::ptr::eq(*of, conclusion)
        });
        let unanswered = without.map(|of| {
            let (joints, push) = (of.head_joints.in_words(), of.push.name());
            format!("with head joints {joints}, pushed to the {push}")
        });
        Some(Self {
            conclusion,
            has_head_joints: conclusion.head_joints == HeadJoints::Open
                || joints.any(|joint| joint.class == JointClass::Head),
            unanswered: unanswered.collect(),
            terms: terms(result, conclusion),
            searched: (result.rows.iter()).any(|row| row.outcome.search().is_some()),
            asked: (result.rows.iter())
                .filter(|row| row.head_joints == conclusion.head_joints)
                .filter_map(|row| row.side(conclusion.push))
                .any(|outcome| (outcome.facts.iter()).any(|fact| matches!(fact, Fact::Bound(_)))),
            demand: result.case.demand,
        })
    }

    /// The whole in a few sentences: what to use and under which conditions, why that may be believed, what
    /// it means for the wall, and what moves.
    pub fn text(&self) -> String {
        let (first, others) = self.sentences();
        [vec![first], others].concat().join(" ")
    }

    /// The first sentence of it, and the others.
    pub fn sentences(&self) -> (String, Vec<String>) {
        let about = self.conditions();
        let about = match about.is_empty() {
            true => String::new(),
            false => format!(" ({about})"),
        };
        let others = [
            self.why(),
            self.may_be_weaker(),
            self.against_demand(),
            self.in_use(),
            self.moves(),
        ];
        let first = format!("{}{about}.", self.lead());
        (first, others.into_iter().flatten().collect())
    }

    /// What to use, in one clause without its conditions: `Use λ = 0.36542`.
    fn lead(&self) -> String {
        let of = self.conclusion;
        let Some(bracket) = of.bracket else {
            return match of.basis {
                Basis::Falls => "It falls under its own weight".to_owned(),
                Basis::Stands => "It stands, however hard it is pushed".to_owned(),
                _ => "There is no λ to use".to_owned(),
            };
        };
        if let Some(reaction) = &of.reaction {
            return gives_way(reaction, of.basis, bracket);
        }
        let Bracket { lower, upper } = bracket;
        match of.basis {
            Basis::UpperBound => format!("λ is at most {}", above(upper, 5)),
            Basis::Estimate => format!("λ may be {}", number(lower, 4)),
            _ if !of.is_explained() => format!("λ may be {}", number(lower, 5)),
            _ => format!("Use λ = {}", number(lower, 5)),
        }
    }

    /// What it is about and what it is worth: `head joints in contact, pushed to the left; verified`.
    fn conditions(&self) -> String {
        let of = self.conclusion;
        let joints = self
            .has_head_joints
            .then(|| format!("head joints {}", of.head_joints.in_words()));
        let push = of.other.as_ref().map(|other| {
            let both = of.collapse_known().zip(other.collapse_known());
            match both {
                Some((one, other)) if is_same_multiplier(one, other, of.multiplier_unit) => {
                    "pushed to either side".to_owned()
                }
                _ => format!("pushed to the {}", of.push.name()),
            }
        });
        let about: Vec<String> = [joints, push].into_iter().flatten().collect();
        let worth = of.bracket.map(|_| of.status.name().to_owned());
        let all = [Some(about.join(", ")), worth].into_iter().flatten();
        let all: Vec<String> = all.filter(|words| !words.is_empty()).collect();
        all.join("; ")
    }

    /// As data, with the text.
    pub fn json(&self) -> serde_json::Value {
        let of = self.conclusion;
        let reads = |lambda: f64| of.reaction.as_ref().map_or(lambda, |of| of.at(lambda));
        let lambda = of.collapse_known().map(reads);
        json!({
            "lambda": Value::from(lambda).json(),
            "head_joints": of.head_joints.name(),
            "push": of.push.name(),
            "status": of.status.name(),
            "demand": Value::from(self.demand).json(),
            "over_demand": Value::from(lambda.zip(self.demand).map(|(of, demand)| of / demand)).json(),
            "text": self.text(),
        })
    }

    fn why(&self) -> Option<String> {
        let of = self.conclusion;
        if !of.is_explained() {
            return Some("Something speaks against it: see the answer.".to_owned());
        }
        let why = match (of.basis, &of.floor) {
            (Basis::LowestState, floor) if of.reaction.is_some() => match floor {
                Some(_) => {
                    "A collapse there is verified, and the answer has what is proved of others."
                }
                None => {
                    "A collapse there is verified; it may give way sooner, as no bound is proved."
                }
            },
            (Basis::LowestState, Some(floor)) => {
                return Some(format!(
                    "A collapse there is verified. It is proved that {floor}."
                ));
            }
            (Basis::LowestState, None) => {
                "A collapse there is verified; one below may exist, as no lower bound is proved."
            }
            (Basis::UpperBound, _) if self.searched => {
                "That is proved, but no collapse is verified: it may give way sooner."
            }
            (Basis::UpperBound, _) => {
                "That is proved, but no collapse is verified: the method `interval` looks for one."
            }
            (Basis::Observed, _) => "There the simulation collapsed; nothing is proved.",
            (Basis::Estimate, _) => "Nothing is proved.",
            (Basis::Falls, _) => return None,
            (Basis::Stands, _) => "That is proved.",
            (Basis::NoneFound, _) if self.asked => {
                "No collapse state was found, which does not prove that none exists."
            }
            (Basis::NoneFound, _) => {
                "No collapse state was found, which does not prove that none exists: the method `bound` may."
            }
            (Basis::Nothing, _) => "No method has an answer.",
        };
        Some(why.to_owned())
    }

    /// What has no answer beside the one that governs; of an upper bound alone that is said already.
    fn may_be_weaker(&self) -> Option<String> {
        let has_number = self.conclusion.bracket.is_some();
        let says_more = has_number && self.conclusion.basis != Basis::UpperBound;
        let without = self.unanswered.join(", nor ");
        (says_more && !without.is_empty())
            .then(|| format!("No collapse is verified {without}: there it may be weaker."))
    }

    /// What moves, and of several parts what the largest does: the answer describes more of them.
    fn moves(&self) -> Option<String> {
        let terms = self.terms.as_ref()?;
        let (words, _) = terms.mechanism.as_ref()?.split_once(':').unzip();
        let when = match self.conclusion.basis {
            Basis::Falls => "As it falls,",
            _ => "Then",
        };
        let Some(words) = words else {
            return Some(format!("{when} {}.", terms.mechanism.as_ref()?));
        };
        let MovingPart {
            blocks,
            words: does,
            ..
        } = terms.moving.first()?;
        let of_them = if blocks.len() == 1 {
            "one block"
        } else {
            &format!("{} blocks", blocks.len())
        };
        Some(format!("{when} {words}; {of_them} {does}."))
    }
}

/// At which reaction a support's wall gives way, with its part of the weight.
fn gives_way(reaction: &Reaction, basis: Basis, bracket: Bracket) -> String {
    let Reaction {
        support, weight, ..
    } = reaction;
    let of_weight = |at: f64| short(100.0 * at / weight, 1);
    if basis == Basis::UpperBound {
        let at = reaction.at(bracket.upper);
        let (least, at) = match reaction.sense {
            Sense::Away => ("at least", below(at, 5)),
            Sense::Against => ("at most", above(at, 5)),
        };
        return format!("{support} carries {least} {at}");
    }
    let at = reaction.at(bracket.lower);
    let way = match reaction.sense {
        Sense::Away => "fallen",
        Sense::Against => "risen",
    };
    format!(
        "It gives way where the reaction of {support} has {way} to {} ({} % of the weight)",
        number(at, 5),
        of_weight(at)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::find;
    use crate::judge::Doubt;
    use crate::method::methods;
    use crate::run::{Plan, run};

    /// The result of a built-in case by two methods.
    fn result(name: &str) -> CaseResult {
        let cases = find(name).expect("it is built in");
        let mut methods = methods();
        methods.retain(|method| ["associative", "interval"].contains(&method.name()));
        let plan = Plan {
            methods,
            ..Plan::default()
        };
        run(&cases, &plan, &|_| {}).remove(0)
    }

    fn said(result: &CaseResult) -> String {
        Governing::of(result).expect("it ran").text()
    }

    #[test]
    fn a_small_push_keeps_two_digits() {
        let text = said(&result("keystone-corbel-of-3-stands"));
        let use_of_it = "It may be shaken with up to 0.00033 g, or the ground tilt by 0.019°.";
        assert!(text.contains(use_of_it), "{text}");
    }

    #[test]
    fn a_search_in_vain_is_not_recommended() {
        let text = said(&result("keystone-six-stands"));
        let in_vain =
            "no collapse is verified: it may give way sooner. It collapses at 0.0069 g, or";
        assert!(text.contains(in_vain), "{text}");
    }

    #[test]
    fn what_falls_says_how() {
        let text = said(&result("keystone-corbel-of-2-falls"));
        let how = "It falls under its own weight. As it falls, both blocks rock about the edge at (0, 1), on the \
                   base.";
        assert_eq!(text, how);
    }

    /// Nothing is allowed for where something speaks against the number, and a side without an answer is named.
    #[test]
    fn what_is_not_vouched_for_is_no_permission() {
        let mut result = result("buttress");
        let text = said(&result);
        assert!(
            text.starts_with("Use λ = ") && text.contains("It may be shaken"),
            "{text}"
        );
        assert!(!text.contains("weaker"), "{text}");

        let other = result.conclusions[0].other.as_mut().expect("two sides");
        (other.basis, other.bracket) = (Basis::Nothing, None);
        let push = other.push.name();
        let text = said(&result);
        assert!(
            text.contains(&format!("pushed to the {push}: there it may be weaker")),
            "{text}"
        );

        let by = "somebody".to_owned();
        result.conclusions[0].doubts.push(Doubt::Stands { by });
        let text = said(&result);
        assert!(
            text.starts_with("λ may be ") && !text.contains("shaken"),
            "{text}"
        );
    }
}
