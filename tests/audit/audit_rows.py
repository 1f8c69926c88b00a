# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""S(f) with its uncertainty, every row from the raw samples by the sum as it is written."""

import numpy as np

from audit_report import SHARE, combined, relative, table
from audit_transform import transform

FRONT_S = 100e-9  # the longest that nobody states
OF_NOISE = 1e-3  # of u of the noise, where the program takes the noise for white


class Row:
    """What one frequency should state."""

    def __init__(self, shots, windows, steps_Pa, onsets_s, u_onsets_s, f_Hz, length_s, span_s, near_rad):
        n = len(shots)
        one = [transform(shot, window, f_Hz, length_s, span_s, shot.stated["baseline"])
               for shot, window in zip(shots, windows)]
        scale = 1.0 / np.array(steps_Pa)
        S = scale * [t.S for t in one]
        variance = scale**2 * [t.variance for t in one]
        self.magnitude = np.mean(np.sqrt(np.maximum(0.0, np.abs(S)**2 - variance)))
        self.u_noise = np.sqrt(variance.sum()) / n
        self.exact_u_noise = np.sqrt(np.sum(scale**2 * [t.exact_variance for t in one])) / n
        self.dof = variance.sum()**2 / sum(v**2 / len(shot.quiet) for v, shot in zip(variance, shots))
        # The onset counts from the first sample of the sum.
        behind = np.array([onset - shot.time_s(shot.first - t.before) for onset, shot, t in zip(onsets_s, shots, one)])
        phases = np.angle(S) + 2.0 * np.pi * f_Hz * behind
        self.phase = near_rad + np.mean(np.mod(phases - near_rad + np.pi, 2.0 * np.pi) - np.pi)
        self.u_onset = 2.0 * np.pi * f_Hz * np.sqrt(np.sum(np.square(u_onsets_s))) / n
        changes = scale @ [t.changes for t in one] / n
        noise = 2.0 * scale**2 @ [t.of_changes for t in one] / n**2
        self.bound_end = 1.2 * np.sqrt(max(0.0, np.max(np.abs(changes)**2 - 6.25 * noise)))
        sinc = np.sinc(min(f_Hz * FRONT_S, 1.0))
        self.front = self.magnitude * (1.0 - sinc) / np.sqrt(5.0)

    def own_lines(self):
        """Quantity -> contribution to the magnitude, degrees of freedom. Bounds as stated: that of the end is
        compared by itself, because what is left of a change that is nearly noise hangs on the noise's estimate."""
        return {"noise": (self.u_noise, self.dof), "end_of_record": (self.stated_end / np.sqrt(3.0), np.inf),
                "aliasing": (self.stated_alias / np.sqrt(3.0), np.inf), "drift": (0.0, np.inf),
                "front_unknown": (self.front, np.inf)}

    def phase_lines(self):
        lines = {name: (u / self.magnitude, dof) for name, (u, dof) in self.own_lines().items()}
        del lines["front_unknown"]
        return {**lines, "onset_s": (self.u_onset, np.inf)}


def covariance(row, u_own, u_phase):
    """var Re, cov, var Im: an ellipse with these half axes along and across, turned by the phase."""
    half_axes = np.exp(1j * row.phase) * np.array([u_own, 1j * row.magnitude * u_phase])
    return [np.sum(half_axes.real**2), np.sum(half_axes.real * half_axes.imag), np.sum(half_axes.imag**2)]


def allowed_of_noise(row, stated_dof):
    """Relative, of its u. White noise too may look coloured by chance; then the program estimates its density
    at the frequency, which it says by fewer degrees of freedom, and such an estimate scatters by as many."""
    if stated_dof is None or stated_dof > 0.98 * row.dof:
        return OF_NOISE
    return 4.0 / np.sqrt(2.0 * stated_dof)


def rows_of(results, folder, shots, fit):
    """Index of each row that is stated, and what it should be."""
    response = results["response"]
    steps_Pa = [stated["step_pa"] for stated in results["shock"]]
    windows = [len(table(folder / f"response_shot_{s.number:03d}.csv")["value"]) for s in shots]
    span_s = results["input"]["offset_s"] + results["input"]["samples"] / results["input"]["sample_rate_hz"]
    onsets_s = [fit.onset_s(i) for i in range(len(shots))]
    u_onsets_s = [fit.u_onset_s(i) for i in range(len(shots))]
    dofs = {line["of"]: line["dof"] for line in results["budget"] if line["quantity"] == "noise"}
    rows = []
    for k, f_Hz in enumerate(response["frequency_hz"]):
        if response["magnitude"][k] is None:
            continue  # withheld
        row = Row(shots, windows, steps_Pa, onsets_s, u_onsets_s, f_Hz, response["length_s"][k], span_s,
                  response["model_phase_rad"][k])
        row.stated_end, row.stated_alias = response["bound_end"][k], response["bound_alias"][k]
        row.stated_dof = dofs.get(f"response.magnitude[{k}]")
        row.allowed = allowed_of_noise(row, row.stated_dof)
        rows.append((k, row))
    return rows


