# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparison with a reference transducer: does U hold the truth, and do step and transducer check each other?

Everything that the budget knows is drawn. Two tables: the response against the transducer alone, without
the shock (sensors and shots as in `coverage`), and both ways on the same shots with a good step, where the
certificate of the reference is right, or wrong by 3 %.
"""
import json
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

from . import capture_file, coverage, laboratory, make, runner, switches

U_CERTIFIED, U_DELAY_s, WRONG = 0.003, 50e-9, 0.03
GOOD_GAIN = 0.002 / np.sqrt(3)  # u of each chain where both ways are compared


def with_reference(lab, rng, gain):
    """`gain` is the half width of the reference's chain."""
    error, phase = rng.normal(0, U_CERTIFIED, 2)
    lab.reference = switches.Reference(gain=1 + rng.uniform(-gain, gain), delay_s=rng.normal(0, U_DELAY_s),
                                       certified=1 + error, certified_phase_rad=phase,
                                       u_certified=U_CERTIFIED)
    lab.noted.recipe["comparison"] = {"enabled": True, "source": "reference.csv", "u_delay_s": U_DELAY_s}
    return lab


def against_transducer(cell, rng):
    sensor, shots = cell % len(coverage.SENSORS), coverage.SHOTS[cell // len(coverage.SENSORS)]
    lab = with_reference(coverage.drawn(sensor, shots, rng), rng, coverage.GAIN)
    lab.noted.recipe["response"] = {"reference": "transducer"}
    return lab


def both_ways(wrong, rng):
    """u(W)/W of 0.1 %, u(T1) of 0.3 K, humidity known, chains to 0.2 %."""
    lab = with_reference(switches.default(rng, 3), rng, 0.002)
    lab.dut.modes, lab.attenuation = [coverage.SENSORS[0] + (1.0,)], rng.uniform(-0.001, 0.002)
    gain = 1 + rng.uniform(-0.002, 0.002)
    for plan in lab.shots:
        plan.gain = gain
    lab.noted.shock["attenuation_per_m"] = [-0.001, 0.002]
    lab.noted.recipe["uncertainty"] = {"budget": [
        {"quantity": name, "u": GOOD_GAIN, "distribution": "rectangular"}
        for name in ("gain_relative", "reference_gain_relative")]}
    lab.reference.certified *= 1 + wrong
    return lab


def calibrated(program, lab, name, seed):
    with tempfile.TemporaryDirectory(prefix="virtual_laboratory_") as folder:
        records = laboratory.perform(lab, make.generator(name + " records", seed))
        capture_file.write(folder, lab, records, name, seed)
        truth = json.loads((Path(folder) / "truth.json").read_text("utf-8"))
        return runner.calibrate(program, Path(folder))[1], truth


def covered(arguments):
    program, cell, seed = arguments
    lab = against_transducer(cell, make.generator(f"comparison_{cell}", seed))
    results, truth = calibrated(program, lab, f"comparison_{cell}", seed)
    return cell, coverage.ratios(results, truth) if results and results.get("response") else None


def agreed(arguments):
    program, wrong, seed = arguments
    name = f"both_ways_{wrong:g}"
    results, _ = calibrated(program, both_ways(wrong, make.generator(name, seed)), name, seed)
    found = (results or {}).get("comparison") or {}
    return wrong, found.get("e_n_mean"), found.get("u_difference_relative")


def agreement(arguments, pool, count):
    by_case = {wrong: [] for wrong in (0.0, WRONG, -WRONG)}
    seeds = range(arguments.first_seed, arguments.first_seed + count)
    for wrong, e_n, u in pool.map(agreed, [(arguments.program, w, s) for w in by_case for s in seeds]):
        by_case[wrong].append((np.nan if e_n is None else e_n, np.nan if u is None else u))
    lines = ["| certificate of the reference | n | within U | told (CMP-001) | rms of 2 E_n | u of the difference |",
             "|---|--:|--:|--:|--:|--:|"]
    for wrong, found in by_case.items():
        e_n, u = np.array(found).T
        lines.append(f"| {'right' if not wrong else f'{100 * wrong:+.0f} %'} | {len(e_n)} | "
                     f"{100 * np.mean(np.abs(e_n) <= 1):.1f} % | {100 * np.mean(np.abs(e_n) > 1):.1f} % | "
                     f"{2 * np.sqrt(np.nanmean(e_n**2)):.2f} | {100 * np.nanmedian(u):.2f} % |")
    return "\n".join(lines)


def study(arguments, count=50):
    count = arguments.seeds or count
    with ProcessPoolExecutor(arguments.processes) as pool:
        table = coverage.table(arguments, pool, covered, count)
        return table + "\n\n" + agreement(arguments, pool, count)
