#!/usr/bin/env python3
"""How time, memory and unknowns grow with a wall: measured to `growth.csv`, and drawn from it.

    tests/reference/growth.py measure target/release/trilith [METHOD ...] > tests/reference/growth.csv
    tests/reference/growth.py chart > .github/growth.svg
    tests/reference/growth.py table

`measure` runs one program at a time, on one thread: about half an hour. The pushover goes through the library and
through running bond, in three shapes of 8 to 1,290 blocks with open head joints and in one of 8 to 102 blocks in
contact; the bound through running bond of 8 to 25 blocks.
`growth-before.csv` is of the commit before contacts stood at the joints of the scene (d4da637), on the same machine
and day; what that program could not read is not in it. The chart shows both.
`table` prints the power of the number of blocks that fits best, and what lies furthest above it.
"""
import csv
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from witness_chart import BOTTOM, FONT, HEIGHT, INK, LEFT, PALE, PANEL, TOP, WIDTH, line, text

HERE = Path(__file__).resolve().parent
CASES = HERE.parent.parent / "cases"
SHAPES = {"4 x 1.75": (4.0, 1.75, 0.65), "3 x 1": (3.0, 1.0, 0.75), "2 x 1": (2.0, 1.0, 0.65)}
# Courses and units a course.
PUSHED = [(3, 2), (4, 3), (6, 4), (8, 6), (12, 8), (16, 10), (20, 12), (24, 14), (30, 16), (36, 18), (48, 20), (60, 21.6)]
RANGES = PUSHED[:5]
BOUND = [(3, 2), (4, 2), (5, 2), (5, 3), (6, 3), (7, 3)]
FIELDS = ["method", "case", "head_joints", "blocks", "unknowns", "seconds", "megabytes", "status", "lower", "upper"]
OUTLIER = 5.0
COLOURS = {"open": "#0072B2", "contact": "#D55E00"}


def running_bond(shape, courses, units):
    (length, height, friction), units = SHAPES[shape], int(units)
    rows = [f"h1*{units - 1}h", f"1*{units}"] if units > 1 else ["hh", "1"]
    rows = (rows * courses)[:courses]
    return f"""title = "{courses} courses of {units} units, {shape}"
source = "growth.py"
unit = {{ length = {length}, height = {height}, weight = 1.0 }}
courses = [{", ".join(f'"{row}"' for row in rows)}]
friction = {friction}
"""


def run(program, case, method, head_joints, *more):
    """The row of one case, with the most memory that the program had."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", case, "--method", method, "--head-joints", head_joints, *more]
        process = subprocess.Popen(
            [*map(str, command), "--format", "csv"],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            cwd=folder,
            env=dict(os.environ, RAYON_NUM_THREADS="1"),
        )
        out = process.stdout.read()
        used = os.wait4(process.pid, 0)[2]
    row = next(csv.DictReader(out.splitlines()))
    return row, round(used.ru_maxrss / 1024)


def measure(program, methods):
    program = str(Path(program).resolve())
    rows = csv.DictWriter(sys.stdout, FIELDS, lineterminator="\n")
    rows.writeheader()
    with tempfile.TemporaryDirectory() as folder:
        walls = lambda sizes, shapes=tuple(SHAPES): [
            (Path(folder) / f"{shape} {courses} x {int(units)}.toml".replace(" ", "-"), running_bond(shape, courses, units))
            for shape in shapes
            for courses, units in sizes
        ]
        for path, wall in walls(PUSHED + BOUND):
            path.write_text(wall)
        pushed = sorted(path for path in CASES.rglob("*.toml") if path.parent.name != "sweeps")
        tasks = [("pushover", path, joints) for path in pushed for joints in COLOURS]
        tasks += [("pushover", path, "open") for path, _ in walls(PUSHED)]
        tasks += [("pushover", path, "contact") for path, _ in walls(RANGES, ("4 x 1.75",))]
        tasks += [("bound", path, joints) for path, _ in walls(BOUND, ("2 x 1",)) for joints in COLOURS]
        for method, path, joints in [task for task in tasks if task[0] in methods]:
            row, megabytes = run(program, path, method, joints)
            unknowns = ""
            if method == "bound":
                refused, _ = run(program, path, method, joints, "--lift-unknowns", 1)
                words = refused["reason"].split()
                unknowns = words[words.index("unknowns,") - 1] if "unknowns," in words else ""
            own = {field: row.get(field, "") for field in ("blocks", "seconds", "status", "lower", "upper")}
            rows.writerow(
                {**own, "method": method, "case": path.stem, "head_joints": joints, "unknowns": unknowns, "megabytes": megabytes}
            )
            sys.stdout.flush()


def fit(points):
    """Factor and power of the line through the logarithms: least absolute distance, so outliers do not bend it."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    lines = [
        ((y2 - y1) / (x2 - x1), y1 - (y2 - y1) / (x2 - x1) * x1)
        for i, (x1, y1) in enumerate(logs)
        for x2, y2 in logs[i + 1 :]
        if x2 - x1 > 0.5
    ]
    power, factor = min(lines, key=lambda line: sum(abs(y - line[0] * x - line[1]) for x, y in logs))
    return math.exp(factor), power


