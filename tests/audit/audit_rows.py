# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""S(f) with its uncertainty, every row from the raw samples by the sum as it is written."""

import numpy as np

from audit_capability import Capability, held, with_line
from audit_report import SHARE, check_lines, combined, or_infinite, relative, table

OF_NOISE = 1e-3  # of u of the noise, where the program takes the noise for white


def allowed_of_noise(row, stated_dof):
    """Relative, of its u. White noise too may look coloured by chance; then the program estimates its density
    at the frequency, which it says by fewer degrees of freedom, and such an estimate scatters by as many."""
    if stated_dof is None or stated_dof > 0.98 * row.dof:
        return OF_NOISE
    return 4.0 / np.sqrt(2.0 * stated_dof)


def rows_of(report, section, maker):
    """Index of each row of a section that is stated, and what it should be."""
    rows = []
    for k, f_Hz in enumerate(section["frequency_hz"]):
        if section["magnitude"][k] is None:
            continue  # withheld
        row = maker.row(f_Hz, section["length_s"][k], section["model_phase_rad"][k])
        if row is None:
            report.equal(f"stated at {f_Hz:.6g} Hz, outside of a table", section["magnitude"][k], None)
            continue
        row.stated_end, row.stated_alias = section["bound_end"][k], section["bound_alias"][k]
        rows.append((k, row))
    return rows


def set_dofs(rows, dofs):
    """Degrees of freedom of the rows' noise, as the program has them."""
    for (_, row), dof in zip(rows, dofs):
        row.stated_dof = dof
        row.allowed = allowed_of_noise(row, dof)


def dofs_of_budget(results, place, rows):
    dofs = {line["of"]: line["dof"] for line in results["budget"] if line["quantity"] == "noise"}
    return [dofs.get(f"{place}.magnitude[{k}]") for k, _ in rows]


def shares_of_whole(section, rows):
    """The noise's degrees of freedom over those of all samples; not a number where other parts decide those of the
    whole row."""
    shares = []
    for k, row in rows:
        whole = section["u_magnitude"][k]**4 / or_infinite(section["dof"][k])
        noise = whole - sum(u**4 / dof for u, dof in row.lines.values())
        shares.append(section["u_noise_magnitude"][k]**4 / noise / row.dof if noise > 0.5 * whole > 0.0 else np.nan)
    return shares


def dofs_of_whole(section, rows):
    """Where no budget states them: from those of the whole row, the median over five rows, so that no single number
    that is off changes what is allowed."""
    shares = shares_of_whole(section, rows)
    medians = [np.nanmedian(near) if np.isfinite(near).sum() > 2 else 1.0
               for near in (shares[max(i - 2, 0):i + 3] for i in range(len(shares)))]
    return [row.dof * (share if share < 0.98 else 1.0) for (_, row), share in zip(rows, medians)]


def dofs_like(section, rows, others):
    """Of the nearest of the others; the row's own where they are much fewer, or where that one's look coloured."""
    dofs = []
    for (_, row), own in zip(rows, shares_of_whole(section, rows)):
        near = min((other for _, other in others), key=lambda other: abs(np.log(other.f_Hz / row.f_Hz)))
        share = near.stated_dof / near.dof if near.stated_dof else 1.0
        dofs.append(row.dof * (np.fmin(share, own) if share < 0.98 or own < 0.9 else 1.0))
    return dofs


