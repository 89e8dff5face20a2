#!/usr/bin/env python3
"""Confirms what trilith claims from its output alone, and shares nothing with it.

    python3 -m pip install numpy
    trilith run FOLDER --states --format json > results.json
    tests/reference/judge.py results.json [--cases FOLDER] [--certificates FOLDER]

Every bound, collapse state, `falls` and `stands` in the output comes with forces and velocities.
This program recomputes from them what they are said to prove: equilibrium, Coulomb's law, flow
rules, complementarity, multipliers, the ends of the brackets; and the scene itself from its
polygons: centroids, loads, joints. With `--cases` it also lays the scenes again from the case
files (coursed walls, blocks with corners in the file or its CSV) and compares friction and weights.
With `--certificates` it proves lower bounds, and that scenes stand, again from the certificates that
`run --certificate` kept there, and demands that no collapse state of any method lies below them.
Prints a line for each claim that is refuted and a summary; exit status 1 where there is one, 2 where
the output cannot be read or says nothing.

Units: forces over the total weight W = sum |f_D|, lengths over the height of the blocks, velocities
so that the live load's power is its total sum |f_L|; multipliers as lambda* = lambda sum|f_L| / W.
Residuals may be 1e-8 so, and 1e-6 of the block's own largest force block by block.
"""
import argparse
import json
import sys
from collections import Counter
from pathlib import Path

import numpy as np

import certificate
import geometry

WHOLE, OWN, WIDTH = 1e-8, 1e-6, 1e-6
DIGITS = 1e-8  # numbers of rows have nine digits


class Refuted(Exception):
    """A claim does not hold; the text says which and by how much."""


def demand(holds, text):
    # Written so that a NaN refutes.
    if not holds:
        raise Refuted(text)


def within(value, limit, what):
    demand(value <= limit, f"{what} {value:.2e}, at most {limit:.0e}")


