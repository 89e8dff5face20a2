#!/usr/bin/env python3
"""Recomputes reference values from the case files alone: all of kind `independent`, and of the published ones those
that a linear program decides.

    python3 -m pip install numpy scipy        (Python 3.11 or later)
    tests/reference/recompute.py cases [--only PATTERN] [--skip paper-3] [--starts 100] [--jobs 2]

Scenes are laid by `lay.py` and solved by `limit.py` with SciPy's HiGHS; the macro-block range is `closed_form.py`;
nothing of trilith is used. Prints a line a value: case, method, quantity, what the case cites, what comes out here,
the difference, the most it may be, and a verdict. Exit status 1 where a value differs, a lower collapse state than
the cited one is found or a value cannot be recomputed here; 2 where a case cannot be read.

What stands for what: `associative` is the largest multiplier of Coulomb's law; of the states without dilatancy,
`lower` is the lowest found, `upper` the highest, `lambda` both; the pushover is held against the lowest, and may be
off by its tolerance, but the value that it is held against may not: at most 1e-5 for all. `at_rest` is 1 where forces
hold the dead load. A case pushed both ways is as strong as its weaker side. The search is by chance, with a fixed
seed: it confirms a lowest state by finding it, and refutes it by a lower one.
"""
import argparse
import sys
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from fnmatch import fnmatch
from pathlib import Path

import numpy as np

from closed_form import macro_block
from falls import letter
from geometry import read_case, tomllib
from lay import scene, settings
from limit import Wall, states
from moves import supported

EXACT = 1e-5  # most difference of any value, whatever a result may be off
BY_PROGRAM = (("associative",), ("at_rest",))  # what one linear program decides
LARGE, FEW = 800, 2  # joints from which on a search has so few starts


def wanted(reference):
    """Which numbers of a scene, or of the closed form, stand for a reference."""
    method, quantity = reference["method"], reference["quantity"]
    if quantity == "at_rest" and method != "macro-block":
        return ("at_rest",)
    if method == "macro-block" and quantity in ("lower", "upper", "tan_beta"):
        return (quantity,)
    if method == "associative" and quantity in ("lambda", "lower", "upper", "reaction"):
        return ("associative",)
    if method == "pushover" and quantity in ("lambda", "reaction"):
        return ("lowest",)
    if method == "interval":
        both = ("lowest", "highest")
        return {"lower": ("lowest",), "upper": ("highest",), "lambda": both, "reaction": both}.get(quantity, ())
    return ()


def numbers(file, head_joints, needs, many):
    """The numbers of a setting of a case by name; of both directions of the push the smaller ones."""
    if "move" in file:
        return reactions(file, head_joints, needs, many)
    sides = []
    for push in settings(file)[1]:
        laid, side = scene(file, head_joints, push), {}
        wall = Wall(laid)
        if "at_rest" in needs:
            side["at_rest"] = {"s": 1.0, "f": 0.0}.get(letter(laid), float("nan"))
        if "associative" in needs:
            top = wall.associative()
            side["associative"] = float("nan") if top is None else -top.fun
        if needs & {"lowest", "highest"}:
            found = states(wall, many if wall.m < LARGE else min(many, FEW))
            side["lowest"], side["highest"], side["met"] = found or (float("nan"),) * 3
        sides.append(side)
    # A NaN of one side is one of the case.
    return {name: float(np.min([side[name] for side in sides])) for name in sides[0]}


def reactions(file, head_joints, needs, many):
    """The same of a support that moves: its reactions. What the pushover is held against is the one reached first."""
    laid, end = supported(file, head_joints, settings(file)[1][0])
    start, sign = laid["support"]["start"], laid["support"]["sign"]
    found = states(Wall(laid), many) if needs & {"lowest", "highest"} else None
    first, last, met = found or (float("nan"),) * 3
    return {"associative": end, "lowest": start + sign * first, "highest": start + sign * last, "met": met}


