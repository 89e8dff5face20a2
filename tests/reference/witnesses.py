#!/usr/bin/env python3
"""Engines that others wrote, on scenes with exact answers and on walls: what is stored, and runs it again.

    tests/reference/witnesses.py exact        every engine and setting on scenes with exact answers: engines.csv
    tests/reference/witnesses.py table        every method and engine on walls, arches and bonds: witnesses.csv
    tests/reference/witnesses.py errors       from engines.csv: the error of each engine by setting
    tests/reference/witnesses.py show         witnesses.csv, a line a scene
    tests/reference/witnesses.py check        repeats three small scenes and compares with witnesses.csv

Everything runs through the program (`--trilith`) and its outside protocol; LMGC90 needs a Python that has it
(`--python`), Box2D the example `box2d_witness`. `--only NAME` runs one engine, `--most SECONDS` gives up on a scene
after so long. Rows are stored as they come; what is stored is not run again.

Errors are of a bracket [a, b] from the exact range [r, R], mostly one number: `error` is that of the farther end,
max(|a - r|, |b - R|) / r; `outside` is how far the range lies outside the bracket, 0 where they meet. What an engine
states as its error with a setting is the largest `outside`.
"""
import argparse
import csv
import io
import json
import subprocess
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
EXACT = """block-cube-rocks block-cube-slides block-flat block-slender block-both eccentric-load line-load overhang-rocks
    overhang-falls point-load-low point-load-top slope-falls slope-rocks slope-slides slope-uphill trapezoid-rocks
    trapezoid-upside-down triangle-left column-2 column-10 column-slides column-slippery-bed column-tapered
    column-top-heavy trilith oppenheim-7 oppenheim-14 semicircle-9 semicircle-27 crown-load""".split()
WALLS = "paper-1@open paper-2@open openings-3@open openings-4@open".split()
SCENES = """paper-1 paper-1@open paper-2 paper-2@open openings-3 openings-3@open openings-4 openings-4@open
    oppenheim-7 oppenheim-28 semicircle-15 segmental-120 semicircle-slides
    overburden-1 overburden-1@open english-bond english-bond@open flemish-bond flemish-bond@open
    header-bond header-bond@open running-third running-third@open stack-bond stack-bond@open
    slippery-base@open battered-wall gable@open rubble-bent@open rubble-cut house-front@open
    paper-3@open paper-3""".split()
SMALL = "oppenheim-7 battered-wall stack-bond@open".split()
# The first setting of an engine is the one that the table of witnesses has.
ENGINES = {
    "pushover": ["", "--set accuracy=fine", "--set accuracy=coarse", "--set substep=4"],
    "box2d": ["", "--once --rate 960", "--once --rate 240", "--once --rate 60"],
    "lmgc90": ["--tolerance 1e-3", "--tolerance 1e-4", "--tolerance 1e-2", "--tolerance 1e-1"],
}
METHODS = ["associative", "interval", *ENGINES]
ENGINE_COLUMNS = "engine setting case reference reference_upper lower upper error outside seconds reason".split()
TABLE_COLUMNS = "case method status lower upper stated_error seconds remark".split()


class Runner:
    def __init__(self, options):
        self.options = options

    def command(self, engine, setting):
        """The program behind an outside engine."""
        if engine == "box2d":
            return [self.options.box2d, *setting.split()]
        return [self.options.python, str(HERE / "lmgc90.py"), *setting.split()]

    def row(self, case, method, setting=""):
        """What the program says of a scene by one method, as a row of its CSV."""
        name, _, joints = case.partition("@")
        file = next(ROOT.glob(f"cases/*/{name}.toml"))
        both = tomllib.loads(file.read_text()).get("head_joints") == "both"
        arguments = [self.options.trilith, "run", str(file), "--format", "csv", "--progress", "lines"]
        if both:
            arguments += ["--head-joints", joints or "contact"]
        outside = method in ("box2d", "lmgc90")
        if outside:
            listed = ROOT / "target" / f"{method}.methods.toml"
            command = json.dumps(self.command(method, setting))
            limit = f"time_limit = {self.options.most}"
            listed.write_text(f'[[method]]\nname = "{method}"\ncommand = {command}\n{limit}\n')
            arguments += ["--method", "associative", "--external", str(listed)]
        else:
            arguments += ["--method", method, *setting.split()]
        done = subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        rows = [row for row in csv.DictReader(io.StringIO(done.stdout)) if row["method"] == method]
        if len(rows) != 1:
            raise SystemExit(f"{' '.join(arguments)}\n{done.stderr}")
        return rows[0]


