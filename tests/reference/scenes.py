#!/usr/bin/env python3
"""Random scenes as case files, from a fixed seed, for `judge.py`.

    tests/reference/scenes.py FOLDER [COUNT] [SEED] [KIND ...]

Walls in running bond, of irregular units, with openings, under overburden or a heavy cap; piles cut
from a box at random, some of which fall; stacks; arches. Weights and sizes spread over decades, live
loads small and large, friction from none to Heyman's. Kinds that are made on request alone: `both`,
any of these pushed both ways; `sideways`, with dead loads sideways; `below`, blocks on slopes, props
and leaning piles, whose friction at rest is not determined; `one-stone`, a live load on one stone;
`proof`, walls and piles of 12 to 20 blocks; `moves`, a support that moves; `keys`, what single courses,
joints and blocks have of their own, and weights that push upwards. Shares nothing with the program.
"""
import json
import sys
from pathlib import Path

import numpy as np

from geometry import contacts


def rounded(value, digits=3):
    return round(float(value), digits)


def spread(rng, low, high):
    return float(f"{10 ** rng.uniform(low, high):.4g}")


def head(rng, kind):
    return [f"# {kind}", f"friction = {friction(rng)}", f'head_joints = "{rng.choice(["contact", "open"])}"',
            f'push = "{rng.choice(["right", "right", "left", "both"])}"']


def friction(rng):
    few = rng.random()
    return 0.0 if few < 0.03 else spread(rng, 1, 6) if few < 0.06 else rounded(rng.uniform(0.2, 1.2))


def running(rng, courses, units):
    rows = ["1" * units, "h" + "1" * (units - 1) + "h"]
    first = rng.integers(2)
    return [rows[(first + k) % 2] for k in range(courses)]


def with_holes(rng, rows, holes):
    """Whole units left out below the top course."""
    for _ in range(holes):
        k = int(rng.integers(0, len(rows) - 1))
        at = [i for i, piece in enumerate(rows[k]) if piece == "1"]
        if len(at) > 1:
            i = int(rng.choice(at))
            rows[k] = rows[k][:i] + "g" + rows[k][i + 1:]
    return rows


def coursed(rng, kind):
    rows = running(rng, int(rng.integers(2, 7)), int(rng.integers(2, 5)))
    if kind == "openings":
        rows = with_holes(rng, rows, int(rng.integers(1, 4)))
    over = 0.0 if kind == "running" else rounded(rng.choice([0.0, rng.uniform(0, 6)]))
    size = spread(rng, -3, 3) if rng.random() < 0.2 else 1.0
    courses = ", ".join(f'"{row}"' for row in rows)
    return head(rng, kind) + [
        f"unit = {{ length = {rounded(rng.uniform(1, 4.5)) * size!r}, height = {rounded(rng.uniform(0.6, 2.4)) * size!r}, "
        f"weight = {spread(rng, -3, 6)!r} }}", f"courses = [{courses}]", f"overburden = {over}"]


def shapes_file(lines, shapes, weights, supports, live="weight", loads=()):
    lines = lines + [f'live = "{live}"', "[blocks]", "specific_weight = 1.0"]
    corner = lambda shape: "[" + ", ".join(f"[{x!r}, {y!r}]" for x, y in shape) + "]"
    for index, shape in enumerate(supports):
        lines += ["[[support]]", f'name = "s{index}"', f"corners = {corner(shape)}"]
    for index, (shape, weight) in enumerate(zip(shapes, weights)):
        lines += ["[[block]]", f'name = "b{index}"', f"corners = {corner(shape)}"]
        lines += [f"weight = {weight!r}"] if weight else []
    for index, live_x, live_y, dead_y in loads:
        x, y = np.mean(shapes[index], axis=0)
        lines += ["[[load]]", f'block = "b{index}"', f"at = [{float(x)!r}, {float(y)!r}]",
                  f"dead = [0.0, {dead_y!r}]", f"live = [{live_x!r}, {live_y!r}]"]
    return lines


