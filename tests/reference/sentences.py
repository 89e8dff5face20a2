#!/usr/bin/env python3
"""Whether what trilith says around its numbers follows from them, by its JSON alone.

    trilith run FOLDER --states --format json > results.json
    tests/reference/sentences.py results.json ...

Of a wall that is pushed both ways: the range is the least of the sides' lower ends and the least of their
upper ends, each end names its side, and every sentence about the sides follows from them. Of a proof:
nothing printed claims more than the side's own full digits. Of every row: no negative multiplier, and
nothing violated. The base shear is what the supports carry along x in the state that it is of. Shares
nothing with the program. Prints a line for each sentence that does not follow and a summary; exit
status 1 where there is one, 2 where nothing was checked.
"""
import json
import math
import re
import sys
from collections import Counter
from pathlib import Path

ALIKE, DIGITS = 1e-6, 5.1e-9
NUMBER = r"(-?[0-9.]+(?:e-?[0-9]+)?)"
PROVES = {"associative": "both", "bound": "lower", "auto": "upper"}


class Checker:
    def __init__(self):
        self.checked, self.wrong = Counter(), []

    def demand(self, row, kind, holds, text):
        self.checked[kind] += 1
        if not holds:
            self.wrong.append(f"{row['case']} {row['method']}: {text}")


def known(method, side):
    """The least multiplier at which a side has a collapse."""
    return side["upper"] if method in ("bound", "associative") else side["lower"]


def unit_of(scene):
    """λ that pushes with the scene's weight: what small multipliers are measured against."""
    loads = [load for block in scene["blocks"] for load in block["loads"]]
    dead, live = (sum(math.hypot(*load[kind]) for load in loads) for kind in ("dead", "live"))
    return dead / live if live else 1.0


def magnitude(value, unit):
    return max(abs(value), 1e-3 * unit)


def share(text):
    match = re.match(r"(?:less than )?([0-9.]+) %", text)
    return float(match.group(1)) / 100


def sentences_of_sides(check, row):
    method, (own, other) = row["method"], row["sides"]
    reason, unit = row["reason"], unit_of(own["scene"])
    sides = {side["push"]: side for side in row["sides"]}
    answered = [side for side in row["sides"] if side["lower"] is not None]
    both = len(answered) == 2
    ends = [(own[end], other[end]) for end in ("lower", "upper")] if both else []
    demand = lambda kind, holds, text: check.demand(row, kind, holds, text)
    if match := re.search(r"the wall is weaker when pushed to the (\w+), by ((?:less than )?[0-9.]+ %)", reason):
        demand("weaker", both and match[1] == own["push"] and own["upper"] < other["lower"], reason)
        if both:
            by = (known(method, other) - known(method, own)) / magnitude(known(method, other), unit)
            demand("share", abs(share(match[2]) - by) <= 6e-4, f"{match[2]} for {by}")
    if match := re.search(r"the lowest collapse known is that of the push to the (\w+), by", reason):
        lower = both and known(method, own) < known(method, other)
        demand("lowest", lower and match[1] == own["push"] and own["upper"] >= other["lower"], reason)
    if "the wall is as strong when pushed" in reason:
        alike = both and all(abs(a - b) <= 2 * ALIKE * magnitude(b, unit) for a, b in ends)
        demand("alike", alike, reason)
    if match := re.search(r"the lower end is that of the push to the (\w+)", reason):
        first, next_side = (own, other) if match[1] == own["push"] else (other, own)
        # Of the side that governs it is said of what a pushover saw alone, which proves no side weaker.
        seen = first is other or method == "pushover" and own["upper"] < other["lower"]
        demand("lower end", both and seen and first["lower"] < next_side["lower"], reason)
    if match := re.search(r"pushed to the (\w+), λ is at most " + NUMBER, reason):
        upper = sides[match[1]]["upper"]
        demand("at most", upper is not None and float(match[2]) >= upper - 1e-12, reason)
    if match := re.search(r"there is no answer when pushed to the (\w+)", reason):
        demand("unanswered", sides[match[1]]["lower"] is None and row["lower"] is None, reason)
    if match := re.search(r"only the push to the (\w+) has a limit", reason):
        others = [side for push, side in sides.items() if push != match[1]]
        demand("only", others[0]["status"] == "stands", reason)
    for end in ("lower", "upper"):
        of_sides = [(side[end], side["push"]) for side in answered]
        complete = both or any(side["status"] == "stands" for side in row["sides"])
        if of_sides and own["status"] != "falls" and (end == "upper" or complete):
            least = min(of_sides)
            demand("range", row[end] is not None and close(row[end], least[0]), f"{end} {row[end]} for {least}")
            tied = [push for value, push in of_sides if close(value, least[0])]
            demand("range", row[f"{end}_push"] in tied, f"{end}_push {row[f'{end}_push']} for {tied}")
        else:
            demand("range", row[end] is None, f"{end} {row[end]} where a side has none")
    if row["status"] in ("verified", "bracketed"):
        needed = row["sides"] if method in PROVES else [own]
        sound = all(side["status"] in ("verified", "bracketed", "stands") for side in needed)
        demand("status", sound, f"{row['status']} of {[side['status'] for side in row['sides']]}")


