//! A program run to its end or to its time limit, whichever comes first.

use std::io::{Read, Write};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

use wait4::Wait4;

use super::External;

/// How a program ended.
pub(super) struct Ended {
    /// Its standard output, or why there is none to be used, in words.
    pub output: Result<Vec<u8>, String>,
    /// CPU time of the program and of those children that it waited for.
    pub cpu: Duration,
}

/// Most bytes of output that are kept; an answer for 100 000 joints is a tenth of it.
const MOST_OUTPUT: u64 = 64 << 20;

/// Most bytes of messages that are kept.
const MOST_MESSAGES: u64 = 1 << 16;

/// Time between two looks at a program that runs.
const LOOK: Duration = Duration::from_millis(2);

/// Time that pipes may stay open after the program's end, by children that left its group.
const GRACE: Duration = Duration::from_secs(1);

/// Runs a program on an input. Where it ends by itself, what is left of its process group is
/// stopped; where it does not within its limit, the whole group is.
///
/// # Errors
/// In words, why it could not be started or waited for.
pub(super) fn run(method: &External, input: String) -> Result<Ended, String> {
    let mut child = start(method)?;
    let (output, messages) = (drain(child.stdout.take(), MOST_OUTPUT), {
        drain(child.stderr.take(), MOST_MESSAGES)
    });
    if let Some(mut pipe) = child.stdin.take() {
        // A program may end without reading it all, which is its own affair.
        thread::spawn(move || drop(pipe.write_all(input.as_bytes())));
    }
    let in_time = wait(&child, method.limit)?;
    stop_group(&mut child);
    let used = child
        .wait4()
        .map_err(|error| format!("cannot be waited for: {error}"))?;
    let output = output.recv_timeout(GRACE).unwrap_or_default();
    let messages = messages.recv_timeout(GRACE).unwrap_or_default();
    let failed = if !in_time {
        let limit = method.limit.as_secs_f64();
        Some(format!("stopped after its time limit of {limit} s"))
    } else if !used.status.success() {
        Some(ending(used.status))
    } else if output.len() as u64 >= MOST_OUTPUT {
        Some(format!("wrote more than {} MiB", MOST_OUTPUT >> 20))
    } else {
        None
    };
    Ok(Ended {
        output: match failed {
            Some(reason) => Err(with_messages(reason, &messages)),
            None => Ok(output),
        },
        cpu: used.rusage.utime + used.rusage.stime,
    })
}

fn start(method: &External) -> Result<Child, String> {
    let [program, arguments @ ..] = method.command.as_slice() else {
        return Err("has no command".to_owned());
    };
    let mut command = Command::new(program);
    command
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    if let Some(folder) = &method.folder {
        command.current_dir(folder);
    }
    // A group of its own, so that its children can be stopped with it.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    command
        .spawn()
        .map_err(|error| format!("cannot start `{program}`: {error}"))
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
fn wait(child: &Child, limit: Duration) -> Result<bool, String> {
    use rustix::process::{WaitId, WaitIdOptions, waitid};
    let began = Instant::now();
    let options = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
    loop {
        let seen = waitid(WaitId::Pid(number(child)), options);
        match seen.map_err(|error| format!("cannot be waited for: {error}"))? {
            Some(_) => return Ok(true),
            None if began.elapsed() >= limit => return Ok(false),
            None => thread::sleep(LOOK.min(limit)),
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
fn wait(child: &Child, _limit: Duration) -> Result<bool, String> {
    let _ = child;
    Err("external methods need a system with process groups".to_owned())
}

#[cfg(not(unix))]
fn stop_group(child: &mut Child) {
    let _ = child.kill();
}

/// How a program ended, in words.
fn ending(status: ExitStatus) -> String {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        return format!("ended by signal {signal}");
    }
    match status.code() {
        Some(code) => format!("ended with exit status {code}"),
        None => "ended without an exit status".to_owned(),
    }
}

fn with_messages(reason: String, messages: &[u8]) -> String {
    let text = String::from_utf8_lossy(messages);
    let lines: Vec<&str> = text
        .lines()
        .map(str::trim)
        .filter(|l| !l.is_empty())
        .collect();
    match lines.as_slice() {
        [] => reason,
        [first] => format!("{reason}: {}", shown(first, 200)),
        [first, .., last] => {
            let first = shown(first, 200);
            format!("{reason}: {first} … {}", shown(last, 200))
        }
    }
}

/// The first characters of a text, on one line and without control characters.
pub(super) fn shown(text: &str, longest: usize) -> String {
    let plain = |c: char| if c.is_control() { ' ' } else { c };
    let mut short: String = text.chars().take(longest).map(plain).collect();
    if text.chars().nth(longest).is_some() {
        short.push('…');
    }
    short
}
