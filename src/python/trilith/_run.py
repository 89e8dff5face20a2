"""Running methods on cases."""

from __future__ import annotations

import json
import os
import sys
import tempfile
from collections.abc import Iterable, Sequence
from typing import Any, Callable, Union

from trilith._case import Case
from trilith._folder import Folder
from trilith._program import Finished, warn
from trilith._program import run as run_program
from trilith._progress import bar
from trilith._result import Result
from trilith._results import Results
from trilith._solver import Solver, answered, solver

Method = Union[str, Solver, Callable[..., Any]]


def run(
    cases: Case | Iterable[Case],
    methods: Sequence[Method] | None = None,
    *,
    push: str | None = None,
    head_joints: str | None = None,
    progress: bool | None = None,
    **settings: Any,
) -> Results:
    """Runs methods on cases: all cases in one run of the program, on all cores.

    Ctrl-C ends it early: what is finished is returned, and `Results.partial` says what is missing.
    Nothing is written outside temporary folders.

    Args:
        cases: a case or several.
        methods: names of methods (``trilith list`` explains them) and functions of your own
            (`solver`); the default methods if left out.
        push: ``"right"``, ``"left"`` or ``"both"``, instead of what the cases say.
        head_joints: ``"contact"``, ``"open"`` or ``"both"``, instead of what the cases say.
        progress: whether a bar on standard error shows how far it is; if left out, on a terminal
            and in a notebook.
        settings: settings of the methods: ``starts=200``, ``accuracy="fine"``;
            ``trilith run --help`` explains them.

    Raises:
        CaseError: a case, method or setting that the program refuses, with its message.
        ProgramError: the program is missing, of another version, or was killed.
        KeyboardInterrupt: Ctrl-C before anything was finished.
    """
    own = [cases] if isinstance(cases, Case) else list(cases)
    if not own:
        return Results([])
    pushed = own if push is None else [case.with_keys(push=push) for case in own]
    solvers = [solver(one) for one in methods or () if not isinstance(one, str)]
    named = [one for one in methods or () if isinstance(one, str)]
    with tempfile.TemporaryDirectory(prefix="trilith-") as path:
        folder = Folder(os.path.join(path, "cases"), pushed)
        common = ["run", *folder.arguments, "--format", "json", "--states"]
        common += ["--head-joints", head_joints] if head_joints else []
        options = [f"--set={name.replace('_', '-')}={_word(value)}" for name, value in settings.items()]
        measured: dict[tuple[str, str], float] = {}
        if solvers:
            measured = answered(solvers, common, path)
            options += ["--external", os.path.join(path, "solvers.toml")]
        names = named + [one.name for one in solvers]
        options += ["--method", ",".join(names)] if methods else []
        shown = bar(progress)
        try:
            told = os.path.join(path, "cases")
            done = run_program([*common, *options], shown, told, keeps=True)
        finally:
            if shown:
                shown.clear()
    return _results(done, dict(zip(folder.names, zip(own, pushed))), measured)


def _word(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _results(
    done: Finished,
    cases: dict[str, tuple[Case, Case]],
    measured: dict[tuple[str, str], float],
) -> Results:
    rows = json.loads(done.out)
    partial = ""
    if rows and "partial" in rows[-1]:
        partial = rows.pop()["partial"]
        print(f"trilith: {partial}", file=sys.stderr)
    elif done.said:
        warn(done.said)
    for row in rows:
        # A solver ran here and not in the program, which timed the handing over of its answers.
        row["seconds"] = measured.get((row["method"], row["case"]), row["seconds"])
    made = [Result(row, *cases[row["case"].split("@")[0]]) for row in rows]
    return Results(made, done.out, partial)


def check(
    function: Method,
    cases: Case | Iterable[Case] | None = None,
    methods: Sequence[str] = ("associative", "interval"),
    **options: Any,
) -> Results:
    """Judges a function of your own against the methods and the published values.

    The function is called here, once for every scene; nothing is pickled and no process is started
    for it. Its answers then go to the program's judge, as those of any outside program: forces and
    velocities that hold are ``"verified"``, a claim that they do not bear out is ``"failed"``, a
    number alone is an ``"estimate"``, which ``verdict`` compares.

    Args:
        function: as `solver` describes.
        cases: a case or several; the whole library if left out.
        methods: what else runs, to compare with.
        options: as for `run`.
    """
    from trilith._read import library

    return run(library() if cases is None else cases, [*methods, function], **options)
