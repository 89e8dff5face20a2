"""Writes drawings of this folder as surveys and publications have them, with ezdxf (ezdxf==1.4.5):

    tests/drawings/surveyed.py FOLDER

The running bond of `generate.py` once in each odd way, and rubble with gaps: cells about points in rows, 1.7 times as
wide as high, inset by half the gap. The tests need only the files that are kept here.
"""
import math, pathlib, random, sys
import ezdxf
from ezdxf.math import OCS, Vec3

out = pathlib.Path(sys.argv[1])
out.mkdir(exist_ok=True, parents=True)


def rect(x, y, w, h):
    return [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]


def bond(courses=4, units=3, long=500.0, high=250.0):
    for course in range(courses):
        ends = [long * k for k in range(units + 1)]
        if course % 2:
            ends = [0.0] + [end + long / 2 for end in ends[:-1]] + [long * units]
        for left, right in zip(ends, ends[1:]):
            yield rect(left, course * high, right - left, high)


WALL, GROUND = list(bond()), rect(-1000, -250, 3500, 250)


def new(version="R2010"):
    drawing = ezdxf.new(version, setup=False)
    drawing.header["$INSUNITS"] = 4
    for layer in ("stones", "support", "notes", "openings"):
        drawing.layers.add(layer)
    return drawing, drawing.modelspace()


def plain(model, stones=WALL, ground=GROUND):
    for corners in stones:
        model.add_lwpolyline(corners, close=True, dxfattribs={"layer": "stones"})
    model.add_lwpolyline(ground, close=True, dxfattribs={"layer": "support"})


# Past its start: along the first edge, with and without the flag of a closed polyline, and along two edges.
drawing, model = new()
for k, corners in enumerate(WALL + [GROUND]):
    (x, y), second = corners[0], corners[1]
    beyond = [(x + (second[0] - x) * 0.3, y)] if k % 3 < 2 else [second, (second[0], y + 100)]
    layer = "support" if corners is GROUND else "stones"
    model.add_lwpolyline(corners + corners[:1] + beyond, close=k % 2 == 0, dxfattribs={"layer": layer})
drawing.saveas(out / "runs-on.dxf")

# Release 10: a header, no tables, no handles, spaces before the codes, lines in space as 3DLINE.
lines = ["  0", "SECTION", "  2", "HEADER", "  9", "$ACADVER", "  1", "AC1006", "  0", "ENDSEC"]
lines += ["  0", "SECTION", "  2", "ENTITIES"]
for k, corners in enumerate(WALL + [GROUND]):
    layer = "SUPPORT" if corners is GROUND else "STONES"
    if k % 2:
        for (x, y), (p, q) in zip(corners, corners[1:] + corners[:1]):
            lines += ["  0", "3DLINE", "  8", layer, " 10", f"{x}", " 20", f"{y}", " 30", "0.0"]
            lines += [" 11", f"{p}", " 21", f"{q}", " 31", "0.0"]
        continue
    lines += ["  0", "POLYLINE", "  8", layer, " 66", "     1", " 70", "     1"]
    for x, y in corners:
        lines += ["  0", "VERTEX", "  8", layer, " 10", f"{x}", " 20", f"{y}"]
    lines += ["  0", "SEQEND", "  8", layer]
(out / "release-10.dxf").write_text("\r\n".join(lines + ["  0", "ENDSEC", "  0", "EOF", ""]))

# Vertical planes: polylines in space, and lines.
for name, place in (("xz", lambda x, y: (x, 40.0, y)), ("yz", lambda x, y: (-7.0, x, y))):
    drawing, model = new()
    for k, corners in enumerate(WALL + [GROUND]):
        layer, points = ("support" if corners is GROUND else "stones"), [place(x, y) for x, y in corners]
        if k % 2:
            for a, b in zip(points, points[1:] + points[:1]):
                model.add_line(a, b, dxfattribs={"layer": layer})
        else:
            model.add_polyline3d(points, close=True, dxfattribs={"layer": layer})
    drawing.saveas(out / f"plane-{name}.dxf")

# Light polylines in the plane of x and z, which have coordinates of their own there; every other is seen from behind.
drawing, model = new()
for k, corners in enumerate(WALL + [GROUND]):
    normal = Vec3(0, 1 if k % 2 else -1, 0)
    ocs = OCS(normal)
    points = [ocs.from_wcs(Vec3(x, 300, y)) for x, y in corners]
    attributes = {"layer": "support" if corners is GROUND else "stones", "extrusion": normal}
    model.add_lwpolyline([p.vec2 for p in points], close=True, dxfattribs=attributes | {"elevation": points[0].z})
drawing.saveas(out / "from-behind.dxf")


# Joint lines alone: the outer sides, the beds, and the heads of each course, some a little long or short.
def joint_lines(model):
    for a, b in (((0, 0), (1500, 0)), ((1500, 0), (1500, 1000)), ((1500, 1000), (0, 1000)), ((0, 1000), (0, 0))):
        model.add_line(a, b, dxfattribs={"layer": "stones"})
    for course in range(1, 4):
        model.add_line((0, course * 250), (1500, course * 250), dxfattribs={"layer": "stones"})
    for course in range(4):
        for x in (500, 1000) if course % 2 == 0 else (250, 750, 1250):
            off = 0.2 * (course - 1)
            ends = (x, course * 250 + (off if course else 0)), (x, course * 250 + 250 - (off if course < 3 else 0))
            model.add_line(*ends, dxfattribs={"layer": "stones"})
    model.add_lwpolyline(GROUND, close=True, dxfattribs={"layer": "support"})


