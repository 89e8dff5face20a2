"""Limit analysis of rigid blocks with SciPy's HiGHS: the associative multiplier, and states without dilatancy.

Two corner forces n1, n2 >= 0 and a shear t a joint, |t| <= mu (n1 + n2), in equilibrium with f_D + lambda f_L;
total weight and largest extent are 1. A collapse state without dilatancy is a pair of forces and velocities u with
openings >= 0, no force where a joint opens, and full friction against the slip where it slips.
"""
import numpy as np
import scipy.sparse as sp
from scipy.optimize import linprog

WHOLE, OWN = 1e-8, 1e-6  # largest residual of a state; block by block in the block's own forces
MOVES = 1e-7
SAME = 1e-9
OPTIONS = {"primal_feasibility_tolerance": 1e-9, "dual_feasibility_tolerance": 1e-9}


class Wall:
    def __init__(self, scene):
        blocks, joints = scene["blocks"], scene["joints"]
        self.m = m = len(joints)
        corners = np.concatenate([np.array(b["corners"], float) for b in blocks])
        size = np.ptp(corners, axis=0).max()
        dead = np.array([b["dead"] for b in blocks], float)
        live = np.array([b["live"] for b in blocks], float)
        total = np.abs(dead[:, :2]).sum()
        self.dead, self.live = ((load / (total * np.array([1, 1, size]))).ravel() for load in (dead, live))
        self.mu = np.array([j["friction"] for j in joints], float)
        self.head = np.array([j["class"] == "head" for j in joints])
        rows, cols, vals = [], [], []
        for k, j in enumerate(joints):
            for body, sign in ((j["from_block"], -1.0), (j["to"], 1.0)):
                if body is None:
                    continue
                forces = ((j["ends"][0], j["normal"]), (j["ends"][1], j["normal"]), (j["ends"][0], j["tangent"]))
                for col, (p, d) in enumerate(forces):
                    arm = np.subtract(p, blocks[body]["centroid"]) / size
                    for row, v in enumerate((d[0], d[1], arm[0] * d[1] - arm[1] * d[0])):
                        if v:
                            rows.append(3 * body + row), cols.append(3 * k + col), vals.append(sign * v)
        if "support" in scene:
            # One equation more: what the joints exert on a support along its motion, its reaction and the change of it.
            for (k, kind), rate in scene["support"]["rates"].items():
                rows.append(3 * len(blocks)), cols.append(3 * k + kind), vals.append(rate)
            self.dead = np.r_[self.dead, -scene["support"]["start"] / total, 0.0, 0.0]
            self.live = np.r_[self.live, -scene["support"]["sign"] / total, 0.0, 0.0]
        self.A = sp.csr_matrix((vals, (rows, cols)), shape=(self.dead.size, 3 * m))
        self.E = sp.hstack([self.A, sp.csr_matrix(self.live[:, None])]).tocsr()
        k = np.arange(m)
        cap = sp.csr_matrix((np.r_[self.mu, self.mu], (np.r_[k, k], np.r_[3 * k, 3 * k + 1])), shape=(m, 3 * m + 1))
        shear = sp.csr_matrix((np.ones(m), (k, 3 * k + 2)), shape=(m, 3 * m + 1))
        self.coulomb = sp.vstack([shear - cap, -shear - cap]).tocsr()  # <= 0
        self.low, self.high = np.full(3 * m + 1, -np.inf), np.full(3 * m + 1, np.inf)
        self.low[3 * k] = self.low[3 * k + 1] = 0.0
        self.push = np.zeros(3 * m + 1)
        self.push[-1] = 1.0

    def program(self, cost, low, high, coulomb=None, tight=None):
        """Least cost over forces in equilibrium, within Coulomb's law unless the bounds are to hold it."""
        rows, right = self.E, -self.dead
        if tight is not None and tight.any():
            rows = sp.vstack([rows, coulomb[tight]])
            right = np.r_[right, np.zeros(tight.sum())]
            coulomb = coulomb[~tight]
        found = linprog(cost, A_ub=coulomb, b_ub=None if coulomb is None else np.zeros(coulomb.shape[0]), A_eq=rows,
                        b_eq=right, bounds=np.c_[low, high], method="highs-ds" if self.m < 800 else "highs-ipm",
                        options=OPTIONS)
        return found if found.status == 0 else None

    def normal(self, x):
        return x[0:-1:3] + x[1:-1:3]

    def associative(self, high=None):
        """Forces at the largest multiplier of Coulomb's law; it is their last entry."""
        return self.program(-self.push, self.low, self.high if high is None else high, self.coulomb)

    def statics(self, cost, multiplier):
        """Normal forces of least cost at a multiplier."""
        low, high = self.low.copy(), self.high.copy()
        low[-1] = high[-1] = multiplier
        found = self.program(cost, low, high, self.coulomb)
        return None if found is None else self.normal(found.x)

    def frozen(self, n):
        """The largest multiplier with frictions mu n: its forces, and its mechanism, which has no dilatancy."""
        low, high = self.low.copy(), self.high.copy()
        high[2:-1:3] = self.mu * np.maximum(n, 0.0)
        low[2:-1:3] = -high[2:-1:3]
        top = self.program(-self.push, low, high)
        if top is None:
            return None
        u = np.array(top.eqlin.marginals)
        power = u @ self.live
        return None if abs(power) < 1e-12 else (top.x, u / power)

    def extreme(self, u, sign):
        """The least (sign 1) or greatest (-1) multiplier of the Coulomb states that mechanism u collapses in."""
        rate = self.A.T @ u
        high = self.high.copy()
        high[0:-1:3][rate[0::3] > MOVES] = 0.0
        high[1:-1:3][rate[1::3] > MOVES] = 0.0
        tight = np.r_[rate[2::3] < -MOVES, rate[2::3] > MOVES]
        return self.program(sign * self.push, self.low, high, self.coulomb, tight)

    def confirmed(self, x, u):
        """Whether forces and mechanism are a collapse state, by their residuals."""
        n1, n2, t = x[0:-1:3], x[1:-1:3], x[2:-1:3]
        rate = self.A.T @ u
        cap, slip = self.mu * (n1 + n2), rate[2::3]
        balance = np.abs(self.E @ x + self.dead)
        whole = max(balance.max(), (np.abs(t) - cap).max(), -min(n1.min(), n2.min()), -rate[0::3].min(),
                    -rate[1::3].min(), np.abs(n1 * rate[0::3]).max(), np.abs(n2 * rate[1::3]).max(),
                    np.abs(t * slip + cap * np.abs(slip)).max())
        forces = abs(self.A.multiply(x[:-1])).max(axis=1).toarray().ravel()
        own = np.maximum.reduce([np.abs(self.dead), np.abs(self.live * x[-1]), forces]).reshape(-1, 3).max(axis=1)
        return whole <= WHOLE and (balance.reshape(-1, 3).max(axis=1) <= OWN * own).all()

    def blend(self, n, rounds=80):
        """From normal forces down to a collapse state: (multiplier, mechanism) or None.

        Where the mechanism of the frozen program has no Coulomb state, the frictions move half-way to the
        program's; where it has, they become those of its lowest state, as long as that falls.
        """
        best = None
        for _ in range(rounds):
            top = self.frozen(n)
            if top is None:
                return best
            x, u = top
            low = self.extreme(u, 1.0)
            if low is None:
                n = 0.5 * n + 0.5 * self.normal(x)
                continue
            if best is not None and low.fun > best[0] - SAME or not self.confirmed(low.x, u):
                return best
            best = (low.fun, u)
            n = self.normal(low.x)
        return best


