//! Lower bounds of tasks that still go on: the last of each, so that ending a run early keeps them.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Mutex;

use super::progress::Progress;
use super::row::Row;
use super::stored::file_name;
use super::task::Task;
use crate::method::SoFar;
use crate::number::number;

/// What a task has proved by now.
#[derive(Clone, Debug)]
pub struct Proof {
    pub scene: String,
    /// Name of the file for its certificate.
    pub file: String,
    pub so_far: SoFar,
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let SoFar {
            push,
            of_reaction,
            proved,
            state,
            ..
        } = &self.so_far;
        write!(f, "{}, pushed to the {}: ", self.scene, push.name())?;
        if *of_reaction {
            write!(f, "by the change of the reaction, ")?;
        }
        let state = number(*state, 6);
        write!(f, "{proved}; the lowest state found is at {state}")
    }
}

/// Keeps the last proof of each task and push until the task is done, and tells another progress all
/// that it hears.
pub struct Proofs<'a> {
    last: &'a Mutex<LastProofs>,
    progress: &'a dyn Progress,
}

/// The last proofs, by the id of the task and the direction of the push.
pub type LastProofs = BTreeMap<(String, &'static str), Proof>;

impl<'a> Proofs<'a> {
    /// Keeps them in `last`.
    pub fn new(last: &'a Mutex<LastProofs>, progress: &'a dyn Progress) -> Self {
        Self { last, progress }
    }
}

impl Progress for Proofs<'_> {
    fn expected(&self, seconds: f64) {
        self.progress.expected(seconds);
    }

    fn known(&self, task: &Task, row: &Row) {
        self.progress.known(task, row);
    }

    fn begun(&self, task: &Task) {
        self.progress.begun(task);
    }

    fn proved(&self, task: &Task, so_far: &dyn Fn() -> SoFar) {
        let so_far = so_far();
        // Rounding may leave nothing of it for motions of any size.
        if so_far.proved.lower <= 0.0 {
            return;
        }
        let subject = task.subject();
        let (case, head_joints) = (&subject.case, subject.head_joints);
        let proof = Proof {
            scene: task.scene_name(),
            file: file_name(case, head_joints, so_far.push),
            so_far: so_far.clone(),
        };
        let of = (task.id().to_owned(), so_far.push.name());
        let mut last = self.last.lock().expect("no other thread panicked");
        last.insert(of, proof);
        drop(last);
        self.progress.proved(task, &|| so_far.clone());
    }

    fn done(&self, task: &Task, row: &Row) {
        let mut last = self.last.lock().expect("no other thread panicked");
        last.retain(|(id, _), _| id != task.id());
        drop(last);
        self.progress.done(task, row);
    }
}