def check_section(report, results, name, maker, common, budget=None):
    """Rows of results[name], and those at the marked frequencies. `common`: relative contributions that all rows
    share; `budget`: what it calls the rows, where it has them. Returns both lists."""
    section = results[name]
    rows, marked = rows_of(report, section, maker), rows_of(report, section["marked"], maker)
    set_dofs(rows, dofs_of_budget(results, budget, rows) if budget else dofs_of_whole(section, rows))
    set_dofs(marked, dofs_like(section["marked"], marked, rows))
    for title, at, found in ((name, section, rows), (f"{name}.marked", section["marked"], marked)):
        report.equal(f"{title}: has phases", any(at["phase_rad"][k] is not None for k, _ in found), maker.has_phase)
        check_values(report, at, title, found)
        check_noise(report, title, found)
        check_uncertainties(report, at, title, found, common, Capability(results))
    if budget:
        for k, row in (rows[0], rows[len(rows) // 2], rows[-1]):
            check_row_lines(report, results, budget, k, row, common, maker.has_phase)
    return rows, marked


def check_noise(report, title, rows):
    least = min(row.u_noise / row.exact_u_noise for _, row in rows)
    report.compare(f"{title}: u of the noise over that of all samples", min(1.0, least), 1.0, OF_NOISE)
    excess = [max(0.0, row.stated_dof / row.dof - 1.0) for _, row in rows if row.stated_dof]
    report.compare(f"{title}: dof of the noise, more than samples have", max(excess, default=0.0), 0.0, 1e-3)


def check_values(report, section, title, rows):
    def compare(name, key, expected, allowed):
        """The last two are functions of a row."""
        stated = [(section[key][k], row) for k, row in rows if section[key][k] is not None]
        if stated:
            report.compare_all(f"{title}: {name}", [value for value, _ in stated], [expected(row) for _, row in stated],
                               [allowed(row) for _, row in stated])

    # From a magnitude what noise adds to it is taken off, by a variance that is estimated.
    compare("magnitude", "magnitude", lambda row: row.magnitude,
            lambda row: relative(row.magnitude, 1e-9)
            + 1.5 * row.shots * row.allowed * row.u_noise**2 / row.magnitude)
    compare("phase (rad)", "phase_rad", lambda row: row.phase, lambda row: 1e-9 + SHARE * row.u_of_fit)
    compare("u of the noise", "u_noise_magnitude", lambda row: row.u_noise, lambda row: row.allowed * row.u_noise)
    compare("u of noise and timing (rad)", "u_noise_phase_rad", u_of_noise_phase,
            lambda row: row.allowed * u_of_noise_phase(row))
    # 6.25 times a change's variance, at most 2 u^2, is taken off its square: an error a of u leaves 5 sqrt(a) u.
    compare("bound of the end", "bound_end", lambda row: row.bound_end,
            lambda row: 0.02 * row.bound_end + 6.0 * np.sqrt(row.allowed) * row.u_noise)


def u_of_noise_phase(row):
    return np.hypot(row.u_noise / row.magnitude, row.timing[1])


def check_uncertainties(report, section, title, rows, common, capability):
    """u, degrees of freedom and k of the whole, and the row's own covariance."""
    u_common = np.sqrt(sum(c**2 for c in common.values()))
    report.compare(f"{title}: u that all rows share, relative", section["u_common_relative"], u_common, 2e-4 * u_common)
    columns = {key: [] for key in ("u_magnitude", "dof", "k_magnitude", "u_phase_rad", "k_phase")}
    allowed = np.array([row.allowed for _, row in rows])
    shares = []
    for k, row in rows:
        own = combined(list(row.own_lines().values()) + [(c * row.magnitude, np.inf) for c in common.values()])
        shares.append((row.u_noise / own[0])**2)
        all_of = held(*own, capability.least("magnitude", row.magnitude, row.f_Hz))
        of_phase = held(*combined(row.phase_lines().values()), capability.least("phase_rad", 1.0, row.f_Hz))
        for key, value in zip(columns, (*all_of, of_phase[0], of_phase[2])):
            columns[key].append(value)
    # The noise's share of u decides what is allowed; degrees of freedom go with the fourth power.
    of_dof = np.where(allowed > OF_NOISE, np.inf, 0.01)  # what the octaves leave is not recomputed
    tolerance = {"u_magnitude": 2e-4 + allowed * shares, "u_phase_rad": allowed, "dof": of_dof,
                 "k_magnitude": 1e-5 + allowed, "k_phase": 1e-5 + allowed}
    for key, expected in columns.items():
        stated = [(or_infinite(section[key][k]), e, t) for (k, _), e, t in zip(rows, expected, tolerance[key])
                  if section[key][k] is not None or key == "dof"]
        if stated:
            values, expected, share = (np.array(column, float) for column in zip(*stated))
            report.compare_all(f"{title}: {key}", values, expected,
                               [t if np.isinf(t) else 0.0 if np.isinf(e) else t * abs(e)
                                for e, t in zip(expected, share)])
    check_covariance(report, section, title, rows, allowed)


def check_covariance(report, section, title, rows, allowed):
    stated = [(section["covariance_re_im"][k], row.covariance(), share) for (k, row), share in zip(rows, allowed)
              if section["covariance_re_im"][k][0] is not None]
    for j, name in enumerate(("var Re", "cov(Re, Im)", "var Im")):
        if stated:
            report.compare_all(f"{title}: {name}", [value[j] for value, _, _ in stated],
                               [one[j] for _, one, _ in stated],
                               [3.0 * share * (one[0] + one[2]) for _, one, share in stated])


def check_row_lines(report, results, place, k, row, common, has_phase):
    """All lines of one row's magnitude and phase."""
    capability = Capability(results)
    own = {(name, None): line for name, line in row.own_lines().items()}
    own.update({one: (c * row.magnitude, np.inf) for one, c in common.items()})
    phase = row.phase_lines() if has_phase else {}
    for of, lines, value in (("magnitude", own, row.magnitude), ("phase_rad", phase, 1.0)):
        check_lines(report, f"{place}.{of}[{k}]", results["budget"],
                    with_line(lines, capability.least(of, value, row.f_Hz)),
                    lambda quantity: row.allowed if quantity == "noise" else 2e-3)


COLUMNS = {"var_re": ("covariance_re_im", 0), "cov_re_im": ("covariance_re_im", 1), "var_im": ("covariance_re_im", 2)}


def check_csv(report, results, folder):
    """The tables hold the same numbers as results.json, to the last digit."""
    response = results["response"]
    for name, column in table(folder / "frequency_response.csv").items():
        key, part = COLUMNS.get(name, (name, None))
        values = response[key] if part is None else [one[part] for one in response[key]]
        values = np.array([np.nan if value is None else value for value in values])
        report.compare_all(f"frequency_response.csv: {name}", np.nan_to_num(column, nan=-1.0),
                           np.nan_to_num(values, nan=-1.0), 0.0)
    poles = results["model"]["poles"]
    columns = table(folder / "poles.csv")
    for name in ("frequency_hz", "damping_ratio", "amplitude"):
        report.compare_all(f"poles.csv: {name}", columns[name], [pole[name] for pole in poles], 0.0)
