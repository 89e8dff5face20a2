//! A program run to its end or to its time limit, whichever comes first.

use std::io::{self, Read, Write};
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;

use wait4::Wait4;

use crate::answer::{ProgramEnding, ProgramFailure};

/// A program that answers scenes.
#[derive(Clone, Debug, PartialEq)]
pub struct External {
    /// Its name in tables.
    pub name: String,
    /// Program and arguments.
    pub command: Vec<String>,
    /// Where it runs; the current folder where there is none.
    pub folder: Option<PathBuf>,
    /// Time by the clock on the wall after which it is stopped.
    pub limit: Duration,
}

pub(super) struct Finished {
    /// Its standard output, or why there is none to be used.
    pub output: Result<Vec<u8>, ProgramFailure>,
    /// CPU time of the program and of those children that it waited for.
    pub cpu: Duration,
}

/// Most bytes of output that are kept; an answer for 100 000 joints is a tenth of it.
const MAX_OUTPUT: u64 = 64 << 20;

/// Most bytes of messages that are kept.
const MAX_MESSAGES: u64 = 1 << 16;

/// Longest line of messages that is shown, in characters.
const LINE_LENGTH: usize = 200;

/// Time between two looks at a program that runs.
#[cfg(unix)]
const POLL_INTERVAL: Duration = Duration::from_millis(2);

/// Time that pipes may stay open after the program's end, by children that left its group.
const GRACE: Duration = Duration::from_secs(1);

/// Runs a program on an input. Where it ends by itself, what is left of its process group is
/// stopped; where it does not within its limit, the whole group is.
///
/// # Errors
/// Why it could not be started or waited for.
pub(super) fn run(program: &External, input: String) -> Result<Finished, ProgramFailure> {
    let mut child = start(program)?;
    let (output, messages) = (drain(child.stdout.take(), MAX_OUTPUT), {
        drain(child.stderr.take(), MAX_MESSAGES)
    });
    if let Some(mut pipe) = child.stdin.take() {
        // A program may end without reading it all, which is its own affair.
        thread::spawn(move || drop(pipe.write_all(input.as_bytes())));
    }
    let in_time = wait(&child, program.limit);
    ended(&child);
    let in_time = in_time?;
    stop_group(&mut child);
    let used = child.wait4().map_err(not_waited_for)?;
    let output = output.recv_timeout(GRACE).unwrap_or_default();
    let messages = messages.recv_timeout(GRACE).unwrap_or_default();
    let failed = if !in_time {
        let seconds = program.limit.as_secs_f64();
        Some(ProgramEnding::TimeLimit { seconds })
    } else if !used.status.success() {
        Some(ending(used.status))
    } else if output.len() as u64 >= MAX_OUTPUT {
        let mebibytes = MAX_OUTPUT >> 20;
        Some(ProgramEnding::TooMuchOutput { mebibytes })
    } else {
        None
    };
    Ok(Finished {
        output: match failed {
            Some(ending) => Err(ProgramFailure::Ended {
                ending,
                messages: first_and_last(&messages),
            }),
            None => Ok(output),
        },
        cpu: used.rusage.utime + used.rusage.stime,
    })
}

fn not_waited_for(error: impl ToString) -> ProgramFailure {
    ProgramFailure::NotWaitedFor {
        error: error.to_string(),
    }
}

fn start(external: &External) -> Result<Child, ProgramFailure> {
    let [program, arguments @ ..] = external.command.as_slice() else {
        return Err(ProgramFailure::NoCommand);
    };
    let mut command = Command::new(program);
    command
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    if let Some(folder) = &external.folder {
        command.current_dir(folder);
    }
    // A group of its own, so that its children can be stopped with it.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    begun(|| command.spawn()).map_err(|error| ProgramFailure::NotStarted {
        program: program.clone(),
        error: error.to_string(),
    })
}

/// Numbers of the programs that run; `None` once all were stopped.
static RUNNING: Mutex<Option<Vec<u32>>> = Mutex::new(Some(Vec::new()));

