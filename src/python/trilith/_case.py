"""Cases: what the program runs, written from Python or read from files.

Keys are those of case files, and this module knows none of them: ``trilith.template("wall")`` prints a
file with every key explained, and the program refuses what it does not know.
"""

from __future__ import annotations

import copy
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Union

from trilith import _toml
from trilith._arrays import plain
from trilith._errors import CaseError

PLAIN = re.compile(r"[^\w.-]")
Pathlike = Union[str, "os.PathLike[str]"]


class Case:
    """A structure that the program can run: keys of a case file, or a file that is there.

    Made by `Wall`, `Blocks`, `Arch`, `load`, `read_dxf` and `read_compas`, or of a dictionary of
    keys: ``Case({"courses": ["11", "h1h"], "unit": {...}, "friction": 0.65}, name="garden")``.

    Lengths and forces are in any one consistent system of units: λ depends on neither. x points to
    the right and y up.

    Attributes:
        name: what it is called in results; a number is added where two are called the same.
    """

    name: str

    def __init__(self, keys: Mapping[str, Any] | None = None, *, name: str = "case") -> None:
        self.name = PLAIN.sub("-", name) or "case"
        self._keys: dict[str, Any] = dict(keys or {})
        # The text that is there already, behind the keys that were changed since.
        self._text = ""
        # Files beside it that it names, as the table of corners of an imported drawing.
        self._beside: dict[str, str] = {}
        # A file or a built-in case that the program reads where it is.
        self._argument: str | None = None

    def with_keys(self, **keys: Any) -> Case:
        """The same case with other values of keys of its file: ``wall.with_keys(friction=0.5)``.

        Raises:
            CaseError: a built-in case or one that has tables beside it in its folder, where nothing
                can be changed.
        """
        changed = copy.copy(self)
        if self._argument is None and not self._text:
            changed._keys = {**self._keys, **keys}
            return changed
        if self._argument is not None:
            # A file is named by its whole path.
            if not os.path.isabs(self._argument):
                raise CaseError(
                    f"the case {self.name} is built in, and its keys stay as they are; write its "
                    "file with `trilith convert`, or make a case of your own"
                )
            with open(self._argument, encoding="utf-8") as file:
                text = file.read()
            if re.search(r"^\s*csv\s*=", text, re.MULTILINE):
                raise CaseError(f"{self._argument} names a table beside it: change the keys in the file")
            changed._text, changed._argument = text, None
        changed._text = _replaced(changed._text, keys)
        return changed

    def text(self) -> str:
        """The text of its case file; empty where the program reads a file where it is."""
        return self._text or _toml.document(self._keys)

    def __repr__(self) -> str:
        return f"<trilith case {self.name}>"

    def draw(self, *methods: str, forces: bool = False, head_joints: str = "") -> Any:
        """A drawing of how it collapses, which a notebook shows.

        Args:
            methods: whose answers are drawn, beside each other where they are several; the
                search's where none is named.
            forces: also draw the contact forces.
            head_joints: ``"contact"`` or ``"open"``, instead of what the case says.

        Returns:
            A `Drawing`.
        """
        from trilith._drawing import draw

        return draw(self, methods, forces=forces, head_joints=head_joints)

    def to_compas(self, path: Pathlike, *, method: str = "associative", head_joints: str = "") -> None:
        """Writes a BlockModel of compas_dem with a method's mechanism and contact forces.

        Blocks stand in x–z about y = 0, as deep as they weigh over their areas. ``displacement``
        [x, y, z] of the centroid and ``rotation`` about -y (only ratios count) are attributes of the
        graph's nodes; contacts carry their forces, on the block that comes second.
        """
        from trilith._drawing import write_compas

        write_compas(self, path, method, head_joints)

    def scene(self, *, push: str = "", head_joints: str = "") -> Any:
        """Blocks, joints and loads as arrays, as an outside method gets them: a `Scene`.

        Args:
            push: ``"right"`` or ``"left"``; the case's first direction if left out.
            head_joints: ``"contact"`` or ``"open"``; the case's first setting if left out.
        """
        from trilith._scene import export

        return export(self, push=push, head_joints=head_joints)


