# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What every budget must satisfy (GUM 5.1.2, G.4), and the budgets of f0 and damping."""

import numpy as np

from audit_capability import Capability, factor, with_line
from audit_report import SHARE, combined, coverage_factor, or_infinite, relative
from audit_sensitivity import CLOCK_RELATIVE

ROUNDING = 1e-12


def stated_values(results):
    """of -> (u, k, dof) of everything that has lines."""
    response, mean = results["response"], results["sensitivity"] or {}
    values = {"sensitivity": tuple(mean.get(key) for key in ("u", "k", "dof"))}
    for one in results["characteristics"]:
        values[one["quantity"]] = one["u"], one["k"], one["dof"]
    for i, one in enumerate(mean.get("per_level") or []):
        values[f"sensitivity.per_level[{i}]"] = one["u"], one["k"], one["dof"]
    for i, one in enumerate(results["shots"] or []):
        values[f"shots[{i}].sensitivity"] = one.get("u_sensitivity"), one.get("k_sensitivity"), "not stated"
    for i, one in enumerate((results["model"] or {}).get("poles") or []):
        if one["im"] >= 0.0:  # a pair has one amplitude
            values[f"model.poles[{i}].amplitude"] = one["u_amplitude"], one["k_amplitude"], "not stated"
    values |= row_values("response", response) | row_values("response.marked", response.get("marked"))
    comparison = results.get("comparison")
    if comparison and response["source"] != "transducer":
        values |= row_values("comparison", comparison) | row_values("comparison.marked", comparison.get("marked"))
    return {of: value for of, value in values.items() if value[0] is not None}


def row_values(of, rows):
    values = {}
    for k in range(len((rows or {}).get("u_magnitude") or [])):
        values[f"{of}.magnitude[{k}]"] = rows["u_magnitude"][k], rows["k_magnitude"][k], rows["dof"][k]
        values[f"{of}.phase_rad[{k}]"] = rows["u_phase_rad"][k], rows["k_phase"][k], "not stated"
    return values


def lines_by_value(results):
    groups = {}
    for line in results["budget"]:
        groups.setdefault(line["of"], []).append(line)
    return groups


def check_every_budget(report, results):
    """contribution = |c| u, shares of u^2 that add up to 100 %, u, its degrees of freedom and k."""
    groups, values = lines_by_value(results), stated_values(results)
    report.equal("values with a budget", sorted(groups), sorted(values))
    rows = {"magnitude": [], "phase": []}
    for of, lines in groups.items():
        found = one_budget(lines, values[of])
        kind = next((kind for kind in rows if f".{kind}" in of), None)
        if kind:
            rows[kind].append(found)
        else:
            compare_budget(report, of, found)
    for kind, found in rows.items():
        for name, worst in zip(PARTS, np.max([[abs(s - r) / max(abs(r), 1e-300) for s, r in one] for one in found],
                                             axis=0) if found else ()):
            report.compare(f"rows' {kind}: {name}, largest relative error", worst, 0.0, allowed_for(name))
    check_steps(report, results)


def check_steps(report, results):
    """Pressure step and velocity of each shot have lines of their own."""
    for shot in results["shock"] or []:
        for of, u in (("step", "u_step_pa"), ("velocity", "u_velocity_m_s")):
            if shot.get(u) is None or not shot[f"{of}_budget"]:
                continue
            value = shot[u], shot[f"{of}_k"], shot[f"{of}_dof"]
            compare_budget(report, f"{of} of shot {shot['shot']}", one_budget(shot[f"{of}_budget"], value))


def check_sources(report, results):
    """No value lacks what every value of its kind has (docs/method/uncertainty.md)."""
    is_by_transducer = results["response"]["source"] == "transducer"
    chain = {"chain"} if results["chain"] else set()
    row = {"noise", "end_of_record", "aliasing", "drift"} | chain
    row |= {"reference_sensitivity"} if is_by_transducer else set()
    chain_of_level = {"gain_relative", "linearity_relative", "mounting_relative"}
    own = {"sensitivity": chain_of_level, "sensitivity.per_level": chain_of_level, "shots": chain_of_level,
           "response.magnitude": row, "response.marked.magnitude": row,
           "response.phase_rad": {"noise", "end_of_record", "aliasing", "drift",
                                  "delay_of_reference" if is_by_transducer else "onset_s"}}
    for of, lines in lines_by_value(results).items():
        needed = own.get(of.split("[")[0], {"noise"})
        if of.endswith(("_hz", "_s")):
            needed = needed | {"clock_relative"}
        missing = needed - {line["quantity"] for line in lines}
        if missing:
            report.equal(f"lines of {of} that are missing", sorted(missing), [])
    report.equal("values with their lines", len(lines_by_value(results)) > 0, True)


PARTS = ("contribution = |c| u", "shares", "sum of shares", "u", "dof", "k")


def allowed_for(name):
    return {"k": 1e-6, "dof": 1e-6}.get(name, ROUNDING)  # Student's quantile is another's; dof a fourth power


def compare_budget(report, of, found):
    for name, (stated, recomputed) in zip(PARTS, found):
        report.compare(f"{of}: {name}", stated, recomputed, relative(recomputed, allowed_for(name)))


def one_budget(lines, value):
    """Pairs of what is stated and what follows from the lines."""
    u, dof = combined([(line["contribution"], or_infinite(line["dof"])) for line in lines])
    # Of a value that a CMC holds up, k u is the CMC, whoever multiplies.
    k = factor(dof) if any(line["quantity"] == "cmc" for line in lines) else coverage_factor(dof)
    product = max(lines, key=error_of_product)
    share = max(lines, key=lambda x: abs(100.0 * (x["contribution"] / u)**2 - x["share_percent"]))
    stated_dof = dof if value[2] == "not stated" else or_infinite(value[2])
    return [(abs(product["contribution"]), abs(product["sensitivity"]) * product["u"]),
            (share["share_percent"], 100.0 * (share["contribution"] / u)**2),
            (sum(line["share_percent"] for line in lines), 100.0),
            (value[0], u), finite_pair(stated_dof, dof), (value[1], k)]


def error_of_product(line):
    size = abs(line["sensitivity"]) * line["u"]
    return abs(abs(line["contribution"]) - size) / max(size, 1e-300)


def has_u_of_first_shot(line):
    """A delay is one for all shots, but its u is found in each; the one stated is the first shot's."""
    return line["quantity"].startswith("delay_s")


def check_delay(report, results):
    """Of a sensitivity by the step."""
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
    capability = Capability(results)
    report.compare("f0 of the characteristics (Hz)", values["f0_hz"], f0, SHARE * u_f)
    report.compare("zeta of the characteristics", values["damping_ratio"], zeta, SHARE * u_z)
    report.compare("Q", values["q"], 0.5 / zeta, SHARE * 0.5 * u_z / zeta**2)
    for of, own in expected.items():
        lines = {line["quantity"]: line for line in results["budget"] if line["of"] == of}
        of_lines = {name: (u, fit.dof() if name == "noise" else np.inf) for name, u in own.items()}
        of_lines = with_line(of_lines, capability.least(of, values[of]))
        report.equal(f"lines of {of}", sorted(lines), sorted(of_lines))
        for quantity in lines:
            u = of_lines.get(quantity, (np.nan, 0.0))[0]
            report.compare(f"{of}: {quantity}", lines[quantity]["contribution"], u, relative(u, SHARE))
        report.compare(f"{of}: dof of the noise", or_infinite(lines["noise"]["dof"]), fit.dof(), 0.0)