def truth(case):
    """The exact range of λ from the case's references; None where it falls without a push."""
    name, _, joints = case.partition("@")
    file = tomllib.loads(next(ROOT.glob(f"cases/*/{name}.toml")).read_text())
    known = {}
    for reference in file["references"]:
        if reference.get("head_joints", joints or "contact") == (joints or "contact"):
            if reference["kind"] in ("analytic", "independent"):
                known[reference["method"], reference["quantity"]] = reference["value"]
    if known.get(("pushover", "at_rest")) == 0.0:
        return None
    for method in ("pushover", "interval", "associative"):
        if (method, "lambda") in known:
            return known[method, "lambda"]
    raise SystemExit(f"{case} has no exact answer")


def compared(row, reference):
    """Error of the farther end and distance of the range from the bracket, relative; empty without a bracket."""
    if not row["lower"] or reference is None:
        return "", ""
    lower, upper = float(row["lower"]), float(row["upper"])
    error = max(abs(lower - reference), abs(upper - reference)) / reference
    outside = max(lower - reference, reference - upper, 0.0) / reference
    return f"{error:.6f}", f"{outside:.6f}"


def stored(path):
    return list(csv.DictReader(path.open())) if path.exists() else []


def store(path, columns, rows):
    """Written whole, and in order, after every row."""
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    fresh = path.with_suffix(".new")
    fresh.write_text(text.getvalue())
    fresh.replace(path)


def chosen(options):
    """The engines that were asked for; Box2D only where it was built."""
    built = Path(options.box2d).exists()
    return [engine for engine in ENGINES if options.only in (None, engine) and (engine != "box2d" or built)]


def exact(options):
    """Every engine and setting, first on the scenes and then on the walls, the cheap settings first."""
    path, rows, runner = HERE / "engines.csv", stored(HERE / "engines.csv"), Runner(options)
    have = {(row["engine"], row["setting"], row["case"]) for row in rows}
    cases = [case for case in EXACT + WALLS if options.case in (None, case)]
    order = [(engine, setting, case) for engine in ENGINES for setting in ENGINES[engine] for case in EXACT + WALLS]
    for engine, setting, case in order:
        if (engine, setting, case) in have or engine not in chosen(options) or case not in cases:
            continue
        row, reference = runner.row(case, engine, setting), truth(case)
        error, outside = compared(row, reference)
        told = {"engine": engine, "setting": setting, "case": case, "error": error, "outside": outside}
        told["reference"] = "falls" if reference is None else f"{reference:.9g}"
        rows.append(told | {name: row[name] for name in ("lower", "upper", "seconds", "reason")})
        rows.sort(key=lambda row: order.index((row["engine"], row["setting"], row["case"])))
        store(path, ENGINE_COLUMNS, rows)
        print(engine, setting, case, row["lower"], row["upper"], error, row["seconds"], flush=True)


def table(options):
    """Every method on every scene, small ones first as listed; remarks that stand are kept."""
    path, rows, runner = HERE / "witnesses.csv", stored(HERE / "witnesses.csv"), Runner(options)
    have = {(row["case"], row["method"]) for row in rows}
    order = [(case, method) for case in SCENES for method in METHODS]
    for case, method in order:
        wanted = method in chosen(options) or method not in ENGINES and not options.only
        if (case, method) in have or not wanted or options.case not in (None, case):
            continue
        row = runner.row(case, method, ENGINES.get(method, [""])[0])
        told = {name: row[name] for name in TABLE_COLUMNS if name in row}
        rows.append(told | {"case": case, "remark": "" if row["lower"] else row["reason"]})
        rows.sort(key=lambda row: order.index((row["case"], row["method"])))
        store(path, TABLE_COLUMNS, rows)
        print(case, method, row["status"], row["lower"], row["upper"], row["seconds"], flush=True)