def _replaced(text: str, keys: Mapping[str, Any]) -> str:
    """The text of a case file with other values at its top level."""
    top, header, rest = re.split(r"(?m)(^\s*\[|\Z)", text, maxsplit=1)
    for key, value in keys.items():
        line = _toml.document({key: value})
        found = re.compile(rf"(?m)^\s*{re.escape(key)}\s*=.*\n?")
        if "\n[[" in f"\n{line.strip()}":
            raise CaseError(f"`{key}` is a list of tables: change it in the file")
        old = found.search(top)
        top = top[: old.start()] + line + top[old.end() :] if old else line + top
    return f"{top}{header}{rest}"


class Wall(Case):
    """A coursed wall on rigid ground, of units in courses.

    Args:
        courses: strings from bottom to top: ``1`` is a unit, ``h`` half a unit, ``q`` a quarter,
            ``g`` a gap one unit wide; or a number of courses, with ``bond`` and ``units``.
        unit: length, height and weight of a full unit; the weight, on which λ does not depend, is 1
            if left out. Or a dictionary as in a case file.
        friction: coefficient of friction (the tangent of the friction angle) of every joint, or
            ``{"bed": 0.65, "head": 0.4, "base": 0.5}``.
        name: what results call it.
        keys: any other key of a case file: ``head_joints="both"``, ``push="both"``,
            ``overburden=0.5``, ``pieces={"L": {"units": 3}}``, ``load=[{...}]``,
            ``heights=[0.2, 0.3]`` of the courses, ``joints=[{"course": 3, "friction": 0.3}]``,
            ``open_head_joints=[2]``, ``live={"weight": [1, 0.3]}``;
            ``trilith.template("wall")`` explains them all.
    """

    def __init__(
        self,
        courses: Sequence[str] | int,
        unit: Sequence[float] | Mapping[str, float],
        friction: float | Mapping[str, float],
        *,
        name: str = "wall",
        **keys: Any,
    ) -> None:
        if not isinstance(unit, Mapping):
            sizes = plain(unit)
            if not isinstance(sizes, list) or len(sizes) not in (2, 3):
                raise CaseError(
                    f"unit={unit!r}: write unit=(length, height) or (length, height, weight)"
                )
            unit = dict(zip(("length", "height", "weight"), [*sizes, 1.0][:3]))
        super().__init__({"unit": unit, "courses": courses, "friction": friction, **keys}, name=name)


class Arch(Case):
    """A circular voussoir arch of constant thickness on fixed springers.

    Its voussoirs weigh what true annular sectors weigh; `Blocks` with the same corners are polygons,
    whose weights and centroids are others. Of 7 voussoirs over 157.5 degrees, 1.5 thick at a radius of
    10, they are 2.6 % lighter and λ is 1.0 % higher.

    Args:
        mean_radius: radius of the middle of the ring.
        thickness: of the ring.
        embrace: angle from springer to springer in degrees; 180 is a semicircle.
        voussoirs: how many.
        friction: coefficient of friction (the tangent of the friction angle).
        specific_weight: weight over the area of the elevation.
        name: what results call it.
        keys: any other key of a case file; ``trilith.template("arch")`` explains them all.
    """

    def __init__(
        self,
        mean_radius: float,
        thickness: float,
        embrace: float,
        voussoirs: int,
        friction: float | Mapping[str, float],
        *,
        specific_weight: float | None = None,
        name: str = "arch",
        **keys: Any,
    ) -> None:
        ring = {
            "mean_radius": mean_radius,
            "thickness": thickness,
            "embrace": embrace,
            "voussoirs": voussoirs,
            "specific_weight": specific_weight,
        }
        super().__init__({"friction": friction, "arch": ring, **keys}, name=name)


