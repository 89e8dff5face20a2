"""Scenes: what methods get."""

from __future__ import annotations

import json
import tempfile
from typing import Any

from trilith._arrays import array
from trilith._case import Case
from trilith._folder import Folder
from trilith._program import run


class Scene:
    """Rigid blocks with forces, joints and friction, in the units of the case.

    x points to the right, y up; rotations and moments are positive counter-clockwise. Blocks and
    joints are counted from 0. All are arrays where NumPy is there, and nested lists else.

    Attributes:
        case: name of the case.
        push: which way the live load pushes: ``"right"`` (+x) or ``"left"``.
        head_joints: ``"contact"`` or ``"open"``; joints that carry nothing are not there.
        names: what the case calls each block.
        corners: a list of one (corners, 2) array a block, counter-clockwise.
        centroids: (blocks, 2), the points that wrenches and velocities are about.
        dead: (blocks, 3), the constant wrench [x, y, moment] about the centroid.
        live: (blocks, 3), the wrench that λ multiplies.
        supports: a list of one (corners, 2) array a shape that never moves.
        from_block: (joints,), the block that the normal points away from; -1 is a support.
        to_block: (joints,), the block that the normal points into.
        ends: (joints, 2, 2), the two ends [x, y]; the normal forces act here.
        normals: (joints, 2), unit normals: a compressive force on ``to_block`` points along it.
        tangents: (joints, 2), the normals turned clockwise: positive shear on ``to_block``.
        friction: (joints,), coefficients of friction.
        classes: ``"base"``, ``"bed"`` or ``"head"`` of each joint.
        data: the whole scene in the format of ``trilith schema scene``.
    """

    def __init__(self, data: dict[str, Any]) -> None:
        self.data = data
        blocks, joints = data["blocks"], data["joints"]
        self.case: str = data["case"]
        self.push: str = data["push"]
        self.head_joints: str = data["head_joints"]
        self.names: list[str] = [block["name"] for block in blocks]
        self.corners = [array(block["corners"]) for block in blocks]
        self.centroids = array([block["centroid"] for block in blocks])
        self.dead = array([block["dead"] for block in blocks])
        self.live = array([block["live"] for block in blocks])
        self.supports = [array(support["corners"]) for support in data["supports"]]
        ends = [-1 if joint["from_block"] is None else joint["from_block"] for joint in joints]
        self.from_block = array(ends)
        self.to_block = array([joint["to"] for joint in joints])
        self.ends = array([joint["ends"] for joint in joints])
        self.normals = array([joint["normal"] for joint in joints], 2)
        self.tangents = array([joint["tangent"] for joint in joints], 2)
        self.friction = array([joint["friction"] for joint in joints])
        self.classes: list[str] = [joint["class"] for joint in joints]

    def equilibrium(self) -> Any:
        """The (3 blocks, 3 joints) matrix A of contact wrenches; it needs NumPy.

        Forces f, in order [n1, n2, t] of every joint, hold the blocks at λ where
        ``A @ f + dead.ravel() + λ * live.ravel() == 0``. Its transpose takes velocities
        [x, y, rotation] of every block to [opening at end 1, at end 2, slip] of every joint.
        """
        import numpy

        matrix = numpy.zeros((3 * len(self.names), 3 * len(self.classes)))
        for j in range(len(self.classes)):
            parts = [(0, self.normals[j]), (1, self.normals[j]), (0, self.tangents[j])]
            for k, (end, along) in enumerate(parts):
                for block, sign in ((self.to_block[j], 1.0), (self.from_block[j], -1.0)):
                    if block < 0:
                        continue
                    x, y = self.ends[j][end] - self.centroids[block]
                    wrench = numpy.array([along[0], along[1], x * along[1] - y * along[0]])
                    matrix[3 * block : 3 * block + 3, 3 * j + k] += sign * wrench
        return matrix

    def __repr__(self) -> str:
        size = f"{len(self.names)} blocks, {len(self.classes)} joints"
        return f"<trilith scene {self.case}: {size}, pushed {self.push}, head joints {self.head_joints}>"


def export(case: Case, push: str = "", head_joints: str = "") -> Scene:
    """The scene of a case, for one direction of the push and one setting of its head joints."""
    with tempfile.TemporaryDirectory(prefix="trilith-") as path:
        folder = Folder(path, [case])
        arguments = ["export", folder.arguments[0]]
        if push:
            arguments += ["--push", push]
        if head_joints:
            arguments += ["--head-joints", head_joints]
        return Scene(json.loads(run(arguments, folder=path).out))
