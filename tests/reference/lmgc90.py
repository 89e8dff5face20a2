#!/usr/bin/env python3
"""A witness that others wrote: LMGC90, non-smooth contact dynamics of rigid polyhedra, as an outside program.

    python3 -m pip install compas-lmgc90==0.1.11        (Linux; LMGC90 is bundled)
    trilith run paper-1 --external lmgc90="python3 tests/reference/lmgc90.py --tolerance 1e-3"

Walls of more than ten courses take longer than the 60 s that trilith gives: a file of methods can give more.

Reads a scene on standard input and writes a bracket of λ on standard output: the last load under which the blocks
come to rest, and the first under which they run away. Each outline becomes a prism, or several triangular ones of one
body where it is not convex; only what shares a joint of the scene touches, with that joint's friction, so that open
head joints carry nothing. Loads act at their points. Lengths are scaled to the median height of the blocks and
weights to their mean, so that units do not matter.

A load is held for some time steps. The speed that a stone gains in one of them in free fall, g·dt, measures all
speeds: at rest they fade to what the Gauss-Seidel sweeps leave over, under more than the wall can carry they grow
from step to step. Steps are short: nothing moves far, and λ is that of the first motion. LMGC90 keeps one simulation
a process, so every load is tried in a fork of the process that is at rest without one.

How far either end may be off was measured on scenes with exact answers: `engines.csv`, which `witnesses.py exact`
makes. `MEASURED` has it.
"""
import argparse
import ctypes
import json
import os
import signal
import sys

import numpy as np

from lmgc90_pieces import Refused
from lmgc90_simulation import Simulation

# By tolerance: the width of the bracket, and the largest error of the farther end on 28 scenes, both relative.
MEASURED = {1e-1: (1e-2, 0.1), 1e-2: (2e-3, 0.01), 1e-3: (5e-4, 0.0025), 1e-4: (1e-4, 0.001)}


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
        growth, kink = np.abs(fourth - second).max(), np.abs(second - 2 * third + fourth).max()
        steady = kink < 0.25 * growth and speed > 1.2 * np.abs(third).max()
        # What the sweeps leave over may look like it once: the speed must double with the time too.
        if steady and speed > 1.8 * before:
            return False
        before, steps = speed if steady else np.inf, 2 * steps
    return None


def search(simulation, settings, scale):
    """The largest load that came to rest, and the lowest that ran away; None where there is none."""
    first = hold(simulation, 0.0, settings)
    if not first:
        return None, 0.0 if first is False else None
    lower, above, upper, trial = 0.0, None, None, 0.27 * scale
    while trial < settings.ceiling * scale:
        outcome = in_a_fork(simulation, trial, settings)
        if outcome:
            lower = trial
        else:
            above, upper = trial, trial if outcome is False else upper
        width = settings.precision * max(lower, 1e-3 * scale)
        if above is None:
            trial *= 2
        elif above - lower > width:
            trial = (lower + above) / 2
        elif above == upper:
            break
        else:
            return beyond(simulation, settings, lower, above, upper, width)
    return lower, upper


def beyond(simulation, settings, lower, above, upper, width):
    """The bracket where neither shows at its upper end, as just at the limit of friction: a little more must run."""
    for k in range(4):
        trial = above + width * 2**k
        outcome = in_a_fork(simulation, trial, settings)
        if outcome is False:
            return lower, trial
        lower = trial if outcome else lower
    return lower, upper


def in_a_fork(simulation, multiplier, settings):
    """What `hold` says of a load from here on, where everything is left as it is; counts go on."""
    outcome, simulation.counts = forked(lambda: [hold(simulation, multiplier, settings), simulation.counts])
    return outcome


def forked(work):
    """What is computed by a process of its own, which LMGC90 may end as it does."""
    read, write = os.pipe()
    if os.fork() == 0:
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # no fork outlives its parent
        os.write(write, json.dumps(work()).encode())
        os._exit(0)
    os.close(write)
    with os.fdopen(read) as file:
        text = file.read()
    _, status = os.wait()
    if not text:
        raise Refused(f"it ended with status {os.waitstatus_to_exitcode(status)}")
    return json.loads(text)


def answer(scene, settings):
    loads = [load for block in scene["blocks"] for load in block["loads"]]
    dead, live = (sum(np.hypot(*load[name]) for load in loads) for name in ("dead", "live"))
    if not dead > 0 or not live > 0:
        raise Refused("there is no dead or no live load")
    simulation = Simulation(scene, settings)
    lower, upper = search(simulation, settings, dead / live)
    steps, sweeps, unfinished = simulation.counts
    note = f"LMGC90, tolerance {settings.tolerance:g}: {steps} steps, {sweeps} sweeps"
    if unfinished:
        note += f"; {unfinished} steps ended at the most sweeps"
    if lower is None:
        what = "falls" if upper == 0 else "does not come to rest"
        return {"kind": "undecided", "reason": f"{what} unpushed ({note})"}
    if upper is None:
        return {"kind": "undecided", "reason": f"at rest up to {lower:.6g}, and no load ran away ({note})"}
    bracket = {"kind": "estimate", "lambda": lower, "upper": upper, "reason": note}
    precision, error = MEASURED.get(settings.tolerance, (0.0, 0.0))
    if settings.precision <= precision:
        bracket["stated_error"] = error
    return bracket


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    number = {"type": float, "metavar": "NUMBER"}
    options.add_argument("--tolerance", default=1e-3, **number, help="speed that sweeps may leave at rest, in g·dt")
    options.add_argument("--step", default=0.002, **number, help="time step, for blocks 1 high and g = 9.81")
    options.add_argument("--alert", default=0.01, **number, help="distance at which contacts are looked for")
    options.add_argument("--precision", **number, help="width of the bracket, relative [default: as measured]")
    options.add_argument("--ceiling", default=100.0, **number, help="most load, times dead over live load")
    options.add_argument("--hold", default=40, type=int, help="time steps of a load before it is judged")
    options.add_argument("--patience", default=4, type=int, help="how often the hold is doubled where neither shows")
    options.add_argument("--sweeps", default=40000, type=int, help="most sweeps in a time step")
    options.add_argument("--check", default=20, type=int, help="sweeps between two looks at the tolerance")
    options.add_argument("--rest", default=3.0, **number, help="speed at rest, in g·dt and times the tolerance")
    settings = options.parse_args()
    if settings.precision is None:
        settings.precision, _ = MEASURED.get(settings.tolerance, (settings.tolerance / 2, None))
    screen = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # LMGC90 writes of its progress
    try:
        result = forked(lambda: told(settings))
    except Refused as why:
        result = {"kind": "not-applicable", "reason": f"LMGC90: {why}"}
    if "error" in result:
        sys.exit(result["error"])
    os.write(screen, json.dumps(result).encode())


def told(settings):
    """The answer to the scene on standard input, or what was wrong with it."""
    try:
        return answer(json.load(sys.stdin), settings)
    except Refused as why:
        return {"kind": "not-applicable", "reason": f"LMGC90: {why}"}
    except ImportError as why:
        return {"error": f"{why}: install it by `python3 -m pip install compas-lmgc90==0.1.11`"}
    except (json.JSONDecodeError, KeyError, TypeError) as why:
        return {"error": f"no scene on standard input, as `trilith export` writes it: {why!r}"}


if __name__ == "__main__":
    main()
