#!/usr/bin/env python3
"""The associative multiplier by SciPy's HiGHS: an external method for trilith.

    trilith run paper-1 --external highs="python3 tests/external/highs.py"

Reads a scene on standard input, writes forces and velocities on standard output. The dual values
of the equilibrium rows are the velocities of the blocks at collapse.
"""

import json
import sys

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix

TIGHT = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}


def program(scene):
    """A q + live * lambda = -dead in units of total weight and height, and B q <= 0."""
    blocks, joints = scene["blocks"], scene["joints"]
    heights = [y for block in blocks for _, y in block["corners"]]
    height = max(heights) - min(heights)
    weight = sum(np.hypot(*load["dead"]) for block in blocks for load in block["loads"])
    units = np.tile([weight, weight, weight * height], len(blocks))
    rows, columns, values = [], [], []
    for j, joint in enumerate(joints):
        ends, normal, tangent = joint["ends"], joint["normal"], joint["tangent"]
        parts = [(ends[0], normal), (ends[1], normal), (ends[0], tangent)]
        for k, (point, along) in enumerate(parts):
            for block, sign in ((joint["to"], 1.0), (joint["from_block"], -1.0)):
                if block is None:
                    continue
                x, y = np.subtract(point, blocks[block]["centroid"]) / height
                wrench = (along[0], along[1], x * along[1] - y * along[0])
                rows += [3 * block, 3 * block + 1, 3 * block + 2]
                columns += [3 * j + k] * 3
                values += [sign * part for part in wrench]
    live = np.concatenate([block["live"] for block in blocks]) / units
    dead = np.concatenate([block["dead"] for block in blocks]) / units
    last = 3 * len(joints)
    rows += list(range(len(live)))
    columns += [last] * len(live)
    values += list(live)
    equilibrium = coo_matrix((values, (rows, columns)), (len(live), last + 1)).tocsr()
    friction = np.array([joint["friction"] for joint in joints])
    first = np.arange(2 * len(joints))
    shear = np.repeat(3 * np.arange(len(joints)) + 2, 2)
    sign = np.tile([1.0, -1.0], len(joints))
    steep = np.repeat(friction, 2)
    limit = coo_matrix(
        (
            np.concatenate([sign, -steep, -steep]),
            (np.tile(first, 3), np.concatenate([shear, shear - 2, shear - 1])),
        ),
        (2 * len(joints), last + 1),
    ).tocsr()
    return equilibrium, -dead, limit, weight, height


def answer(scene):
    equilibrium, right, limit, weight, height = program(scene)
    count = len(scene["joints"])
    bounds = [(0, None), (0, None), (None, None)] * count + [(None, None)]
    cost = np.zeros(3 * count + 1)
    cost[-1] = -1.0
    found = linprog(
        cost, limit, np.zeros(2 * count), equilibrium, right, bounds, "highs-ds", options=TIGHT
    )
    if found.x is None:
        return {"kind": "undecided", "reason": found.message}
    velocities = -found.eqlin.marginals.reshape(-1, 3) / [1.0, 1.0, height]
    return {
        "kind": "associative",
        "lambda": found.x[-1],
        "forces": (found.x[:-1].reshape(-1, 3) * weight).tolist(),
        "velocities": velocities.tolist(),
    }


json.dump(answer(json.load(sys.stdin)), sys.stdout)