def above(points):
    """Factor and power of the trend, and each point with how many times it lies above the trend."""
    # What is refused at once costs nothing, and would draw the trend down.
    factor, power = fit([(blocks, seconds) for blocks, seconds, row in points if row["status"] != "undecided"])
    return factor, power, sorted(((s / (factor * b**power), b, s, row) for b, s, row in points), key=lambda p: -p[0])


def measured(method, joints, field="seconds", stored="growth.csv"):
    """Blocks, a figure and the row, of those that took long enough to be measured."""
    with open(HERE / stored, encoding="utf-8") as lines:
        rows = [row for row in csv.DictReader(lines) if (row["method"], row["head_joints"]) == (method, joints)]
    rows = [row for row in rows if row[field] and int(row["blocks"]) >= 6 and row["status"] != "not-applicable"]
    return [(int(row["blocks"]), float(row[field]), row) for row in rows if float(row[field]) > 0]


def table():
    for joints in COLOURS:
        factor, power, found = above(measured("pushover", joints))
        print(f"pushover, {joints}: {len(found)} scenes, {factor:.3g} s x blocks^{power:.2f}")
        for times, blocks, seconds, row in found:
            if times > OUTLIER:
                print(f"  {times:5.1f} times above: {row['case']}, {blocks} blocks, {seconds:.1f} s, {row['status']}")
        refused = sum(row["status"] == "undecided" for *_, row in found)
        print(f"  undecided: {refused}")
    print("bound: head joints, blocks, unknowns, CPU seconds, MB, status, lower, upper")
    for joints in COLOURS:
        for blocks, seconds, row in measured("bound", joints):
            shown = [row[field] for field in ("unknowns", "megabytes", "status", "lower", "upper")]
            print(f"  {joints:8} {blocks:3} {shown[0]:>6} {seconds:8.2f} {shown[1]:>6} {' '.join(shown[2:])}")
        for field in ("unknowns", "megabytes", "seconds"):
            found = [(blocks, value) for blocks, value, _ in measured("bound", joints, field)]
            print(f"  {joints}: {field} with blocks^{fit(found)[1]:.2f}")


