"""What a scene owes its polygons and its case file, for `judge.py`: centroids, loads and joints are
derived here again, and what differs is told in a line each."""
import csv

import numpy as np

import bonds
from own import Own, levels, live_of_weight

try:
    import tomllib
except ImportError:  # Python before 3.11: scenes are not laid again
    tomllib = None

TOUCH = 1e-6  # edges touch within this part of the smaller body's extent, unless the file says otherwise


def area_and_centroid(corners):
    p = corners - corners[0]
    q = np.roll(p, -1, axis=0)
    cross = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    area = cross.sum() / 2
    return area, corners[0] + ((p + q) * cross[:, None]).sum(0) / (6 * area)


def extent(corners):
    return np.hypot(*np.ptp(corners, axis=0))


def violations(scene, touch=None, file=None):
    """Lines about blocks whose loads do not add up and joints that the polygons do not have, or lack; with a case
    file, which may call a joint open or a head joint, that is known."""
    blocks = [np.array(b["corners"], float) for b in scene["blocks"]]
    supports = [np.array(s["corners"], float) for s in scene["supports"]]
    for index, (corners, block) in enumerate(zip(blocks, scene["blocks"])):
        area, centre = area_and_centroid(corners)
        size = extent(corners)
        if not area > 0:
            yield f"block {index} runs clockwise"
        # Thin blocks far from the origin lose digits in any order of summation.
        slack = 1e-9 * size + 1e-13 * np.abs(corners).max() * size * size / abs(area)
        if not np.hypot(*(centre - block["centroid"])) <= slack:
            yield f"block {index}: its centroid is {centre}, not {block['centroid']}"
        for part in ("dead", "live"):
            forces = np.array([load[part] for load in block["loads"]], float).reshape(-1, 2)
            arms = np.array([load["point"] for load in block["loads"]], float).reshape(-1, 2) - block["centroid"]
            total = np.append(forces.sum(0), (arms[:, 0] * forces[:, 1] - arms[:, 1] * forces[:, 0]).sum())
            unit = np.abs(forces).sum() * np.array([1, 1, size + np.abs(arms).max(initial=0)])
            if not (np.abs(total - block[part]) <= 1e-9 * unit).all():
                yield f"block {index}: its {part} loads add up to {total}, not {block[part]}"
    yield from joint_violations(scene, blocks, supports, touch or TOUCH, Own(file) if file else None)


def at_rest(scene):
    """A scene with its moving supports put back among those that do not move, and lines about what guides them.

    A support that moves is a block behind all others, on joints of the class "guide": two rails along one line, or a
    pin of four joints; its other joints are those of the support that it is. Without such blocks nothing changes.
    """
    guides = [joint for joint in scene["joints"] if joint["class"] == "guide"]
    if not guides:
        return scene, []
    place, lines = {}, []
    for joint in guides:
        if joint["from_support"] is not None:
            place[joint["to"]] = joint["from_support"]
        if joint["friction"] != 0:
            lines.append(f"the guide of block {joint['to']} has friction")
    for block in place:
        rates = []
        for joint in guides:
            if joint["to"] == block and joint["from_support"] is not None:
                for end in joint["ends"]:
                    arm = np.subtract(end, scene["blocks"][block]["centroid"])
                    normal = joint["normal"]
                    rates.append([*normal, arm[0] * normal[1] - arm[1] * normal[0]])
        # Each way that is closed is closed both ways, so that one motion is left.
        total = np.abs(np.sum(rates, axis=0)).max()
        if np.linalg.matrix_rank(rates, 1e-9 * np.abs(rates).max()) != 2 or total > 1e-9 * np.abs(rates).max():
            lines.append(f"block {block} is not left one motion by its guides")
    many = min(place)
    joints = []
    for joint in scene["joints"]:
        if joint["class"] != "guide":
            source = joint["from_block"]
            moved = {"from_block": None, "from_support": place[source]} if source in place else {}
            joints.append({**joint, **moved})
    return {**scene, "blocks": scene["blocks"][:many], "joints": joints}, lines


def is_convex(corners):
    """Whether an outline that runs counter-clockwise bends to the left everywhere."""
    edge = np.roll(corners, -1, axis=0) - corners
    after = np.roll(edge, -1, axis=0)
    return (edge[:, 0] * after[:, 1] - edge[:, 1] * after[:, 0] > 0).all()