def starts(wall, many, rng):
    """Normal forces to begin the blend with, of six kinds; a few of them as they are, then at random."""
    top = wall.associative()
    associative, above = wall.normal(top.x), top.x[-1]
    size = np.zeros(3 * wall.m + 1)
    size[0:-1:3] = size[1:-1:3] = 1.0
    rest = wall.statics(size, 0.0)
    high = wall.high.copy()
    high[0:-1:3][wall.head] = high[1:-1:3][wall.head] = 0.0
    opened = wall.associative(high)

    def vertex(part):
        cost = np.zeros(3 * wall.m + 1)
        cost[:-1] = rng.exponential(1.0, 3 * wall.m) + 0.5
        cost[2:-1:3] = 0.3 * rng.normal(0.0, 1.0, wall.m)
        found = wall.statics(cost, above * part)
        return associative if found is None else found

    centre = np.mean([vertex(0.9) for _ in range(4)], axis=0)
    first = [associative, rest, centre, None if opened is None else wall.normal(opened.x)]
    first = [n for n in first if n is not None]
    kinds = [lambda: associative * rng.uniform(0.1, 1.8, wall.m),
             lambda: centre * rng.uniform(0.1, 1.8, wall.m),
             lambda: first[1] * rng.uniform(0.1, 1.8, wall.m),
             lambda: vertex(rng.uniform(0.2, 0.6)),
             lambda: vertex(rng.uniform(0.6, 1.0)),
             lambda: associative * rng.uniform(0.1, 1.8, wall.m) * ~wall.head]
    for k in range(many):
        yield first[k] if k < len(first) else kinds[(k - len(first)) % len(kinds)]()


def states(wall, many, seed=14):
    """(lowest, highest, how many starts met the lowest) of the collapse states found, or None."""
    found = [state for n in starts(wall, many, np.random.default_rng(seed)) if (state := wall.blend(n)) is not None]
    if not found:
        return None
    lowest = min(state[0] for state in found)
    tops = (wall.extreme(u, -1.0) for u in {round(value, 7): u for value, u in found}.values())
    highest = max([state[0] for state in found] + [-top.fun for top in tops if top is not None])
    return lowest, highest, sum(state[0] < lowest + 1e-7 for state in found)
