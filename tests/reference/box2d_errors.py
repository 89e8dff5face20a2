#!/usr/bin/env python3
"""The error of Box2D on scenes whose multiplier is known, setting by setting.

    cargo build --release --bins --example box2d_witness
    tests/reference/box2d_errors.py > tests/reference/engines-box2d.csv
    tests/reference/box2d_errors.py --check

The scenes are cases of the library whose largest associative multiplier is also that of every collapse
state (references of `associative` and of `interval` that are equal), and two walls with open head joints
whose states differ by less than 0.04 %. The error of a bracket [a, b] of r is max(|a − r|, |b − r|) / r; it is
empty where Box2D gives no bracket. `--check` repeats three scenes at the default setting, through
trilith's outside protocol, and holds them within the error that the program states; exit status 1 where
one is not.
"""
import csv
import io
import json
import resource
import subprocess
import sys
from pathlib import Path

import tomllib

ROOT = Path(__file__).resolve().parents[2]
TRILITH = ROOT / "target/release/trilith"
WITNESS = ROOT / "target/release/examples/box2d_witness"
CASES = """block-cube-rocks block-cube-slides block-flat block-slender eccentric-load line-load overhang-rocks
    point-load-low point-load-top slope-rocks slope-slides slope-uphill trapezoid-rocks trapezoid-upside-down
    triangle-left column-2 column-10 column-slides column-slippery-bed column-tapered column-top-heavy trilith
    oppenheim-7 oppenheim-14 oppenheim-28 oppenheim-100 semicircle-9 semicircle-15 semicircle-27 semicircle-100
    crown-load paper-1@open paper-2@open""".split()
CHECKED = ["block-cube-rocks", "semicircle-9", "paper-1@open"]
# The first is the engine's own default; contacts of 30 Hz, then an eighth of the substeps a second.
SETTINGS = [
    "--rate 60 --substeps 4",
    "--rate 240 --substeps 8 --hertz 30",
    "--rate 60 --substeps 8",
    "--rate 120 --substeps 8",
    "--rate 240 --substeps 8",
    "--rate 480 --substeps 8",
    "--rate 960 --substeps 8",
]


def exact(case):
    name, _, joints = case.partition("@")
    [path] = ROOT.glob(f"cases/*/{name}.toml")
    values = {}
    for reference in tomllib.loads(path.read_text())["references"]:
        here = reference.get("head_joints", joints) == joints
        if here and reference["quantity"] in ("lambda", "lower") and reference["kind"] != "published":
            values.setdefault(reference["method"], reference["value"])
    highest, lowest = values["associative"], values["interval"]
    assert abs(highest - lowest) <= 4e-4 * highest, case
    return lowest


def scene(case):
    name, _, joints = case.partition("@")
    command = [TRILITH, "export", name] + (["--head-joints", joints] if joints else [])
    return subprocess.run(command, check=True, capture_output=True).stdout


def error(value, lower, upper):
    return max(abs(lower - value), abs(upper - value)) / value


def measured(case, setting):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    text = scene(case)
    between = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    command = [WITNESS, "--once", *setting.split()]
    done = subprocess.run(command, input=text, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    answer, value = json.loads(done.stdout), exact(case)
    row = ["box2d", setting, case, f"{value:.6f}", "", "", "", f"{after - between:.2f}"]
    if answer["kind"] == "estimate":
        lower, upper = answer["lambda"], answer["upper"]
        row[4:7] = [f"{lower:.6f}", f"{upper:.6f}", f"{100 * error(value, lower, upper):.3f}"]
    return row


def table():
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow("engine,setting,case,exact,lower,upper,error_percent,cpu_seconds".split(","))
    for setting in SETTINGS:
        for case in CASES:
            writer.writerow(measured(case, setting))
            sys.stdout.flush()


def check():
    names = [case.partition("@")[0] for case in CHECKED]
    program = [f"box2d={WITNESS}", "--method", "associative", "--format", "csv"]
    done = subprocess.run([TRILITH, "run", *names, "--external", *program], check=True, capture_output=True)
    rows = {row["case"]: row for row in csv.DictReader(io.StringIO(done.stdout.decode())) if row["method"] == "box2d"}
    wrong = 0
    for case in CHECKED:
        answer = json.loads(subprocess.run([WITNESS], input=scene(case), check=True, capture_output=True).stdout)
        value, stated, row = exact(case), answer["stated_error"], rows[case]
        off = error(value, float(row["lower"]), float(row["upper"]))
        # A bracket is as wide as the tolerance of the search; what it may be off beside is what it states.
        most = stated + 0.002
        verdict = "holds" if off <= most else "VIOLATED"
        wrong += off > most
        print(f"{case}: [{row['lower']}, {row['upper']}] for {value:.6f}, {100 * off:.2f} % of {100 * most:.2f} %: {verdict}")
    return wrong


if __name__ == "__main__":
    sys.exit(bool(check()) if "--check" in sys.argv[1:] else table())
