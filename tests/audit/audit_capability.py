# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""No U below the laboratory's CMC (docs/method/uncertainty.md)."""

import numpy as np
from scipy import optimize

from audit_report import coverage_factor

RECIPROCAL = {"q": "damping_ratio", "damping_ratio": "q"}
FACTOR = 2.0  # that U is stated with, or Student's where it is larger


def factor(dof):
    return max(FACTOR, coverage_factor(dof))


class Capability:
    """Of the recipe's uncertainty.cmc."""

    def __init__(self, results):
        self.entries = results["recipe"]["uncertainty"]["cmc"]

    def least(self, of, value, f_Hz=0.0):
        """The largest U of the entries for this; 0 without one. Q is 1/(2 damping): relative to both, either's is the
        other's."""
        own = self.entered(of, value, f_Hz)
        if of not in RECIPROCAL:
            return own
        other = 0.5 / value
        return max(own, self.entered(RECIPROCAL[of], other) * abs(value / other))

    def entered(self, of, value, f_Hz=0.0):
        """The same of the entries that name it."""
        found = [0.0]
        for entry in self.entries:
            over_frequency = of in ("magnitude", "phase_rad")
            top = np.inf if entry["to_hz"] is None else entry["to_hz"]
            if entry["of"] == of and (not over_frequency or entry["from_hz"] <= f_Hz <= top):
                is_relative = entry["relative"] and of != "phase_rad"
                found.append(entry["expanded"] * (abs(value) if is_relative else 1.0))
        return max(found)


def held(u, dof, least):
    """u, degrees of freedom and k of a value of which no U below `least` is stated."""
    if not factor(dof) * u < least:
        return u, dof, coverage_factor(dof)

    def U_less(one):
        return factor(dof * (one / u)**4) * one - least

    high = least / FACTOR
    u_held = high if U_less(high) <= 0.0 else optimize.brentq(U_less, u, high, xtol=1e-15 * u, rtol=1e-14)
    dof_held = dof * (u_held / u)**4
    return u_held, dof_held, factor(dof_held)


def with_line(lines, least):
    """Lines (u, dof) by name, and the line `cmc` where there must be one."""
    if not lines:
        return lines
    u = np.sqrt(sum(c**2 for c, _ in lines.values()))
    fourth = sum(c**4 / dof for c, dof in lines.values())
    raised = held(u, u**4 / fourth if fourth > 0.0 else np.inf, least)[0]
    return lines if raised == u else {**lines, "cmc": (np.sqrt(raised**2 - u**2), np.inf)}


def check_capability(report, results):
    """Whatever has U stays at or above the CMC, and at it where the line `cmc` says so."""
    capability = Capability(results)
    if not capability.entries:
        return
    raised = {line["of"] for line in results["budget"] if line["quantity"] == "cmc"}
    margins = [(of, U / least - 1.0) for of, U, least in stated_and_least(results, capability) if least > 0.0]
    report.compare("U below the CMC, by so much of it", max([0.0] + [-margin for _, margin in margins]), 0.0, 1e-9)
    report.compare("U over the CMC where the line cmc makes it up",
                   max([0.0] + [margin for of, margin in margins if of in raised]), 0.0, 1e-9)
    report.equal("values with a CMC", bool(margins), True)


def stated_and_least(results, capability):
    """(name as in the budget, U, CMC) of everything stated."""
    def U(u, k):
        return max(FACTOR, k) * u

    mean = results["sensitivity"]
    if mean and mean["u"]:
        yield "sensitivity", U(mean["u"], mean["k"]), capability.least("sensitivity", mean["value"])
        for level in mean["per_level"]:
            yield level["level"], U(level["u"], level["k"]), capability.least("sensitivity", level["value"])
    for shot in results["shots"]:
        if shot["u_sensitivity"]:
            yield "shot", U(shot["u_sensitivity"], shot["k_sensitivity"]), capability.least("sensitivity",
                                                                                           shot["sensitivity"])
    for one in results["characteristics"]:
        if one["u"]:
            yield one["quantity"], U(one["u"], one["k"]), capability.least(one["quantity"], one["value"])
    for place, section in sections_of(results):
        yield from rows_and_least(place, section, capability)


def sections_of(results):
    """Everything with measured rows; the places of the first are those of the budget."""
    for name in ("response", "comparison"):
        if results[name] and results[name]["magnitude"]:
            yield name, results[name]
            if results[name]["marked"]:
                yield f"{name}.marked", results[name]["marked"]


def rows_and_least(place, section, capability):
    for k, f_Hz in enumerate(section["frequency_hz"]):
        for of, u, factor_key in (("magnitude", "u_magnitude", "k_magnitude"), ("phase_rad", "u_phase_rad", "k_phase")):
            if section[u][k] is not None:
                yield (f"{place}.{of}[{k}]", max(FACTOR, section[factor_key][k]) * section[u][k],
                       capability.least(of, section[of][k], f_Hz))
        for of, u in (("magnitude", "u_model_magnitude"), ("phase_rad", "u_model_phase_rad")):
            if section[u][k] is not None:
                yield (f"{place}.model_{of}[{k}]", FACTOR * section[u][k],
                       capability.least(of, section[f"model_{of}"][k], f_Hz))