def joint_violations(scene, blocks, supports, touch, own):
    listed = {}
    for index, joint in enumerate(scene["joints"]):
        from_block, from_support = joint["from_block"], joint["from_support"]
        if (from_block is None) == (from_support is None):
            yield f"joint {index} has no one body that it comes from"
            continue
        source = supports[from_support] if from_block is None else blocks[from_block]
        to = blocks[joint["to"]]
        near = max(touch, TOUCH) * min(extent(source), extent(to)) * 1.001
        ends, normal = np.array(joint["ends"], float), np.array(joint["normal"], float)
        along = ends[1] - ends[0]
        length = np.hypot(*along)
        if not (abs(np.hypot(*normal) - 1) < 1e-9 and abs(normal @ along) <= 1e-9 * length):
            yield f"joint {index}: its normal is no unit vector across it"
        if not np.allclose(joint["tangent"], [normal[1], -normal[0]], rtol=0, atol=1e-12):
            yield f"joint {index}: its tangent is not the normal turned clockwise"
        # Both bodies reach the joint, and lie on their own sides of it.
        heights = [(body - ends[0]) @ normal for body in (source, to)]
        convex = is_convex(source) and is_convex(to)
        if convex and not (-2 * near <= heights[0].max() <= 2 * near and -2 * near <= heights[1].min() <= 2 * near):
            yield f"joint {index}: its normal does not point from one body into the other"
        for name, body in (("first", source), ("second", to)):
            far = max(distance(end, body) for end in ends)
            if not far <= 2 * near:
                yield f"joint {index}: an end lies {far:.1e} off the boundary of its {name} body"
        if not (np.isfinite(joint["friction"]) and joint["friction"] >= 0):
            yield f"joint {index}: friction {joint['friction']}"
        kind = "base" if from_block is None else "bed" if abs(normal[1]) >= abs(normal[0]) else "head"
        body = -1 - from_support if from_block is None else from_block
        kind, _, is_open = own.joint(body, joint["to"], kind) if own else (kind, None, False)
        if is_open:
            yield f"joint {index} is open in the file"
        # Between voussoirs every joint is a bed joint.
        if joint["class"] != kind and not (kind == "head" and joint["class"] == "bed"):
            yield f"joint {index} is called {joint['class']}, but is {kind}"
        if scene["head_joints"] == "open" and joint["class"] == "head":
            yield f"joint {index} is a head joint where those are open"
        listed.setdefault((from_block, from_support, joint["to"]), []).append(ends)
    yield from missing(scene, blocks, supports, touch, listed, own)


def distance(point, corners):
    """From a point to the outline."""
    start, edge = corners, np.roll(corners, -1, axis=0) - corners
    share = np.clip(((point - start) * edge).sum(1) / (edge**2).sum(1), 0, 1)
    return np.hypot(*(point - start - share[:, None] * edge).T).min()


def missing(scene, blocks, supports, touch, listed, own):
    """Contacts that the polygons have beyond doubt and the scene does not list, and the other way round twice."""
    bodies = supports + blocks
    many = len(supports)
    low = np.array([body.min(0) for body in bodies])
    high = np.array([body.max(0) for body in bodies])
    slack = touch * np.array([extent(body) for body in bodies])
    low, high = low - slack[:, None], high + slack[:, None]
    for second in range(many, len(bodies)):
        meets = (low[:second] <= high[second]).all(1) & (high[:second] >= low[second]).all(1)
        for first in np.flatnonzero(meets):
            source, to = bodies[first], bodies[second]
            size = min(extent(source), extent(to))
            key = (None, int(first), second - many) if first < many else (int(first) - many, None, second - many)
            known = listed.get(key, [])
            sure = [c for c in contacts(source, to, 0.5 * touch * size) if c[2] > 3 * touch * size]
            for ends, normal, length in sure:
                kind = "base" if first < many else "head" if abs(normal[1]) < abs(normal[0]) else "bed"
                body = -1 - first if first < many else first - many
                kind, _, is_open = own.joint(body, second - many, kind) if own else (kind, None, False)
                if is_open or kind == "head" and scene["head_joints"] == "open":
                    continue
                middle = (ends[0] + ends[1]) / 2
                if not any(distance(middle, np.array(k)) <= 3 * touch * size for k in known):
                    yield f"bodies {first} and {second} touch along {length:.3g} at {middle} without a joint"
            for ends in known:
                length = np.hypot(*(ends[1] - ends[0]))
                among = [c[2] for c in contacts(source, to, 2 * touch * size)
                         if distance((ends[0] + ends[1]) / 2, np.array(c[0])) <= 3 * touch * size]
                if not any(abs(length - own) <= 3 * touch * size for own in among):
                    yield f"the joint of bodies {first} and {second} at {ends.mean(0)} is {length:.6g} long, not {among}"


