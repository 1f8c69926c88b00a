# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does the complete U hold the truth? Everything that the budget knows is drawn, nothing is wrong.

Three sensors, three and six shots: six cells. Of each run: sensitivity, f0, zeta, band edges, step,
and S(f) at up to twelve frequencies, amplitude and phase, against the truth itself (not, as in the
other studies, relative to the true step).
"""
from collections import Counter

import numpy as np

from . import held_table, judge, make, readings, runs, switches
from .studies_conditions import ATTENUATION

SENSORS = ((318e3, 0.02), (120e3, 0.05), (200e3, 0.4))
SHOTS = (3, 6)
CELLS = list(range(len(SENSORS) * len(SHOTS)))
LABELS = [f"{f / 1e3:.0f} kHz, {z}, {n} shots" for n in SHOTS for f, z in SENSORS]
ROWS = 12
GAIN, LINEARITY, MOUNTING, CLOCK, FRONT_s = 0.005, 0.001, 0.001, 50e-6, 100e-9  # what is not stated


def of_cell(cell):
    """The number of its sensor, and its shots."""
    return cell % len(SENSORS), SHOTS[cell // len(SENSORS)]


def drawn(sensor, shots, rng):
    lab = switches.default(rng)
    f0, zeta = SENSORS[sensor]
    lab.dut.modes = [(f0, zeta, 1.0)]
    lab.dut.front = ("ramp", rng.uniform(0, FRONT_s))
    lab.noise = np.exp(rng.uniform(np.log(0.002), np.log(0.02)))
    lab.attenuation = rng.uniform(*ATTENUATION)
    lab.humidity = rng.uniform(0, 1)
    lab.noted.humidity = None if rng.random() < 0.5 else round(lab.humidity, 2)
    lab.recorder.clock = rng.uniform(-CLOCK, CLOCK)
    common, lab.dut.seat = 1 + rng.uniform(-GAIN, GAIN), rng.normal(0, MOUNTING)
    lab.shots = [switches.ShotPlan(switches.SPEEDS[i % 3] * (1 + rng.normal(0, 0.003)), switches.LEVELS[i % 3])
                 for i in range(shots)]
    for plan in lab.shots:
        plan.gain = common * (1 + rng.uniform(-LINEARITY, LINEARITY))
    return lab


def z_of(value, u, k, true):
    return None if value is None or not u or not k else (value - true) / (k * u)


def rows(results, truth):
    """(error/U of the magnitude, of the phase) at up to twelve frequencies."""
    answer = results["response"]
    chosen = [i for i, u in enumerate(answer["u_magnitude"] or []) if u is not None and answer["u_phase_rad"][i]]
    for i in chosen[::max(1, len(chosen) // ROWS)][:ROWS]:
        true = complex(readings.true_response(truth, [answer["frequency_hz"][i]])[0])
        turn = np.angle(np.exp(1j * (answer["phase_rad"][i] - np.angle(true))))
        yield (z_of(answer["magnitude"][i], answer["u_magnitude"][i], answer["k_magnitude"][i], abs(true)),
               turn / (answer["k_phase"][i] * answer["u_phase_rad"][i]),
               answer["u_common_relative"] * answer["magnitude"][i] / answer["u_magnitude"][i])


def ratios(results, truth):
    """error/U by quantity; several for S(f)."""
    found = {"S(f), noise": [], "S(f), step": [], "phase": []}
    s = results["sensitivity"] or {}
    found["sensitivity"] = [z_of(s.get("value"), s.get("u"), s.get("k"), truth["sensitivity"])]
    stated = readings.stated_characteristics(results, {"f0_hz": truth["f0_hz"], "damping_ratio": truth["zeta"]})
    for name, item in {**stated, **readings.bands(results, truth)}.items():
        found[name] = [z_of(item["value"], item["u"], item["k"], item["true"])]
    step = readings.of_shock(results, truth, len(truth["shots"]) - 1, "step_pa", "step_dof")
    found["step"] = [z_of(step["value"], step["u"], step["k"], step["true"])] if step else []
    for magnitude, phase, common in rows(results, truth):
        found["S(f), step" if common > np.sqrt(0.5) else "S(f), noise"].append(magnitude)
        found["phase"].append(phase)
    return {name: [v for v in values if v is not None] for name, values in found.items()}


def judged(results, truth):
    """What a line of `runs` has of one run."""
    answered = results and results.get("response")
    return {"found": ratios(results, truth) if answered else None,
            "build": readings.get(results, "software", "build"),
            "cautions": sorted({f["id"] for f in judge.cautions(results or {})})}


def laboratory(cell, seed):
    sensor, shots = of_cell(cell)
    name = f"coverage_{sensor}_{shots}"
    return drawn(sensor, shots, make.generator(name, seed)), name


KIND = runs.Kind(laboratory, judged)


def cautions(lines):
    """How many runs have each caution."""
    tally = Counter(caution for line in lines for caution in line.get("cautions") or [])
    return "Cautions, in runs: " + (", ".join(f"{c} {n}" for c, n in sorted(tally.items())) or "none")


def study(arguments, count=50):
    lines = runs.collect(arguments, "coverage", KIND, CELLS, count)
    return held_table.table(lines, CELLS, LABELS)
