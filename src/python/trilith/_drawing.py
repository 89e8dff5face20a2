"""Drawings of walls and how they collapse, and models for other programs."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence

from trilith._case import Case, Pathlike
from trilith._folder import Folder
from trilith._program import run


class Drawing:
    """A drawing, which a notebook shows.

    Attributes:
        svg: its text.
    """

    def __init__(self, svg: str) -> None:
        self.svg = svg

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: Pathlike) -> None:
        """Writes it as an SVG file."""
        with open(os.fspath(path), "w", encoding="utf-8", newline="\n") as file:
            file.write(self.svg)

    def __repr__(self) -> str:
        return f"<trilith drawing, {len(self.svg)} bytes of SVG>"


def draw(case: Case, methods: Sequence[str], *, forces: bool = False, head_joints: str = "") -> Drawing:
    """Draws a case with the answers of methods, which run again for it."""
    with tempfile.TemporaryDirectory(prefix="trilith-") as path:
        arguments = ["draw", *Folder(path, [case]).arguments, "-o", "-"]
        if methods:
            arguments += ["--method", ",".join(methods)]
        if len(methods) > 1:
            arguments.append("--side-by-side")
        if head_joints:
            arguments += ["--head-joints", head_joints]
        if forces:
            arguments.append("--forces")
        return Drawing(run(arguments, folder=path).out)


def write_compas(case: Case, path: Pathlike, method: str, head_joints: str) -> None:
    """Writes a BlockModel of COMPAS."""
    with tempfile.TemporaryDirectory(prefix="trilith-") as folder:
        arguments = ["export", *Folder(folder, [case]).arguments, "--method", method]
        arguments += ["--head-joints", head_joints] if head_joints else []
        run([*arguments, "--compas", os.path.abspath(os.fspath(path))], folder=folder)