class Panel:
    """Axes in decades, blocks across."""

    def __init__(self, left, title, blocks, figures, words):
        self.left, self.blocks, self.figures = left, blocks, figures
        right = left + PANEL - 20
        self.out = [text(left, TOP - 12, title, 12, extra=' font-weight="700"')]
        for value in (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000):
            if blocks[0] <= value <= blocks[1]:
                x, _ = self.place(value, figures[0])
                self.out += [line(x, TOP, x, BOTTOM, PALE), text(x, BOTTOM + 16, f"{value}", anchor="middle")]
        for decade in range(round(math.log10(figures[0])), round(math.log10(figures[1])) + 1):
            _, y = self.place(blocks[0], 10.0**decade)
            self.out += [line(left, y, right, y, PALE), text(left - 6, y + 4, f"{10.0**decade:g}", anchor="end")]
        self.out += [line(left, BOTTOM, right, BOTTOM, INK), line(left, TOP, left, BOTTOM, INK)]
        self.out.append(text((left + right) / 2, BOTTOM + 34, "blocks", anchor="middle"))
        middle = (TOP + BOTTOM) / 2
        turned = f' transform="rotate(-90 {left - 40} {middle:.0f})"'
        self.out.append(text(left - 40, middle, words, 11, "middle", turned))

    def place(self, blocks, figure):
        part = lambda value, ends: math.log(value / ends[0]) / math.log(ends[1] / ends[0])
        figure = min(max(figure, self.figures[0]), self.figures[1])
        x = self.left + (PANEL - 20) * part(blocks, self.blocks)
        return x, BOTTOM - (BOTTOM - TOP) * part(figure, self.figures)

    def dot(self, blocks, figure, colour, hollow=False):
        x, y = self.place(blocks, figure)
        fill = "#fff" if hollow else colour
        self.out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6" fill="{fill}" stroke="{colour}" fill-opacity="0.75"/>')

    def trend(self, factor, power, blocks, colour, extra=""):
        ends = [self.place(at, factor * at**power) for at in blocks]
        self.out.append(line(*ends[0], *ends[1], colour, 1.4, extra))


def pushed_panel(left, title, stored):
    """The pushovers of one measurement, their trend and five times that."""
    panel = Panel(left, title, (5, 1500), (1e-2, 1e3), "CPU time, seconds")
    for joints, colour in COLOURS.items():
        factor, power, found = above(measured("pushover", joints, stored=stored))
        for _, blocks, seconds, row in found:
            panel.dot(blocks, seconds, colour, row["status"] == "undecided")
        answered = [blocks for _, blocks, _, row in found if row["status"] != "undecided"]
        ends = min(answered), max(answered)
        panel.trend(factor, power, ends, colour)
        panel.trend(OUTLIER * factor, power, ends, colour, ' stroke-dasharray="4 3"')
    return panel


def chart():
    title = "How time grows with a wall"
    before = pushed_panel(LEFT, "pushover, before", "growth-before.csv")
    now = pushed_panel(LEFT + PANEL + 60, "pushover, now", "growth.csv")
    proved = Panel(LEFT + 2 * (PANEL + 60), "bound, default limits", (5, 50), (1e-2, 1e5), "seconds, MB, unknowns")
    for joints, colour in COLOURS.items():
        for field, name in (("unknowns", "unknowns"), ("megabytes", "memory, MB"), ("seconds", "CPU time, s")):
            # A program that is refused says how many unknowns it would have, and costs nothing.
            refused = lambda row: row["status"] == "undecided" and field != "unknowns"
            found = [point for point in measured("bound", joints, field) if not refused(point[2])]
            places = [proved.place(blocks, value) for blocks, value, _ in found]
            proved.out += [line(*one, *other, colour, 1.2) for one, other in zip(places, places[1:])]
            for blocks, value, row in found:
                proved.dot(blocks, value, colour, row["status"] == "undecided")
            if joints == "open":
                proved.out.append(text(places[-1][0] + 7, places[-1][1] + 4, name, 10))
    width = WIDTH + PANEL + 60
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {HEIGHT}" width="{width}" height="{HEIGHT}"',
        f'role="img" aria-label="{title}" font-family="{FONT}" fill="{INK}">',
        f"<title>{title}</title>",
        '<rect width="100%" height="100%" fill="#fff"/>',
        text(14, 26, title, 15, extra=' font-weight="700"'),
    ]
    for at, (joints, colour) in enumerate(COLOURS.items()):
        out += [f'<circle cx="{19 + 150 * at}" cy="44" r="4" fill="{colour}"/>', text(29 + 150 * at, 48, f"head joints: {joints}", 12)]
    out.append(text(330, 48, "hollow: undecided; dashed: five times the trend", 12))
    sys.stdout.write("\n".join([*out, *before.out, *now.out, *proved.out, "</svg>"]) + "\n")


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["measure"] and len(arguments) >= 2:
        measure(arguments[1], arguments[2:] or ["pushover", "bound"])
    elif arguments == ["chart"]:
        chart()
    elif arguments == ["table"]:
        table()
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
