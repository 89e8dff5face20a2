#!/usr/bin/env python3
"""A witness that others wrote: LMGC90, non-smooth contact dynamics of rigid polyhedra, as an outside program.

    python3 -m pip install compas-lmgc90==0.1.11        (Linux; LMGC90 is bundled)
    trilith run paper-1 --external lmgc90="python3 tests/reference/lmgc90.py --tolerance 1e-3"

Reads a scene on standard input and writes a bracket of λ on standard output: the last load under which the blocks
come to rest, and the first under which they run away. Each outline becomes a prism; only bodies that share a joint of
the scene touch, with that joint's friction, so that open head joints carry nothing. Loads act at their points.
Lengths are scaled to the median height of the blocks and weights to their mean, so that units do not matter.

A load is held for some time steps. The speed that a stone gains in one of them in free fall, g·dt, measures all
speeds: at rest they fade to what the Gauss-Seidel sweeps leave over, under more than the wall can carry they grow
from step to step. Steps are short: nothing moves far, and λ is that of the first motion. LMGC90 keeps one simulation
a process, so every load is tried in a fork of the process that is at rest: where it comes to rest too, the fork goes
on from there with a longer stride, else the older process goes on with a shorter one.

How far answers may be off was measured on scenes with exact answers, by setting: `engines.csv`, which
`witnesses.py exact` makes. `STATED` has it.
"""
import argparse
import ctypes
import json
import os
import sys

import numpy as np

G = 9.81
# Tolerance of the sweeps, and the relative error that scenes with exact answers showed.
STATED = {}


class Refused(Exception):
    """The scene is outside what this program can treat."""


class Descriptor(ctypes.Structure):
    """How gfortran passes a pointer to an array of doubles."""

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
        super().__init__(values.ctypes.data, -1, 8, 0, 1, 3, 0, 8, 1, 1, len(values))


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


def area_and_centroid(corners):
    following = np.roll(corners, -1, axis=0)
    cross = corners[:, 0] * following[:, 1] - following[:, 0] * corners[:, 1]
    return cross.sum() / 2, ((corners + following) * cross[:, None]).sum(axis=0) / (3 * cross.sum())


def is_convex(corners):
    edge = np.roll(corners, -1, axis=0) - corners
    following = np.roll(edge, -1, axis=0)
    return (edge[:, 0] * following[:, 1] - edge[:, 1] * following[:, 0]).min() > -1e-9 * np.abs(edge).max() ** 2


def prism(corners, depth):
    """Vertices and outward triangles (from 1) of an outline in x-z, as deep along y, as flat lists."""
    count = len(corners)
    faces = []
    for k in range(1, count - 1):
        faces += [0, k, k + 1, count, count + k + 1, count + k]
    for k in range(count):
        following = (k + 1) % count
        faces += [k, count + k, count + following, k, count + following, following]
    vertices = [value for y in (-depth / 2, depth / 2) for x, z in corners for value in (x, y, z)]
    return vertices, [corner + 1 for corner in faces]