/// Stops every program with its group, because this one is about to end. None is begun afterwards,
/// and none gives an answer: that it was stopped says nothing about it.
pub fn stop_all() {
    let running = RUNNING.lock().expect("nobody panics with it").take();
    #[cfg(unix)]
    for program in running.into_iter().flatten() {
        use rustix::process::{Pid, Signal, kill_process_group};
        if let Some(group) = i32::try_from(program).ok().and_then(Pid::from_raw) {
            // One that has ended needs nothing more.
            let _ = kill_process_group(group, Signal::KILL);
        }
    }
    #[cfg(not(unix))]
    drop(running);
}

/// Starts a program that [`stop_all`] knows.
fn begun(start: impl FnOnce() -> io::Result<Child>) -> io::Result<Child> {
    let mut running = RUNNING.lock().expect("nobody panics with it");
    let Some(running) = running.as_mut() else {
        return Err(io::ErrorKind::Interrupted.into());
    };
    let child = start()?;
    running.push(child.id());
    Ok(child)
}

/// Forgets a program that has ended; does not return where all were stopped.
fn ended(child: &Child) {
    if let Some(running) = RUNNING.lock().expect("nobody panics with it").as_mut() {
        running.retain(|&program| program != child.id());
        return;
    }
    loop {
        thread::park();
    }
}

/// Reads a pipe to its end in a thread of its own, and keeps at most `most` bytes.
fn drain(pipe: Option<impl Read + Send + 'static>, most: u64) -> Receiver<Vec<u8>> {
    let (send, receive) = channel();
    thread::spawn(move || {
        let mut kept = Vec::new();
        if let Some(mut pipe) = pipe {
            // An error ends the text like its end does.
            let _ = pipe.by_ref().take(most).read_to_end(&mut kept);
            let _ = std::io::copy(&mut pipe, &mut std::io::sink());
        }
        let _ = send.send(kept);
    });
    receive
}

/// Whether the program ends within the limit. It is not reaped, so its number stays its own.
#[cfg(unix)]
fn wait(child: &Child, limit: Duration) -> Result<bool, ProgramFailure> {
    use std::time::Instant;

    use rustix::process::{WaitId, WaitIdOptions, waitid};

    let began = Instant::now();
    let options = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
    loop {
        let seen = waitid(WaitId::Pid(number(child)), options);
        match seen.map_err(not_waited_for)? {
            Some(_) => return Ok(true),
            None if began.elapsed() >= limit => return Ok(false),
            None => thread::sleep(POLL_INTERVAL.min(limit)),
        }
    }
}

#[cfg(unix)]
fn number(child: &Child) -> rustix::process::Pid {
    rustix::process::Pid::from_child(child)
}

/// Stops the program, should it still run, and what is left of its group.
#[cfg(unix)]
fn stop_group(child: &mut Child) {
    use rustix::process::{Signal, kill_process_group};
    // A group that has ended needs nothing more.
    let _ = kill_process_group(number(child), Signal::KILL);
}

#[cfg(not(unix))]
fn wait(_child: &Child, _limit: Duration) -> Result<bool, ProgramFailure> {
    Err(ProgramFailure::NoProcessGroups)
}

#[cfg(not(unix))]
fn stop_group(child: &mut Child) {
    let _ = child.kill();
}

fn ending(status: ExitStatus) -> ProgramEnding {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        return ProgramEnding::Signal(signal);
    }
    match status.code() {
        Some(code) => ProgramEnding::ExitStatus(code),
        None => ProgramEnding::NoExitStatus,
    }
}

/// The first and the last line of messages.
fn first_and_last(messages: &[u8]) -> String {
    let text = String::from_utf8_lossy(messages);
    let lines: Vec<&str> = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .collect();
    match lines.as_slice() {
        [] => String::new(),
        [first] => shortened(first, LINE_LENGTH),
        [first, .., last] => {
            let [first, last] = [first, last].map(|line| shortened(line, LINE_LENGTH));
            format!("{first} … {last}")
        }
    }
}

/// The first characters of a text, on one line and without control characters.
pub(super) fn shortened(text: &str, longest: usize) -> String {
    let plain = |c: char| if c.is_control() { ' ' } else { c };
    let mut short: String = text.chars().take(longest).map(plain).collect();
    if text.chars().nth(longest).is_some() {
        short.push('…');
    }
    short
}