def contacts(source, to, near):
    """Where edges of two polygons face each other within a distance: ends, normal, length."""
    for a, b in zip(source, np.roll(source, -1, axis=0)):
        along = (b - a) / np.hypot(*(b - a))
        normal = np.array([along[1], -along[0]])
        for c, d in zip(to, np.roll(to, -1, axis=0)):
            if (d - c) @ along >= 0 or max(abs((c - a) @ normal), abs((d - a) @ normal)) > near:
                continue
            start, end = max((d - a) @ along, 0.0), min((c - a) @ along, np.hypot(*(b - a)))
            if end > start:
                yield (a + along * start, a + along * end), normal, end - start


def case_files(folder):
    """Every case file below a folder that can be laid again here, by the name of its case."""
    files = {}
    for path in sorted(folder.rglob("*.toml")) if tomllib else []:
        if not path.name.endswith(".sweep.toml"):
            files[path.stem] = read_case(path)
    return files


def read_case(path):
    """A case file, the outlines of its CSV among its blocks and supports."""
    file = tomllib.loads(path.read_text())
    if "csv" in file.get("blocks", {}):
        outlines, still = {}, file["blocks"].get("supports", [])
        lines = (path.parent / file["blocks"]["csv"]).read_text().splitlines()
        header, *rows = csv.reader(line for line in lines if line and not line.startswith("#"))
        for row in rows:
            cells = {key.strip(): cell.strip() for key, cell in zip(header, row)}
            body = outlines.setdefault(cells["block"], {"name": cells["block"], "corners": []})
            body["corners"].append([float(cells["x"]), float(cells["y"])])
            if cells.get("weight"):
                body["weight"] = float(cells["weight"])
        # What a block has beside its corners stands in the case.
        for own in file.pop("block", []):
            outlines.setdefault(own["name"], {}).update(own)
        for name, body in outlines.items():
            file.setdefault("support" if name in still else "block", []).append(body)
    return file


def laid_again(file, scene):
    """Lines about what differs between a scene and its file; None where this program cannot lay the file."""
    moves = file.get("move", [])
    own, lines = Own(file), []
    for index, joint in enumerate(scene["joints"]):
        body = -1 - joint["from_support"] if joint["from_block"] is None else joint["from_block"]
        _, given, _ = own.joint(body, joint["to"], joint["class"])
        if joint["friction"] != given:
            lines.append(f"joint {index}: friction {joint['friction']}, in the file {given}")
    pushes = {"both": ("right", "left")}.get(file.get("push", "right"), (file.get("push", "right"),))
    if scene["push"] not in pushes:
        lines.append(f"pushed {scene['push']}, in the file {pushes}")
    if "unit" in file:
        expected = courses(file)
    elif {"gap", "tolerance"} & set(file.get("blocks", {})):
        return None
    elif all("corners" in block for block in file.get("block", [{}])):
        expected = bodies(file)
    else:
        return None
    sign = 1.0 if scene["push"] == "right" else -1.0
    if len(expected) != len(scene["blocks"]):
        return lines + [f"{len(scene['blocks'])} blocks, in the file {len(expected)}"]
    for index, ((corners, loads), block) in enumerate(zip(expected, scene["blocks"])):
        own = np.array(block["corners"])
        if any(np.hypot(*(own - corner).T).min() > 1e-9 * extent(own) for corner in corners):
            lines.append(f"block {index} has the corners {block['corners']}, in the file {corners}")
        for part in ("dead", "live"):
            if moves and part == "live":
                continue
            wanted = np.zeros(3)
            for point, dead, live in loads:
                pushed = np.array([sign * live[0], live[1]])
                force = pushed if part == "live" else np.array(dead) + pushed * (moves[0].get("pushed", 0) if moves else 0)
                arm = np.subtract(point, block["centroid"])
                wanted += [*force, arm[0] * force[1] - arm[1] * force[0]]
            unit = np.abs(wanted).max() + 1e-300
            if np.abs(wanted - block[part]).max() > 1e-8 * unit * max(1.0, extent(own)):
                lines.append(f"block {index}: {part} load {block[part]}, by the file {wanted.tolist()}")
    return lines