drawing, model = new()
joint_lines(model)
drawing.saveas(out / "joint-lines.dxf")
model.add_lwpolyline(rect(250, 250, 1000, 250), close=True, dxfattribs={"layer": "openings"})
drawing.saveas(out / "joint-lines-opening.dxf")

# Some stones twice, from another corner on, with corners off and one more.
drawing, model = new()
plain(model)
for k, corners in enumerate(WALL[::3]):
    again = [(x + 0.4 * (-1) ** k, y - 0.3) for x, y in corners[2:] + corners[:2]]
    again.insert(1, ((again[0][0] + again[1][0]) / 2, again[0][1]))
    model.add_lwpolyline(again, close=True, dxfattribs={"layer": "notes"})
drawing.saveas(out / "twice-off.dxf")

# What nobody sees.
drawing, model = new()
plain(model)
for layer in ("draft", "old"):
    drawing.layers.add(layer)
drawing.layers.get("draft").freeze()
drawing.layers.get("old").off()
for k, attributes in enumerate(({"layer": "draft"}, {"layer": "old"}, {"layer": "stones", "invisible": 1})):
    model.add_lwpolyline(rect(100 * k, 1000, 300, 200), close=True, dxfattribs=attributes)
drawing.saveas(out / "frozen-off-invisible.dxf")

# Coordinates of a survey grid, in millimetres.
drawing, model = new()
far = lambda corners: [(x + 4_512_345_000, y + 312_345_000) for x, y in corners]
plain(model, [far(corners) for corners in WALL], far(GROUND))
drawing.saveas(out / "survey-grid.dxf")

# A sheet with a frame in paper space, text, a hatch, a dimension.
drawing, model = new()
plain(model)
model.add_text("north side", dxfattribs={"layer": "notes"})
hatch = model.add_hatch(dxfattribs={"layer": "notes"})
hatch.paths.add_polyline_path(WALL[0], is_closed=True)
model.add_linear_dim(base=(0, 1200), p1=(0, 1000), p2=(1500, 1000)).render()
drawing.layout("Layout1").add_lwpolyline(rect(0, 0, 297, 210), close=True)
drawing.saveas(out / "sheet.dxf")


# Rubble: cells of points in rows, cut out of the wall's rectangle by the lines half-way between points.
def clipped(polygon, point, normal):
    kept = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        da, db = ((p[0] - point[0]) * normal[0] + (p[1] - point[1]) * normal[1] for p in (a, b))
        if da <= 0:
            kept.append(a)
        if (da < 0 < db) or (db < 0 < da):
            t = da / (da - db)
            kept.append((a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t))
    return kept


def rubble(rows=5, columns=6, seed=8):
    rng = random.Random(seed)
    points = [(k + 0.5 + (0.2 if row % 2 else -0.2) + rng.uniform(-0.2, 0.2), row + 0.5 + rng.uniform(-0.13, 0.13))
              for row in range(rows) for k in range(columns)]
    stones = []
    for p in points:
        cell = rect(0, 0, columns, rows)
        for q in points:
            if p != q:
                cell = clipped(cell, ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2), (q[0] - p[0], q[1] - p[1]))
        stones.append([(x * 425.0, y * 250.0) for x, y in cell])
    return stones, columns * 425.0, rows * 250.0


def inset(polygon, gap, kept):
    lines = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        length = math.dist(a, b)
        way = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
        by = 0 if kept(a, b) else gap / 2
        lines.append(((a[0] - way[1] * by, a[1] + way[0] * by), way))
    corners = []
    for (p, s), (q, t) in zip(lines[-1:] + lines[:-1], lines):
        part = ((q[0] - p[0]) * t[1] - (q[1] - p[1]) * t[0]) / (s[0] * t[1] - s[1] * t[0])
        corners.append((p[0] + s[0] * part, p[1] + s[1] * part))
    return corners


stones, wide, high = rubble()
face = lambda a, b: any(abs(a[k] - v) + abs(b[k] - v) < 1e-6 for k, v in ((0, 0), (0, wide), (1, high)))
rng = random.Random(5)
for name, gap, kept, noise in (
    ("0", 0, face, 0),
    ("0.2", 0.2, face, 0),
    ("5", 5, face, 0),
    ("15", 15, face, 0),
    ("10-all-about", 10, lambda a, b: False, 0),
    ("10-noise", 10, face, 0.5),
):
    drawing, model = new()
    drawn = [inset(stone, gap, kept) for stone in stones]
    drawn = [[(x + rng.uniform(-noise, noise), y + rng.uniform(-noise, noise)) for x, y in stone] for stone in drawn]
    plain(model, drawn, rect(-1000, -250, wide + 2000, 250))
    drawing.saveas(out / f"rubble-{name}.dxf")
