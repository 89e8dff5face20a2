"""Scenes from case files alone, in the form of `trilith export` as far as `limit.py` and `falls.py` read it."""
import numpy as np

import geometry
from geometry import area_and_centroid, contacts, extent
from own import Own, live_of_weight

KEYS = {"title", "source", "references", "unit", "courses", "repeat", "bond", "units", "overlap", "first", "friction",
        "overburden", "pieces", "head_joints", "push", "live", "load", "blocks", "block", "support", "arch",
        "heights", "open_head_joints", "joint", "joints",
        "demand"}


def settings(file):
    """The settings of head joints and the directions of the push that a case runs with."""
    heads = {"both": ("contact", "open")}.get(file.get("head_joints", "contact"), (file.get("head_joints", "contact"),))
    pushes = {"both": ("right", "left")}.get(file.get("push", "right"), (file.get("push", "right"),))
    return heads, pushes


def scene(file, head_joints, push):
    """Blocks with their loads and joints of a case, head joints in contact or open."""
    unknown = set(file) - KEYS
    if unknown:
        raise ValueError(f"{sorted(unknown)} of a case file mean nothing here")
    if "arch" in file:
        bodies, supports = arch(file)
    elif "unit" in file:
        bodies = geometry.courses(file)
        wide = max(x for corners, _ in bodies for x, _ in corners)
        supports = [[(-wide, -1.0), (2 * wide, -1.0), (2 * wide, 0.0), (-wide, 0.0)]]
    else:
        bodies, supports = geometry.bodies(file), [support["corners"] for support in file["support"]]
    sign = 1.0 if push == "right" else -1.0
    return {"blocks": [block(corners, loads, sign) for corners, loads in bodies],
            "joints": joints([np.array(corners, float) for corners, _ in bodies],
                             [np.array(corners, float) for corners in supports], file, head_joints)}


def block(corners, loads, sign):
    """A block with its loads as force and moment about its centroid."""
    centre = area_and_centroid(np.array(corners, float))[1]
    total = {"dead": np.zeros(3), "live": np.zeros(3)}
    for point, dead, live in loads:
        for part, (x, y) in (("dead", dead), ("live", (sign * live[0], live[1]))):
            arm = np.subtract(point, centre)
            total[part] += [x, y, arm[0] * y - arm[1] * x]
    return {"corners": corners, "centroid": centre, **total}


def joints(blocks, supports, file, head_joints):
    """Where outlines share a segment; the normal points from the first body into the second."""
    own = Own(file)
    bodies, many, touch = supports + blocks, len(supports), geometry.TOUCH
    low, high = np.array([b.min(0) for b in bodies]), np.array([b.max(0) for b in bodies])
    slack = touch * np.array([extent(b) for b in bodies])[:, None]
    low, high = low - slack, high + slack
    found = []
    for second in range(many, len(bodies)):
        meets = (low[:second] <= high[second]).all(1) & (high[:second] >= low[second]).all(1)
        for first in np.flatnonzero(meets):
            size = min(extent(bodies[first]), extent(bodies[second]))
            for ends, normal, length in contacts(bodies[first], bodies[second], touch * size):
                flat = abs(normal[1]) >= abs(normal[0]) or "arch" in file
                kind = "base" if first < many else "bed" if flat else "head"
                body = -1 - int(first) if first < many else int(first) - many
                kind, friction, is_open = own.joint(body, second - many, kind)
                if length <= touch * size or is_open or (kind == "head" and head_joints == "open"):
                    continue
                found.append({"from_block": int(first) - many if first >= many else None,
                              "from_support": int(first) if first < many else None, "to": second - many,
                              "ends": ends, "normal": normal, "tangent": (normal[1], -normal[0]), "class": kind,
                              "friction": friction})
    return found


def arch(file):
    """Voussoirs from the left as trapezoids with the weights of annular sectors at their centroids, and springers."""
    given, live = file["arch"], live_of_weight(file)
    radius, thickness, many = given["mean_radius"], given["thickness"], given["voussoirs"]
    embrace = np.radians(given["embrace"])
    inner, outer, step = radius - thickness / 2, radius + thickness / 2, embrace / many
    ring = outer**2 - inner**2
    weight = given.get("specific_weight", 1.0) * step / 2 * ring
    centre = 4 * np.sin(step / 2) * (outer**3 - inner**3) / (3 * step * ring)
    on = lambda size, angle: (size * np.cos(angle), size * np.sin(angle))
    angles = [(np.pi + embrace) / 2 - step * k for k in range(-1, many + 2)]
    shapes = [[on(inner, a), on(inner, b), on(outer, b), on(outer, a)] for a, b in zip(angles, angles[1:])]
    bodies = [(shape, [geometry.weight_at(on(centre, a - step / 2), weight, live)])
              for shape, a in zip(shapes[1:-1], angles[1:])]
    geometry.add_forces(file, bodies, {str(k + 1): k for k in range(many)})
    return bodies, [shapes[0], shapes[-1]]