class Simulation:
    """The scene in LMGC90: x to the right, z up, a depth of 1 along y."""

    def __init__(self, scene, settings):
        self.settings, blocks = settings, scene["blocks"]
        self.count = len(blocks)
        unit = float(np.median([np.ptp([y for _, y in block["corners"]]) for block in blocks]))
        outlines = [np.array(shape["corners"]) / unit for shape in blocks + scene["supports"]]
        pairs = treatable(scene, outlines)
        weights = [float(np.hypot(*block["dead"][:2])) for block in blocks]
        self.force = sum(weights) / self.count / G  # so that the mean mass is 1
        from compas_lmgc90 import _lmgc90  # what is refused needs no LMGC90

        self.solver, self.fortran = _lmgc90.LMGC90Solver(), Fortran(_lmgc90.__file__)
        self.kind = self.fortran("parameters.get_interaction_id_from_name", b"PRPRx")
        self.solver.initialize(settings.step, 0.5, False)
        self.joints(pairs)
        self.bodies(outlines, [weight / self.force / G for weight in weights])
        self.loads = [
            [
                (np.array(load["point"]) / unit - centre, *(np.array(load[part]) / self.force for part in ("dead", "live")))
                for load in block["loads"]
            ]
            for block, centre in zip(blocks, self.centres)
        ]
        # What a sweep still changes is a small part of what is left: errors fade as slowly as heat in a bar.
        self.tolerance = settings.tolerance / (4 * farthest(pairs, self.count) ** 2)
        self.reach = [np.hypot(*(outline - centre).T).max() for outline, centre in zip(outlines, self.centres)]
        self.turned = np.zeros(self.count)
        self.steps = self.sweeps = self.unfinished = 0

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
            sees = (*polyhedron, label("b", one), law, *polyhedron, label("b", other))
            call("tact_behaviour.add_to_see_ll", *sees, self.settings.alert, 0.0)
        call("tact_behaviour.close_see_ll")

    def bodies(self, outlines, masses):
        """Prisms of these masses, and supports, wider, that no degree of freedom is left of."""
        shapes = [area_and_centroid(outline) for outline in outlines]
        self.centres = [centre for _, centre in shapes]
        mean = sum(masses) / len(masses)
        densities = [(mass or mean) / area for mass, (area, _) in zip(masses, shapes)] + [1.0] * len(outlines)
        materials = sorted(set(densities[: len(outlines)]))
        self.solver.set_materials(materials)
        self.fortran("bulk_behaviour.set_gravity", np.zeros(3))
        self.solver.set_nb_bodies(len(outlines))
        for k, (outline, centre) in enumerate(zip(outlines, self.centres)):
            fixed = k >= self.count
            vertices, faces = prism(outline - centre, 3.0 if fixed else 1.0)
            material = f"s{materials.index(densities[k]) + 1:04d}"
            self.solver.set_one_polyr(material, [centre[0], 0.0, centre[1]], faces, vertices, 6 * fixed, 0)
            for freedom in range(1, 7) if fixed else ():
                self.solver.set_drvdof(k + 1, freedom, [0.0] * 6, True, False)
            self.fortran("rbdy3.set_color_rbdy3", k + 1, 1, label("b", k))
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
        if self.steps == 0:
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
        self.steps += 1
        return self.speeds()

    def sweep(self):
        """Gauss-Seidel over the contacts, to the tolerance or to the most sweeps."""
        call, settings, open_ = self.fortran, self.settings, ctypes.c_int(1)
        call("nlgs_3d.set_nlgs_parameter", b"QM/16", self.tolerance, 1.0)
        call("nlgs_3d.prep_nlgs", 1)
        for _ in range(0, settings.sweeps, settings.check):
            for _ in range(settings.check):
                call("nlgs_3d.solve_nlgs", 1)
            self.sweeps += settings.check
            call("nlgs_3d.prep_check_nlgs", ctypes.byref(open_))
            call("nlgs_3d.solve_nlgs", 2)
            call("nlgs_3d.comp_check_nlgs", ctypes.byref(open_))
            if open_.value <= 0:
                break
        self.unfinished += open_.value > 0
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


def farthest(pairs, count):
    """How many joints lie between the farthest block and the supports."""
    level, distance = set(range(count, 1 + max(max(pair) for pair in pairs))), {}
    while level:
        distance.update(dict.fromkeys(level, len(distance) and 1 + max(distance.values())))
        level = {end for pair in pairs for end in pair if level & set(pair)} - set(distance)
    return max(distance.values())


def treatable(scene, outlines):
    """The pairs of bodies that touch, with their friction; what LMGC90's polyhedra cannot do is refused by name."""
    count = len(scene["blocks"])
    for k, outline in enumerate(outlines):
        if not is_convex(outline):
            name = scene["blocks"][k]["name"] or f"block {k}" if k < count else f"support {k - count}"
            raise Refused(f"{name} is not convex")
    pairs = {}
    for joint in scene["joints"]:
        other = joint["from_block"]
        pair = (joint["to"], count + joint["from_support"] if other is None else other)
        if pairs.setdefault(pair, joint["friction"]) != joint["friction"]:
            raise Refused("two joints of different friction between the same two bodies")
    return pairs