class Scene:
    """Arrays of an exported scene: blocks are rows, joints are rows."""

    def __init__(self, scene):
        blocks, joints = scene["blocks"], scene["joints"]
        self.centre = np.array([b["centroid"] for b in blocks], float).reshape(-1, 2)
        self.dead = np.array([b["dead"] for b in blocks], float).reshape(-1, 3)
        self.live = np.array([b["live"] for b in blocks], float).reshape(-1, 3)
        self.reach = np.array([np.hypot(*(np.array(b["corners"]) - b["centroid"]).T).max() for b in blocks])
        corners = np.concatenate([np.array(b["corners"], float) for b in blocks])
        self.height = np.ptp(corners[:, 1])
        loads = [load for b in blocks for load in b["loads"]]
        self.weight = sum(np.hypot(*load["dead"]) for load in loads)
        self.push = sum(np.hypot(*load["live"]) for load in loads)
        # A block's own largest load, for residuals block by block.
        self.own_dead = np.array([max((np.hypot(*load["dead"]) for load in b["loads"]), default=0) for b in blocks])
        self.own_live = np.array([max((np.hypot(*load["live"]) for load in b["loads"]), default=0) for b in blocks])
        # The ground is body -1, which index arithmetic turns into the last row of padded arrays.
        self.source = np.array([-1 if j["from_block"] is None else j["from_block"] for j in joints], int)
        self.to = np.array([j["to"] for j in joints], int)
        self.ends = np.array([j["ends"] for j in joints], float).reshape(-1, 2, 2)
        self.normal = np.array([j["normal"] for j in joints], float).reshape(-1, 2)
        self.tangent = np.column_stack([self.normal[:, 1], -self.normal[:, 0]])
        self.mu = np.array([j["friction"] for j in joints], float)
        self.blocks, self.joints = len(blocks), len(joints)

    def forces(self, rows):
        q = np.array(rows, float).reshape(-1, 3)
        demand(len(q) == self.joints, f"{len(q)} joints have forces, not {self.joints}")
        demand(np.isfinite(q).all(), "forces that are no numbers")
        return q

    def velocities(self, rows):
        u = np.array(rows, float).reshape(-1, 3)
        demand(len(u) == self.blocks, f"{len(u)} blocks have velocities, not {self.blocks}")
        demand(np.isfinite(u).all(), "velocities that are no numbers")
        return u

    def wrenches(self, q):
        """What the joints exert on every block: force and moment about its centroid."""
        total = np.zeros((self.blocks + 1, 3))
        centre = np.vstack([self.centre, [0.0, 0.0]])
        for end, size, way in ((0, q[:, 0], self.normal), (1, q[:, 1], self.normal), (0, q[:, 2], self.tangent)):
            force = size[:, None] * way
            for body, sign in ((self.to, 1.0), (self.source, -1.0)):
                arm = self.ends[:, end] - centre[body]
                moment = arm[:, 0] * force[:, 1] - arm[:, 1] * force[:, 0]
                np.add.at(total, body, sign * np.column_stack([force, moment]))
        return total[:-1]

    def rates(self, u):
        """Openings at both ends and slip of every joint."""
        padded, centre = np.vstack([u, np.zeros(3)]), np.vstack([self.centre, [0.0, 0.0]])

        def at(body, end):
            arm, motion = self.ends[:, end] - centre[body], padded[body]
            return motion[:, :2] + motion[:, 2:] * np.column_stack([-arm[:, 1], arm[:, 0]])

        moves = [at(self.to, end) - at(self.source, end) for end in (0, 1)]
        opening = np.column_stack([(move * self.normal).sum(1) for move in moves])
        return opening, (moves[0] * self.tangent).sum(1)

    def lighter(self, own):
        """The smaller of the measures of a joint's two bodies."""
        padded = np.append(own, np.inf)
        return np.minimum(padded[self.to], padded[self.source])

    def own(self, q, loads):
        """The largest force on every block: its loads, and what joints exert on it."""
        largest = np.append(loads, 0.0)
        for body in (self.to, self.source):
            np.maximum.at(largest, body, np.abs(q).max(1) if len(q) else np.zeros(0))
        return np.maximum(largest[:-1], 1e-300)

    def admissible(self, q, loads, own_loads, unit, friction=True):
        """Equilibrium with the loads, compression and Coulomb's law (or no shear at all)."""
        mu = self.mu if friction else 0.0
        balance = np.abs(self.wrenches(q) + loads)
        own = self.own(q, own_loads)
        sizes = np.column_stack([own, own, own * self.reach])
        within((balance / [unit, unit, unit * self.height]).max(), WHOLE, "equilibrium is violated by")
        within((balance / sizes).max(), OWN, "a block's own equilibrium is violated by")
        if not len(q):
            return
        excess = np.abs(q[:, 2]) - mu * (q[:, 0] + q[:, 1])
        for violation, what in ((-q[:, :2].min(1), "tension"), (excess, "shear beyond friction")):
            within(violation.max() / unit, WHOLE, what)
            within((violation / self.lighter(own)).max(), OWN, f"against a block's own forces, {what}")

    def at(self, q, multiplier):
        loads = self.dead + multiplier * self.live
        self.admissible(q, loads, np.maximum(self.own_dead, abs(multiplier) * self.own_live), self.weight)

    def ray(self, q, friction):
        self.admissible(q, self.live, self.own_live, self.push or self.weight, friction)

    def star(self, multiplier):
        """lambda*, with the least size that widths are measured against."""
        return max(abs(multiplier) * self.push / self.weight, 1e-3)

    def same(self, a, b, tolerance):
        """Whether two multipliers agree to a part of lambda*."""
        unit = self.push / self.weight if self.push else 1.0
        return abs(a - b) * unit <= tolerance * self.star(max(abs(a), abs(b)))

    def pushed(self, u):
        """Velocities on which the live load's power is its total."""
        power = (self.live * u).sum()
        demand(power > 0.0, f"the live load does no work on the mechanism: {power:.2e}")
        return u * (self.push / power)

    def flow(self, u):
        """The largest violation of opening >= mu |slip|."""
        opening, slip = self.rates(u)
        return (self.mu * np.abs(slip) - opening.min(1)).max(initial=0.0)

    def ceiling(self, u):
        """The multiplier of an admissible mechanism with dilatancy."""
        u = self.pushed(u)
        within(self.flow(u), WHOLE, "the flow rule opening >= mu |slip| is violated by")
        return -(self.dead * u).sum() / (self.live * u).sum()

    def collapse(self, q, u, multiplier):
        """A collapse state without dilatancy."""
        self.at(q, multiplier)
        u = self.pushed(u)
        opening, slip = self.rates(u)
        within(-opening.min(initial=0.0), WHOLE, "joints close by")
        idle = self.mu * (q[:, 0] + q[:, 1]) * np.abs(slip) + q[:, 2] * slip
        power = np.abs(q[:, :2] * opening).sum(1) + np.abs(idle)
        within(power.sum() / self.weight, WHOLE, "force at openings and slip below full friction:")
        # Virtual work of the whole state, which follows from the rest.
        work = (self.dead * u).sum() + multiplier * (self.live * u).sum()
        dissipated = (self.mu * (q[:, 0] + q[:, 1]) * np.abs(slip)).sum()
        within(abs(work - dissipated) / self.weight, 10 * WHOLE * self.star(multiplier) / 1e-3,
               "work of the loads and dissipation differ by")

    def fall(self, u):
        work = (self.dead * u).sum()
        demand(work > 0.0, f"the dead load does no work on the mechanism: {work:.2e}")
        within(self.flow(u * (self.weight / work)), WHOLE, "the flow rule opening >= mu |slip| is violated by")