def check_rows(report, results, folder, shots, fit, common):
    response = results["response"]
    rows = rows_of(results, folder, shots, fit)

    def compare(name, key, expected, allowed):
        """The last two are functions of a row."""
        report.compare_all(name, [response[key][k] for k, _ in rows], [expected(row) for _, row in rows],
                           [allowed(row) for _, row in rows])

    for k, row in rows:
        # From a magnitude what noise adds to it is taken off, by a variance that is estimated.
        added = 0.5 * len(shots) * row.u_noise**2 / row.magnitude
        report.compare(f"magnitude at {response['frequency_hz'][k]:.4g} Hz", response["magnitude"][k], row.magnitude,
                       relative(row.magnitude, 1e-9) + 3.0 * row.allowed * added)
    compare("phase (rad)", "phase_rad", lambda row: row.phase, lambda row: 1e-9 + SHARE * row.u_onset)
    compare("u of the noise", "u_noise_magnitude", lambda row: row.u_noise, lambda row: row.allowed * row.u_noise)
    compare("u of noise and onset (rad)", "u_noise_phase_rad",
            lambda row: np.hypot(row.u_noise / row.magnitude, row.u_onset),
            lambda row: row.allowed * np.hypot(row.u_noise / row.magnitude, row.u_onset))
    # 6.25 times a change's variance, at most 2 u^2, is taken off its square: an error a of u leaves 5 sqrt(a) u.
    compare("bound of the end", "bound_end", lambda row: row.bound_end,
            lambda row: 0.02 * row.bound_end + 6.0 * np.sqrt(row.allowed) * row.u_noise)
    least = min(row.u_noise / row.exact_u_noise for _, row in rows)
    report.compare("u of the noise over that of all samples' parts", min(1.0, least), 1.0, OF_NOISE)
    excess = [max(0.0, row.stated_dof / row.dof - 1.0) for _, row in rows if row.stated_dof]
    report.compare("dof of the noise, more than all samples have", max(excess, default=0.0), 0.0, 1e-3)
    check_uncertainties(report, results, rows, common)


def check_uncertainties(report, results, rows, common):
    """k and the degrees of freedom of the whole: check_every_budget."""
    response, u_common = results["response"], np.sqrt(sum(c**2 for c in common.values()))
    report.compare("u that all rows share, relative", response["u_common_relative"], u_common, 2e-4 * u_common)
    u_all, u_phases, ellipses = [], [], []
    for k, row in rows:
        own = list(row.own_lines().values())
        u_all.append(combined(own + [(c * row.magnitude, np.inf) for c in common.values()])[0])
        u_phases.append(combined(row.phase_lines().values())[0])
        ellipses.append(covariance(row, combined(own)[0], u_phases[-1]))
    allowed = np.array([row.allowed for _, row in rows])
    of_noise = np.array([row.u_noise for _, row in rows]) / u_all  # its share of u decides what is allowed
    for key, expected, share in (("u_magnitude", u_all, 2e-4 + allowed * of_noise**2),
                                 ("u_phase_rad", u_phases, allowed)):
        report.compare_all(key, [response[key][k] for k, _ in rows], expected, share * np.array(expected))
    sizes = np.array([one[0] + one[2] for one in ellipses])
    for j, name in enumerate(("var Re", "cov(Re, Im)", "var Im")):
        report.compare_all(name, [response["covariance_re_im"][k][j] for k, _ in rows], [one[j] for one in ellipses],
                           3.0 * allowed * sizes)
    for k, row in (rows[0], rows[len(rows) // 2], rows[-1]):
        check_row_lines(report, results, k, row, common)


def check_row_lines(report, results, k, row, common):
    """All lines of one row's magnitude and phase."""
    expected = {(name, None): u for name, (u, _) in row.own_lines().items()}
    expected.update({place: c * row.magnitude for place, c in common.items()})
    phase = {(name, None): u for name, (u, _) in row.phase_lines().items()}
    for of, lines in ((f"response.magnitude[{k}]", expected), (f"response.phase_rad[{k}]", phase)):
        stated = {(line["quantity"], line["shot"]): line for line in results["budget"] if line["of"] == of}
        report.equal(f"lines of {of}", sorted(map(str, stated)), sorted(map(str, lines)))
        for place, line in stated.items():
            value = lines.get(place, np.nan)
            name = f"{of}: {place[0]}" + (f", shot {place[1]}" if place[1] else "")
            share = row.allowed if place[0] == "noise" else 2e-3
            report.compare(name, line["contribution"], value, relative(value, share) + 1e-18)


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
