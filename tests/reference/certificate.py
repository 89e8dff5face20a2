"""Certificates of lower bounds: read from their files and proved again, for `judge.py`.

A certificate holds multipliers of an identity between all forces s = (1, lambda, n1, n2, t of every joint)
and all motions k = (velocities, forward slip of every joint), without dimensions:

    lambda (fL.u) - sigma (fL.u) = sum of M * (force condition * rate) + sum of B * (equilibrium * motion) + R

Every product of a force condition (n1, n2, mu N + t, mu N - t, 1, lambda - a, b - lambda) and a rate (openings,
both parts of slip, the power fL.u, what slips fall short of their bounds) is not negative in a collapse state with
a <= lambda <= b, and zero where a factor is said to be zero; equilibrium is zero. So the left side is at least R.
A slice without an upper end has -sigma ((1 + 2 lambda) fL.u + fD.u) on the left side, which is negative for every
motion that the push or the weight drives, and so excludes them all. This program multiplies the matrices out
in extended precision and bounds R over all that forces and motions can be.
"""
import zlib
from pathlib import Path

import numpy as np

TITLE = b"trilith lower bound, version 3\n"
EXACT = np.longdouble
FORCE, RATE = 0, 1


class Unproved(Exception):
    """A certificate does not prove what it is to prove."""


def find(folder, row, side):
    """The certificate of one side of a row; `None` where there is none."""
    path = Path(folder) / f"{row['case']}.{side['push']}.bound"
    return Certificate(path) if path.exists() else None


def guided(scene, away):
    """The exported scene without its guides, and the motion of its supports that move: x, y and rotation of each."""
    guides = [joint for joint in scene["joints"] if joint["class"] == "guide"]
    moving = sorted({joint["to"] for joint in guides})
    motions = []
    for block in moving:
        of_block = scene["blocks"][block]
        closed = []
        for joint in guides:
            if joint["to"] == block and joint["from_block"] is None:
                for end in joint["ends"]:
                    (x, y), normal = np.subtract(end, of_block["centroid"]), joint["normal"]
                    closed.append([*normal, x * normal[1] - y * normal[0]])
        motion = np.linalg.svd(closed)[2][-1]
        # On its own live load it does an equal share of the whole work, which is 1 where it moves away.
        work = np.dot(of_block["live"][:2], motion[:2]) * len(moving)
        motions.append(motion * (1 if away else -1) / work)
    plain = [joint for joint in scene["joints"] if joint["class"] != "guide"]
    return {**scene, "joints": plain}, np.array(motions).reshape(-1, 3)


def lower(scene_of, row, side, certificate):
    """What a certificate proves of one side of a row; `scene_of` reads an exported scene."""
    plain, moving = guided(side["scene"], row.get("reaction", {}).get("moves") == "away")
    return Proof(scene_of(plain), moving, certificate).lower()


class Certificate:
    """The numbers of a file, in its order."""

    def __init__(self, path):
        data = Path(path).read_bytes()
        if not data.startswith(TITLE):
            raise Unproved("it is no certificate of version 3")
        try:
            self.rest = memoryview(zlib.decompress(data[len(TITLE):]))
        except zlib.error as why:
            raise Unproved(f"it is damaged: {why}") from why
        self.take(self.count())  # the scene's fingerprint: the identity itself tells another scene
        self.lower, self.cap = self.numbers(2)
        self.opening = self.list()
        self.longest_way = self.count() + 1
        self.slices = [Slice(self) for _ in range(self.count())]
        if self.rest:
            raise Unproved(f"{len(self.rest)} bytes too many")

    def take(self, length):
        taken, self.rest = self.rest[:length], self.rest[length:]
        if len(taken) < length:
            raise Unproved("it is cut off")
        return taken

    def count(self):
        return int(np.frombuffer(self.take(8), "<u8")[0])

    def numbers(self, many):
        return np.frombuffer(self.take(8 * many), "<f8")

    def list(self):
        """Numbers whose first bytes come first, then their second bytes and so on."""
        many = self.count()
        planes = np.frombuffer(self.take(8 * many), np.uint8).reshape(8, many)
        return np.ascontiguousarray(planes.T).view("<f8")[:, 0]


