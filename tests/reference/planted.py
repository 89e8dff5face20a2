#!/usr/bin/env python3
"""Plants faults in what trilith printed and demands that `judge.py` refutes every one.

    tests/reference/planted.py results.json [--cases FOLDER] [--certificates FOLDER]

Of each kind of claim up to 40 are taken; each must be confirmed as it is, and refuted with one force,
velocity, multiplier, end, status, ray, joint or load changed; up to 40 certificates with a number changed
or a slice left out.
"""
import argparse
import copy
import json
import sys
from collections import Counter
from pathlib import Path

import numpy as np

import certificate
import judge

OF_A_KIND = 40


def push_a_joint(row, side, answer):
    """A corner force more than equilibrium has room for."""
    forces = answer["forces"]
    forces[len(forces) // 2][0] += 1e-5 * judge.Scene(side["scene"]).weight


def pull_a_joint(row, side, answer):
    """Tension where there is least compression, or shear beyond friction."""
    forces = answer["forces"]
    least = min(range(len(forces)), key=lambda j: min(forces[j][:2]))
    forces[least][int(forces[least][1] < forces[least][0])] -= 1e-4 * judge.Scene(side["scene"]).weight


def spoil_the_ray(row, side, answer):
    scene = judge.Scene(side["scene"])
    answer["ray"][0][1] += 1e-5 * (scene.push or scene.weight)


def turn_the_mechanism(row, side, answer):
    answer["velocities"] = [[-v for v in motion] for motion in answer["velocities"]]


def close_a_joint(row, side, answer, key="velocities"):
    """The block of the joint that can least bear it moves into the other body."""
    scene = judge.Scene(side["scene"])
    u = np.array(answer[key])
    opening, slip = scene.rates(u)
    fastest = np.abs(u[:, :2]).max() + (np.abs(u[:, 2]) * scene.reach).max()
    joint = int((opening.min(1) - scene.mu * np.abs(slip)).argmin())
    answer[key][scene.to[joint]][:2] = (u[scene.to[joint], :2] - 1e-2 * fastest * scene.normal[joint]).tolist()


def spoil_the_ceiling(row, side, answer):
    close_a_joint(row, side, answer, "ceiling")


def raise_the_multiplier(row, side, answer):
    """Everywhere alike, so that only statics can tell."""
    old = answer["lambda"]
    new = old * (1 + 1e-4) + 1e-4
    answer["lambda"] = new
    for where in (side, row):
        for end in ("lower", "upper"):
            if abs(where[end] - old) <= 1e-6 * abs(old) + 1e-9:
                where[end] = new


def raise_the_lower_end(row, side, answer):
    side["lower"] = row["lower"] = side["lower"] * (1 - 1e-4) - 1e-4


def raise_the_upper_end(row, side, answer):
    side["upper"] = row["upper"] = side["upper"] * (1 + 1e-4) + 1e-4


def other_row(row, side, answer):
    row["upper" if row["upper"] is not None else "push"] = 12345.0


def call_it_standing(row, side, answer):
    row["status"] = side["status"] = "stands"


def call_it_falling(row, side, answer):
    row["status"] = side["status"] = "falls"


def call_it_verified(row, side, answer):
    row["status"] = side["status"] = "verified"


def withhold(row, side, answer):
    side["answers"] = []


def turn_a_normal(row, side, answer):
    joint = side["scene"]["joints"][0]
    joint["normal"] = [-v for v in joint["normal"]]
    joint["tangent"] = [-v for v in joint["tangent"]]


def move_an_end(row, side, answer):
    joint = side["scene"]["joints"][-1]
    a, b = np.array(joint["ends"])
    joint["ends"][0] = (a + 1e-3 * (b - a)).tolist()


def forget_a_joint(row, side, answer):
    del side["scene"]["joints"][-1]
    for a in side["answers"]:
        for key in ("forces", "ray"):
            if a.get(key):
                del a[key][-1]


def hide_a_load(row, side, answer):
    block = side["scene"]["blocks"][0]
    block["loads"][0]["dead"][1] *= 1 + 1e-6


SCENE = [turn_a_normal, move_an_end, forget_a_joint, hide_a_load]
FAULTS = {
    "associative": [push_a_joint, pull_a_joint, turn_the_mechanism, close_a_joint, raise_the_multiplier,
                    raise_the_lower_end, raise_the_upper_end, other_row, call_it_standing, call_it_falling, withhold],
    "collapse-state": [push_a_joint, pull_a_joint, turn_the_mechanism, close_a_joint, raise_the_multiplier,
                       raise_the_lower_end, raise_the_upper_end, other_row, call_it_standing, call_it_falling, withhold],
    # A lower end that is lowered is still a bound, and needs no other proof.
    "bounded": [push_a_joint, pull_a_joint, turn_the_mechanism, close_a_joint, raise_the_multiplier,
                raise_the_upper_end, other_row, call_it_standing, call_it_falling, withhold],
    "enclosed": [push_a_joint, turn_the_mechanism, close_a_joint, spoil_the_ceiling, raise_the_multiplier,
                 other_row, call_it_standing, call_it_falling],
    "stands": [push_a_joint, spoil_the_ray, call_it_falling, call_it_verified, withhold],
    "certified": [push_a_joint, spoil_the_ray, call_it_falling, call_it_verified, withhold],
    "stands-without-dilatancy": [push_a_joint, spoil_the_ray, call_it_falling, call_it_verified, withhold],
    "falls": [turn_the_mechanism, close_a_joint, call_it_standing, call_it_verified, withhold],
    "nothing": [call_it_verified, call_it_standing],
}


def lower_sigma(file):
    """The multipliers then leave more than rounding; without an upper end they may absorb a little."""
    file.slices[0].sigma *= -1 if file.slices[0].endless else 0.999


def raise_sigma(file):
    part = file.slices[0]
    part.sigma = 3 * part.sigma if part.endless else 1.001 * part.sigma + 1e-3


def negative_multiplier(file):
    """The largest one: negative where it may not be, else the identity fails."""
    part = file.slices[0]
    part.multipliers = part.multipliers.copy()
    part.multipliers[part.multipliers.argmax()] *= -1


def spoil_the_balance(file):
    part = file.slices[0]
    part.balance = part.balance.copy()
    part.balance[np.abs(part.balance).argmax()] *= 1.001


def leave_a_slice_out(file):
    del file.slices[0]


def move_a_slice(file):
    file.slices[0].start += 1e-3


def turn_the_opening(file):
    file.opening = -file.opening


def cap_motions(file):
    file.cap = 1e-9


def claim_more(file):
    """A larger bound, or an end for a slice without one."""
    if np.isfinite(file.lower):
        file.lower *= 1.001
    else:
        file.slices[0].end, file.slices[0].endless = 1e9, False


CERTIFICATE = [lower_sigma, raise_sigma, negative_multiplier, spoil_the_balance, leave_a_slice_out, move_a_slice,
               turn_the_opening, cap_motions, claim_more]


def certificates(rows, folder, planted, missed):
    """Plants faults in certificates; how many were taken."""
    taken = 0
    for row in rows:
        side = row["sides"][0]
        file = certificate.find(folder, row, side)
        if file is None or judge.claim(row, side) == 0.0 or taken >= OF_A_KIND or len(file.opening) > 100:
            continue
        if any(judge.judge_certificates([row], folder, Counter())):
            continue  # refuted as it is; judge.py says so
        taken += 1
        for fault in CERTIFICATE:
            changed = certificate.find(folder, row, side)
            fault(changed)
            one = {**row, "sides": [side]}
            planted[fault.__name__] += 1
            if not any(judge.judge_certificates([one], folder, Counter(), lambda *_: changed)):
                missed.append(f"{row['case']} certificate: {fault.__name__}")
    return taken


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("results", nargs="+")
    ask.add_argument("--cases", type=Path)
    ask.add_argument("--certificates", type=Path)
    asked = ask.parse_args()
    rows = [row for path in asked.results for row in json.loads(Path(path).read_text())]
    taken, planted, missed = Counter(), Counter(), []
    for row in rows:
        answer = next(iter(row["sides"][0]["answers"]), None)
        kind = answer["kind"] if answer else "nothing"
        kind = "nothing" if kind == "estimate" else judge.kind_of(row["method"], kind)
        if kind not in FAULTS or taken[kind] >= OF_A_KIND or len(row["sides"][0]["scene"]["blocks"]) > 200:
            continue
        # That a scene stands is proved by its certificate alone.
        proofs = asked.certificates if kind == "certified" else None
        if judge.judge([row], certificates=proofs)[0]:
            continue  # refuted as it is; judge.py says so
        taken[kind] += 1
        for fault in FAULTS[kind] + SCENE:
            changed = copy.deepcopy(row)
            side = changed["sides"][0]
            if fault is withhold and row["method"] == "pushover":
                continue  # what it sees falling is observed, with or without velocities
            try:
                fault(changed, side, answer and side["answers"][0])
            except KeyError:
                continue  # without velocities, as the pushover's
            planted[fault.__name__] += 1
            if not judge.judge([changed], asked.cases, proofs)[0]:
                missed.append(f"{row['case']} {row['method']} {kind}: {fault.__name__}")
    if asked.certificates:
        taken["certificate"] = certificates(rows, asked.certificates, planted, missed)
    for line in missed:
        print(f"not found: {line}")
    print(f"{sum(planted.values())} faults planted in {dict(taken)}, {len(missed)} not found")
    return 1 if missed or not taken else 0


if __name__ == "__main__":
    sys.exit(main())
