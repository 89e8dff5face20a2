"""Outlines cut into convex pieces, for engines whose shapes are convex, and which pieces touch."""
import numpy as np


class Refused(Exception):
    """The scene is outside what the engine can treat."""


def area_and_centroid(corners):
    following = np.roll(corners, -1, axis=0)
    cross = corners[:, 0] * following[:, 1] - following[:, 0] * corners[:, 1]
    return cross.sum() / 2, ((corners + following) * cross[:, None]).sum(axis=0) / (3 * cross.sum())


def turns(corners):
    """At every corner, twice the area of the triangle with its neighbours: positive where it turns left."""
    back, on = np.roll(corners, 1, axis=0) - corners, np.roll(corners, -1, axis=0) - corners
    return on[:, 0] * back[:, 1] - on[:, 1] * back[:, 0]


def convex_pieces(corners):
    """The outline itself where it is convex, else triangles: the roundest ear first."""
    least = 1e-9 * np.ptp(corners, axis=0).max() ** 2
    corners = corners[np.abs(turns(corners)) > least]
    if turns(corners).min() > 0:
        return [corners]
    pieces = []
    while len(corners) > 3:
        ears = [ear for ear in range(len(corners)) if is_ear(corners, ear, least)]
        ear = max(ears, key=lambda ear: roundness(triangle(corners, ear)))
        pieces.append(triangle(corners, ear))
        corners = np.delete(corners, ear, axis=0)
    return [*pieces, corners]


def triangle(corners, ear):
    """A corner with its neighbours."""
    return corners[[ear - 1, ear, (ear + 1) % len(corners)]]


def roundness(corners):
    """The area of a triangle over the squares of its sides, which slivers have little of."""
    sides = np.roll(corners, -1, axis=0) - corners
    return turns(corners)[1] / (sides**2).sum()


def is_ear(corners, ear, least):
    """Whether a corner can be cut off: it turns left, and no other corner lies in its triangle."""
    piece = triangle(corners, ear)
    others = np.delete(corners, [ear - 1, ear, (ear + 1) % len(corners)], axis=0)
    edges = list(zip(piece, np.roll(piece, -1, axis=0)))
    inside = (all(turns(np.array([point, *edge]))[0] > -least for edge in edges) for point in others)
    return turns(piece)[1] > least and not any(inside)


def bodies_of(joint, count):
    """The two bodies of a joint, supports after the blocks."""
    other = joint["from_block"]
    return joint["to"], count + joint["from_support"] if other is None else other


def farthest(scene, count):
    """How many joints lie between the farthest block and the supports."""
    pairs = [set(bodies_of(joint, count)) for joint in scene["joints"]]
    reached, level, distance = set(), set(range(count, count + len(scene["supports"]))), 0
    while level:
        reached |= level
        level = set().union(*(pair for pair in pairs if pair & level)) - reached
        distance += bool(level)
    return max(distance, 1)


def touching(scene, shapes, unit):
    """The friction of every two pieces that a joint lies between; pieces are numbered through all bodies."""
    count, pairs = len(scene["blocks"]), {}
    first = np.cumsum([0, *map(len, shapes)])
    for joint in scene["joints"]:
        ends = np.array(joint["ends"]) / unit
        pair = tuple(first[body] + piece_along(shapes[body], ends) for body in bodies_of(joint, count))
        if pairs.setdefault(pair, joint["friction"]) != joint["friction"]:
            raise Refused("two joints of different friction between the same two convex pieces")
    return pairs


def piece_along(shape, ends):
    """Which piece has an edge along a joint."""

    def distance(corners):
        edges = zip(corners, np.roll(corners, -1, axis=0))
        return min(np.abs([turns(np.array([one, other, end]))[0] / np.hypot(*(other - one)) for end in ends]).max()
                   + beyond(one, other, ends) for one, other in edges)

    return min(range(len(shape)), key=lambda k: distance(shape[k]))


def beyond(one, other, ends):
    """How far the ends of a joint lie beyond those of an edge."""
    along = (other - one) / np.hypot(*(other - one))
    places = (ends - one) @ along
    return max(-places.min(), places.max() - np.hypot(*(other - one)), 0.0)
