"""One result: the answer of a method to a case."""

from __future__ import annotations

from typing import Any

from trilith._arrays import array
from trilith._case import Case
from trilith._drawing import Drawing, draw
from trilith._scene import Scene


class Answer:
    """What all methods together come to for a case and one setting of its head joints.

    As text it is the closing sentence.

    Attributes:
        data: everything that the program says of it, as ``base_shear``, ``tilt_degrees``,
            ``mechanism``, ``first_blocks``, ``methods``, ``doubts``.
        lower: λ of the answer, or the lower end of its range; None where there is none.
        upper: the upper end of its range, the same as ``lower`` for one number.
        status: what it is worth: ``"verified"``, ``"bracketed"``, ``"estimate"``, ``"stands"``, ...
        push: the direction that it is about, of a wall that is pushed both ways the weaker one.
    """

    def __init__(self, data: dict[str, Any]) -> None:
        self.data = data
        self.lower: float | None = data["lower"]
        self.upper: float | None = data["upper"]
        self.status: str = data["status"]
        self.push: str = data["push"]

    def __getitem__(self, key: str) -> Any:
        return self.data[key]

    def __str__(self) -> str:
        return str(self.data["line"])

    def __repr__(self) -> str:
        return f"<trilith answer: {self}>"


class Side:
    """A method's answer for one direction of the push.

    Attributes:
        push: ``"right"`` or ``"left"``.
        status: what it is worth.
        lower: λ or the lower end of its range in full digits; None where there is none.
        upper: the upper end.
        reason: why, in words.
        scene: the `Scene`.
        answers: what it rests on, in the format of ``trilith schema result``, lowest λ first.
    """

    def __init__(self, data: dict[str, Any]) -> None:
        self.push: str = data["push"]
        self.status: str = data["status"]
        self.lower: float | None = data["lower"]
        self.upper: float | None = data["upper"]
        self.reason: str = data["reason"]
        self.answers: list[dict[str, Any]] = data["answers"]
        self._scene: dict[str, Any] = data["scene"]

    @property
    def scene(self) -> Scene:
        """Blocks, joints and loads."""
        return Scene(self._scene)

    @property
    def forces(self) -> Any:
        """(joints, 3): [n1, n2, t] of every joint of the lowest state that has them, else None.

        n1 and n2 are normal forces at the ends of the joint, compression positive; t is the shear
        on the block that the normal points into, along the tangent. In forces of the case.
        """
        return self._first("forces")

    @property
    def velocities(self) -> Any:
        """(blocks, 3): [x, y, rotation] of every block in the lowest state's mechanism, else None.

        The velocity of the centroid and the rotation rate, counter-clockwise; only ratios count.
        """
        return self._first("velocities")

    def _first(self, key: str) -> Any:
        found = (answer[key] for answer in self.answers if answer.get(key) is not None)
        numbers = next(found, None)
        return None if numbers is None else array(numbers, 3)


class Result:
    """The answer of one method to one case with one setting of its head joints.

    Every column of the program's JSON is an item: ``result["tan_beta"]``.

    Attributes:
        data: the program's row.
        of: the case that was handed to `run`.
        case: the case's name, with ``@open`` behind it for open head joints.
        method: the method's name.
        head_joints: what head joints carry: ``"contact"`` or ``"open"``.
        status: ``"verified"``, ``"bracketed"``, ``"estimate"``, ``"stands"``, ``"falls"``,
            ``"undecided"``, ``"not-applicable"`` or ``"failed"``.
        lower: the collapse multiplier λ, or the lower end of its range; None where there is none.
            Without dimension. Of a wall that is pushed both ways it is the weaker side's. What the
            ends are depends on the method: README.md has the table.
        upper: the upper end of the range of λ; None where there is none.
        stated_error: the error of λ that the method itself states, relative to λ (0.002 is 0.2 %).
        reason: why, in words; may be empty.
        seconds: CPU time.
    """

    def __init__(self, data: dict[str, Any], of: Case, pushed: Case) -> None:
        self.data = data
        self.of = of
        # The same, pushed as `run` was told to.
        self.pushed = pushed
        self.case: str = data["case"]
        self.method: str = data["method"]
        self.head_joints: str = data["head_joints"]
        self.status: str = data["status"]
        self.lower: float | None = data["lower"]
        self.upper: float | None = data["upper"]
        self.stated_error: float | None = data["stated_error"]
        self.reason: str = data["reason"]
        self.seconds: float = data["seconds"]

    @property
    def sides(self) -> list[Side]:
        """What it answers for each direction of the push, the deciding one first."""
        return [Side(side) for side in self.data["sides"]]

    @property
    def forces(self) -> Any:
        """`Side.forces` of the direction that decides."""
        return self.sides[0].forces

    @property
    def velocities(self) -> Any:
        """`Side.velocities` of the direction that decides."""
        return self.sides[0].velocities

    @property
    def scene(self) -> Scene:
        """`Scene` of the direction that decides."""
        return self.sides[0].scene

    @property
    def answer(self) -> Answer | None:
        """What all methods that ran come to for this case and these head joints; None of no method."""
        conclusion = self.data["conclusion"]
        return None if conclusion is None else Answer(conclusion)

    def draw(self, forces: bool = False) -> Drawing:
        """A drawing of the case with this answer; the method runs again for it."""
        return draw(self.pushed, [self.method], forces=forces, head_joints=self.head_joints)

    def __getitem__(self, column: str) -> Any:
        return self.data[column]

    def __repr__(self) -> str:
        return f"<trilith result {self.case} {self.method}: {in_words(self)} {self.status}>"


def in_words(row: Result) -> str:
    """λ as people read it."""
    if row.lower is None or row.upper is None:
        return "no λ"
    one = f"{row.lower:.5f}"
    return f"λ = {one}" if one == f"{row.upper:.5f}" else f"λ = {one} to {row.upper:.5f}"
