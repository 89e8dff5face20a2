"""A scene as a simulation of LMGC90, of which there is one a process."""
import ctypes

import numpy as np

from lmgc90_pieces import Refused, area_and_centroid, convex_pieces, farthest, touching

G = 9.81


class Descriptor(ctypes.Structure):
    """How gfortran passes a pointer to an array, of doubles or of integers of 32 bits."""

    _fields_ = [
        ("base", ctypes.c_void_p),
        ("offset", ctypes.c_ssize_t),
        ("bytes", ctypes.c_size_t),
        ("version", ctypes.c_int),
        ("rank", ctypes.c_byte),
        ("type", ctypes.c_byte),
        ("attribute", ctypes.c_short),
        ("span", ctypes.c_ssize_t),
        ("stride", ctypes.c_ssize_t),
        ("first", ctypes.c_ssize_t),
        ("last", ctypes.c_ssize_t),
    ]

    def __init__(self, values):
        kind, size = 3 if values.dtype == float else 1, values.itemsize
        super().__init__(values.ctypes.data, -1, size, 0, 1, kind, 0, size, 1, 1, len(values))
        self.values = values  # kept as long as this is


def by_reference(value):
    if isinstance(value, int):
        return ctypes.byref(ctypes.c_int(value))
    if isinstance(value, float):
        return ctypes.byref(ctypes.c_double(value))
    if isinstance(value, np.ndarray):
        return ctypes.c_void_p(value.ctypes.data)
    return ctypes.byref(value) if isinstance(value, ctypes.Structure) else value


class Fortran:
    """Procedures of LMGC90's modules, all of which the wheel's library exports. The wheel's own classes know one law
    of contact, and sweeps to a tolerance that cannot be set."""

    def __init__(self, path):
        self.library = ctypes.CDLL(path)

    def __call__(self, name, *arguments):
        """`module.procedure`; lengths of texts, bytes here, come last."""
        module, procedure = name.split(".")
        lengths = [ctypes.c_size_t(len(text)) for text in arguments if isinstance(text, bytes)]
        return getattr(self.library, f"__{module}_MOD_{procedure}")(*map(by_reference, arguments), *lengths)


def label(letter, number):
    """A name of five characters, which is what LMGC90 has room for."""
    if number > 0xFFFF:
        raise Refused("more than 65,536 bodies or coefficients of friction")
    return f"{letter}{number:04x}".encode()


def prism(corners, depth):
    """Vertices and outward triangles (from 1) of an outline in x-z, as deep along y."""
    count = len(corners)
    faces = []
    for k in range(1, count - 1):
        faces += [0, k, k + 1, count, count + k + 1, count + k]
    for k in range(count):
        following = (k + 1) % count
        faces += [k, count + k, count + following, k, count + following, following]
    vertices = [[x, y, z] for y in (-depth / 2, depth / 2) for x, z in corners]
    return np.ravel(vertices), np.array(faces, dtype=np.int32) + 1