def weight_at(point, weight, live):
    return point, (0.0, -weight), (live[0] * weight, live[1] * weight)


def weighed(corners, weight, live, centre=None):
    point = area_and_centroid(np.array(corners, float))[1] if centre is None else centre
    return corners, [weight_at(point, weight, live)]


def courses(file):
    """Blocks of a coursed wall: corners and loads (point, dead, live for a push to the right)."""
    length, height = (file["unit"][key] for key in ("length", "height"))
    weight = file["unit"].get("weight", 1.0)
    rows, live, tables = bonds.rows(file), live_of_weight(file), Own(file)
    bed = levels(file)
    own = {letter: piece["weight"] for letter, piece in file.get("pieces", {}).items() if "weight" in piece}
    blocks = []
    for row, course in enumerate(rows):
        x = 0.0
        for kind, part in course:
            wide = part * length
            if kind != "g":
                low, high = bed[row], bed[row + 1]
                table = tables.tables.get(len(blocks), {})
                heavy = own.get(kind, weight * part * (high - low) / height)
                if "specific_weight" in table:
                    heavy = table["specific_weight"] * file["unit"].get("thickness", 1.0) * wide * (high - low)
                block = weighed([(x, low), (x + wide, low), (x + wide, high), (x, high)], table.get("weight", heavy), live)
                if row + 1 == len(rows):
                    # p / (gamma H) times gamma H times the width.
                    on_top = file.get("overburden", 0.0) * bed[-1] / height * weight * part
                    block[1].append(weight_at((x + wide / 2, high), on_top, live))
                blocks.append(block)
            x += wide
    add_forces(file, blocks, tables.places)
    return blocks


def bodies(file):
    """Blocks with corners in the file, with the forces on them."""
    shared, live = file.get("blocks", {}), live_of_weight(file)
    blocks, places = [], {}
    for body in file["block"]:
        area = abs(area_and_centroid(np.array(body["corners"], float))[0])
        weight = body.get("weight")
        if weight is None:
            specific = body.get("specific_weight", shared.get("specific_weight", 1.0))
            weight = specific * area * shared.get("thickness", 1.0)
        places[body["name"]] = len(blocks)
        blocks.append(weighed([tuple(c) for c in body["corners"]], weight, live, body.get("centre")))
    if file.get("overburden", 0.0):
        add_overburden(blocks, file["overburden"], live)
    add_forces(file, blocks, places)
    return blocks


def add_overburden(blocks, ratio, live):
    """The overburden on the level faces at the very top, a part of the mean weight of all blocks over their areas."""
    every = np.array([corner for corners, _ in blocks for corner in corners])
    top, height = every[:, 1].max(), np.ptp(every[:, 1])
    weight = -sum(load[1][1] for _, loads in blocks for load in loads)
    pressure = ratio * height * weight / sum(abs(area_and_centroid(np.array(c, float))[0]) for c, _ in blocks)
    for corners, loads in blocks:
        for (x, y), (to, level) in zip(corners, corners[1:] + corners[:1]):
            if min(y, level) > top - 1e-6 * height:
                loads.append(weight_at(((x + to) / 2, top), pressure * abs(to - x), live))


def add_forces(file, blocks, places):
    """The forces of a file on its blocks, which have their places by name."""
    for load in file.get("load", []):
        line = np.array(load.get("along", [load.get("at")] * 2), float)
        # A line load is a force per length, and acts at the middle of its line.
        length = np.hypot(*(line[1] - line[0])) if "along" in load else 1.0
        dead, live_part = (length * np.array(load.get(part, (0.0, 0.0))) for part in ("dead", "live"))
        blocks[places[load["block"]]][1].append((line.mean(0), dead, live_part))
