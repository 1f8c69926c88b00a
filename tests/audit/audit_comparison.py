# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Section `comparison`: S(f) by the reference transducer, and its difference from that by the pressure step."""

import numpy as np

from audit_model import check_model_rows
from audit_report import relative
from audit_row import front_relative
from audit_rows import check_section
from audit_sensitivity import CHAIN, budget_of
from audit_transducer import common_of_rows, u_common_of_model

ROUNDING = 1e-9  # of a frequency that both have


def check_comparison(report, results, run):
    """Where the response itself is by the transducer, both sections hold the same numbers."""
    section, response = results["comparison"], results["response"]
    mean, lines = budget_of(run.by_transducer, run.chain_lowest())
    if response["source"] == "transducer":
        for key in response:
            report.equal(f"comparison.{key}, as of response", section[key] == response[key], True)
    else:
        common = common_of_rows(mean, lines, True)
        both = check_section(report, results, "comparison", run.transducer_rows, common)
        for name, rows in zip(("comparison", "comparison.marked"), both):
            check_model_rows(report, results, name, run.fit, mean, u_common_of_model(mean, lines), rows, run.chain)
    check_difference(report, section, run, own_of_ratio(section), run.common_of_step())


def own_of_ratio(section):
    """Per row: u of noise and bounds, absolute."""
    parts = [np.array([np.nan if value is None else value for value in section[key]])
             for key in ("u_noise_magnitude", "bound_end", "bound_alias")]
    return np.sqrt(parts[0]**2 + (parts[1]**2 + parts[2]**2) / 3.0)


def without_own_chain(common):
    """u of the step without the DUT's chain, which both ways have."""
    return np.sqrt(sum(c**2 for place, c in common.items() if place[0] not in CHAIN))


def u_of_both(run, f_Hz, u_step):
    """Of step and transducer, correlated, and of the front that the step alone has; relative."""
    rho = run.results["recipe"]["comparison"]["correlation_with_step"]
    u_ref = np.hypot(run.transducer_rows.S_ref.at(f_Hz).u_relative(), run.by_transducer[0].u_gain)
    return np.sqrt(u_step**2 + u_ref**2 - 2.0 * rho * u_step * u_ref + front_relative(f_Hz)**2)


def magnitudes_by_step(run, section):
    """At the rows of the section, and how well they are known: as stated; where the response is by the transducer,
    from the records."""
    response = run.results["response"]
    if response["source"] == "transducer":
        # The step's rows are as long as 20 periods or the span (docs/method/response.md), within the window.
        rows = run.step_rows
        length = [min(max(rows.span_s, 20.0 / f), rows.longest_s()) for f in section["frequency_hz"]]
        found = [rows.row(f, one, 0.0) for f, one in zip(section["frequency_hz"], length)]
        # Of noise that looks coloured the variance that is taken off may be estimated 30 % off.
        return (np.array([row.magnitude for row in found]),
                np.array([0.45 * row.shots * row.u_noise**2 / row.magnitude for row in found]))
    found = []
    for f in section["frequency_hz"]:
        same = [m for g, m in zip(response["frequency_hz"], response["magnitude"]) if abs(g / f - 1.0) < ROUNDING]
        found.append(np.nan if not same or same[0] is None else same[0])
    return np.array(found), np.zeros(len(found))


def check_difference(report, section, run, own, common_of_step):
    by_step, error = magnitudes_by_step(run, section)
    by_transducer = np.array([np.nan if m is None else m for m in section["magnitude"]])
    f = np.array(section["frequency_hz"])
    mean = 0.5 * (by_step + by_transducer)
    difference = (by_step - by_transducer) / mean
    u_step = without_own_chain(common_of_step)
    together = np.array([u_of_both(run, one, u_step) for one in f])
    u = np.hypot(own / mean, together)
    e_n, error = difference / (2.0 * u), error / mean / (2.0 * u)
    stated = np.array([np.nan if value is None else value for value in section["e_n_step"]])
    known = np.isfinite(stated)
    report.equal("rows compared with the step", list(np.flatnonzero(known)), list(np.flatnonzero(np.isfinite(e_n))))
    report.compare_all("E_n against the step", stated[known], e_n[known],
                       1e-3 * np.abs(e_n[known]) + 1e-6 + error[known])
    flat = known & (f <= run.flat_up_to_Hz())
    flat = flat if flat.any() else known
    mean_difference = difference[flat].mean()
    u = np.hypot(np.sqrt(np.sum((own / mean)[flat]**2)) / flat.sum(), together[flat].max())
    report.compare("difference from the step, relative", section["difference_relative"], mean_difference, 1e-4 * u)
    report.compare("u of the difference, relative", section["u_difference_relative"], u, 1e-3 * u)
    report.compare("E_n of the means", section["e_n_mean"], mean_difference / (2.0 * u),
                   relative(mean_difference / (2.0 * u), 1e-3) + 1e-4)
