# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does U still hold the truth where the tube does what the analysis has no model of?

One effect at a time, on top of all that `coverage` draws. The sizes are those of README.md.
"""
from functools import partial

import numpy as np

from . import coverage, held_table, make, runs

ACCELERATION_PA = (0.1, 1.4)  # per m/s^2; quartz sensors, compensated and not
WALL_KG, BORE_m2 = (2.0, 10.0), np.pi * 0.05**2  # the mass that moves with the mode
WALL_HZ, WALL_ZETA = (2e3, 40e3), (0.005, 0.05)
RISE_OF_RAMP = 0.8  # 10-90 %, of a ramp's duration
LEAST = 0.9


def log_uniform(rng, limits):
    return float(np.exp(rng.uniform(*np.log(limits))))


def mounting(lab, rng):
    """The step shakes the end wall, and the sensor feels the acceleration, with either sign."""
    share = rng.uniform(*ACCELERATION_PA) * BORE_m2 / log_uniform(rng, WALL_KG)
    lab.dut.mount = (share * rng.choice((-1, 1)), log_uniform(rng, WALL_HZ), log_uniform(rng, WALL_ZETA))


def attenuation(lab, rng):
    """The same change over the tube, but not in proportion to the distance."""
    lab.attenuation_law = str(rng.choice(("exponential", "early", "late")))


def front(lab, rng):
    """Another shape with the rise, 10 to 90 %, that the ramp has."""
    lab.dut.front = (str(rng.choice(("exponential", "half_sine"))), RISE_OF_RAMP * lab.dut.front[1])


EFFECTS = {effect.__name__: effect for effect in (mounting, attenuation, front)}


def disturbed(effect, cell, rng):
    lab = coverage.drawn(*coverage.of_cell(cell), rng)
    EFFECTS[effect](lab, rng)
    return lab


def laboratory(effect, cell, seed):
    name = f"unmodelled_{effect}_{cell}"
    return disturbed(effect, cell, make.generator(name, seed)), name


def wanted(name, count):
    return (LEAST, 1.0), (0.0, 1.0), np.inf


def study(arguments, count=20):
    parts = []
    for effect in (e for e in EFFECTS if not arguments.only or e in arguments.only):
        kind = runs.Kind(partial(laboratory, effect), coverage.judged)
        lines = runs.collect(arguments, f"unmodelled {effect}", kind, coverage.CELLS, count)
        parts.append(f"### {effect}\n\n" + held_table.table(lines, coverage.CELLS, coverage.LABELS, wanted)
                     + "\n\n" + coverage.cautions(lines))
    return "\n\n".join(parts)