def errors(_):
    """The largest and the median error by engine and setting, and what they cost, as a table."""
    rows = stored(HERE / "engines.csv")
    print("| engine | setting | answers | largest error % | median % | outside % | on the walls % | CPU s, median |")
    print("|---|---|---|---|---|---|---|---|")
    for engine, settings in ENGINES.items():
        for setting in settings:
            own = [row for row in rows if row["engine"] == engine and row["setting"] == setting]
            scenes = [row for row in own if row["case"] in EXACT]
            if not scenes:
                continue
            right = [row for row in scenes if row["error"] or row["reference"] == "falls" and not row["lower"]]
            found = sorted(100 * float(row["error"]) for row in scenes if row["error"])
            outside = max(100 * float(row["outside"]) for row in scenes if row["outside"])
            walls = [100 * float(row["outside"]) for row in own if row["case"] in WALLS and row["outside"]]
            seconds = sorted(float(row["seconds"]) for row in scenes)
            cells = [engine, f"`{setting}`" if setting else "default", f"{len(right)} of {len(scenes)}"]
            cells += [f"{found[-1]:.3f}", f"{found[len(found) // 2]:.3f}", f"{outside:.3f}"]
            cells += [f"{max(walls):.3f}" if len(walls) == len(WALLS) else "", f"{seconds[len(seconds) // 2]:.2f}"]
            print("| " + " | ".join(cells) + " |")


def bracket(row):
    if not row or not row["lower"]:
        return row["status"] if row else ""
    lower, upper = (f"{float(row[end]):.5f}" for end in ("lower", "upper"))
    return lower if lower == upper else f"{lower} to {upper}"


def show(_):
    rows = {(row["case"], row["method"]): row for row in stored(HERE / "witnesses.csv")}
    print("| scene | λ_A | interval | " + " | ".join(ENGINES) + " |")
    print("|---|---|---|" + "---|" * len(ENGINES))
    for case in SCENES:
        found = [rows.get((case, method)) for method in METHODS]
        if any(found):
            print(f"| {case} | " + " | ".join(bracket(row) for row in found) + " |")


def check(options):
    """Repeats small scenes; what differs by more than the stated error and the width of the bracket fails."""
    rows = {(row["case"], row["method"]): row for row in stored(HERE / "witnesses.csv")}
    runner, wrong = Runner(options), 0
    for engine in chosen(options) if options.only else ["lmgc90"]:
        for case in SMALL:
            old, new = rows[case, engine], runner.row(case, engine, ENGINES[engine][0])
            lower, upper = float(old["lower"]), float(old["upper"])
            most = float(old["stated_error"]) * upper + upper - lower
            right = bool(new["lower"]) and max(abs(float(new["lower"]) - lower), abs(float(new["upper"]) - upper)) <= most
            wrong += not right
            print(f"{case} {engine}: {bracket(new)}, stored {bracket(old)}, {'agrees' if right else 'DIFFERS'}")
    return 1 if wrong else 0


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("what", choices=["exact", "table", "errors", "show", "check"])
    ask.add_argument("--trilith", default=str(ROOT / "target/release/trilith"))
    ask.add_argument("--box2d", default=str(ROOT / "target/release/examples/box2d_witness"))
    ask.add_argument("--python", default=sys.executable, help="a Python with compas-lmgc90 (%(default)s)")
    ask.add_argument("--only", choices=list(ENGINES), help="one engine")
    ask.add_argument("--case", help="one scene")
    ask.add_argument("--most", type=float, default=3600.0, help="seconds after which an engine is stopped (%(default)g)")
    options = ask.parse_args()
    return globals()[options.what](options)


if __name__ == "__main__":
    sys.exit(main())