# Methods whose claims are about friction without dilatancy, where a ray needs no friction.
WITHOUT_DILATANCY = {"interval", "sequential", "auto", "bound"}
# Methods whose lower end is a proved bound, and whose upper end is a collapse state.
BOUNDED = {"bound"}
# Methods that may prove by a certificate that a scene stands although its ray needs friction.
CERTIFYING = {"interval", "auto", "bound"}
# What proves a status. An `enclosed` answer of `auto` may be undecided: its ends are proved, the multiplier is not unique.
PROOFS = {"verified": {"associative", "collapse-state", "enclosed"}, "stands": {"stands", "stands-without-dilatancy"},
          "falls": {"falls"}}


def multiplier(answer, side, end):
    value = answer["lambda"]
    demand(value is not None and value == side[end], f"lambda {value} is not the {end} end {side[end]}")
    return value


def confirm_associative(scene, side, answers):
    (answer,) = answers
    scene.at(scene.forces(answer["forces"]), multiplier(answer, side, "lower"))
    above = scene.ceiling(scene.velocities(answer["velocities"]))
    demand(scene.same(above, side["upper"], 1e-9), f"the mechanism's multiplier is {above}, not {side['upper']}")
    ordered(scene, side)


def ordered(scene, side):
    lower, upper = side["lower"], side["upper"]
    demand(lower <= upper or scene.same(lower, upper, 1e-9), f"lower end {lower} above upper end {upper}")
    if side["status"] == "verified":
        demand(scene.same(lower, upper, WIDTH), f"verified, but {lower} and {upper} are apart")


def confirm_states(scene, side, answers):
    lambdas = [answer["lambda"] for answer in answers]
    for answer in answers:
        try:
            scene.collapse(scene.forces(answer["forces"]), scene.velocities(answer["velocities"]), answer["lambda"])
        except Refuted as why:
            raise Refuted(f"state at {answer['lambda']}: {why}") from why
    for end in ("lower", "upper"):
        demand(side[end] in lambdas, f"no state at the {end} end {side[end]}: {lambdas}")
    demand(side["lower"] == min(lambdas), f"a state at {min(lambdas)} lies below the lower end {side['lower']}")
    demand(side["upper"] == max(lambdas), f"a state at {max(lambdas)} lies above the upper end {side['upper']}")


def confirm_bounded(scene, side, answers):
    """The lowest state at the upper end. The certificate, a file of its own, proves the lower end."""
    (answer,) = answers
    scene.collapse(scene.forces(answer["forces"]), scene.velocities(answer["velocities"]),
                   multiplier(answer, side, "upper"))
    ordered(scene, side)


def confirm_enclosed(scene, side, answers):
    (answer,) = answers
    scene.collapse(scene.forces(answer["forces"]), scene.velocities(answer["velocities"]),
                   multiplier(answer, side, "lower"))
    above = scene.ceiling(scene.velocities(answer["ceiling"]))
    demand(above <= side["upper"] or scene.same(above, side["upper"], 1e-9),
           f"the ceiling's multiplier {above} is above {side['upper']}")
    ordered(scene, side)


def confirm_stands(scene, side, answers, friction=True):
    (answer,) = answers
    scene.at(scene.forces(answer["forces"]), 0.0)
    scene.ray(scene.forces(answer["ray"]), friction)


def confirm_falls(scene, side, answers):
    (answer,) = answers
    scene.fall(scene.velocities(answer["velocities"]))


CONFIRM = {
    "associative": confirm_associative,
    "collapse-state": confirm_states,
    "bounded": confirm_bounded,
    "enclosed": confirm_enclosed,
    "stands": confirm_stands,
    "stands-without-dilatancy": lambda *claim: confirm_stands(*claim, friction=False),
    # The certificate, a file of its own, proves that nothing collapses without dilatancy.
    "certified": confirm_stands,
    "falls": confirm_falls,
}