def hold(simulation, multiplier, settings):
    """Whether the blocks come to rest (True) or run away (False) under a load; None where neither shows."""
    moved, steps, before = [np.zeros((simulation.count, 3))], settings.hold, np.inf
    for _ in range(settings.patience):
        while len(moved) <= steps:
            moved.append(moved[-1] + simulation.advance(multiplier))
        if not np.isfinite(moved[-1]).all():
            return None
        # Mean speeds in the last three quarters of the time: of what runs away they are as 3 to 5 to 7.
        ends = [moved[steps * quarter // 4] for quarter in (1, 2, 3, 4)]
        second, third, fourth = ((later - earlier) / (steps / 4) for earlier, later in zip(ends, ends[1:]))
        speed, limit = np.abs(fourth).max(), settings.rest * settings.tolerance
        if speed < limit:
            return True
        steady = np.abs(second - 2 * third + fourth).max() < 0.25 * np.abs(fourth - second).max() < 0.25 * speed
        # What the sweeps leave over may look like it once: little speed must grow over twice the time too.
        if steady and (speed > 10 * limit or speed > 1.5 * before):
            return False
        before, steps = speed if steady else np.inf, 2 * steps
    return None


def search(simulation, settings, scale):
    """The last load at rest, and the lowest that ran away since; None where there is none."""
    first = hold(simulation, 0.0, settings)
    if not first:
        return {"lower": None, "upper": 0.0 if first is False else None, **counts(simulation)}
    lower, upper, stride, failed, parent = 0.0, None, settings.stride * scale, False, None
    while lower < settings.ceiling * scale:
        least = settings.precision * max(lower, 1e-3 * scale)
        stride = max(stride, least)
        trial, (read, write) = lower + stride, os.pipe()
        if os.fork() == 0:
            outcome, parent = hold(simulation, trial, settings), write
            if not outcome:
                end(parent, {"ran": outcome is False, **counts(simulation)})
            lower, upper = trial, upper if upper and upper > trial else None
            stride *= 1 if failed else 2
            continue
        os.close(write)
        told = message(read)
        if "ran" not in told:
            return told if parent is None else end(parent, told)
        for name in counts(simulation):
            setattr(simulation, name, told[name])
        upper, failed = trial if told["ran"] else upper, True
        if stride <= least:
            break
        stride /= 4
    answer = {"lower": lower, "upper": upper, **counts(simulation)}
    return answer if parent is None else end(parent, answer)


def counts(simulation):
    return {name: getattr(simulation, name) for name in ("steps", "sweeps", "unfinished")}


def message(read):
    """What a fork, or the last one of its forks, wrote; it is over then."""
    with os.fdopen(read) as file:
        text = file.read()
    _, status = os.wait()
    if not text:
        raise Refused(f"LMGC90 ended with status {status}")
    return json.loads(text)


def end(parent, told):
    os.write(parent, json.dumps(told).encode())
    os._exit(0)


def answer(scene, settings):
    loads = [load for block in scene["blocks"] for load in block["loads"]]
    dead, live = (sum(np.hypot(*load[name]) for load in loads) for name in ("dead", "live"))
    if not dead > 0 or not live > 0:
        raise Refused("there is no dead or no live load")
    found = search(Simulation(scene, settings), settings, dead / live)
    note = f"LMGC90, tolerance {settings.tolerance:g}: {found['steps']} steps, {found['sweeps']} sweeps"
    if found["unfinished"]:
        note += f"; {found['unfinished']} steps ended at the most sweeps"
    lower, upper = found["lower"], found["upper"]
    if lower is None:
        what = "falls" if upper == 0 else "does not come to rest"
        return {"kind": "undecided", "reason": f"{what} unpushed ({note})"}
    if upper is None:
        return {"kind": "undecided", "reason": f"at rest up to {lower:.6g}, and no load ran away ({note})"}
    bracket = {"kind": "estimate", "lambda": lower, "upper": upper, "reason": note}
    if settings.tolerance in STATED:
        bracket["stated_error"] = STATED[settings.tolerance]
    return bracket


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    number = {"type": float, "metavar": "NUMBER"}
    options.add_argument("--tolerance", default=1e-3, **number, help="speed that the sweeps may leave at rest, in g·dt")
    options.add_argument("--step", default=0.002, **number, help="time step, for blocks 1 high and g = 9.81")
    options.add_argument("--alert", default=0.01, **number, help="distance at which contacts are looked for")
    options.add_argument("--precision", default=5e-4, **number, help="width of the bracket, relative")
    options.add_argument("--stride", default=0.05, **number, help="first change of the load, times dead over live load")
    options.add_argument("--ceiling", default=100.0, **number, help="most load, times dead over live load")
    options.add_argument("--hold", default=40, type=int, help="time steps of a load before it is judged")
    options.add_argument("--patience", default=4, type=int, help="how often the hold is doubled where neither shows")
    options.add_argument("--sweeps", default=40000, type=int, help="most sweeps in a time step")
    options.add_argument("--check", default=20, type=int, help="sweeps between two looks at the tolerance")
    options.add_argument("--rest", default=3.0, **number, help="speed at rest, in g·dt and times the tolerance")
    settings = options.parse_args()
    screen = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # LMGC90 writes of its progress
    try:
        result = answer(json.load(sys.stdin), settings)
    except Refused as why:
        result = {"kind": "not-applicable", "reason": f"LMGC90: {why}"}
    os.write(screen, json.dumps(result).encode())


if __name__ == "__main__":
    main()
