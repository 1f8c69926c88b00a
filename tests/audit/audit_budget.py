# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What every budget must satisfy (GUM 5.1.2, G.4), and the budgets of f0 and damping."""

import numpy as np

from audit_report import SHARE, combined, coverage_factor, or_infinite, relative
from audit_sensitivity import CLOCK_RELATIVE

ROUNDING = 1e-12


def stated_values(results):
    """of -> (u, k, dof) of everything that has lines."""
    response = results["response"]
    values = {"sensitivity": tuple(results["sensitivity"][key] for key in ("u", "k", "dof"))}
    for one in results["characteristics"]:
        values[one["quantity"]] = one["u"], one["k"], one["dof"]
    for k in range(len(response["frequency_hz"])):
        values[f"response.magnitude[{k}]"] = (response["u_magnitude"][k], response["k_magnitude"][k],
                                              response["dof"][k])
        values[f"response.phase_rad[{k}]"] = response["u_phase_rad"][k], response["k_phase"][k], "not stated"
    return {of: value for of, value in values.items() if value[0] is not None}


def check_every_budget(report, results):
    """contribution = |c| u, shares of u^2 that add up to 100 %, u, its degrees of freedom and k."""
    groups = {}
    for line in results["budget"]:
        groups.setdefault(line["of"], []).append(line)
    values = stated_values(results)
    report.equal("values with a budget", sorted(groups), sorted(values))
    check_delay(report, results)
    rows = {"magnitude": [], "phase": []}
    for of, lines in groups.items():
        found = one_budget(lines, values[of])
        kind = next((kind for kind in rows if of.startswith(f"response.{kind}")), None)
        if kind:
            rows[kind].append(found)
        else:
            compare_budget(report, of, found)
    for kind, found in rows.items():
        for name, worst in zip(("contribution = |c| u", "shares", "sum of shares", "u", "dof", "k"),
                               np.max([[abs(s - r) / max(abs(r), 1e-300) for s, r in one] for one in found], axis=0)):
            report.compare(f"rows' {kind}: {name}, largest relative error", worst, 0.0, allowed_for(name))


def allowed_for(name):
    return {"k": 1e-6, "dof": 1e-6}.get(name, ROUNDING)  # Student's quantile is another's; dof a fourth power


def compare_budget(report, of, found):
    for name, (stated, recomputed) in zip(("contribution = |c| u", "shares", "sum of shares", "u", "dof", "k"), found):
        report.compare(f"{of}: {name}", stated, recomputed, relative(recomputed, allowed_for(name)))


def one_budget(lines, value):
    """Pairs of what is stated and what follows from the lines."""
    u, dof = combined([(line["contribution"], or_infinite(line["dof"])) for line in lines])
    product = max(lines, key=error_of_product)
    share = max(lines, key=lambda x: abs(100.0 * (x["contribution"] / u)**2 - x["share_percent"]))
    stated_dof = dof if value[2] == "not stated" else or_infinite(value[2])
    return [(abs(product["contribution"]), abs(product["sensitivity"]) * product["u"]),
            (share["share_percent"], 100.0 * (share["contribution"] / u)**2),
            (sum(line["share_percent"] for line in lines), 100.0),
            (value[0], u), finite_pair(stated_dof, dof), (value[1], coverage_factor(dof))]


def error_of_product(line):
    size = abs(line["sensitivity"]) * line["u"]
    return abs(abs(line["contribution"]) - size) / max(size, 1e-300)


def has_u_of_first_shot(line):
    """A delay is one for all shots, but its u is found in each; the one stated is the first shot's."""
    return line["quantity"].startswith("delay_s")


def check_delay(report, results):
    line = next(line for line in results["budget"] if line["of"] == "sensitivity" and has_u_of_first_shot(line))
    of_shots = [next(a for a in shock["arrivals"] if not a["dut"])["u_delay_s"] for shock in results["shock"]]
    report.compare("u of the delay: the first shot's (s)", line["u"], of_shots[0], relative(of_shots[0], ROUNDING))


def finite_pair(stated, recomputed):
    """Two infinite ones are equal."""
    return (1.0, 1.0) if np.isinf(stated) and np.isinf(recomputed) else (stated, recomputed)


def check_resonance_budget(report, results, fit):
    """f0, damping and Q: lines from the fit's own covariance and the clock."""
    f0, zeta, u_f, u_z = fit.resonance()
    expected = {"f0_hz": {"noise": u_f, "clock_relative": f0 * CLOCK_RELATIVE}, "damping_ratio": {"noise": u_z},
                "q": {"noise": 0.5 * u_z / zeta**2}}
    values = {one["quantity"]: one["value"] for one in results["characteristics"]}
    report.compare("f0 of the characteristics (Hz)", values["f0_hz"], f0, SHARE * u_f)
    report.compare("zeta of the characteristics", values["damping_ratio"], zeta, SHARE * u_z)
    report.compare("Q", values["q"], 0.5 / zeta, SHARE * 0.5 * u_z / zeta**2)
    for of, own in expected.items():
        lines = {line["quantity"]: line for line in results["budget"] if line["of"] == of}
        report.equal(f"lines of {of}", sorted(lines), sorted(own))
        for quantity, u in own.items():
            report.compare(f"{of}: {quantity}", lines[quantity]["contribution"], u, relative(u, SHARE))
        report.compare(f"{of}: dof of the noise", or_infinite(lines["noise"]["dof"]), fit.dof(), 0.0)
