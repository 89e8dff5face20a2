#!/usr/bin/env python3
"""Error against CPU time of the engines in `engines.csv` and `engines-box2d.csv`, as SVG on standard output.

    tests/reference/witness_chart.py > .github/witnesses.svg

A mark is one engine with one setting: the worst scene's error (of the farther end of its bracket) above the median
CPU time; a bar reaches down to the median error. Scenes without a bracket do not count and are said; on
the walls a setting is shown where both were run.
"""
import math
import sys

from witnesses import ENGINES, EXACT, WALLS, measured, settings_of

LOOKS = {"pushover": ("#D55E00", "rapier (pushover)"), "box2d": ("#0072B2", "Box2D"), "lmgc90": ("#009E73", "LMGC90")}
FONT = "'Helvetica Neue',Helvetica,Arial,'Liberation Sans','DejaVu Sans',sans-serif"
INK, PALE = "#222", "#ddd"
WIDTH, HEIGHT, PANEL, LEFT, TOP, BOTTOM = 760, 372, 300, 58, 84, 312
TIMES, ERRORS = (-3.0, 2.0), (-2.5, 1.5)  # decades of seconds and of per cent


def short(setting):
    """A setting as a label: what is not said is the default."""
    words = setting.split()
    if not words:
        return "default"
    if "--tolerance" in words:
        return "10" + words[-1].split("e")[1].translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    if "--rate" in words:
        substep = int(words[1]) * int(words[3])
        return f"1/{substep} s" + (", soft" if "--hertz" in words else "")
    return words[-1].replace("accuracy=", "").replace("substep=", "substep × ")


def median(values):
    return sorted(values)[len(values) // 2]


def points(rows, engine, cases):
    """Setting, median seconds, median and largest error in per cent, scenes with a bracket, scenes."""
    for setting in settings_of(engine, rows):
        own = [row for row in rows if (row["engine"], row["setting"]) == (engine, setting) and row["case"] in cases]
        own = [row for row in own if row["reference"] != "falls"]
        if cases == WALLS and len(own) < len(WALLS):
            continue
        errors = [100 * float(row["error"]) for row in own if row["error"]]
        if errors:
            seconds = median([float(row["seconds"]) for row in own if row["error"]])
            yield setting, seconds, median(errors), max(errors), len(errors), len(own)


def text(x, y, words, size=11, anchor="start", extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}"{extra}>{words}</text>'


def line(x1, y1, x2, y2, colour, width=1.0, extra=""):
    path = f"M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}"
    return f'<path d="{path}" stroke="{colour}" stroke-width="{width}" fill="none"{extra}/>'


def mark(engine, x, y):
    look = f'fill="{LOOKS[engine][0]}" stroke="#fff" stroke-width="1"'
    if engine == "lmgc90":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.4" {look}/>'
    left, right, top, bottom = x - 4.6, x + 4.6, y - 4.4, y + 4.4
    rest = f"L{x:.1f} {bottom:.1f}Z" if engine == "pushover" else f"V{bottom:.1f}H{left:.1f}Z"
    return f'<path d="M{left:.1f} {top:.1f}H{right:.1f}{rest}" {look}/>'


def panel(left, title, rows, cases):
    across = (PANEL - 20) / (TIMES[1] - TIMES[0])
    along = (BOTTOM - TOP) / (ERRORS[1] - ERRORS[0])
    place = lambda seconds, error: (
        left + (min(max(math.log10(seconds), TIMES[0]), TIMES[1]) - TIMES[0]) * across,
        BOTTOM - (min(max(math.log10(error), ERRORS[0]), ERRORS[1]) - ERRORS[0]) * along,
    )
    right = left + (TIMES[1] - TIMES[0]) * across
    out = [text(left, TOP - 12, title, 12, extra=' font-weight="700"')]
    for decade in range(int(TIMES[0]), int(TIMES[1]) + 1):
        x, _ = place(10.0**decade, 1.0)
        out += [line(x, TOP, x, BOTTOM, PALE), text(x, BOTTOM + 16, f"{10.0**decade:g}", anchor="middle")]
    for decade in range(math.ceil(ERRORS[0]), math.floor(ERRORS[1]) + 1):
        _, y = place(1.0, 10.0**decade)
        out += [line(left, y, right, y, PALE), text(left - 6, y + 4, f"{10.0**decade:g}", anchor="end")]
    out += [line(left, BOTTOM, right, BOTTOM, INK), line(left, TOP, left, BOTTOM, INK)]
    out.append(text((left + right) / 2, BOTTOM + 34, "CPU time of the median scene, seconds", anchor="middle"))
    notes, taken = [], []
    for engine in ENGINES:
        found, colour = sorted(points(rows, engine, cases), key=lambda point: point[1]), LOOKS[engine][0]
        ladder = [place(seconds, most) for setting, seconds, _, most, _, _ in found if "--hertz" not in setting]
        out += [line(*one, *other, colour, 1.2, ' stroke-opacity="0.45"') for one, other in zip(ladder, ladder[1:])]
        for setting, seconds, middle, most, answered, asked in found:
            x, y = place(seconds, most)
            out += [line(x, y, *place(seconds, middle), colour, 2.0), mark(engine, x, y)]
            taken.append((x - 5, y - 5, x + 5, y + 5))
            note = short(setting) + (f" ({answered} of {asked})" if answered < asked else "")
            notes.append((x, y, note, colour))
    for x, y, note, colour in notes:
        label(out, taken, x, y, note, colour)
    return out


def label(out, taken, x, y, note, colour):
    """Beside its mark where there is room; what lies among others goes without."""
    wide = 5.6 * len(note)
    for right, base in ((True, y - 5), (True, y + 13), (False, y - 5), (False, y + 13)):
        left, anchor = (x + 7, "start") if right else (x - 7 - wide, "end")
        box = (left, base - 9, left + wide, base + 2)
        if all(box[2] < a or box[0] > c or box[3] < b or box[1] > d for a, b, c, d in taken):
            taken.append(box)
            out.append(text(left if right else left + wide, base, note, 10, anchor, f' fill="{colour}"'))
            return


def main():
    rows = measured()
    exact = [case for case in EXACT if "falls" not in case]
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}"',
        f'role="img" aria-label="Error against CPU time of three engines" font-family="{FONT}" fill="{INK}">',
        "<title>Error against CPU time of three engines</title>",
        '<rect width="100%" height="100%" fill="#fff"/>',
        text(14, 26, "Three engines: error against CPU time", 15, extra=' font-weight="700"'),
    ]
    x = 14
    for engine in ENGINES:
        out += [mark(engine, x + 5, 44), text(x + 15, 48, LOOKS[engine][1], 12)]
        x += 30 + 7 * len(LOOKS[engine][1])
    out.append(text(x + 8, 48, "mark: the worst scene; bar: down to the median scene", 12))
    out += panel(LEFT, f"{len(exact)} scenes with exact answers", rows, exact)
    out += panel(LEFT + PANEL + 60, "paper-1 and paper-2, head joints open", rows, WALLS)
    middle = (TOP + BOTTOM) / 2
    out.append(text(18, middle, "error, %", 11, "middle", f' transform="rotate(-90 18 {middle:.0f})"'))
    sys.stdout.write("\n".join([*out, "</svg>"]) + "\n")


if __name__ == "__main__":
    main()
