#!/usr/bin/env python3
"""Engines that others wrote, on scenes with exact answers and on walls: what is stored, and runs it again.

    tests/reference/witnesses.py exact        rapier and LMGC90 by setting on scenes with exact answers: engines.csv
    tests/reference/witnesses.py table        every method and engine on walls, arches and bonds: witnesses.csv
    tests/reference/witnesses.py errors       from engines.csv: the error of each engine by setting
    tests/reference/witnesses.py show         witnesses.csv, a line a scene
    tests/reference/witnesses.py check        repeats three small scenes and compares with witnesses.csv

Box2D's errors by setting are in `engines-box2d.csv`, made by `box2d_errors.py`; this reads them too.

Everything runs through the program (`--trilith`) and its outside protocol; LMGC90 needs a Python that has it
(`--python`), Box2D the example `box2d_witness`. `--only NAME` runs one method or engine, `--most SECONDS` gives up on a scene
after so long. Rows are stored as they come; what is stored is not run again.

Errors are of a bracket [a, b] from the exact value r: `error` is that of the farther end, max(|a - r|, |b - r|) / r;
`outside` is how far r lies outside the bracket, 0 where it lies within.
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
EXACT = """block-cube-rocks block-cube-slides block-flat block-slender block-both eccentric-load line-load
    overhang-rocks overhang-falls point-load-low point-load-top slope-falls slope-rocks slope-slides slope-uphill
    trapezoid-rocks trapezoid-upside-down triangle-left column-2 column-10 column-slides column-slippery-bed
    column-tapered column-top-heavy trilith oppenheim-7 oppenheim-14 semicircle-9 semicircle-27 crown-load""".split()
WALLS = "paper-1@open paper-2@open".split()
SCENES = """paper-1 paper-1@open paper-2 paper-2@open openings-3 openings-3@open openings-4 openings-4@open
    oppenheim-7 oppenheim-28 semicircle-15 segmental-120 semicircle-slides
    overburden-1 overburden-1@open english-bond english-bond@open flemish-bond flemish-bond@open
    header-bond header-bond@open running-third running-third@open stack-bond stack-bond@open
    slippery-base@open battered-wall gable@open rubble-bent@open rubble-cut house-front@open
    paper-3@open""".split()
SMALL = "oppenheim-7 battered-wall stack-bond@open".split()
# The first setting of an engine is the one that the table of witnesses has.
ENGINES = {
    "pushover": ["", "--set accuracy=fine", "--set accuracy=coarse"],
    "box2d": [""],
    "lmgc90": ["--tolerance 1e-3", "--tolerance 1e-4", "--tolerance 1e-2", "--tolerance 1e-1"],
}
METHODS = ["associative", "interval", *ENGINES]
# A sweep of its contacts takes 2.1 ms; paper-2 needs 1.3 million of them, and they grow with the square of the courses.
NOT_RUN = {("paper-3@open", "lmgc90"): "not asked: it would take about 17 hours of CPU"}
ENGINE_COLUMNS = "engine setting case reference lower upper error outside seconds reason".split()
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


def measured():
    """Rows of engines.csv and of Box2D's own table, alike."""
    rows = stored(HERE / "engines.csv")
    for row in stored(HERE / "engines-box2d.csv"):
        lower, upper, value = (float(row[name] or "nan") for name in ("lower", "upper", "exact"))
        outside = f"{max(lower - value, value - upper, 0.0) / value:.6f}" if row["lower"] else ""
        error = f"{float(row['error_percent']) / 100:.6f}" if row["error_percent"] else ""
        row |= {"reference": row["exact"], "seconds": row["cpu_seconds"]}
        rows.append(row | {"error": error, "outside": outside})
    return rows


def settings_of(engine, rows):
    return list(dict.fromkeys(row["setting"] for row in rows if row["engine"] == engine))


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
    """The methods that were asked for; Box2D only where it was built."""
    built = Path(options.box2d).exists()
    return [method for method in METHODS if options.only in (None, method) and (method != "box2d" or built)]