class Slice:
    def __init__(self, file):
        self.start, self.end, self.sigma = file.numbers(3)
        codes = [file.count() for _ in range(file.count())]
        self.assumed = tuple((code // 2, code % 2) for code in codes)
        self.multipliers, self.balance = file.list(), file.list()
        self.endless = np.isposinf(self.end)


class Conditions:
    """Of a scene without guides: equilibrium, rates and slip bounds as dense matrices.

    Supports that move are the last blocks, and have one velocity together: `moving` has the three of each.
    """

    def __init__(self, scene, moving, longest_way):
        self.scene, joints, height = scene, scene.joints, scene.height
        self.joints, self.mu, self.free = joints, scene.mu, scene.blocks - len(moving)
        self.velocities = 3 * self.free + (len(moving) > 0)
        # Velocities of all blocks by the unknown ones.
        self.unknown = np.eye(3 * scene.blocks, self.velocities)
        if len(moving):
            self.unknown[3 * self.free:, -1] = (moving * [1, 1, height]).ravel()
        weight, push = scene.weight, scene.push
        unit = weight / push if weight and push and abs(weight / push - 1) > 1e-12 else 1.0
        self.unit = unit
        self.dead, self.live = ((loads / [1, 1, height] * factor / weight).ravel() @ self.unknown
                                for loads, factor in ((scene.dead, 1.0), (scene.live, unit)))
        self.opens = [self.row(j, scene.ends[j, e], scene.normal[j]) for j in range(joints) for e in (0, 1)]
        self.opens = np.array(self.opens).reshape(joints, 2, self.velocities)
        self.slips = np.array([self.row(j, scene.ends[j, 0], scene.tangent[j]) for j in range(joints)])
        motions = self.velocities + joints
        rates = np.zeros((4 * joints + 1, motions), EXACT)
        for j in range(joints):
            rates[4 * j:4 * j + 2, :self.velocities] = self.opens[j]
            rates[4 * j + 2:4 * j + 4, self.velocities + j] = 1
            rates[4 * j + 3, :self.velocities] = -self.slips[j]
        rates[-1, :self.velocities] = self.live
        self.bounds = [self.slip_bound(j, way) for j, way in self.chosen_ways(longest_way)]
        # What a slip falls short of its bound, and the rounding of the bound's shares.
        shares = np.zeros((len(self.bounds), len(rates)), EXACT)
        self.shares_wrong = np.zeros((len(self.bounds), motions))
        for index, (j, parts, wrong) in enumerate(self.bounds):
            shares[index, 4 * j + 2] -= 1
            for rate, share in parts:
                shares[index, rate] += share
            self.shares_wrong[index, :self.velocities] = np.abs(wrong)
        self.rates = np.vstack([rates, shares @ rates])
        self.equilibrium = np.zeros((self.velocities, 2 + 3 * joints), EXACT)
        self.equilibrium[:, 0], self.equilibrium[:, 1] = self.dead, self.live
        for j in range(joints):
            self.equilibrium[:, 2 + 3 * j:4 + 3 * j] = self.opens[j].T
            self.equilibrium[:, 4 + 3 * j] = self.slips[j]

    def arm(self, j, point, body):
        return (point - self.scene.centre[body]) / self.scene.height

    def row(self, j, point, direction):
        """The velocity of a joint's second body against its first, at a point and in a direction."""
        row = np.zeros(3 * self.scene.blocks)
        for body, sign in ((self.scene.source[j], -1.0), (self.scene.to[j], 1.0)):
            if body >= 0:
                x, y = self.arm(j, point, body)
                row[3 * body:3 * body + 3] = sign * np.array([*direction, x * direction[1] - y * direction[0]])
        return row @ self.unknown

    def by_rates(self):
        """Velocities by the rates of joints, three a joint and the power, along a tree of joints from the supports."""
        reached, rows = [-1, *range(self.free, self.scene.blocks)], []
        for body in reached:
            for j, (one, other) in enumerate(zip(self.scene.source, self.scene.to)):
                if body in (one, other) and (next_body := one + other - body) not in reached:
                    reached.append(next_body)
                    rows += [3 * j, 3 * j + 1, 3 * j + 2]
        if len(rows) < 3 * self.free:
            raise Unproved("a block hangs on nothing")
        if self.velocities > 3 * self.free:
            rows.append(3 * self.joints)
        of_joints = np.concatenate([self.opens, self.slips[:, None]], axis=1).reshape(-1, self.velocities)
        by_rates = np.zeros((self.velocities, 3 * self.joints + 1))
        by_rates[:, rows] = np.linalg.inv(np.vstack([of_joints, self.live])[rows])
        return by_rates

    def ways(self, j, length):
        """Ways of so many joints from a joint's first body to its second without it: joints with their sense."""
        source, to = self.scene.source, self.scene.to
        found = [([], [source[j]])]
        for step in range(1, length + 1):
            longer = []
            for way, through in found:
                for other in range(self.joints):
                    for body, next_body, sense in ((source[other], to[other], 1), (to[other], source[other], -1)):
                        fits = body == through[-1] and other != j and next_body not in through
                        if fits and (next_body == to[j]) == (step == length):
                            longer.append((way + [(other, sense)], through + [next_body]))
            found = longer
        return [way for way, _ in found]

    def chosen_ways(self, longest):
        chosen = []
        for j in range(self.joints):
            chosen += [(j, way) for way in sorted(self.ways(j, 1) + self.ways(j, 2), key=lambda way: way[0][0])]
        if longest > 2:
            have = {j for j, _ in chosen}
            for j in range(self.joints):
                if j not in have:
                    chosen += [(j, way) for way in self.ways(j, 3)[:1]]
        return chosen

    def slip_bound(self, j, way):
        """Rates that add to a forward slip with their shares, and what is left of the slip without them."""
        ends, normal, tangent = self.scene.ends, self.scene.normal, self.scene.tangent
        direction, parts, left = tangent[j], [], self.slips[j].astype(EXACT)
        for other, sense in way:
            across = (ends[other, 1] - ends[other, 0]) / self.scene.height
            lever = normal[other, 1] * across[0] - normal[other, 0] * across[1]
            x, y = (ends[j, 0] - ends[other, 0]) / self.scene.height
            turning = np.array([-y, x]) / lever
            # Motion of the other joint's sides against each other at this joint's first corner, by its rates.
            motions = [(self.opens[other, 0], normal[other] - turning), (self.opens[other, 1], turning),
                       (self.slips[other], tangent[other])]
            for kind, (row, motion) in enumerate(motions):
                share = sense * (direction[0] * motion[0] + direction[1] * motion[1])
                if abs(share) <= 1e-15:
                    continue
                left = left - EXACT(share) * row
                if share > 0:
                    parts.append((4 * other + kind, share))
                elif kind == 2:
                    parts.append((4 * other + 3, -share))
        return j, parts, left

    def force_conditions(self, start, end):
        """Rows over s: four a joint, 1, lambda - a and b - lambda (nothing without an end)."""
        rows = np.zeros((4 * self.joints + 3, 2 + 3 * self.joints), EXACT)
        for j in range(self.joints):
            at = 2 + 3 * j
            rows[4 * j, at] = rows[4 * j + 1, at + 1] = 1
            rows[4 * j + 2:4 * j + 4, at:at + 2] = self.mu[j]
            rows[4 * j + 2:4 * j + 4, at + 2] = 1, -1
        rows[-3, 0] = 1
        rows[-2, :2] = -start, 1
        if np.isfinite(end):
            rows[-1, :2] = end, -1
        return rows


def product(few, many):
    """A product of matrices in extended precision, where few entries of the first are not 0."""
    rows, columns = np.nonzero(few)
    total = np.zeros((few.shape[0], many.shape[1]), EXACT)
    np.add.at(total, rows, few[rows, columns][:, None] * many[columns])
    return total


class Proof:
    """What the slices of a certificate prove of a scene."""

    def __init__(self, scene, moving, certificate):
        self.file, self.of = certificate, Conditions(scene, moving, certificate.longest_way)
        conditions, of = (4 * self.of.joints + 3) * len(self.of.rates), self.of
        sizes = len(certificate.opening) == of.velocities and all(
            len(part.multipliers) == conditions and len(part.balance) == of.velocities * (of.velocities + of.joints)
            for part in certificate.slices)
        if not sizes:
            raise Unproved("its size is of another scene")
        if not certificate.cap >= 1:
            raise Unproved("it speaks of hardly any motion")
        self.forces_bounded()
        self.by_rates = np.abs(self.of.by_rates())

    def forces_bounded(self):
        """By the virtual work of a motion that opens every joint by more than mu |slip|."""
        motion = self.file.opening
        self.margin = (self.of.opens @ motion).min(1) - self.of.mu * np.abs(self.of.slips @ motion)
        if not self.margin.min(initial=1.0) > 1e-12 * np.abs(motion).max():
            raise Unproved("its motion does not open every joint, so that forces have no limit")
        self.work = -self.of.dead @ motion, abs(self.of.live @ motion)

    def identity(self, part):
        """|R|, by motion and force."""
        of, joints = self.of, self.of.joints
        many = len(of.rates), 4 * joints + 3
        multipliers = part.multipliers.reshape(many[1], many[0]).astype(EXACT)
        balance = part.balance.reshape(of.velocities, of.velocities + joints).astype(EXACT)
        zero = self.zeros(part)
        if not (np.isfinite(multipliers).all() and np.isfinite(balance).all() and np.isfinite(part.sigma)):
            raise Unproved("a number is not finite")
        if (multipliers < 0)[~zero].any():
            raise Unproved("a multiplier of a product that need not be zero is negative")
        left = np.zeros((of.velocities + joints, 2 + 3 * joints), EXACT)
        of_power, of_dead = ((-part.sigma, -2 * part.sigma), -part.sigma) if part.endless else ((-part.sigma, 1.0), 0.0)
        left[:of.velocities, 0] = of_power[0] * of.live.astype(EXACT) + of_dead * of.dead.astype(EXACT)
        left[:of.velocities, 1] = of_power[1] * of.live.astype(EXACT)
        combined = product(of.force_conditions(part.start, part.end).T, multipliers).T
        rest = np.abs(left - product(of.rates.T, combined) - product(of.equilibrium.T, balance).T)
        return rest + of.shares_wrong.T @ np.abs(combined[4 * joints + 1:])

    def zeros(self, part):
        """Which products are zero: in every collapse state, and by what the slice assumes."""
        joints = self.of.joints
        zero = np.zeros((4 * joints + 3, len(self.of.rates)), bool)
        zero[range(4 * joints), range(4 * joints)] = True
        self.no_rate = np.zeros(len(self.of.rates), bool)
        for pair, factor in part.assumed:
            if factor == RATE:
                self.no_rate[pair] = True
            else:
                zero[pair] = True
                # Only states with that slip are left, and they have none in the other direction.
                if pair % 4 > 1:
                    self.no_rate[pair ^ 1] = True
        zero[:, self.no_rate] = True
        return zero

    def slice(self, part):
        """What lambda is at least in the slice, for motions up to the cap."""
        rest, joints, of = self.identity(part), self.of.joints, self.of
        total = max(*self.work, 0.0) if part.endless else max(self.work[0] + part.end * self.work[1], 0.0)
        own = rest[:, 2:].reshape(-1, joints, 3)
        by_joint = (own[:, :, :2].max(2) + of.mu * own[:, :, 2]) / self.margin
        loads = rest[:, :2].max(1) if part.endless else rest[:, 0] + part.end * rest[:, 1]
        cost = loads + total * by_joint.max(1, initial=0.0)
        of_rates = cost[:of.velocities] @ self.by_rates
        needed = np.zeros(4 * joints + 1)
        needed[-1], of_joints = of_rates[-1], needed[:-1].reshape(joints, 4)
        # Either part of a slip is no more than both.
        of_joints[:] = of_rates[:-1].reshape(joints, 3)[:, [0, 1, 2, 2]]
        of_joints[:, 2] += cost[of.velocities:]
        one, above, below = part.multipliers.reshape(4 * joints + 3, -1)[-3:, :4 * joints + 1]
        absorbed = np.minimum(one, above) if part.endless else one + (part.end - part.start) * np.minimum(above, below)
        short = np.where(self.no_rate[:4 * joints + 1], 0.0, np.maximum(needed - absorbed, 0.0))
        # The power is 1; the rates of joints add up to no more than the cap.
        capped = short[:-1].max(initial=0.0)
        least = float(part.sigma - self.file.cap * capped - short[-1])
        if part.endless:
            return np.inf if least > 0 and capped == 0 and part.start == 0 else 0.0
        return least

    def lower(self):
        """No collapse state has 0 <= lambda below this."""
        parts = [(part, min(self.slice(part), part.end)) for part in self.file.slices]
        return float(self.together(parts, 0, 0.0) * self.of.unit)

    def together(self, parts, depth, lower):
        """Slices side by side, then both branches of the next assumption that they share."""
        for part, least in parts:
            if len(part.assumed) == depth:
                # It begins where another program found the one before it to end.
                if part.start > lower + 1e-9 * max(1.0, lower):
                    raise Unproved("a slice begins above what those before it prove")
                lower = max(lower, least)
        deeper = [(part, least) for part, least in parts if len(part.assumed) > depth]
        if not deeper:
            return lower
        pairs = {part.assumed[depth][0] for part, _ in deeper}
        if len(pairs) > 1:
            raise Unproved("branches that assume something of different products")
        branches = [[(part, least) for part, least in deeper if part.assumed[depth][1] == factor]
                    for factor in (FORCE, RATE)]
        return max(lower, min(self.together(branch, depth + 1, lower) for branch in branches))
