"""Models of COMPAS, as compas_dem itself writes and reads them."""

import pytest

import trilith

models = pytest.importorskip("compas_dem.models", reason="compas_dem is not there")
from compas.datastructures import Mesh  # noqa: E402
from compas.geometry import Box, Frame, Transformation, Translation  # noqa: E402
from compas_dem.elements import Block  # noqa: E402
from compas_dem.templates import ArchTemplate  # noqa: E402

VOUSSOIRS = 20
ENDS = (0, VOUSSOIRS - 1)


def arch():
    template = ArchTemplate(rise=3, span=10, thickness=0.5, depth=0.5, n=VOUSSOIRS)
    model = models.BlockModel()
    for mesh in template.blocks():
        model.add_element(Block.from_mesh(mesh))
    for element in model.elements():
        element.is_support = element.graphnode in ENDS
    return model


def outlines(model):
    """The fronts of hexahedra as ArchTemplate orders their vertices."""
    for element in model.elements():
        points = element.modelgeometry.to_vertices_and_faces()[0]
        yield [[points[k][0], points[k][2]] for k in (0, 3, 7, 4)]


def test_the_arch_of_a_template_is_that_of_its_corners():
    model = arch()
    read = trilith.read_compas(model, 0.7)
    own = trilith.Blocks(list(outlines(model)), ENDS, 0.7)
    methods = ["associative", "interval"]
    for a, b in zip(trilith.run(read, methods), trilith.run(own, methods)):
        assert abs(a.sides[0].lower - b.sides[0].lower) <= 1e-9
        assert abs(a.sides[0].upper - b.sides[0].upper) <= 1e-9
    # In the plane; the model's corners lie at y = 0 and 0.5, and what is written lies about y = 0.
    for a, b in zip(read.scene().corners, own.scene().corners):
        nearest = [min(abs(p - q).max() for q in b) for p in a]
        assert max(nearest) <= 1e-12


def test_a_round_trip_moves_no_corner_and_compas_reads_motion_and_forces(tmp_path):
    first = trilith.read_compas(arch(), 0.7)
    path = tmp_path / "arch.json"
    first.to_compas(path, method="interval")
    model = models.BlockModel.from_json(path)
    second = trilith.read_compas(model, 0.7)
    one, two = first.scene(), second.scene()
    assert one.names == two.names
    assert max(abs(a - b).max() for a, b in zip(one.corners, two.corners)) <= 1e-12
    assert abs(one.dead - two.dead).max() <= 1e-12
    contacts = list(model.contacts())
    assert len(contacts) == len(one.classes) and all(contact.forces for contact in contacts)
    # The two springers carry all the weight.
    result = trilith.run(first, ["interval"])["interval"]
    total = sum(abs(force[:2]).sum() for force in result.forces)
    written = sum(force["c_np"] for contact in contacts for force in contact.forces)
    assert written == pytest.approx(total, rel=1e-9)
    moves = [node for node in model.graph.nodes() if model.graph.node_attribute(node, "displacement")]
    assert len(moves) == VOUSSOIRS - 2


def test_transformations_and_other_planes_are_followed():
    model = models.BlockModel()
    sizes = [(3.0, 1.0, 1.0, 0.5, -0.5), (1.0, 1.0, 2.0, 0.0, 1.0)]
    for place, (x, y, z, at, up) in enumerate(sizes):
        box = Box(x, y, z)
        block = Block.from_mesh(Mesh.from_shape(box))
        block.transformation = Translation.from_vector([at, 0.0, up])
        block.is_support = place == 0
        model.add_element(block)
    case = trilith.read_compas(model, 0.7)
    assert trilith.run(case, ["associative"]).lower == pytest.approx([0.5])
    model.transformation = Transformation.from_frame(Frame([5, 5, 0], [0, 1, 0], [-1, 0, 0]))
    case = trilith.read_compas(model, 0.7)
    assert trilith.run(case, ["associative"]).lower == pytest.approx([0.5])


def test_a_model_that_is_not_plane_is_refused_with_the_blocks_name():
    model = arch()
    element = list(model.elements())[7]
    element.transformation = Translation.from_vector([0.0, 0.2, 0.0])
    element.name = "leaning"
    with pytest.raises(trilith.CaseError, match="middle of the block `leaning` lies 0.2000 beside"):
        trilith.read_compas(model, 0.7)
