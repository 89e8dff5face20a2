//! Lower bounds of tasks that still go on: the last of each, so that ending a run early keeps them.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Mutex;

use super::progress::{Event, Progress};
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

impl Proof {
    fn of(task: &Task, so_far: SoFar) -> Self {
        let subject = task.subject();
        Self {
            scene: task.scene_name(),
            file: file_name(&subject.case, subject.head_joints, so_far.push),
            so_far,
        }
    }
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

/// The last proofs, by the id of the task and the direction of the push.
pub type LastProofs = BTreeMap<(String, &'static str), Proof>;

/// Keeps the last proof of each task and push in `last` until the task is done, and tells another progress
/// all that it hears.
pub fn keeping<'a>(
    last: &'a Mutex<LastProofs>,
    progress: &'a Progress<'a>,
) -> impl Fn(Event) + Sync + 'a {
    let last = || last.lock().expect("no other thread panicked");
    move |event| match event {
        Event::Proved(task, so_far) => {
            let so_far = so_far();
            // Rounding may leave nothing of it for motions of any size.
            if so_far.proved.lower > 0.0 {
                let proof = Proof::of(task, so_far.clone());
                last().insert((task.id().to_owned(), so_far.push.name()), proof);
                progress(Event::Proved(task, &|| so_far.clone()));
            }
        }
        Event::Done(task, _) => {
            last().retain(|(id, _), _| id != task.id());
            progress(event);
        }
        Event::Expected(_) | Event::Known(_) | Event::Begun(_) => progress(event),
    }
}
