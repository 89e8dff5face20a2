#!/usr/bin/env python3
"""Associative multipliers of any cases, from their files alone, beside those of results.

    python3 -m pip install numpy scipy        (Python 3.11 or later)
    tests/reference/scenes.py FOLDER 200 41 keys
    trilith run FOLDER --method associative --format json --states > results.json
    tests/reference/lambda_a.py results.json --cases FOLDER

Scenes are laid by `lay.py` and solved by `limit.py`; `falls.py` says which do not stand. Prints a line for each answer
that differs by more than 1e-6 of the multiplier, or of 1e-3 where that is less, and a summary; exit status 1 where
there is one.
"""
import argparse
import json
import sys
from collections import Counter
from pathlib import Path

import geometry
import lay
from falls import letter
from limit import Wall

ALIKE = 1e-6


def compared(side, scene):
    """What is wrong with the answer for one direction of the push, or None, and a word for what it is."""
    rests = letter(scene)
    if rests == "f" or side["status"] == "falls":
        return None if (rests, side["status"]) == ("f", "falls") else f"{side['status']}, and here {rests}", "falls"
    top = Wall(scene).associative()
    if top is None:
        return None, f"not solved here, {side['status']}"
    here = max(-top.fun, 0.0)
    if side["lower"] is None:
        return f"{side['status']}, and here {here}", side["status"]
    unit = ALIKE * max(here, 1e-3)
    wrong = not (side["lower"] - unit <= here <= side["upper"] + unit)
    return f"[{side['lower']}, {side['upper']}], and here {here}" if wrong else None, "compared"


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("results", type=Path)
    ask.add_argument("--cases", type=Path, required=True, help="folder of the case files")
    asked = ask.parse_args()
    files, counts, wrong = geometry.case_files(asked.cases), Counter(), 0
    for row in json.loads(asked.results.read_text()):
        if row["method"] != "associative":
            continue
        file = files[row["case"].split("@")[0]]
        for side in row["sides"]:
            line, word = compared(side, lay.scene(file, side["scene"]["head_joints"], side["push"]))
            counts[word] += 1
            if line:
                wrong += 1
                print(f"differs: {row['case']} pushed {side['push']}: {line}")
    print(", ".join(f"{count} {word}" for word, count in sorted(counts.items())) + f"; {wrong} differ")
    return 1 if wrong or not counts["compared"] else 0


if __name__ == "__main__":
    sys.exit(main())
