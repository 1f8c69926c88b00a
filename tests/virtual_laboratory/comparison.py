# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparison with a reference transducer: does U hold the truth, and do step and transducer check each other?

Everything that the budget knows is drawn. Two tables: the response against the transducer alone, without
the shock (sensors and shots as in `coverage`), and both ways on the same shots with a good step, where the
certificate of the reference is right, or wrong by 3 %.
"""
import numpy as np

from . import coverage, held_table, make, readings, runs, switches

U_CERTIFIED, U_DELAY_s, WRONG = 0.003, 50e-9, 0.03
CERTIFICATES = [0.0, WRONG, -WRONG]
CAUGHT, AGREE, ENOUGH = 0.9, 0.95, 0.8  # shares; ENOUGH of fewer than 200 runs
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
    lab = with_reference(coverage.drawn(*coverage.of_cell(cell), rng), rng, coverage.GAIN)
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


def covered(cell, seed):
    name = f"comparison_{cell}"
    return against_transducer(cell, make.generator(name, seed)), name


def agreed(wrong, seed):
    name = f"both_ways_{wrong:g}"
    return both_ways(wrong, make.generator(name, seed)), name


def agreement_of(results, _truth):
    compared = (results or {}).get("comparison")
    keys = ("e_n_mean", "u_difference_relative")
    return {"found": {k: compared.get(k) for k in keys} if compared else None,
            "build": readings.get(results, "software", "build")}


def agreement(lines):
    """`lines` of `agreement_of`; a run without a result does not agree and tells nothing."""
    rows = ["| certificate of the reference | n | within U | told (CMP-001) | rms of 2 E_n "
            "| u of the difference | held |",
            "|---|--:|--:|--:|--:|--:|---|"]
    for wrong in CERTIFICATES:
        found = [line.get("found") or {} for line in lines if line["cell"] == wrong]
        e_n, u = (np.array([f.get(k) for f in found], float) for k in ("e_n_mean", "u_difference_relative"))
        if len(e_n):
            within, told = np.mean(np.abs(e_n) <= 1), np.mean(np.abs(e_n) > 1)
            held = told >= CAUGHT if wrong else within >= (AGREE if len(e_n) >= 200 else ENOUGH)
            rows.append(f"| {'right' if not wrong else f'{100 * wrong:+.0f} %'} | {len(e_n)} | "
                        f"{100 * within:.1f} % | {100 * told:.1f} % | {2 * np.sqrt(np.nanmean(e_n**2)):.2f} | "
                        f"{100 * np.nanmedian(u):.2f} % | {'yes' if held else 'NO'} |")
    return "\n".join([runs.head(lines, CERTIFICATES), "", *rows]) if lines else "no runs"


def study(arguments, count=50):
    lines = runs.collect(arguments, "comparison", runs.Kind(covered, coverage.judged), coverage.CELLS, count)
    both = runs.collect(arguments, "both_ways", runs.Kind(agreed, agreement_of), CERTIFICATES, count)
    return held_table.table(lines, coverage.CELLS, coverage.LABELS) + "\n\n### both ways\n\n" + agreement(both)
