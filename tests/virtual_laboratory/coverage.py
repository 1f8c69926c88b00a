# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does the complete U hold the truth? Everything that the budget knows is drawn, nothing is wrong.

Three sensors, three and six shots: six cells. Of each run: sensitivity, f0, zeta, band edges, step,
and S(f) at up to twelve frequencies, amplitude and phase, against the truth itself (not, as in the
other studies, relative to the true step).
"""
import json
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

from . import capture_file, laboratory, make, readings, runner, switches
from .studies_conditions import ATTENUATION

SENSORS = ((318e3, 0.02), (120e3, 0.05), (200e3, 0.4))
SHOTS = (3, 6)
ROWS = 12
GAIN, LINEARITY, MOUNTING, CLOCK, FRONT_s = 0.005, 0.001, 0.001, 50e-6, 100e-9  # what is not stated


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
    common = (1 + rng.uniform(-GAIN, GAIN)) * (1 + rng.normal(0, MOUNTING))
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


def one(arguments):
    program, cell, seed = arguments
    sensor, shots = cell % len(SENSORS), SHOTS[cell // len(SENSORS)]
    name = f"coverage_{sensor}_{shots}"
    with tempfile.TemporaryDirectory(prefix="virtual_laboratory_") as folder:
        lab = drawn(sensor, shots, make.generator(name, seed))
        records = laboratory.perform(lab, make.generator(name + " records", seed))
        capture_file.write(folder, lab, records, name, seed)
        truth = json.loads((Path(folder) / "truth.json").read_text("utf-8"))
        results = runner.calibrate(program, Path(folder))[1]
        return cell, ratios(results, truth) if results and results.get("response") else None


def table(arguments, pool, run, count):
    """`run`: of (program, cell, seed), the cell and its ratios."""
    seeds = range(arguments.first_seed, arguments.first_seed + count)
    tasks = [(arguments.program, cell, seed) for cell in range(len(SENSORS) * len(SHOTS)) for seed in seeds]
    cells = {}
    for cell, found in pool.map(run, tasks):
        for name, values in (found or {"no result": [1.0]}).items():
            cells.setdefault(name, {}).setdefault(cell, []).extend(values)
    head = " | ".join(f"{f / 1e3:.0f} kHz, {z}, {n} shots" for n in SHOTS for f, z in SENSORS)
    lines = [f"{len(seeds)} runs in each of {len(SENSORS) * len(SHOTS)} cells, % within U", "",
             f"| quantity | n | all | {head} | rms z |", "|---|--:|--:|" + "--:|" * 7]
    for name, by_cell in cells.items():
        everything = np.concatenate([by_cell[c] for c in by_cell if by_cell[c]] or [[]])
        if len(everything):
            def share(values):
                return f"{100 * np.mean(np.abs(values) <= 1):.1f}" if len(values) else "–"
            each = " | ".join(share(by_cell.get(c, [])) for c in range(len(SENSORS) * len(SHOTS)))
            rms = 1.96 * np.sqrt(np.mean(np.square(everything)))
            lines.append(f"| {name} | {len(everything)} | {share(everything)} | {each} | {rms:.2f} |")
    return "\n".join(lines)


def study(arguments, count=50):
    with ProcessPoolExecutor(arguments.processes) as pool:
        return table(arguments, pool, one, arguments.seeds or count)