def work(task):
    """(numbers of a setting, seconds)"""
    path, head_joints, needs, many = task
    began = time.process_time()
    file = read_case(path)
    out = macro_block(file) if head_joints is None else numbers(file, head_joints, needs, many)
    return out, time.process_time() - began


def verdict(reference, names, found):
    """What comes out, how far the farthest of it is from the cited value, and a word."""
    cited, limit = reference["value"], reference["tolerance"]
    if reference["kind"] == "independent":
        limit = min(limit, EXACT)
    values = [found[name] for name in names]
    value = max(values, key=lambda value: abs(value - cited))
    difference = value - cited
    if abs(difference) <= limit:  # a NaN is not
        return value, difference, limit, "ok"
    # A lower state refutes the value; one that is not found again only leaves it unconfirmed.
    word = "LOWER" if difference < 0 else "NOT FOUND" if difference > 0 else "DIFFERS"
    return value, difference, limit, word if names == ("lowest",) else "DIFFERS"


def tasks_of(path, file, many):
    """Settings to compute, each with the references that it is for."""
    jobs = {}
    for reference in file.get("references", []):
        published = reference["kind"] == "published" and "deviation" not in reference
        if reference["kind"] != "independent" and not (published and wanted(reference) in BY_PROGRAM):
            continue
        heads = [None] if reference["method"] == "macro-block" else \
            [reference["head_joints"]] if "head_joints" in reference else settings(file)[0]
        for head_joints in heads:
            jobs.setdefault(head_joints, []).append((reference, wanted(reference)))
    return [((path, head_joints, {name for _, names in held for name in names}, many), held)
            for head_joints, held in jobs.items()]


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("folder", type=Path)
    ask.add_argument("--only", default="*", help="names of cases, with * and ?")
    ask.add_argument("--skip", action="append", default=[], help="names of cases to leave out; can be repeated")
    ask.add_argument("--starts", type=int, default=100, help="starts of a search for collapse states (%(default)s)")
    ask.add_argument("--jobs", type=int, default=2, help="processes (%(default)s)")
    asked = ask.parse_args()
    if tomllib is None:
        sys.exit("Python 3.11 or later is needed to read case files")
    began, jobs, skipped = time.monotonic(), [], 0
    for path in sorted(asked.folder.rglob("*.toml")):
        if path.name.endswith(".sweep.toml") or not fnmatch(path.stem, asked.only):
            continue
        own = tasks_of(path, read_case(path), asked.starts)
        if any(fnmatch(path.stem, pattern) for pattern in asked.skip):
            skipped += len({id(reference) for _, held in own for reference, _ in held})
        else:
            jobs += own
    counts, seconds = Counter(), 0.0
    with ProcessPoolExecutor(asked.jobs) as pool:
        for (task, held), (found, spent) in zip(jobs, pool.map(work, [task for task, _ in jobs])):
            name = task[0].stem + ("@open" if task[1] == "open" else "")
            seconds += spent
            for reference, names in held:
                label = f"{name:<26} {reference['method']:<12} {reference['quantity']:<9} {reference['value']:<12.9g}"
                if names:
                    value, difference, limit, word = verdict(reference, names, found)
                    met = f" in {found['met']:.0f} starts" if "lowest" in names else ""
                    print(f"{label} {value:<12.9g} {difference:>9.1e} {limit:>8.1e} {word}{met}", flush=True)
                else:
                    word = "not recomputed here"
                    print(f"{label} {word}", flush=True)
                counts[word] += 1
    total = sum(counts.values())
    print(f"{total} values: " + ", ".join(f"{many} {word}" for word, many in counts.items())
          + f"; {skipped} skipped; {seconds:.0f} s of CPU in {time.monotonic() - began:.0f} s")
    return 0 if total and counts["ok"] == total else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, KeyError, ValueError) as why:
        print(f"cannot be recomputed: {why!r}", file=sys.stderr)
        sys.exit(2)
