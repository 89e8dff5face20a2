"""Results: a row a case, head joints and method, and what the rows of a case come to."""

from __future__ import annotations

import html
from collections.abc import Iterator, Sequence
from typing import Any

from trilith._case import Case
from trilith._drawing import Drawing, draw
from trilith._result import Answer, Result, in_words

TABLE = ("case", "method", "status", "lower", "upper", "stated_error", "reference", "verdict")


class Results:
    """Results in the order of cases, their head joints, and methods.

    Attributes:
        text: the JSON of the program, as it came.
        partial: why results are missing; empty where all are there.
    """

    def __init__(self, rows: Sequence[Result], text: str = "", partial: str = "") -> None:
        self._rows = list(rows)
        self.text = text
        self.partial = partial

    def __getitem__(self, key: Any) -> Any:
        """A row by its place; the rows of a method, of a case's name (``"wall@open"``) or of a case.

        The one row of a method where there is only one: ``results["interval"].lower``.

        Raises:
            KeyError: nothing is called so.
        """
        if isinstance(key, int):
            return self._rows[key]
        if isinstance(key, slice):
            return Results(self._rows[key], self.text, self.partial)
        if isinstance(key, Case):
            return Results([row for row in self._rows if row.of is key], self.text, self.partial)
        of_method = [row for row in self._rows if row.method == key]
        found = of_method or [row for row in self._rows if row.case == key]
        if not found:
            raise KeyError(key)
        return found[0] if len(of_method) == 1 else Results(found, self.text, self.partial)

    def __len__(self) -> int:
        return len(self._rows)

    def __iter__(self) -> Iterator[Result]:
        return iter(self._rows)

    @property
    def lower(self) -> list[float | None]:
        """`Result.lower` of every row."""
        return [row.lower for row in self._rows]

    @property
    def upper(self) -> list[float | None]:
        """`Result.upper` of every row."""
        return [row.upper for row in self._rows]

    @property
    def answers(self) -> dict[str, Answer]:
        """What the methods come to, for every case and setting of head joints by its name."""
        answers = ((row.case, row.answer) for row in self._rows)
        return {case: answer for case, answer in answers if answer is not None}

    @property
    def answer(self) -> Answer:
        """The one of `answers`.

        Raises:
            ValueError: there are several.
        """
        answers = self.answers
        if len(answers) != 1:
            raise ValueError(f"there are {len(answers)} answers; write `results.answers[NAME]`")
        return next(iter(answers.values()))

    def to_pandas(self) -> Any:
        """A DataFrame with the columns of ``--format csv``; it needs pandas."""
        import pandas  # type: ignore[import-untyped,unused-ignore]

        flat = [
            {column: value for column, value in row.data.items() if not isinstance(value, (dict, list))}
            for row in self._rows
        ]
        return pandas.DataFrame(flat)

    def draw(self, forces: bool = False) -> Drawing:
        """A drawing of the one case, with the answers of its methods beside each other.

        Raises:
            ValueError: the rows are of several cases or head joints.
        """
        names = {row.case for row in self._rows}
        if len(names) != 1:
            raise ValueError(f"{len(names)} cases cannot be drawn as one; write `results[NAME].draw()`")
        first = self._rows[0]
        methods = [row.method for row in self._rows]
        return draw(first.pushed, methods, forces=forces, head_joints=first.head_joints)

    def __repr__(self) -> str:
        lines = [f"{row.case}  {row.method}  {in_words(row)}  {row.status}" for row in self._rows[:50]]
        lines += [f"and {len(self) - 50} more"] if len(self) > 50 else []
        lines += [f"{name}: {answer}" for name, answer in list(self.answers.items())[:10]]
        return "\n".join([*lines, *([self.partial] if self.partial else [])])

    def _repr_html_(self) -> str:
        def cells(kind: str, values: Sequence[object]) -> str:
            return "".join(f"<{kind}>{html.escape(str(value))}</{kind}>" for value in values)

        rows = []
        for row in self._rows:
            values = (row.data.get(column) for column in TABLE)
            shown = ["" if v is None else f"{v:.5g}" if isinstance(v, float) else v for v in values]
            rows.append(f"<tr title='{html.escape(row.reason, quote=True)}'>{cells('td', shown)}</tr>")
        said = [
            f"<p><b>{html.escape(n)}</b>: {html.escape(str(a))}</p>" for n, a in self.answers.items()
        ]
        if self.partial:
            said.append(f"<p>{html.escape(self.partial)}</p>")
        head = f"<thead><tr>{cells('th', TABLE)}</tr></thead>"
        return f"<table>{head}<tbody>{''.join(rows)}</tbody></table>{''.join(said)}"
