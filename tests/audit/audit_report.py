# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What all parts of the audit share: comparisons as lines, and tables."""

import csv
from functools import lru_cache

import numpy as np
from scipy import stats

SHARE = 2e-3  # of a standard uncertainty: the program's descent ends at half of that


class Report:
    """Every comparison a line; `allowed` in the unit of the quantity."""

    def __init__(self):
        self.failed = 0

    def compare(self, name, stated, recomputed, allowed):
        stated = np.nan if stated is None else stated
        difference = abs(stated - recomputed) if stated != recomputed else 0.0  # both may be infinite
        passes = difference <= allowed  # false for NaN too
        self.failed += not passes
        print(f"{'ok  ' if passes else 'OFF '} {name:44s} {stated:.12g}  {recomputed:.12g}"
              f"  ({difference:.2g} of {allowed:.2g})")

    def compare_all(self, name, stated, recomputed, allowed):
        """One line for a column: the value that is farthest out."""
        stated, recomputed = np.array(stated, float), np.array(recomputed, float)
        allowed = np.broadcast_to(allowed, stated.shape)
        out = np.abs(stated - recomputed) / np.maximum(allowed, np.finfo(float).tiny)
        k = np.where(np.isnan(out), np.inf, out).argmax()
        self.compare(f"{name}, worst of {len(stated)}: [{k}]", stated[k], recomputed[k], allowed[k])

    def equal(self, name, stated, recomputed):
        self.failed += stated != recomputed
        print(f"{'ok  ' if stated == recomputed else 'OFF '} {name:44s} {stated}"
              + ("" if stated == recomputed else f" is not {recomputed}"))


def relative(value, share):
    return abs(value) * share


def combined(lines):
    """u and effective degrees of freedom of pairs (contribution, degrees of freedom)."""
    variance = sum(c**2 for c, _ in lines)
    fourth = sum(c**4 / dof for c, dof in lines)
    return np.sqrt(variance), variance**2 / fourth if fourth > 0.0 else np.inf


@lru_cache(maxsize=None)
def coverage_factor(dof):
    """Student's, two sides, 95 %."""
    return stats.t.ppf(0.975, dof) if np.isfinite(dof) else stats.norm.ppf(0.975)


def check_lines(report, of, budget, lines, share_of):
    """Every line that is stated against (contribution, degrees of freedom) of the one that belongs there, sign
    included. `lines`: by quantity or (quantity, shot); `share_of(quantity)`: of a contribution, what is allowed."""
    lines = {key if isinstance(key, tuple) else (key, None): line for key, line in lines.items()}
    stated = {(line["quantity"], line["shot"]): line for line in budget if line["of"] == of}
    report.equal(f"lines of {of}", sorted(map(str, stated)), sorted(map(str, lines)))
    for place, line in stated.items():
        expected, dof = lines.get(place, (np.nan, np.nan))
        name = f"{of}: {place[0]}" + (f", shot {place[1]}" if place[1] else "")
        report.compare(name, line["contribution"], expected, relative(expected, share_of(place[0])) + 1e-18)
        if place[0] != "noise":  # how many it has is an estimate
            report.compare(f"{name}, dof", or_infinite(line["dof"]), dof, 0.0 if np.isinf(dof) else relative(dof, 1e-9))


def or_infinite(dof):
    return np.inf if dof is None else dof


@lru_cache(maxsize=None)
def table(path):
    """Columns of a csv by their names; an empty cell is NaN."""
    with open(path, newline="") as file:
        names = next(csv.reader(file))
        try:
            values = np.loadtxt(file, delimiter=",", ndmin=2)
        except ValueError:
            file.seek(0)
            rows = list(csv.reader(file))[1:]
            values = np.array([[float(cell) if cell else np.nan for cell in row] for row in rows])
    return dict(zip(names, values.T))