def kind_of(method, kind):
    """What a claim is confirmed as: of a lower bound, the state is at the upper end, and a ray may need friction."""
    if method in BOUNDED and kind == "collapse-state":
        return "bounded"
    return "certified" if method in CERTIFYING and kind == "stands" else kind


def judge_side(row, side, counts):
    """Confirms the claims of one row for one direction of the push."""
    status, method = side["status"], row["method"]
    answers = [a for a in side["answers"] if a["kind"] not in ("estimate", "undecided", "not-applicable")]
    kinds = {answer["kind"] for answer in answers}
    if method == "pushover" and status == "falls" and not any(a.get("velocities") for a in answers):
        counts["observed"] += 1
        return
    if method in BOUNDED and status == "bracketed":
        demand(kinds == {"collapse-state"}, f"bracketed by a state, but {sorted(kinds) or 'nothing'}")
    if status in PROOFS:
        demand(kinds & PROOFS[status], f"{status} without a proof, but {sorted(kinds) or 'nothing'}")
    demand(len(kinds) <= 1, f"claims of several kinds: {sorted(kinds)}")
    if status == "stands" and method in WITHOUT_DILATANCY - CERTIFYING:
        demand(kinds == {"stands-without-dilatancy"}, "stands without dilatancy, on a ray that needs friction")
    if status in ("stands", "falls"):
        demand(side["lower"] is None and side["upper"] is None, "a multiplier where there is none")
    if status == "failed":
        counts["failed"] += 1
    if not kinds:
        counts["nothing to confirm"] += 1
        return
    scene = Scene(side["scene"])
    kind = kind_of(method, *kinds)
    CONFIRM[kind](scene, side, answers)
    counts[kind] += 1


def read(row, side, end):
    """An end of a side as the row has it: of a support that moves, of its reaction."""
    if "reaction" not in row:
        return side[end]
    start, away = row["reaction"]["start"], row["reaction"]["moves"] == "away"
    other = {"lower": "upper", "upper": "lower"}[end]
    return start - side[other] if away else start + side[end]


def judge_wall(row):
    """The row's own range and status follow from its sides: the least of either end."""
    own, sides = row["sides"][0], row["sides"]
    demand(row["push"] == own["push"], f"row pushed {row['push']}, side {own['push']}")
    unknown = [side for side in sides if side["lower"] is None and side["status"] != "stands"]
    for end in ("lower", "upper"):
        known = [read(row, side, end) for side in sides if side[end] is not None]
        holds = known and own["status"] != "falls" and (end == "upper" or not unknown)
        mine, exact = row[end], min(known) if holds else None
        demand((mine is None) == (exact is None), f"{end} end {mine} in the row, {exact} in the sides")
        # Bounds are rounded outwards, by up to one in the ninth digit.
        slack = 1e-300 + 1e-14 * abs(row.get("reaction", {}).get("start", 0.0))
        demand(mine is None or abs(mine - exact) <= 1.01 * DIGITS * abs(exact) + slack, f"{end} end {mine} is not {exact}")
    one = row["lower"] is not None and abs(row["upper"] - row["lower"]) <= WIDTH * max(abs(row["upper"]), 1e-3)
    statuses = {own["status"]}
    if len(sides) > 1 and not unknown:
        both_ends = {side["status"] for side in sides} - {"stands"}
        statuses |= both_ends | ({"verified"} if one and both_ends <= {"verified", "bracketed"} else {"bracketed"})
    demand(row["status"] in statuses, f"row {row['status']}, sides {[side['status'] for side in sides]}")


def judge_row(row, counts):
    """Lines about what is refuted in a row."""
    for index, side in enumerate(row["sides"]):
        try:
            if index == 0:
                judge_wall(row)
            judge_side(row, side, counts)
        except (Refuted, KeyError, TypeError, ValueError) as why:
            text = why if isinstance(why, Refuted) else f"cannot be read: {why!r}"
            yield f"{row['case']} {row['method']} pushed {side['push']}, {side['status']}: {text}"


