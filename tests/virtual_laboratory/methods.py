# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Methods side by side: bias and scatter of f0 and damping ratio of the same calibrations, by treatment of the response.

What tests/accuracy/method_table.cpp asks of one record in one process is asked here of whole calibrations: every
method is a recipe, so the study is a plan of `dyncal batch` like any other. Noise of 1 % of each shot's step, three shots,
nothing wrong; the methods of one sensor and seed have the same records.
"""
from functools import partial

import numpy as np

from . import coverage, make, runs, switches

NOISE = 0.01


def recipe(treatment, combine, order=2, refine=False):
    return {"input": {"treatment": treatment, "combine": combine}, "realization": {"order": order, "refine": refine}}


METHODS = {
    "thesis, order 2": recipe("step-as-impulse", "pca-average"),
    "thesis, order 3": recipe("step-as-impulse", "pca-average", 3),
    "differenced, average": recipe("differenced", "pca-average"),
    "differenced, stacked": recipe("differenced", "stacked"),
    "step deflated": recipe("step-deflated", "stacked"),
    "deflated, refined": recipe("step-deflated", "stacked", refine=True),
}
CELLS = list(range(len(coverage.SENSORS)))


def laboratory(method, sensor, seed):
    name = f"methods_{sensor}"
    lab = switches.default(make.generator(name, seed))
    f0, zeta = coverage.SENSORS[sensor]
    lab.dut.modes, lab.noise = [(f0, zeta, 1.0)], NOISE
    lab.noted.recipe.update(METHODS[method])
    return lab, name


def judged(results, truth):
    """Relative errors of the oscillating pole with the largest amplitude; none where no pole oscillates."""
    model = (results or {}).get("model")
    ringing = [p for p in model["poles"] if p["im"] > 0 and p["class"] != "nyquist"] if model else []
    if not ringing:
        return {"found": None, "build": results["software"]["build"] if results else None}
    pole = max(ringing, key=lambda p: p["amplitude"] or 0.0)
    return {"found": {"f0": pole["frequency_hz"] / truth["f0_hz"] - 1, "zeta": pole["damping_ratio"] / truth["zeta"] - 1},
            "build": results["software"]["build"]}


def cell_of_table(errors):
    return f"{100 * np.mean(errors):+.4f} ± {100 * np.std(errors):.4f}"


def rows(method, lines):
    """One for each sensor."""
    for sensor, (f0, zeta) in enumerate(coverage.SENSORS):
        of_sensor = [line for line in lines if line["cell"] == sensor]
        found = [line["found"] for line in of_sensor if line.get("found")]
        values = [cell_of_table([f[q] for f in found]) if found else "–" for q in ("f0", "zeta")]
        yield f"| {f0 / 1e3:.0f} kHz, {zeta} | {method} | {len(found)} of {len(of_sensor)} | {' | '.join(values)} |"


def study(arguments, count=40):
    table = {}
    for method in METHODS:
        kind = runs.Kind(partial(laboratory, method), judged)
        lines = runs.collect(arguments, f"methods {method}", kind, CELLS, count)
        for row in rows(method, lines):
            table.setdefault(row.split(" | ")[0], []).append(row)
    return "\n".join(["| sensor | method | n | f0, % | damping ratio, % |", "|---|---|--:|--:|--:|",
                      *(row for of_sensor in table.values() for row in of_sensor)])
