"""The program: where it is, and running it."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import sysconfig
import threading
from collections.abc import Sequence
from typing import NamedTuple

from trilith._errors import CaseError, ProgramError
from trilith._progress import Bar

VERSION = "0.1.0"

# Exit status of a process that Windows ends by Ctrl-C.
WINDOWS_INTERRUPT = 0xC000013A

_checked: set[str] = set()


class Finished(NamedTuple):
    """What a run of the program left behind."""

    out: str
    """Its standard output."""
    said: str
    """Its standard error, without the lines of progress."""
    interrupted: bool
    """Whether Ctrl-C or a signal ended it early."""


def program() -> str:
    """The path of the program that the module runs.

    That is ``TRILITH_PROGRAM`` where the environment names it, else the one that was installed with
    the module, else the first ``trilith`` of ``PATH``.

    Raises:
        ProgramError: there is none, or it is of another version than the module.
    """
    path = _find()
    if path not in _checked:
        _check(path)
        _checked.add(path)
    return path


def _find() -> str:
    named = os.environ.get("TRILITH_PROGRAM")
    if named:
        return named
    name = "trilith" + (".exe" if os.name == "nt" else "")
    user = "nt_user" if os.name == "nt" else "posix_user"
    schemes = [None, user, "osx_framework_user"]
    for scheme in (one for one in schemes if one is None or one in sysconfig.get_scheme_names()):
        folder = sysconfig.get_path("scripts", scheme) if scheme else sysconfig.get_path("scripts")
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            return path
    # `pip install --target DIR` puts scripts into DIR/bin.
    beside = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "bin", name)
    path = beside if os.path.isfile(beside) else (shutil.which("trilith") or "")
    if not path:
        raise ProgramError(
            "the program trilith is missing: it is neither beside this Python nor on PATH; install "
            "it again (`pip install --force-reinstall trilith`), or name it in TRILITH_PROGRAM"
        )
    return path


def _check(path: str) -> None:
    try:
        done = subprocess.run([path, "--version"], capture_output=True, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise ProgramError(f"the program {path} cannot be run: {error}") from None
    words = done.stdout.split()
    if done.returncode != 0 or words[:1] != ["trilith"]:
        raise ProgramError(f"{path} is not the program trilith: `--version` says {done.stdout!r}")
    version = words[-1]
    if version != VERSION:
        raise ProgramError(
            f"the program {path} is of version {version}, and this module of {VERSION}: install both "
            "again (`pip install --force-reinstall trilith`)"
        )


def run(
    arguments: Sequence[str],
    progress: Bar | None = None,
    folder: str = "",
    keeps: bool = False,
) -> Finished:
    """Runs the program to its end. Ctrl-C makes it hand out what is finished, where the caller keeps it.

    Args:
        arguments: behind the program's name.
        progress: shows the share of the work that is done, the seconds left and bounds as they grow.
        folder: a temporary folder, which messages leave out.
        keeps: whether the caller wants what is finished after Ctrl-C.

    Raises:
        CaseError: bad input, with the program's message.
        ProgramError: it cannot be run, or was ended from outside.
        KeyboardInterrupt: Ctrl-C before anything was finished, or where nothing of it is kept.
    """
    command = [program(), *arguments]
    if progress:
        command += ["--progress", "lines"]
    try:
        process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
    except OSError as error:
        raise ProgramError(f"the program {command[0]} cannot be run: {error}") from None
    lines: list[str] = []
    reader = threading.Thread(target=_listen, args=(process, lines, progress), daemon=True)
    try:
        reader.start()
        out, interrupts = _read(process)
        status = process.wait()
        reader.join()
    except BaseException:
        process.kill()
        process.wait()
        raise
    said = "".join(lines)
    if folder:
        said = re.sub(re.escape(folder) + r"(?:[/\\]\d{6})*[/\\]?", "", said)
    if interrupts and not keeps:
        # It may have ended as if nothing had happened, and what follows must not begin.
        raise KeyboardInterrupt(said.strip())
    return _judged(status, out.decode(), said.strip(), interrupts > 0)


def _read(process: subprocess.Popen[bytes]) -> tuple[bytes, int]:
    """Its standard output, and how often Ctrl-C came: once lets it hand out, twice ends it."""
    parts: list[bytes] = []
    interrupts = 0
    assert process.stdout is not None
    while True:
        try:
            part = os.read(process.stdout.fileno(), 1 << 20)
        except KeyboardInterrupt:
            interrupts += 1
            if interrupts > 1:
                raise
            # A terminal has told it already, a notebook has not; twice at once counts as once.
            if os.name != "nt":
                process.send_signal(signal.SIGINT)
            continue
        if not part:
            process.stdout.close()
            return b"".join(parts), interrupts
        parts.append(part)


def _listen(
    process: subprocess.Popen[bytes],
    lines: list[str],
    progress: Bar | None,
) -> None:
    """Its standard error, line by line."""
    assert process.stderr is not None
    with process.stderr as stream:
        for raw in stream:
            line = raw.decode(errors="replace")
            if progress and line.startswith("progress "):
                share, left = line.split()[1:3]
                progress(float(share), float(left))
            elif progress and line.startswith("proved "):
                progress.proved(*line.removeprefix("proved ").rsplit(maxsplit=3))
            else:
                lines.append(line)


def _judged(status: int, out: str, said: str, interrupted: bool) -> Finished:
    """What a status means. 1 is a result that failed or a violated reference: rows say so."""
    if status in (0, 1):
        return Finished(out, said, False)
    if status == 2:
        raise CaseError(said)
    signals = {128 + int(one): one.name for one in (signal.SIGINT, signal.SIGTERM)}
    if interrupted or status in signals or status in (-signal.SIGINT, WINDOWS_INTERRUPT):
        if out.strip():
            return Finished(out, said, True)
        if interrupted or status != 128 + signal.SIGTERM:
            raise KeyboardInterrupt(said)
    what = f"signal {-status}" if status < 0 else f"exit status {status}"
    if status in (-9, 137):
        what += ", mostly for want of memory"
    raise ProgramError(f"the program trilith was ended before it answered ({what})\n{said}".strip())


def warn(said: str) -> None:
    """Hands on what the program said beside its answer."""
    if said:
        print(said, file=sys.stderr)