class Blocks(Case):
    """Rigid blocks of any shape; edges that touch are joints.

    Args:
        polygons: outlines, each a list or an array of corners [x, y] in order round it, either way,
            or a Shapely polygon; in a dictionary, each under its name.
        supports: what never moves: outlines as above, or names (of a list: places from 0) of
            ``polygons``.
        friction: coefficient of friction (the tangent of the friction angle) of every joint, or
            ``{"bed": 0.65, "head": 0.4, "base": 0.5}``.
        weights: weight of each of ``polygons`` in their order; if left out, its area times
            ``specific_weight`` and ``thickness`` of ``blocks``, which are 1.
        specific_weights: of each of ``polygons`` in their order, or by name; None, or a name that is
            left out, for that of ``blocks``.
        frictions: coefficients of friction of single blocks in the same way; of two blocks the
            smaller one counts.
        name: what results call it.
        keys: any other key of a case file: ``push="both"``, ``load=[{"block": "2", ...}]``,
            ``blocks={"thickness": 0.3}``, ``overburden=0.5``,
            ``joints=[{"between": ["0", "1"], "friction": 0.3}]``; ``trilith.template("blocks")`` explains them all. Blocks
            of a list are named by their places: "0", "1", ...
    """

    def __init__(
        self,
        polygons: Mapping[str, Any] | Sequence[Any],
        supports: Mapping[str, Any] | Sequence[Any],
        friction: float | Mapping[str, float],
        *,
        weights: Iterable[float] | None = None,
        specific_weights: Iterable[float | None] | Mapping[str, float] | None = None,
        frictions: Iterable[float | None] | Mapping[str, float] | None = None,
        name: str = "blocks",
        **keys: Any,
    ) -> None:
        outlines = _named(polygons)
        held: set[str] = set()
        fixed: dict[str, Any] = {}
        if isinstance(supports, Mapping):
            fixed = dict(supports)
        else:
            for place, one in enumerate(plain(list(supports))):
                if isinstance(one, (str, int)):
                    if str(one) not in outlines:
                        raise CaseError(f"supports: there is no polygon named `{one}`")
                    held.add(str(one))
                else:
                    fixed[f"support {place + 1}"] = one
        own = {
            "weight": _each(weights, outlines, "weights"),
            "specific_weight": _each(specific_weights, outlines, "specific_weights"),
            "friction": _each(frictions, outlines, "frictions"),
        }
        blocks = [
            {
                "name": label,
                "corners": _corners(label, shape),
                **{key: values[label] for key, values in own.items()},
            }
            for label, shape in outlines.items()
            if label not in held
        ]
        stays = {**{label: outlines[label] for label in outlines if label in held}, **fixed}
        support = [{"name": n, "corners": _corners(n, shape)} for n, shape in stays.items()]
        super().__init__({"friction": friction, **keys, "support": support, "block": blocks}, name=name)


def _named(polygons: Any) -> dict[str, Any]:
    if isinstance(polygons, Mapping):
        return {str(name): shape for name, shape in polygons.items()}
    return {str(place): shape for place, shape in enumerate(polygons)}


def _each(values: Any, outlines: Mapping[str, Any], what: str) -> dict[str, Any]:
    """The value of every polygon by its name, of values in their order or by name."""
    if isinstance(values, Mapping):
        for name in values:
            if str(name) not in outlines:
                raise CaseError(f"{what}: there is no polygon named `{name}`")
        given = {str(name): value for name, value in plain(dict(values)).items()}
    elif values is not None:
        listed = plain(list(values))
        if len(listed) != len(outlines):
            raise CaseError(f"{len(listed)} {what} of {len(outlines)} polygons")
        given = dict(zip(outlines, listed))
    else:
        given = {}
    return {name: given.get(name) for name in outlines}


def _corners(name: str, shape: Any) -> list[list[float]]:
    """The corners of an outline; a ring of Shapely ends where it begins."""
    ring = getattr(shape, "exterior", None)
    if ring is not None and list(getattr(shape, "interiors", ())):
        raise CaseError(f"polygon `{name}` has a hole: cut it into blocks without")
    points = plain(list(ring.coords)) if ring is not None else plain(shape)
    if ring is not None and len(points) > 1 and points[0] == points[-1]:
        points = points[:-1]
    if not isinstance(points, list) or not all(isinstance(p, list) and len(p) == 2 for p in points):
        raise CaseError(f"polygon `{name}`: write its corners as [x, y], [x, y], ...")
    return points
