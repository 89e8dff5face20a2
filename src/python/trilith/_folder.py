"""Cases on their way to the program: files in a temporary folder, or names of what is there."""

from __future__ import annotations

import os
from collections.abc import Sequence

from trilith._case import Case
from trilith._errors import CaseError


class Folder:
    """Writes cases below a temporary folder, in their order, each in a folder of its own.

    Attributes:
        arguments: what names all of them to the program.
        names: what the program calls each.
    """

    def __init__(self, path: str, cases: Sequence[Case]) -> None:
        self.arguments: list[str] = []
        self.names: list[str] = []
        self._path = path
        taken = {case.name for case in cases if case._argument is not None}
        counts: dict[str, int] = {}
        for place, case in enumerate(cases):
            if not isinstance(case, Case):
                raise CaseError(f"{case!r} is no case: make one with Wall, Blocks, Arch or load")
            if case._argument is not None:
                self.names.append(case.name)
                self.arguments.append(case._argument)
                continue
            name = case.name
            while name in taken:
                counts[case.name] = counts.get(case.name, 1) + 1
                name = f"{case.name}-{counts[case.name]}"
            taken.add(name)
            self.names.append(name)
            self._write(place, name, case)

    def _write(self, place: int, name: str, case: Case) -> None:
        # Cases that follow each other share a folder, which the program reads in the order of names.
        last = self.arguments[-1] if self.arguments else ""
        if not last.startswith(self._path):
            last = os.path.join(self._path, f"{place:06}")
            self.arguments.append(last)
        own = os.path.join(last, f"{place:06}")
        os.makedirs(own)
        for file, text in [(f"{name}.toml", case.text()), *case._beside.items()]:
            with open(os.path.join(own, file), "w", encoding="utf-8", newline="\n") as out:
                out.write(text)