def close(printed, exact):
    """To nine digits, to the nearest or outwards."""
    return abs(printed - exact) <= 2 * DIGITS * abs(exact) + 1e-15


def rounding(check, row):
    """Ends that are proved bounds are rounded outwards, but where both are one number as printed."""
    proves = PROVES.get(row["method"])
    if not proves or row["status"] not in ("verified", "bracketed") or row["lower"] is None:
        return
    for end, sign in (("lower", 1), ("upper", -1)):
        if proves in (end, "both") and row["lower"] != row["upper"]:
            exact = min(side[end] for side in row["sides"] if side[end] is not None)
            shown = end
            if reaction := row.get("reaction"):
                # λ is the change of the reaction, which falls where the support moves away.
                if reaction["moves"] == "away":
                    shown, sign = {"lower": "upper", "upper": "lower"}[end], -sign
                exact = reaction["start"] + (-exact if reaction["moves"] == "away" else exact)
            outwards = sign * (exact - row[shown]) >= 0 or (end == "lower" and exact < 0 <= row[end])
            check.demand(row, "rounding", outwards, f"{shown} {row[shown]} for {exact!r}")
    for push, text in re.findall(r"(?:pushed to the (\w+): )?it is proved that no collapse state with 0 ≤ λ < " + NUMBER, row["reason"]):
        of_sides = [side["lower"] for side in row["sides"] if side["lower"] is not None and push in ("", side["push"])]
        check.demand(row, "floor", float(text) <= min(of_sides), f"0 ≤ λ < {text} for {min(of_sides)!r}")


def conclusion(check, row, rows):
    """The closing line about the scene follows from all rows about it."""
    said = row["conclusion"]
    same = [other for other in rows if other["case"] == row["case"]]
    line = said["line"]
    if match := re.match(r"λ = " + NUMBER + " is verified: it is the lowest collapse state found", line):
        states = []
        for other in same:
            for side in other["sides"]:
                kinds = ("collapse-state", "enclosed")
                states += [answer["lambda"] for answer in side["answers"] if answer["kind"] in kinds]
        least = min(states)
        holds = abs(float(match[1]) - least) <= 0.5000001e-5 + 2e-6 * abs(least)
        check.demand(row, "lowest state", holds, f"{line[:60]} for {least!r}")
    floors = [side["lower"] for other in same if other["method"] == "bound" and other["status"] in ("verified", "bracketed")
              for side in other["sides"] if side["lower"] is not None]
    for push, text in re.findall(r"it is proved that (?:pushed to the (\w+), )?no collapse state with 0 ≤ λ < " + NUMBER, line):
        check.demand(row, "floor", floors and (push or float(text) <= min(floors)), f"{line} for {floors}")


def base_shear(check, row):
    """Supports carry along x what joints against them carry, in the state that the conclusion is of."""
    said = row["conclusion"]
    if said["basis"] != "lowest-state-found" or said["methods"][0] != row["method"] or said["base_shear"] is None:
        return
    side = next(side for side in row["sides"] if side["push"] == said["push"])
    state = min((answer for answer in side["answers"] if answer.get("forces")), key=lambda answer: answer["lambda"])
    scene, carried, size = side["scene"], 0.0, 0.0
    for joint, (n1, n2, t) in zip(scene["joints"], state["forces"]):
        if joint["from_block"] is None:
            x, y = joint["normal"]
            # The support's force on the block; the block's on the support is the other way.
            carried -= (n1 + n2) * x + t * y
            size += abs(n1) + abs(n2) + abs(t)
    live = sum(load["live"][0] for block in scene["blocks"] for load in block["loads"])
    carried *= -1 if live < 0 else 1
    holds = abs(carried - said["base_shear"]) <= 1e-9 * max(size, abs(said["base_shear"])) + 1e-300
    check.demand(row, "base shear", holds, f"{said['base_shear']} for {carried!r}")


def main():
    check = Checker()
    for name in sys.argv[1:]:
        rows = json.loads(Path(name).read_text())
        for row in rows:
            if len(row["sides"]) == 2:
                sentences_of_sides(check, row)
            rounding(check, row)
            numbers = [row["lower"], row["upper"]] + [side[end] for side in row["sides"] for end in ("lower", "upper")]
            given = [number for number in numbers if number is not None]
            check.demand(row, "λ ≥ 0", all(number >= 0 for number in given), f"a negative multiplier, {numbers}")
            check.demand(row, "verdict", row["verdict"] != "VIOLATED", f"VIOLATED: {row['reason']}")
            base_shear(check, row)
            conclusion(check, row, rows)
    for wrong in check.wrong:
        print(wrong)
    print(f"{sum(check.checked.values())} checked, {len(check.wrong)} do not follow: {dict(check.checked)}")
    sys.exit(2 if not check.checked else 1 if check.wrong else 0)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main()
