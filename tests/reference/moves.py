#!/usr/bin/env python3
"""Reactions of supports that move, from case files alone, by another form of the problem.

    python3 -m pip install numpy scipy        (Python 3.11 or later)
    tests/reference/scenes.py FOLDER 200 31 moves
    trilith run FOLDER --method associative interval --format json > results.json
    tests/reference/moves.py results.json --cases FOLDER

The program makes a block of the support and lets guides leave it one motion. Here nothing of the support is unknown: it
moves with a given velocity g, and the blocks follow with the velocities u of least -f_D.u, where every joint opens by at
least mu |slip|, against the support by its own velocity. That is the reaction's power: moved against the wall at a speed
of 1 it is the largest reaction, moved away the least one with its sign turned. Every reaction of a state without
dilatancy lies between the two. Prints a line for each answer that differs by more than 1e-6 of the weight, and a summary;
exit status 1 where there is one.
"""
import argparse
import json
import sys
from collections import Counter
from pathlib import Path

import numpy as np
import scipy.sparse as sp
from scipy.optimize import linprog

import bonds
import geometry
import lay

ALIKE = 1e-6
CONVERGED = 1e-3  # the sequential method lets joints carry a little more than friction


def supports_of(file):
    """Outline of every support by its name, in their order."""
    if "arch" in file:
        given = file["arch"]
        return dict(zip(("left", "right"), lay.arch({**file, "load": []})[1]))
    return {support["name"]: support["corners"] for support in file.get("support", [])}


def under(file, units):
    """Blocks of the lowest course on these pieces, and where their ground's middle is."""
    first, _, last = units.partition("-")
    length, height = file["unit"]["length"], file["unit"]["height"]
    block, x, blocks, ends = 0, 0.0, [], []
    for piece, (kind, part) in enumerate(bonds.rows(file)[0], 1):
        if kind != "g":
            if int(first) <= piece <= int(last or first):
                blocks.append(block)
                ends += [x, x + part * length]
            block += 1
        x += part * length
    return blocks, np.array([(min(ends) + max(ends)) / 2, -height / 2])


def velocities(file, laid):
    """Velocity away from the wall of the support's side of every joint, at both its ends."""
    names, rates = list(supports_of(file)), np.zeros((len(laid["joints"]), 2, 2))
    first = file["move"][0]
    for move in file["move"]:
        if "units" in move:
            support, (blocks, middle) = 0, under(file, move["units"])
        else:
            support, blocks = names.index(move["support"]), None
            middle = geometry.area_and_centroid(np.array(supports_of(file)[move["support"]], float))[1]
        speed = move.get("rate", 1.0) / first.get("rate", 1.0)
        direction = np.array(move["direction"], float) / np.hypot(*move["direction"])
        for k, joint in enumerate(laid["joints"]):
            if joint["from_support"] != support or (blocks is not None and joint["to"] not in blocks):
                continue
            if "about" not in move:
                rates[k] = speed * direction
                continue
            # The first support's middle moves at a speed of 1.
            turned = lambda arm: np.array([-arm[1], arm[0]])
            own = turned(middle - move["about"])
            if move is first:
                turning = np.sign(own @ direction) / np.hypot(*own)
            rates[k] = [turning * turned(np.subtract(end, move["about"])) for end in joint["ends"]]
    return rates


def moving(file, head_joints, push="right"):
    """The laid scene, loads of the push among the dead ones, and the velocities of the supports' sides."""
    laid = lay.scene({key: value for key, value in file.items() if key != "move"}, head_joints, push)
    pushed = file["move"][0].get("pushed", 0.0)
    for block in laid["blocks"]:
        block["dead"], block["live"] = block["dead"] + pushed * block["live"], np.zeros(3)
    return laid, velocities(file, laid)