def exact(options):
    """rapier and LMGC90 with every setting, on the scenes and then on two walls."""
    order = [(engine, setting, case) for engine in ENGINES for setting in ENGINES[engine] for case in EXACT + WALLS]
    engines = [engine for engine in chosen(options) if engine in ("pushover", "lmgc90")]

    def told(engine, setting, case):
        row, reference = Runner(options).row(case, engine, setting), truth(case)
        error, outside = compared(row, reference)
        found = {name: row[name] for name in ("lower", "upper", "seconds", "reason")}
        found |= {"engine": engine, "setting": setting, "case": case, "error": error, "outside": outside}
        return found | {"reference": "falls" if reference is None else f"{reference:.9g}"}

    wanted = [key for key in order if key[0] in engines and options.case in (None, key[2])]
    fill(HERE / "engines.csv", ENGINE_COLUMNS, ["engine", "setting", "case"], order, wanted, told)


def table(options):
    """Every method on every scene, as listed; remarks that were written into the file are kept."""
    order = [(case, method) for case in SCENES for method in METHODS]

    def told(case, method):
        if (case, method) in NOT_RUN:
            nothing = dict.fromkeys(TABLE_COLUMNS, "") | {"status": "not run", "seconds": "0"}
            return nothing | {"case": case, "method": method, "remark": NOT_RUN[case, method]}
        row = Runner(options).row(case, method, ENGINES.get(method, [""])[0])
        found = {name: row[name] for name in TABLE_COLUMNS if name in row}
        return found | {"case": case, "remark": "" if row["lower"] else row["reason"]}

    wanted = [key for key in order if key[1] in chosen(options) and options.case in (None, key[0])]
    fill(HERE / "witnesses.csv", TABLE_COLUMNS, ["case", "method"], order, wanted, told)


def fill(path, columns, names, order, wanted, told):
    """Adds the rows that are wanted and not there, each stored as it comes, in their order."""

    def key(row):
        return tuple(row[name] for name in names)

    for want in wanted:
        if want in map(key, stored(path)):
            continue
        row = told(*want)
        # Read again: another process may have added rows meanwhile.
        rows = [other for other in stored(path) if key(other) in order and key(other) != want]
        store(path, columns, sorted([*rows, row], key=lambda row: order.index(key(row))))
        print(*want, row["lower"], row["upper"], row["seconds"], flush=True)


def errors(_):
    """The largest and the median error by engine and setting, and what they cost, as a table."""
    rows = measured()
    print("| engine | setting | answers | largest error % | median % | outside % | on the walls % | CPU s, median |")
    print("|---|---|---|---|---|---|---|---|")
    for engine in ENGINES:
        for setting in settings_of(engine, rows):
            own = [row for row in rows if row["engine"] == engine and row["setting"] == setting]
            scenes = [row for row in own if row["case"] in EXACT]
            if not scenes:
                continue
            right = [row for row in scenes if bool(row["error"]) != (row["reference"] == "falls")]
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
            ends = (abs(float(new[end]) - float(old[end])) for end in ("lower", "upper"))
            right = bool(new["lower"]) and max(ends) <= most
            wrong += not right
            print(f"{case} {engine}: {bracket(new)}, stored {bracket(old)}, {'agrees' if right else 'DIFFERS'}")
    return 1 if wrong else 0


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("what", choices=["exact", "table", "errors", "show", "check"])
    ask.add_argument("--trilith", default=str(ROOT / "target/release/trilith"))
    ask.add_argument("--box2d", default=str(ROOT / "target/release/examples/box2d_witness"))
    ask.add_argument("--python", default=sys.executable, help="a Python with compas-lmgc90 (%(default)s)")
    ask.add_argument("--only", choices=METHODS, help="one method or engine")
    ask.add_argument("--case", help="one scene")
    ask.add_argument("--most", type=float, default=3600.0, help="seconds until an engine is stopped (%(default)g)")
    options = ask.parse_args()
    return globals()[options.what](options)


if __name__ == "__main__":
    sys.exit(main())
