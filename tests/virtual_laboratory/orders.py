# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does the answer from the record alone change with the order? Its points, order by order."""
import json
import tempfile
from pathlib import Path

import numpy as np

from . import make, runner


def points(results):
    answer = results.get("response") or {}
    f, m, p = (answer.get(k) or [] for k in ("frequency_hz", "magnitude", "phase_rad"))
    return {a: (b, c) for a, b, c in zip(f, m, p) if b is not None}


def largest_difference(first, other, onset_change):
    """Relative of the magnitude, and of the phase beyond 2 pi f times the onset's change, rad."""
    shared = sorted(set(first) & set(other))
    if not shared:
        return float("nan"), float("nan")
    a, b = (np.array([s[f] for f in shared]) for s in (first, other))
    turn = b[:, 1] - a[:, 1] - 2 * np.pi * np.array(shared) * onset_change
    return float(np.max(abs(b[:, 0] / a[:, 0] - 1))), float(np.max(abs(np.angle(np.exp(1j * turn)))))


def line(order, code, results, first):
    if not results or not points(results):
        return f"| {order} | exit {code} | – | – |"
    change = np.mean([s["onset_s"] - t["onset_s"] for s, t in zip(results["shots"], first["shots"])
                      if s["onset_s"] is not None and t["onset_s"] is not None] or [0.0])
    magnitude, phase = largest_difference(points(first), points(results), change)
    return f"| {order} | {len(points(results))} | {magnitude:.2e} | {phase:.2e} |"


def study(arguments, condition="slow_modes", orders=(1, 2, 3, 4, 6, 8, 10, 15, 20, 30, 53, 80, 120)):
    lines = ["| order | points | largest relative difference of the magnitude | of the phase, rad |",
             "|--:|--:|--:|--:|"]
    with tempfile.TemporaryDirectory() as name:
        folder, first = Path(name), None
        make.make(condition, arguments.first_seed, folder)
        truth = json.loads((folder / "truth.json").read_text())
        for order in orders:
            recipe = json.loads((folder / "recipe.json").read_text())
            # A velocity that rests on the DUT's own arrival moves with the onset, hence the step.
            recipe.setdefault("shock", {})["step_pa"] = [shot["step_pa"] for shot in truth["shots"]]
            recipe["response"] = {"frequencies_hz": list(np.geomspace(1e3, 3e5, 25))}
            (folder / "recipe.json").write_text(json.dumps(recipe))
            code, results, _ = runner.calibrate(arguments.program, folder, ("--order", str(order)))
            first = first or results
            lines.append(line(order, code, results, first))
    return "\n".join(lines)