def extreme(laid, rates, sign):
    """The largest reaction (sign 1) or the least (-1) of associative friction; infinite without a limit, NaN where
    nothing holds the blocks, None where the solver gave up."""
    blocks, joints = laid["blocks"], laid["joints"]
    size = max(np.ptp([corner for block in blocks for corner in block["corners"]], axis=0))
    weight = sum(np.hypot(*block["dead"][:2]) for block in blocks)
    rows, cols, vals, right = [], [], [], []

    def at(row, k, end, direction, factor):
        for body, side in ((joints[k]["from_block"], -1.0), (joints[k]["to"], 1.0)):
            if body is not None:
                arm = np.subtract(joints[k]["ends"][end], blocks[body]["centroid"]) / size
                for column, value in enumerate((*direction, arm[0] * direction[1] - arm[1] * direction[0])):
                    rows.append(row), cols.append(3 * body + column), vals.append(factor * side * value)

    for k, joint in enumerate(joints):
        moved = -sign * rates[k]  # velocity of the support's side
        for end in (0, 1):
            for way in (1.0, -1.0):
                # mu * way * (slip - g_t) - (opening - g_n) <= 0
                row, mu = len(right), way * joint["friction"]
                at(row, k, 0, joint["tangent"], mu)
                at(row, k, end, joint["normal"], -1.0)
                right.append(mu * moved[0] @ joint["tangent"] - moved[end] @ joint["normal"])
    cost = np.concatenate([-block["dead"] / weight / np.array([1, 1, size]) for block in blocks])
    system = sp.csr_matrix((vals, (rows, cols)), shape=(len(right), cost.size))
    found = linprog(cost, A_ub=system, b_ub=right, bounds=(None, None), method="highs",
                    options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
    # Without a motion of the blocks the support cannot move; without a limit of the cost nothing holds them.
    ends = {0: lambda: sign * found.fun * weight, 2: lambda: sign * np.inf, 3: lambda: np.nan}
    return ends.get(found.status, lambda: None)()


def supported(file, head_joints, push="right"):
    """The scene for `limit.py`, whose multiplier is the change of the reaction from the other end; and both ends."""
    laid, rates = moving(file, head_joints, push)
    sign = 1.0 if file["move"][0]["moves"] == "against" else -1.0
    end, start = (extreme(laid, rates, way) for way in (sign, -sign))
    of_joints = {}
    for k, joint in enumerate(laid["joints"]):
        if np.abs(rates[k]).any():
            # What acts on the block acts on the support the other way.
            for kind, (at, direction) in enumerate(((0, "normal"), (1, "normal"), (0, "tangent"))):
                of_joints[k, kind] = -rates[k][at] @ joint[direction]
    return {**laid, "support": {"rates": of_joints, "start": start, "sign": sign}}, end


def compared(row, file):
    """What is wrong with an answer, or a word for what it is."""
    heads = row["case"].endswith("@open")
    laid, rates = moving(file, "open" if heads else file.get("head_joints", "contact").replace("both", "contact"),
                         file.get("push", "right"))
    sign = 1.0 if file["move"][0]["moves"] == "against" else -1.0
    end, other = (extreme(laid, rates, way) for way in (sign, -sign))
    weight = sum(np.hypot(*block["dead"][:2]) for block in laid["blocks"])
    lower, upper = row["lower"], row["upper"]
    if end is None or other is None:
        return None, "not solved here"
    if np.isnan(end) or np.isnan(other):
        return None if lower is None else f"[{lower}, {upper}], and nothing holds it", "falls"
    if lower is None:
        unlimited = row["status"] == "stands" and (not np.isfinite(end) or row["method"] != "associative")
        return None if unlimited or row["status"] == "undecided" else f"{row['status']}, and the end is {end}", row["status"]
    if row["method"] == "associative":
        wrong = max(abs(lower - end), abs(upper - end)) > ALIKE * max(weight, abs(end))
        return f"[{lower}, {upper}], and here {end}" if wrong else None, "compared"
    low, high = sorted((end, other))
    slack = (CONVERGED if row["method"] == "sequential" else ALIKE) * max(weight, abs(lower))
    outside = lower < low - slack or upper > high + slack
    return f"[{lower}, {upper}] outside of [{low}, {high}]" if outside else None, "inside"


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("results", type=Path)
    ask.add_argument("--cases", type=Path, required=True, help="folder of the case files")
    asked = ask.parse_args()
    files, counts, wrong = geometry.case_files(asked.cases), Counter(), 0
    for row in json.loads(asked.results.read_text()):
        file = files[row["case"].split("@")[0]]
        if "move" not in file or row["method"] not in ("associative", "interval", "sequential", "auto"):
            continue
        line, word = compared(row, file)
        counts[f"{row['method']} {word}"] += 1
        if line:
            wrong += 1
            print(f"differs: {row['case']} {row['method']} {row['status']}: {line}")
    print(", ".join(f"{count} {word}" for word, count in sorted(counts.items())) + f"; {wrong} differ")
    return 1 if wrong or not counts else 0


if __name__ == "__main__":
    sys.exit(main())
