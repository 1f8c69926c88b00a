# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The statement of conformity: every row of the claim by its rule (docs/method/uncertainty.md)."""

import numpy as np
from scipy import stats

from audit_capability import factor
from audit_report import combined, relative, table
from audit_rows import OF_NOISE

ROUNDING = 1e-9  # of the ends of the claim
WIDEST = 1.28 * (1.0 + 1e-4)  # a third of an octave, rounded as ISO 266 does
NOT_IN_ROWS = ("level_relative", "chain_relative", "reference_sensitivity_relative", "reference_level_relative")


class Judged:
    """One row of the claim."""

    def __init__(self, row, low, of_low, decision):
        """`low`: the sensitivity; `of_low`: its lines that no row has, relative."""
        self.f_Hz = row.f_Hz
        self.deviation = row.magnitude / low - 1.0
        lines = [(c / low, dof) for c, dof in row.own_lines().values()]
        self.u, self.dof = combined(lines + [(c * row.magnitude / low, dof) for c, dof in of_low])
        # As of the row: its noise may look coloured by chance, its variance makes the magnitude smaller.
        of_noise = (row.u_noise / low / self.u)**2
        self.allowed_of_u = 1e-3 + row.allowed * of_noise
        self.allowed = 0.002 * self.u + 1.5 * row.shots * row.allowed * of_noise * self.u**2
        self.is_coloured = row.allowed > OF_NOISE
        self.k = factor(self.dof)
        self.limit = 0.01 * decision["within_percent"]
        distance = stats.norm if np.isinf(self.dof) else stats.t(self.dof)
        self.risk = (distance.sf((self.limit - self.deviation) / self.u)
                     + distance.sf((self.limit + self.deviation) / self.u))

    def strain(self, rule):
        """What the rule compares: the worst row has most of it."""
        size = abs(self.deviation)
        return {"simple": size, "guard-band": size + self.k * self.u, "risk": self.risk}[rule]

    def is_accepted(self, decision):
        if decision["rule"] == "risk":
            return self.risk <= 0.01 * decision["max_risk_percent"]
        return self.strain(decision["rule"]) <= self.limit


def claimed(f_Hz, decision):
    return decision["from_hz"] * (1.0 - ROUNDING) <= f_Hz <= decision["to_hz"] * (1.0 + ROUNDING)


def reason_for_none(results, frequencies, has_gaps, decision):
    """Why nothing is said; None where something can be."""
    response = results["response"]
    if (decision["from_hz"] < response["f_low_hz"] * (1.0 - ROUNDING)
            or decision["to_hz"] > response["f_high_hz"] * (1.0 + ROUNDING)):
        return "measured"
    if has_gaps:
        return "complete uncertainty"
    at = [decision["from_hz"], *frequencies, decision["to_hz"]]
    if not frequencies or any(b > WIDEST * a for a, b in zip(at, at[1:])):
        return "widest step"
    return None


def is_left_by_model(folder, low, decision, guard):
    """Between the rows, by the model's curve."""
    curve = table(folder / "csv" / "model_curve.csv")
    size = [abs(m / low - 1.0) for f, m in zip(curve["frequency_hz"], curve["magnitude"]) if claimed(f, decision)]
    return any(one > 0.01 * decision["within_percent"] - guard for one in size)


def check_conformity(report, results, folder, rows, lines, mean):
    """`rows`: all that the response states, those at marked frequencies too; `lines` of the sensitivity `mean`."""
    decision, stated = results["recipe"]["certificate"]["decision"], results["conformity"]
    report.equal("conformity is stated where it is asked for", stated is not None, decision is not None)
    if decision is None:
        return
    of_low = [(c / mean, dof) for place, (c, dof) in lines.items() if place[0] in NOT_IN_ROWS]
    judged = sorted((Judged(row, mean, of_low, decision)
                     for row in rows if claimed(row.f_Hz, decision)), key=lambda one: one.f_Hz)
    frequencies = sorted(f for section in (results["response"], results["response"]["marked"])
                         for f in section["frequency_hz"] if claimed(f, decision))
    reason = reason_for_none(results, frequencies, len(judged) < len(frequencies), decision)
    if not reason:
        worst = max(judged, key=lambda one: one.strain(decision["rule"]))
        guard = worst.k * worst.u if decision["rule"] == "guard-band" else 0.0
        verdict = "conforms" if all(one.is_accepted(decision) for one in judged) else "does-not-conform"
        if verdict == "conforms" and is_left_by_model(folder, mean, decision, guard):
            reason = "between them"
    if reason:
        report.equal("no statement of conformity", stated["verdict"], None)
        report.equal(f"its reason names '{reason}'", reason in stated["verdict_reason"], True)
        return
    report.equal("verdict of conformity", stated["verdict"], verdict)
    report.equal("rows judged", stated["rows"], len(judged))
    check_worst(report, stated["worst"], worst)


def check_worst(report, stated, worst):
    report.compare("worst frequency (Hz)", stated["frequency_hz"], worst.f_Hz, relative(worst.f_Hz, 1e-12))
    for key, value, allowed in (("deviation_percent", 100.0 * worst.deviation, 100.0 * worst.allowed),
                                ("u_percent", 100.0 * worst.u, relative(100.0 * worst.u, worst.allowed_of_u)),
                                ("k", worst.k, 1e-2 if worst.is_coloured else 1e-4)):
        report.compare(f"worst row: {key}", stated[key], value, allowed)
    if worst.is_coloured:
        return
    # The tail's slope: a thousandth of u moves it by as much of the distance in u.
    steep = 0.02 * (1.0 + ((worst.limit - abs(worst.deviation)) / worst.u)**2)
    report.compare("worst row: risk_percent", stated["risk_percent"], 100.0 * worst.risk,
                   relative(100.0 * worst.risk, min(1.0, steep)) + 1e-13)
    dof = np.inf if stated["dof"] is None else stated["dof"]
    report.compare("worst row: dof", dof, worst.dof, relative(worst.dof, 1e-2) if worst.dof < np.inf else 0.0)
