"""Cases as Python writes them, and what is said of wrong ones."""

import sys

import pytest

import trilith

GROUND = [[-1, -1], [2, -1], [2, 0], [-1, 0]]


def wall(**keys):
    return trilith.Wall(["111", "h11h"] * 2, (0.4, 0.2), 0.65, **keys)


def test_a_mistake_is_answered_with_the_programs_own_words():
    with pytest.raises(trilith.CaseError) as refused:
        trilith.run(wall(frction=0.5))
    said = str(refused.value)
    assert "unknown key `frction`" in said and "did you mean `friction`?" in said
    assert " --> wall.toml:" in said, said
    for case in (
        trilith.Wall(["1k1"], (0.4, 0.2), 0.65),
        trilith.Wall(["111"], (0.4, 0.2), float("nan")),
        trilith.Wall(["111"], (0.4, -0.2), 0.65),
        trilith.Arch(10.0, 1.5, 400.0, 7, 0.65),
        trilith.Blocks([[[0, 0], [1, 1], [1, 0], [0, 1]]], [GROUND], 0.65),
    ):
        with pytest.raises(trilith.CaseError, match="error: "):
            trilith.run(case)
    with pytest.raises(trilith.CaseError, match="no method named `guess`"):
        trilith.run(wall(), ["guess"])
    with pytest.raises(trilith.CaseError, match="start"):
        trilith.run(wall(), ["interval"], strts=3)
    with pytest.raises(trilith.CaseError, match="no case named"):
        trilith.load("none")


def test_polygons_come_as_lists_arrays_names_and_shapely():
    numpy = pytest.importorskip("numpy")
    block = [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]]

    class Ring:  # as Shapely's: the last corner is the first
        coords = [tuple(corner) for corner in [*block, block[0]]]

    class Polygon:
        exterior = Ring()
        interiors = ()

    same = [
        trilith.Blocks([block], [GROUND], 0.65),
        trilith.Blocks([numpy.array(block)], [numpy.array(GROUND)], numpy.float64(0.65)),
        trilith.Blocks([Polygon()], {"ground": GROUND}, 0.65),
        trilith.Blocks({"stone": block, "ground": GROUND}, ["ground"], 0.65, weights=[3.0, 1.0]),
        trilith.Blocks([GROUND, block], [0], 0.65),
    ]
    results = trilith.run(same, ["associative"])
    assert [row.case for row in results] == ["blocks", *[f"blocks-{k}" for k in (2, 3, 4, 5)]]
    assert results.lower == pytest.approx([0.5] * 5, abs=1e-8)
    scene = same[3].scene()
    assert scene.names == ["stone"] and list(scene.dead[0]) == [0.0, -3.0, 0.0]
    for wrong in ([[0, 0, 0]], 7, "abc"):
        with pytest.raises(trilith.CaseError, match="corners"):
            trilith.Blocks([wrong], [GROUND], 0.65)
    with pytest.raises(trilith.CaseError, match="no polygon named `3`"):
        trilith.Blocks([block], [3], 0.65)


def test_courses_joints_and_blocks_have_keys_of_their_own():
    damp = wall(joints=[{"course": 3, "friction": 0.2}], head_joints="both", push="both")
    lifted = wall(live={"weight": [1, 0.3]}).with_keys(friction=0.2)
    stack = trilith.Wall(["1", "1", "1"], (1.0, 0.5), 0.65, heights=[0.4, 1.1, 0.5])
    slender = trilith.Wall(["11", "q1"], (1, 1), {"bed": 0.65, "head": 0}, open_head_joints=[2])
    box = lambda low: [[0, low], [1, low], [1, low + 1], [0, low + 1]]  # noqa: E731
    heavy = trilith.Blocks([box(0), box(1)], [GROUND], 0.65, specific_weights=[None, 2.0])
    smooth = trilith.Blocks({"a": box(0), "b": box(1)}, [GROUND], 0.4, frictions={"b": 0.1})
    rough = trilith.Blocks(
        {"a": box(0), "b": box(1)},
        [GROUND],
        0.4,
        frictions={"b": 0.1},
        joints=[{"between": ["a", "b"], "friction": 0.3}],
    )
    loaded = trilith.Blocks([[[0, 0], [1, 0], [1, 2], [0, 2]]], [GROUND], 0.65, overburden=1.0)
    cases = [damp, lifted, stack, slender, heavy, smooth, rough, loaded]
    expected = [0.2, 0.2, 0.2 / 1.06, 0.5, 0.25, 3 / 7, 0.1, 0.3, 1 / 3]
    results = trilith.run(cases, ["associative"])
    assert results.lower == pytest.approx(expected, abs=1e-6)
    for wrong in ({"c": 0.1}, [0.1]):
        with pytest.raises(trilith.CaseError, match="frictions"):
            trilith.Blocks({"a": box(0), "b": box(1)}, [GROUND], 0.4, frictions=wrong)
    with pytest.raises(trilith.CaseError, match="2 heights for 3 courses"):
        trilith.run(trilith.Wall(["1", "1", "1"], (1, 1), 0.65, heights=[1, 2]), ["associative"])


def test_keys_change_in_every_form(tmp_path):
    file = tmp_path / "garden.toml"
    file.write_text(
        wall(
            title='A "quoted" wall',
            load=[{"block": "course 1 piece 1", "at": [0.1, 0.1], "dead": [0, -1]}],
        ).text()
    )
    for case in (wall(), trilith.load(file)):
        slippery = case.with_keys(friction=0.3, push="both")
        assert "friction = 0.3" in slippery.text() and "0.65" not in slippery.text()
        (row,) = trilith.run(slippery, ["associative"])
        assert row.lower == pytest.approx(0.3, abs=1e-8)
        assert len(row.sides) == 2
    with pytest.raises(trilith.CaseError, match="built in"):
        trilith.load("paper-1").with_keys(friction=0.3)


def test_keys_say_the_same_in_python_as_in_files():
    """Every case that is built in, read by Python, written by it, and laid by the program."""
    tomllib = pytest.importorskip("tomllib", reason="Python 3.11 reads TOML")
    root = cases_folder()
    count = 0
    for path in sorted(root.rglob("*.toml")):
        if path.name.endswith(".sweep.toml") or "csv =" in path.read_text():
            continue
        keys = tomllib.loads(path.read_text())
        case = trilith.Case(keys, name=path.stem)
        assert tomllib.loads(case.text()) == keys, path
        assert case.scene().data == trilith.load(path).scene().data, path
        count += 1
    assert count > 60


def cases_folder():
    from pathlib import Path

    root = Path(__file__).resolve().parents[3] / "cases"
    if not root.is_dir():
        pytest.skip("no checkout")
    return root


def test_templates_explain_the_keys():
    for kind in ("wall", "blocks", "arch"):
        assert "friction" in trilith.template(kind)


def test_it_needs_nothing_but_python():
    import subprocess

    hidden = "import sys; sys.modules.update(numpy=None, pandas=None, matplotlib=None)\n"
    script = hidden + (
        "import trilith\n"
        "row = trilith.run(trilith.Wall(['11'], (0.4, 0.2), 0.3), ['interval'])['interval']\n"
        "assert isinstance(row.forces, list) and len(row.velocities[0]) == 3, row.forces\n"
        "assert isinstance(row.scene.dead, list)\n"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
