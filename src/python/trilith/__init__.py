"""Limit analysis of dry-joint masonry: a thin module over the program trilith.

    import trilith
    wall = trilith.Wall(courses=["111", "h11h"] * 3, unit=(0.4, 0.2), friction=0.65)
    print(trilith.run(wall, methods=["interval", "pushover"], push="both").answer)

λ is the collapse multiplier: every block carries its weight W, and λ W sideways. The module writes
cases into a temporary folder, runs the program once, and reads what it answers; all that is computed
is computed there.
"""

from trilith._case import Arch, Blocks, Case, Wall
from trilith._drawing import Drawing
from trilith._errors import CaseError, ProgramError
from trilith._program import VERSION as __version__
from trilith._program import program
from trilith._read import library, load, read_compas, read_dxf, template
from trilith._result import Answer, Result, Side
from trilith._results import Results
from trilith._run import check, run
from trilith._scene import Scene
from trilith._solver import Solver, solver

__all__ = [
    "Answer",
    "Arch",
    "Blocks",
    "Case",
    "CaseError",
    "Drawing",
    "ProgramError",
    "Result",
    "Results",
    "Scene",
    "Side",
    "Solver",
    "Wall",
    "__version__",
    "check",
    "library",
    "load",
    "program",
    "read_compas",
    "read_dxf",
    "run",
    "solver",
    "template",
]
