"""Cases from elsewhere: files, the built-in library, drawings, models of COMPAS."""

from __future__ import annotations

import os
import tempfile
from typing import Any

from trilith._case import PLAIN, Case, Pathlike
from trilith._program import run, warn


def load(path: Pathlike) -> Case:
    """A case file, or a built-in case by its name (``"paper-1"``; `library` has them all).

    Tables that it names stay beside it, and the program reads both where they are.

    Raises:
        CaseError: there is no such case.
    """
    argument = os.fspath(path)
    name = os.path.splitext(os.path.basename(argument))[0] if argument.endswith(".toml") else argument
    if os.path.isfile(argument):
        return _named(name, os.path.abspath(argument))
    known = _listed().get(argument)
    if known is None:
        # The program says what is wrong.
        run(["show", argument])
    return _named(name, known or argument)


def library() -> list[Case]:
    """Every case that is built into the program, in the order of ``trilith list``."""
    return [_named(name, file) for name, file in _listed().items()]


def _listed() -> dict[str, str]:
    """The built-in cases and their files, by which no folder can be meant."""
    lines = run(["list"]).out.split("\n\n")[0].splitlines()[2:]
    return {line.split()[0]: line.split()[1] for line in lines}


def _named(name: str, argument: str) -> Case:
    case = Case(name=name)
    case._argument = argument
    return case


def template(kind: str = "wall") -> str:
    """A commented case file that explains every key.

    Args:
        kind: ``"wall"``, ``"blocks"`` or ``"arch"``.
    """
    with tempfile.TemporaryDirectory(prefix="trilith-") as folder:
        path = os.path.join(folder, "case.toml")
        run(["new", path, "--kind", kind])
        return _text(path)


def read_dxf(path: Pathlike, friction: float, **options: Any) -> Case:
    """A case from a DXF drawing: every closed outline is a block.

    What the program took for what, and every corner that it moved, is said on standard error.

    Args:
        path: the drawing, a DXF in text form.
        friction: coefficient of friction (the tangent of the friction angle) of every joint.
        options: those of ``trilith import``: ``support="ground"`` and ``without="text"`` name
            layers, ``units="mm"``, ``gap="12mm"``, ``push="both"``, ``head_joints="open"``,
            ``tolerance=0.01``.

    Raises:
        CaseError: what cannot be a wall, with the entity's name, handle and layer.
    """
    return _imported(os.fspath(path), friction, options)


def read_compas(model: Pathlike | Any, friction: float, **options: Any) -> Case:
    """A case from a plane model of COMPAS: a BlockModel of compas_dem, an Assembly of compas_assembly.

    Blocks take the model's depth and, where every block has a material, its density; blocks with
    ``is_support`` never move.

    Args:
        model: the JSON file of a model, or a model itself, which is written with its ``to_json``.
        friction: coefficient of friction (the tangent of the friction angle) of every joint.
        options: those of ``trilith import``: ``push="both"``, ``head_joints="open"``,
            ``tolerance=0.01``.

    Raises:
        CaseError: a model that is not plane, with the block's name, or that is no model.
    """
    if not hasattr(model, "to_json"):
        return _imported(os.fspath(model), friction, options)
    with tempfile.TemporaryDirectory(prefix="trilith-") as folder:
        path = os.path.join(folder, f"{PLAIN.sub('-', getattr(model, 'name', '') or 'model')}.json")
        model.to_json(path)
        return _imported(path, friction, options, hidden=folder)


def _imported(path: str, friction: float, options: dict[str, Any], hidden: str = "") -> Case:
    with tempfile.TemporaryDirectory(prefix="trilith-") as folder:
        name = PLAIN.sub("-", os.path.splitext(os.path.basename(path))[0]) or "case"
        target = os.path.join(folder, f"{name}.toml")
        arguments = ["import", path, "-o", target, f"--friction={float(friction)!r}"]
        for option, value in options.items():
            arguments.append(f"--{option.replace('_', '-')}={value}")
        done = run(arguments, folder=hidden or folder)
        warn(done.said)
        case = Case(name=name)
        case._text = _text(target)
        case._beside = {f"{name}.csv": _text(os.path.join(folder, f"{name}.csv"))}
        return case


def _text(path: str) -> str:
    with open(path, encoding="utf-8") as file:
        return file.read()