class Simulation:
    """The scene in LMGC90: x to the right, z up, a depth of 1 along y."""

    def __init__(self, scene, settings):
        self.settings, blocks = settings, scene["blocks"]
        self.count = len(blocks)
        unit = float(np.median([np.ptp([y for _, y in block["corners"]]) for block in blocks]))
        outlines = [np.array(shape["corners"]) / unit for shape in blocks + scene["supports"]]
        shapes = [convex_pieces(outline) for outline in outlines]
        pairs = touching(scene, shapes, unit)
        weights = [float(np.hypot(*block["dead"][:2])) for block in blocks]
        self.force = sum(weights) / self.count / G  # so that the mean mass is 1
        from compas_lmgc90 import _lmgc90  # what is refused needs no LMGC90

        self.solver, self.fortran = _lmgc90.LMGC90Solver(), Fortran(_lmgc90.__file__)
        self.kind = self.fortran("parameters.get_interaction_id_from_name", b"PRPRx")
        self.solver.initialize(settings.step, 0.5, False)
        self.joints(pairs)
        self.bodies(outlines, shapes, [weight / self.force / G for weight in weights])
        self.loads = [
            [
                (
                    np.array(load["point"]) / unit - centre,
                    np.array(load["dead"]) / self.force,
                    np.array(load["live"]) / self.force,
                )
                for load in block["loads"]
            ]
            for block, centre in zip(blocks, self.centres)
        ]
        # What a sweep still changes is a small part of what is left: errors fade as slowly as heat in a bar.
        self.tolerance = settings.tolerance / (4 * farthest(scene, self.count) ** 2)
        self.reach = [np.hypot(*(outline - centre).T).max() for outline, centre in zip(outlines, self.centres)]
        self.turned = np.zeros(self.count)
        self.counts = [0, 0, 0]  # steps, sweeps, steps that ended at the most sweeps

    def joints(self, pairs):
        """A law of contact for each coefficient of friction, and who sees whom."""
        call, frictions = self.fortran, sorted(set(pairs.values()))
        call("tact_behaviour.open_tact_behav_ll")
        for k, friction in enumerate(frictions):
            values = np.array([friction])
            call("tact_behaviour.add_to_tact_behav_ll", b"IQS_CLB".ljust(30), label("f", k), Descriptor(values))
        call("tact_behaviour.close_tact_behav_ll")
        call("tact_behaviour.open_see_ll")
        polyhedron = (b"RBDY3", b"POLYR")
        for (one, other), friction in pairs.items():
            law = label("f", frictions.index(friction))
            sees = (*polyhedron, label("p", one), law, *polyhedron, label("p", other))
            call("tact_behaviour.add_to_see_ll", *sees, self.settings.alert, 0.0)
        call("tact_behaviour.close_see_ll")

    def bodies(self, outlines, shapes, masses):
        """Prisms of these masses, of one or several pieces; supports, wider, that no degree of freedom is left of."""
        areas, self.centres = zip(*map(area_and_centroid, outlines))
        mean = sum(masses) / len(masses)
        densities = [(mass or mean) / area for mass, area in zip(masses, areas)] + [1.0] * (len(outlines) - self.count)
        materials = sorted(set(densities))
        self.solver.set_materials(materials)
        call, nothing, piece = self.fortran, np.zeros(9), 0
        call("bulk_behaviour.set_gravity", nothing)
        self.solver.set_nb_bodies(len(outlines))
        polyhedron = call("parameters.get_contactor_id_from_name", b"POLYR")
        for k, (centre, shape) in enumerate(zip(self.centres, shapes), start=1):
            fixed = k > self.count
            call("rbdy3.add_one_rbdy3", np.array([centre[0], 0.0, centre[1]]), len(shape), 6 * fixed, 0)
            for freedom in range(1, 7) if fixed else ():
                self.solver.set_drvdof(k, freedom, [0.0] * 6, True, False)
            for number, corners in enumerate(shape, start=1):
                vertices, faces = prism(corners - centre, 3.0 if fixed else 1.0)
                sizes = np.array([len(vertices) // 3, len(faces) // 3], dtype=np.int32)
                data = (Descriptor(np.concatenate([sizes, faces])), Descriptor(vertices))
                frame = (0.0, nothing, nothing, nothing)
                call("rbdy3.set_one_tactor_rbdy3", k, number, polyhedron, label("p", piece), *frame, *data)
                piece += 1
            material = f"s{materials.index(densities[k - 1]) + 1:04d}".encode()
            call("rbdy3.set_blmty_rbdy3", k, material, 0.0, nothing, nothing)
        self.solver.close_before_computing()
        start = self.solver.get_initial_state()
        self.frames = [np.array(start.init_body_frames[k]).reshape(3, 3) for k in range(self.count)]

    def push(self, multiplier):
        """Dead and live forces at their points, which turn with their blocks; moments in the block's own axes."""
        for k, loads in enumerate(self.loads):
            cosine, sine = np.cos(self.turned[k]), np.sin(self.turned[k])
            total, moment = np.zeros(2), 0.0
            for (x, z), dead, live in loads:
                force = dead + multiplier * live
                total += force
                moment += (cosine * x - sine * z) * force[1] - (sine * x + cosine * z) * force[0]
            wrench = np.concatenate([[total[0], 0.0, total[1]], self.frames[k] @ [0.0, -moment, 0.0]])
            self.fortran("rbdy3.put_vector_rbdy3", b"Fext_", k + 1, wrench, 6)

    def advance(self, multiplier):
        """One time step; the speeds after it."""
        call = self.fortran
        call("overall.time_increment")
        call("rbdy3.increment_rbdy3")
        call("rbdy3.comp_fext_rbdy3")
        self.push(multiplier)
        call("rbdy3.comp_fint_rbdy3")
        call("rbdy3.comp_free_vlocy_rbdy3")
        call("overall.init_entitylist")
        call("overall.set_run_contactor", 1)
        if self.counts[0] == 0:
            call("prprx.compute_box_prprx")
        call("prprx.coor_prediction_prprx")
        call("prprx.run_prprx")
        call("prprx.creation_tab_visu_prprx")
        call("prprx.wcp_compute_contact_prprx", None)
        call("inter_meca_handler_3d.recup_rloc", self.kind)
        self.sweep()
        call("inter_meca_handler_3d.stock_rloc", self.kind)
        call("rbdy3.comp_dof_rbdy3")
        call("overall.updt_time_begin")
        call("rbdy3.update_dof_rbdy3")
        self.counts[0] += 1
        return self.speeds()

    def sweep(self):
        """Gauss-Seidel over the contacts, to the tolerance or to the most sweeps."""
        call, settings, open_ = self.fortran, self.settings, ctypes.c_int(1)
        call("nlgs_3d.set_nlgs_parameter", b"QM/16", self.tolerance, 1.0)
        call("nlgs_3d.prep_nlgs", 1)
        for _ in range(0, settings.sweeps, settings.check):
            for _ in range(settings.check):
                call("nlgs_3d.solve_nlgs", 1)
            self.counts[1] += settings.check
            call("nlgs_3d.prep_check_nlgs", ctypes.byref(open_))
            call("nlgs_3d.solve_nlgs", 2)
            call("nlgs_3d.comp_check_nlgs", ctypes.byref(open_))
            if open_.value <= 0:
                break
        self.counts[2] += open_.value > 0
        call("nlgs_3d.rnodhrloc_nlgs", None, None)
        call("nlgs_3d.solve_nlgs", 3)
        call("nlgs_3d.nullify_entitylist_nlgs")
        call("nlgs_3d.update_tact_behav_nlgs")

    def speeds(self):
        """Of every block along x and z, and of its farthest corner by its spin, in g·dt."""
        speeds, velocity = np.zeros((self.count, 3)), np.zeros(6)
        for k in range(self.count):
            self.fortran("rbdy3.get_vector_rbdy3", b"V____", k + 1, velocity, 6)
            spin = -(velocity[3:] @ self.frames[k])[1]
            self.turned[k] += spin * self.settings.step
            speeds[k] = velocity[0], velocity[2], spin * self.reach[k]
        return speeds / (G * self.settings.step)