def judge_relations(rows):
    """No verified collapse state lies above a verified lambda_A of the same scene, nor is a state without push."""
    sides = {}
    for row in rows:
        for side in row["sides"]:
            sides.setdefault((row["case"], side["push"]), []).append((row["method"], side))
    for (case, push), found in sides.items():
        tops = [s["upper"] for m, s in found if m == "associative" and s["status"] == "verified"]
        falls = {m for m, s in found if s["status"] == "falls"}
        for method, side in found:
            for answer in side["answers"]:
                if answer["kind"] in ("collapse-state", "enclosed"):
                    if any(answer["lambda"] > top + 1e-6 * max(abs(top), 1e-3) for top in tops):
                        yield f"{case} {method} pushed {push}: state at {answer['lambda']} above lambda_A {tops[0]}"
                    if "associative" in falls:
                        yield f"{case} {method} pushed {push}: state at {answer['lambda']} of a scene that falls"


def claim(row, side):
    """The bound that a certificate is to prove: infinite where no state is said to exist, 0 where nothing is claimed."""
    method, status, kinds = row["method"], side["status"], {answer["kind"] for answer in side["answers"]}
    if status == "stands":
        return np.inf if method in CERTIFYING and kinds == {"stands"} else 0.0
    return side["lower"] or 0.0 if method in BOUNDED and status not in ("estimate", "falls") else 0.0


def judge_certificates(rows, folder, counts, find=certificate.find):
    """What the certificates in a folder prove: all that is said to be, and nothing that a state contradicts. Without
    a folder lower bounds are taken as they are, and no scene stands by a certificate."""
    found = {}
    for row in rows:
        for side in row["sides"]:
            found.setdefault((row["case"], side["push"]), []).append((row, side))
    for (case, push), of_scene in found.items():
        where = f"{case} pushed {push}"
        if folder is None:
            if any(np.isinf(claim(*of)) for of in of_scene):
                yield f"{where}: it stands by a certificate, and no folder with certificates is named"
            continue
        claimed, proved = max((claim(*of) for of in of_scene), default=0.0), 0.0
        try:
            file = find(folder, *of_scene[0])
            if file is not None:
                # Of the same scene, which `judge` demands.
                proved = certificate.lower(Scene, *of_scene[0], file)
                claimed = max(claimed, file.lower)
                counts["certificates proved"] += 1
        except certificate.Unproved as why:
            yield f"{where}: its certificate proves nothing: {why}"
            continue
        # Written so that a NaN refutes.
        if not claimed <= proved * (1 + 1e-8):
            yield f"{where}: no state is said to lie below {claimed}, and {proved} is proved"
        for row, side in of_scene:
            for answer in side["answers"]:
                # States below 0 are of the other push.
                if answer["kind"] in ("collapse-state", "enclosed") and 0 <= answer["lambda"] < proved * (1 - WIDTH):
                    yield f"{where}: {row['method']} has a state at {answer['lambda']}, and none is below {proved}"


def judge(rows, folder=None, certificates=None):
    """Lines about everything that is refuted, and counts of what was looked at."""
    lines, counts, scenes = [], Counter(), {}
    for row in rows:
        lines += judge_row(row, counts)
        for side in row["sides"]:
            scenes.setdefault((row["case"], side["push"]), (side["scene"], []))[1].append(side["scene"])
    lines += judge_relations(rows)
    lines += judge_certificates(rows, certificates, counts)
    files = geometry.case_files(folder) if folder else {}
    for (case, push), (scene, all_alike) in scenes.items():
        where = f"{case} pushed {push}"
        if any(other != scene for other in all_alike):
            lines.append(f"{where}: methods got different scenes")
        scene, guided = geometry.at_rest(scene)
        file = files.get(case.split("@")[0])
        lines += [f"{where}: {line}" for line in [*guided, *geometry.violations(scene, file=file)]]
        if file is not None:
            laid = geometry.laid_again(file, scene)
            counts["scenes laid again"] += laid is not None
            lines += [f"{where}: {line}" for line in laid or []]
        counts["scenes"] += 1
    return lines, counts


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("results", nargs="+", help="what trilith printed")
    ask.add_argument("--cases", type=Path, help="folder of the case files, to lay the scenes again")
    ask.add_argument("--certificates", type=Path, help="folder of the certificates that `run` kept")
    asked = ask.parse_args()
    try:
        rows = [row for path in asked.results for row in json.loads(Path(path).read_text())]
        rows[0]["sides"]
    except (OSError, ValueError, LookupError, TypeError) as why:
        print(f"no results with states: {why!r}", file=sys.stderr)
        return 2
    lines, counts = judge(rows, asked.cases, asked.certificates)
    for line in lines:
        print(f"refuted: {line}")
    print(f"{len(rows)} rows: " + ", ".join(f"{count} {what}" for what, count in sorted(counts.items())))
    print(f"{len(lines)} refuted")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
