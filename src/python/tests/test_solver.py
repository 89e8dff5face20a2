"""Outside methods in Python, judged by the program."""

import os

import pytest

import trilith

pytestmark = pytest.mark.skipif(os.name == "nt", reason="outside methods do not run on Windows")

numpy = pytest.importorskip("numpy")


def wall():
    return trilith.Wall(["111", "h11h"] * 2, (0.4, 0.2), 0.65, push="both", head_joints="both")


def test_true_forces_are_verified_and_false_ones_fail():
    true = trilith.run(wall(), ["interval"])
    known = {(side.push, row.head_joints): side for row in true for side in row.sides}

    @trilith.solver(name="remembers")
    def remembers(scene):
        side = known[scene.push, scene.head_joints]
        return {"lambda": side.lower, "forces": side.forces, "velocities": side.velocities}

    @trilith.solver
    def exaggerates(scene):
        return {**remembers(scene), "lambda": 1.01 * known[scene.push, scene.head_joints].lower}

    results = trilith.run(wall(), ["interval", remembers, exaggerates])
    assert len(results) == 6
    assert {row.status for row in results["remembers"]} == {"verified"}
    assert {row.status for row in results["exaggerates"]} == {"failed"}
    assert results["remembers"].lower == pytest.approx(results["interval"].lower)
    assert all(row.seconds > 0 for row in results["remembers"])


def test_numbers_are_compared_and_errors_are_rows():
    def half(scene):
        return 0.5

    def a_range(scene):
        return 0.1, 0.2

    def nothing(scene):
        return None

    def breaks(scene):
        raise ValueError("no such stone")

    case = trilith.load("block-both")
    results = trilith.run(case, ["associative", half, a_range, nothing, breaks])
    assert (results["half"].lower, results["half"].status) == (0.5, "estimate")
    assert (results["a-range"].lower, results["a-range"].upper) == (0.1, 0.2)
    assert results["nothing"].status == "undecided"
    assert results["breaks"].status == "failed" and "no such stone" in results["breaks"].reason
    with pytest.raises(trilith.CaseError, match="neither the name of a method nor a function"):
        trilith.run(case, [7])


def test_a_function_is_judged_against_the_library():
    linprog = pytest.importorskip("scipy.optimize").linprog

    @trilith.solver
    def highs(scene):
        joints = len(scene.classes)
        limits = numpy.zeros((2 * joints, 3 * joints + 1))
        for j, friction in enumerate(scene.friction):
            limits[2 * j : 2 * j + 2, 3 * j : 3 * j + 2] = -friction
            limits[2 * j : 2 * j + 2, 3 * j + 2] = [1.0, -1.0]
        found = linprog(
            [0.0] * 3 * joints + [-1.0],
            limits,
            numpy.zeros(2 * joints),
            numpy.column_stack([scene.equilibrium(), scene.live.ravel()]),
            -scene.dead.ravel(),
            [(0, None), (0, None), (None, None)] * joints + [(None, None)],
        )
        return found.x[-1] if found.x is not None else None

    names = ["trilith", "column-2", "oppenheim-7", "crown-load", "slope-both", "buttress"]
    results = trilith.check(highs, [trilith.load(name) for name in names], ["associative"])
    for name in names:
        ours, own = results[name]
        assert own.lower == pytest.approx(ours.lower, rel=1e-5), name
        assert own["verdict"] != "VIOLATED", name