def box(x0, x1, y0, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def irregular(rng, _kind):
    """Courses of unequal heights and units, sometimes under a heavy cap."""
    y, shapes, weights, before = 0.0, [], [], []
    decades = rng.choice([0, 0, 0, 2, 6])
    for _ in range(int(rng.integers(2, 6))):
        h = rounded(rng.uniform(0.5, 1.6), 2)
        for _ in range(200):
            parts = rng.uniform(0.6, 1.8, int(rng.integers(2, 5)))
            cuts = [rounded(c, 2) for c in (np.cumsum(parts) / parts.sum() * 8)[:-1]]
            if all(abs(c - b) > 0.1 for c in cuts for b in before):
                break
        before, ends = cuts, [0.0, *cuts, 8.0]
        top = rounded(y + h, 2)
        shapes += [box(a, b, y, top) for a, b in zip(ends, ends[1:])]
        weights += [spread(rng, -decades / 2, decades / 2) if decades else None for _ in ends[1:]]
        y = top
    if rng.random() < 0.3:
        shapes.append(box(0.0, 8.0, y, y + 0.5))
        weights.append(spread(rng, 0, 2))
    return shapes_file(head(rng, "irregular"), shapes, weights, [box(-20.0, 30.0, -1.0, 0.0)])


def cut(shape, through, along):
    """The two parts of a convex polygon on both sides of a line."""
    sides, count = ([], []), len(shape)
    height = [along[0] * (y - through[1]) - along[1] * (x - through[0]) for x, y in shape]
    for i in range(count):
        (p, a), (q, b) = (shape[i], height[i]), (shape[(i + 1) % count], height[(i + 1) % count])
        sides[int(a < 0)].append(p)
        if (a < 0) != (b < 0):
            on = tuple(float(v) for v in np.array(p) + (np.array(q) - p) * (a / (a - b)))
            sides[0].append(on), sides[1].append(on)
    return sides


def area(shape):
    p = np.array(shape)
    q = np.roll(p, -1, axis=0)
    return float((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum() / 2)


def sound(shape, whole):
    """Big enough, and without an edge or a bend that a case file would be refused for."""
    if len(shape) < 3:
        return False
    p = np.array(shape)
    edges = np.roll(p, -1, axis=0) - p
    long = np.hypot(*edges.T)
    if area(shape) < 0.01 * whole or long.min() < 0.02 * long.max():
        return False
    turn = edges[:, 0] * np.roll(edges[:, 1], -1) - edges[:, 1] * np.roll(edges[:, 0], -1)
    return (turn > 0.02 * long * np.roll(long, -1)).all()


def held(shapes, supports):
    """The pieces that a chain of joints connects with a support: others are no scene."""
    touch = lambda a, b: any(c[2] > 1e-6 for c in contacts(np.array(a), np.array(b), 1e-6))
    reached, kept, left = list(supports), [], list(shapes)
    while reached:
        body = reached.pop()
        new = [shape for shape in left if touch(body, shape) or touch(shape, body)]
        left = [shape for shape in left if shape not in new]
        reached += new
        kept += new
    return sorted(kept)


def pile(rng, _kind):
    """A box cut at random, some pieces missing, perhaps between walls."""
    wide, high = rng.uniform(2, 6), rng.uniform(1.5, 5)
    shapes = [box(0.0, rounded(wide), 0.0, rounded(high))]
    wide, high = shapes[0][2]
    for _ in range(int(rng.integers(3, 10))):
        largest = max(range(len(shapes)), key=lambda i: area(shapes[i]))
        low, top = np.min(shapes[largest], axis=0), np.max(shapes[largest], axis=0)
        through = low + (top - low) * rng.uniform(0.3, 0.7, 2)
        angle = rng.choice([0.0, 0.0, np.pi / 2, rng.uniform(0, np.pi)])
        along = (1.0, 0.0) if angle == 0 else (0.0, 1.0) if angle == np.pi / 2 else (np.cos(angle), np.sin(angle))
        parts = cut(shapes[largest], through, along)
        if all(sound(part, wide * high) for part in parts):
            shapes[largest:largest + 1] = parts
    kept = [shape for shape in shapes if rng.random() > 0.08]
    supports = [box(-20.0, 30.0, -1.0, 0.0)]
    supports += [box(wide, wide + 1.0, 0.0, high)] if rng.random() < 0.4 else []
    supports += [box(-1.0, 0.0, 0.0, high)] if rng.random() < 0.2 else []
    kept = held(kept, supports) or held(shapes, supports)
    decades = rng.choice([0, 0, 1, 3, 6])
    weights = [float(f"{area(s) * spread(rng, -decades / 2, decades / 2):.6g}") for s in kept]
    return shapes_file(head(rng, "pile"), kept, weights, supports)


def stack(rng, _kind):
    """Blocks on one another, pushed by their weights or by a force on one of them."""
    shapes, y, x = [], 0.0, 0.0
    size = spread(rng, -3, 3)
    for _ in range(int(rng.integers(1, 6))):
        wide, tall = rng.uniform(0.5, 3, 2)
        x += rng.uniform(-0.15, 0.15)
        shapes.append(box(*(float(f"{v * size:.6g}") for v in (x - wide / 2, x + wide / 2)), y,
                          float(f"{y + tall * size:.6g}")))
        y = shapes[-1][2][1]
    weights = [float(f"{area(s) * spread(rng, -1, 1):.6g}") for s in shapes]
    ground = box(-50 * size, 50 * size, -size, 0.0)
    if rng.random() < 0.5:
        return shapes_file(head(rng, "stack"), shapes, weights, [ground])
    index, push = int(rng.integers(len(shapes))), spread(rng, -6, 6)
    load = (index, float(f"{push * max(weights):.6g}"), 0.0, -float(f"{rng.uniform(0, 2) * max(weights):.6g}"))
    return shapes_file(head(rng, "stack"), shapes, weights, [ground], "loads", [load])


def arch(rng, kind):
    radius = spread(rng, -2, 2)
    thickness = float(f"{radius * rng.uniform(0.05, 0.4):.5g}")
    lines = head(rng, kind)
    # An arch has no head joints.
    return [line for line in lines if not line.startswith("head_joints")] + [
        "[arch]", f"mean_radius = {radius!r}", f"thickness = {thickness!r}", f"embrace = {rounded(rng.uniform(60, 180), 1)}",
        f"voussoirs = {int(rng.integers(3, 16))}", f"specific_weight = {spread(rng, -2, 3)!r}"]


def both(rng, _kind):
    """Any scene, pushed both ways."""
    # Without the stacks: a case file would be refused for the loads of some.
    lines = of_kind(rng, str(rng.choice([kind for kind in KINDS if kind != "stack"])))
    return ['push = "both"' if line.startswith("push =") else line for line in lines]


def corners_of(lines):
    """The outlines of a case's blocks, by name; none for courses and arches."""
    found, name, block = {}, None, False
    for line in lines:
        block = line == "[[block]]" if line.startswith("[") else block
        if line.startswith("name ="):
            name = line.split('"')[1]
        if line.startswith("corners =") and block:
            found[name] = np.array(json.loads(line.split("=", 1)[1]))
    return found


def with_loads(rng, lines, count, load):
    """The case with loads at the middle of some of its blocks."""
    shapes = corners_of(lines)
    for name in rng.choice(sorted(shapes), min(count, len(shapes)), replace=False):
        x, y = shapes[name].mean(axis=0)
        dead, live = load(rng)
        lines = lines + ["[[load]]", f'block = "{name}"', f"at = [{float(x)!r}, {float(y)!r}]",
                         f"dead = {dead}", f"live = {live}"]
    return lines


def sideways(rng, _kind):
    """Dead loads sideways, small beside the weights and large."""
    lines = of_kind(rng, str(rng.choice(["irregular", "pile"])))
    push = lambda rng: ([rounded(rng.uniform(-0.4, 0.4)), rounded(rng.uniform(-1, 0))], [0.0, 0.0])
    return with_loads(rng, lines, int(rng.integers(1, 4)), push)


def one_stone(rng, _kind):
    """A live load on one stone, which may or may not move the wall."""
    lines = of_kind(rng, str(rng.choice(["irregular", "pile"])))
    lines = ['live = "loads"' if line.startswith('live = "') else line for line in lines]
    load = lambda rng: ([0.0, 0.0], [float(rng.choice([0.0, 0.0, 1.0, -1.0])), float(rng.choice([-1.0, -1.0, 0.5]))])
    return with_loads(rng, lines, 1, load)


def turned(shapes, angle):
    c, s = np.cos(angle), np.sin(angle)
    return [[(float(c * x - s * y), float(s * x + c * y)) for x, y in shape] for shape in shapes]


def below(rng, _kind):
    """Blocks on a slope, posts that a lintel presses beside loads sideways, and piles that lean."""
    mu = rounded(rng.uniform(0.4, 1.0))
    lines = [f"friction = {mu}", 'head_joints = "contact"', f'push = "{rng.choice(["right", "left", "both"])}"']
    form = rng.choice(["slope", "props", "lean"])
    if form == "slope":
        # Between walls across the slope, friction may hold more than the weights need.
        shapes, x = [], 0.0
        for _ in range(int(rng.integers(1, 5))):
            wide, tall = rng.uniform(0.6, 2, 2)
            shapes.append(box(x, x + wide, 0.0, tall))
            x += wide
        angle = rng.uniform(-0.9, 0.9) * np.arctan(mu)
        supports = [box(-10.0, 20.0, -1.0, 0.0)] + ([box(x, x + 1.0, 0.0, 3.0)] if rng.random() < 0.5 else [])
        return shapes_file(lines, turned(shapes, angle), [None] * len(shapes), turned(supports, angle))
    if form == "props":
        count = int(rng.integers(2, 5))
        shapes, x = [], 0.0
        for _ in range(count):
            wide = rng.uniform(0.6, 1.4)
            shapes.append(box(x, x + wide, 0.0, 1.0))
            x += wide + rng.uniform(0.5, 2)
        shapes.append(box(0.0, shapes[-1][1][0], 1.0, 1.0 + rng.uniform(0.3, 1.2)))
        lines = shapes_file(lines, shapes, [None] * len(shapes), [box(-5.0, x + 5, -1.0, 0.0)])
        index = int(rng.integers(count))
        at = np.mean(shapes[index], axis=0)
        return lines + ["[[load]]", f'block = "b{index}"', f"at = [{float(at[0])!r}, {float(rng.uniform(0.1, 0.6))!r}]",
                        f"dead = [{rounded(rng.uniform(-1.2, 1.2))}, 0.0]", "live = [0.0, 0.0]"]
    # Cubes that hang over, held by a weight behind, as in a clamp.
    over = rng.uniform(0.2, 0.75)
    shapes = [box(-0.5, 0.5, 1.0, 2.0), box(-0.5 - over, 0.5 - over, 2.0, 3.0), box(-0.5, 0.5, 3.0, 4.0),
              box(over, 1.0 + over, 2.0, 3.0)]
    gap = shapes[3][0][0] - shapes[1][1][0]
    if gap < 0.05:
        shapes[3] = box(shapes[1][1][0] + 0.05, shapes[1][1][0] + 1.05, 2.0, 3.0)
    supports = [box(-6.0, rng.uniform(-0.1, 0.4), 0.0, 1.0)]
    kept = held(shapes, supports)
    return shapes_file(lines, kept, [None] * len(kept), supports)


def proof(rng, _kind):
    """Walls and piles of 12 to 20 blocks: under overburden, of low friction, of unequal weights."""
    for _ in range(1000):
        kind = str(rng.choice(["overburden", "irregular", "pile", "running"]))
        lines = coursed(rng, kind) if kind in ("overburden", "running") else of_kind(rng, kind)
        if kind in ("overburden", "running"):
            courses = next(line for line in lines if line.startswith("courses"))
            count = sum(courses.count(piece) for piece in "1h") - courses.split("=")[0].count("h")
        else:
            count = len(corners_of(lines))
        if 12 <= count <= 20:
            low = rng.random() < 0.3
            return [f"friction = {rounded(rng.uniform(0.08, 0.3))}" if low and line.startswith("friction") else line
                    for line in lines]
    raise RuntimeError("no scene of that size")


def moves(rng, _kind):
    """Walls on ground that sinks or rises under some units, irregular ones on piers, arches: one support moves or two."""
    kind = str(rng.choice(["running", "openings", "overburden", "piers", "piers", "arch"]))
    sense = rng.choice(["away", "against"])
    tilt = rng.choice([0.0, 0.0, rng.uniform(-0.6, 0.6)])
    direction = [float(np.sin(tilt)), -float(np.cos(tilt))]
    if kind == "arch":
        lines, where = arch(rng, kind), [f'support = "{rng.choice(["left", "right"])}"']
        # Outwards and down: one that rises may press the springing into the arch, which is refused.
        tilt = rng.uniform(-0.8, 0.0)
        direction = [float(np.cos(tilt)) * (1 if "right" in where[0] else -1), float(np.sin(tilt))]
    elif kind == "piers":
        lines = irregular(rng, kind)
        ground = next(k for k, line in enumerate(lines) if line == "[[support]]")
        ends = [0.0, *sorted(rounded(x, 2) for x in rng.choice(np.arange(1.5, 7.0, 0.7), 2, replace=False)), 8.0]
        piers = [box(a, b - rng.choice([0.0, 0.0, 0.6]), -1.0, 0.0) for a, b in zip(ends, ends[1:])]
        written = []
        for index, shape in enumerate(piers):
            corners = ", ".join(f"[{float(x)!r}, {float(y)!r}]" for x, y in shape)
            written += ["[[support]]", f'name = "s{index}"', f"corners = [{corners}]"]
        lines = lines[:ground] + written + lines[ground + 3:]
        chosen = rng.choice(3, rng.choice([1, 1, 2]), replace=False)
        where = [f'support = "s{index}"' for index in chosen]
    else:
        lines = coursed(rng, kind)
        count = next(line for line in lines if line.startswith("courses")).split('"')[1]
        # From a unit on, as a gap stands on nothing.
        first = int(rng.choice([k + 1 for k, piece in enumerate(count) if piece != "g"]))
        last = int(rng.integers(first, len(count) + 1))
        where = [f'units = "{first}-{last}"']
    lines = [line.replace("both", "right") if line.startswith("push") else line for line in lines]
    about = [f"about = [{rounded(rng.uniform(-9, -3))}, {rounded(rng.uniform(-0.4, -0.1))}]"]
    about = about if kind != "arch" and rng.random() < 0.25 else []
    direction = [0.0, -1.0] if about else direction
    for place in where:
        lines += ["[[move]]", place, f"direction = {direction}", f'moves = "{sense}"', *about]
    return lines


def touching(lines):
    """Names of every two blocks of a case that share an edge, and whether that is plumb; "s0" is the ground."""
    shapes = corners_of(lines)
    names = sorted(shapes)
    for k, first in enumerate(names):
        for second in names[k + 1:]:
            found = [c for c in contacts(shapes[first], shapes[second], 1e-6) if c[2] > 1e-3]
            if len(found) == 1:
                yield first, second, abs(found[0][1][0]) > abs(found[0][1][1])


def table(**keys):
    return "{ " + ", ".join(f"{key} = {json.dumps(value)}" for key, value in keys.items()) + " }"


def of_own_courses(rng):
    """A coursed wall with heights, beds, open head joints and single stones of its own."""
    lines = coursed(rng, str(rng.choice(["running", "openings", "overburden"])))
    rows = json.loads(next(line for line in lines if line.startswith("courses")).split("=", 1)[1])
    unit = next(line for line in lines if line.startswith("unit"))
    high = float(unit.split("height = ")[1].split(",")[0])
    some = lambda: sorted(int(k) + 1 for k in rng.choice(len(rows), int(rng.integers(1, len(rows) + 1)), replace=False))
    if rng.random() < 0.6:
        lines.append(f"heights = {[float(f'{high * rng.uniform(0.5, 1.8):.4g}') for _ in rows]}")
    if rng.random() < 0.5:
        lines = [line for line in lines if not line.startswith("head_joints")]
        lines += [f'head_joints = "{rng.choice(["contact", "both"])}"', f"open_head_joints = {some()}"]
    joints = [table(course=k, friction=friction(rng)) for k in some()] if rng.random() < 0.6 else []
    if rng.random() < 0.4:
        # One stone above another: the first of the upper course lies on the first of the lower one.
        first = [1 + next(i for i, piece in enumerate(rows[k]) if piece != "g") for k in (0, 1)]
        if first == [1, 1]:
            joints.append(table(between=["course 2 piece 1", "course 1 piece 1"], friction=friction(rng)))
    lines += [f"joints = [{', '.join(joints)}]"] if joints else []
    for row in some()[:2] if rng.random() < 0.6 else []:
        piece = int(rng.choice([i + 1 for i, piece in enumerate(rows[row - 1]) if piece != "g"]))
        lines += ["[[block]]", f"course = {row}", f"piece = {piece}", f"friction = {friction(rng)}"]
        weight = float(unit.split("weight = ")[1].split(" ")[0])
        lines += [f"weight = {weight * rounded(rng.uniform(0.3, 4))!r}"] if rng.random() < 0.5 else []
    return lines


def of_own_blocks(rng):
    """Explicit blocks with frictions, specific weights and joints of their own, under overburden."""
    lines = irregular(rng, "irregular") if rng.random() < 0.6 else pile(rng, "pile")
    names, out, place = sorted(corners_of(lines)), [], 0
    for line in lines:
        out.append(line)
        if line.startswith("corners") and place < len(names) and '"b' in out[-2]:
            place += 1
            if rng.random() < 0.3:
                out.append(f"friction = {friction(rng)}")
    if rng.random() < 0.5:
        out = [f"specific_weight = {rounded(rng.uniform(0.3, 4))}" if line.startswith("weight") else line for line in out]
    lines = out
    level = max(y for shape in corners_of(lines).values() for _, y in shape)
    flat = any(sum(abs(y - level) < 1e-9 for _, y in shape) > 1 for shape in corners_of(lines).values())
    if flat and rng.random() < 0.6:
        lines.insert(1, f"overburden = {rounded(rng.uniform(0, 4))}")
    for first, second, plumb in touching(lines):
        if rng.random() < 0.25:
            lines += ["[[joint]]", f'between = ["{first}", "{second}"]']
            if not plumb or rng.random() < 0.5:
                lines.append(f"friction = {friction(rng)}")
            else:
                lines += ['class = "head"', "open = true"]
    return lines


def keys(rng, _kind):
    """What single courses, joints and blocks have of their own, and weights that push upwards too."""
    lines = of_own_courses(rng) if rng.random() < 0.6 else of_own_blocks(rng)
    if rng.random() < 0.5:
        lines = [line for line in lines if not line.startswith("live =")]
        lines.insert(1, f"live = {table(weight=[1, rounded(rng.uniform(-0.6, 0.6))])}")
    return lines


def of_kind(rng, kind):
    makers = {"keys": keys, "moves": moves, "irregular": irregular, "pile": pile, "stack": stack, "arch": arch, "both": both,
              "sideways": sideways, "one-stone": one_stone, "below": below, "proof": proof}
    return makers.get(kind, coursed)(rng, kind)


def one(rng, kind):
    return "\n".join(of_kind(rng, kind)) + "\n"


KINDS = ["running", "openings", "overburden", "irregular", "pile", "pile", "stack", "arch"]


def main():
    folder = Path(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 500
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 12
    kinds = sys.argv[4:] or KINDS
    folder.mkdir(parents=True, exist_ok=True)
    for index in range(count):
        # Each scene has a seed of its own, so that any of them can be made alone.
        rng = np.random.default_rng([seed, index])
        kind = kinds[index % len(kinds)]
        (folder / f"{kind}-{index:04d}.toml").write_text(one(rng, kind))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main()
