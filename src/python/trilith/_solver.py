"""Outside methods in Python: functions that answer scenes."""

from __future__ import annotations

import functools
import hashlib
import json
import os
import re
import sys
import time
import traceback
from collections.abc import Sequence
from typing import Any, Callable

from trilith import _toml
from trilith._arrays import plain
from trilith._errors import CaseError
from trilith._program import run
from trilith._scene import Scene

LONGEST_NAME = 12
# A method that costs next to nothing: only the scenes of its rows are wanted.
CHEAP = "macro-block"


class Solver:
    """A function that answers scenes, under the name that results call it."""

    def __init__(self, function: Callable[[Scene], Any], name: str) -> None:
        self.function = function
        self.name = name
        functools.update_wrapper(self, function, updated=())

    def __call__(self, scene: Scene) -> Any:
        return self.function(scene)


def solver(function: Any = None, *, name: str | None = None) -> Any:
    """Makes a method of a function that gets a `Scene`: ``@trilith.solver``.

    The function returns one of

    - a number: λ, without a proof;
    - two numbers: the ends of a range of λ, without a proof;
    - None: no answer;
    - a dictionary in the format of ``trilith schema result``, with arrays or lists: ``lambda``,
      ``forces`` (joints, 3), ``velocities`` (blocks, 3), ``kind``. Without a kind, forces and
      velocities together are ``"collapse-state"``, and anything else is ``"estimate"``.

    Args:
        function: what to decorate.
        name: what results call it, up to 12 letters; the function's name if left out.
    """
    if function is None:
        return functools.partial(solver, name=name)
    if isinstance(function, Solver):
        return function
    if not callable(function):
        raise CaseError(f"{function!r} is neither the name of a method nor a function")
    own = str(name or getattr(function, "__name__", "solver"))
    own = re.sub(r"[^A-Za-z0-9]+", "-", own).strip("-")[:LONGEST_NAME].strip("-").lower()
    return Solver(function, own or "solver")


def answered(
    solvers: Sequence[Solver], arguments: Sequence[str], folder: str
) -> dict[tuple[str, str], float]:
    """Calls solvers with every scene, and leaves their answers in a folder for the program.

    Returns:
        Seconds of CPU time that each solver took for each case.
    """
    rows = json.loads(run([*arguments, "--method", CHEAP], folder=folder).out)
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "_replay.py")
    seconds: dict[tuple[str, str], float] = {}
    programs = []
    for place, one in enumerate(solvers):
        answers = os.path.join(folder, f"answers-{place}")
        os.mkdir(answers)
        for row in rows:
            for side in row.get("sides", ()):
                began = time.process_time()
                text = _answer(one, side["scene"])
                key = (one.name, row["case"])
                seconds[key] = seconds.get(key, 0.0) + time.process_time() - began
                with open(os.path.join(answers, digest(side["scene"])), "w", encoding="utf-8") as out:
                    out.write(text)
        # Alone: neither the user's packages nor what the environment says is read.
        command = [sys.executable, "-I", "-S", script, answers]
        programs.append({"name": one.name, "command": command})
    with open(os.path.join(folder, "solvers.toml"), "w", encoding="utf-8") as out:
        out.write(_toml.document({"method": programs}))
    return seconds


def digest(scene: dict[str, Any]) -> str:
    """What tells scenes apart, whichever way their JSON was written."""
    text = json.dumps(scene, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def _answer(one: Solver, data: dict[str, Any]) -> str:
    """The answer as JSON; of a function that raises, the traceback."""
    try:
        return json.dumps(_complete(one(Scene(data))), allow_nan=False)
    except Exception:  # whatever a function of others raises
        return traceback.format_exc()


def _complete(given: Any) -> dict[str, Any]:
    value = plain(given)
    if value is None:
        return {"kind": "undecided", "reason": "the function returned None"}
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return {"kind": "estimate", "lambda": value}
    if isinstance(value, list) and len(value) == 2:
        return {"kind": "estimate", "lambda": value[0], "upper": value[1]}
    if not isinstance(value, dict):
        raise TypeError(f"a solver returns a number, two numbers, a dictionary or None, not {given!r}")
    proved = "forces" in value and "velocities" in value
    return {"kind": "collapse-state" if proved else "estimate", **value}
