#!/usr/bin/env python3
"""Which scenes fall under their own weight, by another code: SciPy's HiGHS.

    python3 -m pip install scipy
    TRILITH_SCENES=DIR cargo test --release --test pushover -- --ignored falling::export
    tests/reference/falls.py DIR/*.json

Least total of what is out of balance, every block's force and moment measured in its own weight:

    min sum |e|   s.t.   A q + f_D = W e,   n1, n2 >= 0,   |t| <= mu (n1 + n2)

It is 0 for scenes that stand; for one that falls the multipliers are a mechanism (|u| <= 1 in every
component), on which the dead load does as much work as the minimum. Prints `s`, `f`, or `?` where the
minimum is neither 0 nor beyond 1e-6, the residual block by block that a verified result may have. It shares nothing with the program but the scene.
"""
import json
import sys

import numpy as np
import scipy.sparse as sp
from scipy.optimize import linprog


def letter(scene):
    blocks, joints = scene["blocks"], scene["joints"]
    centre = np.array([block["centroid"] for block in blocks])
    dead = np.array([block["dead"] for block in blocks])
    size = [np.ptp(np.array(block["corners"]), axis=0).max() for block in blocks]
    weight = np.array([[w, w, w * s] for w, s in zip(np.hypot(dead[:, 0], dead[:, 1]), size)])
    rows, cols, vals = [], [], []
    for k, joint in enumerate(joints):
        normal, tangent, ends = joint["normal"], joint["tangent"], joint["ends"]
        # In units of the lighter body's weight, so that no column is out of scale.
        unit = min(weight[i, 0] for i in (joint["from_block"], joint["to"]) if i is not None)
        for body, sign in ((joint["from_block"], -1.0), (joint["to"], 1.0)):
            if body is None:
                continue
            for column, (p, d) in enumerate(((ends[0], normal), (ends[1], normal), (ends[0], tangent))):
                arm = np.subtract(p, centre[body])
                for row, value in enumerate((d[0], d[1], arm[0] * d[1] - arm[1] * d[0])):
                    if value:
                        rows.append(3 * body + row), cols.append(3 * k + column)
                        vals.append(sign * value * unit / weight[body, row])
    many, m = 3 * len(blocks), len(joints)
    balance = sp.csr_matrix((vals, (rows, cols)), shape=(many, 3 * m))
    elastic = sp.hstack([balance, sp.eye(many), -sp.eye(many)]).tocsr()
    mu = np.array([joint["friction"] for joint in joints])
    k = np.arange(m)
    cone = sp.csr_matrix((np.r_[-mu, -mu, np.ones(m), -mu, -mu, -np.ones(m)],
                          (np.r_[k, k, k, k + m, k + m, k + m], np.tile(np.r_[3 * k, 3 * k + 1, 3 * k + 2], 2))),
                         shape=(2 * m, 3 * m + 2 * many))
    low = np.zeros(3 * m + 2 * many)
    low[3 * k + 2] = -np.inf
    cost = np.r_[np.zeros(3 * m), np.ones(2 * many)]
    least = linprog(cost, A_ub=cone if m else None, b_ub=np.zeros(2 * m) if m else None, A_eq=elastic,
                    b_eq=-(dead / weight).ravel(), bounds=np.c_[low, np.full(low.size, np.inf)], method="highs-ds",
                    options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
    if least.status != 0:
        return "?"
    return "s" if least.fun < 1e-9 else "f" if least.fun > 1e-6 else "?"


if __name__ == "__main__":
    print("".join(letter(json.load(open(path))) for path in sys.argv[1:]))
