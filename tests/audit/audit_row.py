# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What one frequency of S(f) should state: by the pressure step or by a reference transducer, without the chain."""

from functools import cached_property

import numpy as np

from audit_report import combined
from audit_transform import transform

FRONT_S = 100e-9  # the longest that nobody states


def front_relative(f_Hz):
    """Missing for a front that nobody stated, as u."""
    return (1.0 / np.sinc(min(f_Hz * FRONT_S, 0.9)) - 1.0) / np.sqrt(5.0)


class Row:
    """Of the shots' S, their variances, what the cuts change and the variances of that; `known` is what H or S_ref
    multiplies all of it by."""

    def __init__(self, f_Hz, S, variance, exact_variance, changes, of_changes, dofs):
        n = len(S)
        self.f_Hz = f_Hz
        self.shots = n
        self.magnitude = np.mean(np.sqrt(np.maximum(0.0, np.abs(S)**2 - variance)))
        self.u_noise = np.sqrt(variance.sum()) / n
        self.exact_u_noise = np.sqrt(exact_variance.sum()) / n
        self.dof = variance.sum()**2 / np.sum(variance**2 / dofs)
        noise = 2.0 * of_changes.sum(axis=0) / n**2
        self.bound_end = 1.2 * np.sqrt(max(0.0, np.max(np.abs(changes.sum(axis=0) / n)**2 - 6.25 * noise)))
        self.lines, self.of_phase = {}, {}  # beside noise, bounds and drift: name -> (u, dof)
        self.u_of_fit = 0.0  # what of the phase's u is that of a fitted onset

    def set_phase(self, phases, near_rad):
        """Mean over the shots, about what they have in common; whole turns as `near_rad`."""
        middle = np.angle(np.exp(1j * phases).sum())
        mean = middle + np.mean(np.angle(np.exp(1j * (phases - middle))))
        near_rad = np.nan if near_rad is None else near_rad  # of a chain without phases there are none
        self.phase = near_rad + np.mod(mean - near_rad + np.pi, 2.0 * np.pi) - np.pi

    def multiply(self, known):
        for name in ("magnitude", "u_noise", "exact_u_noise", "bound_end"):
            setattr(self, name, getattr(self, name) * known)
        self.lines = {name: (u * known, dof) for name, (u, dof) in self.lines.items()}

    def without_chain(self, H, u_delay_s):
        """S/H; `u_delay_s` is what the onset may hold of the chain's delay."""
        self.multiply(1.0 / H.magnitude)
        self.lines["chain"] = self.magnitude * H.u_relative(), H.dof
        self.timing = self.timing[0], np.hypot(self.timing[1], 2.0 * np.pi * self.f_Hz * u_delay_s)
        if H.phase_rad is not None:
            self.of_phase["chain_phase"] = H.u_phase_rad, H.dof

    def own_lines(self):
        """Quantity -> contribution to the magnitude, degrees of freedom. Bounds as stated: that of the end is
        compared by itself, because what is left of a change that is nearly noise hangs on the noise's estimate."""
        return {"noise": (self.u_noise, self.stated_dof or self.dof),
                "end_of_record": (self.stated_end / np.sqrt(3.0), np.inf),
                "aliasing": (self.stated_alias / np.sqrt(3.0), np.inf), "drift": (0.0, np.inf), **self.lines}

    def phase_lines(self):
        own = {name: (u / self.magnitude, dof) for name, (u, dof) in self.own_lines().items() if name not in self.lines}
        return {**own, self.timing[0]: (self.timing[1], np.inf), **self.of_phase}

    def u_phase(self):
        return combined(self.phase_lines().values())[0]

    def covariance(self):
        """var Re, cov, var Im: an ellipse with these half axes along and across, turned by the phase."""
        u_own = combined(self.own_lines().values())[0]
        half_axes = np.exp(1j * self.phase) * np.array([u_own, 1j * self.magnitude * self.u_phase()])
        return [np.sum(half_axes.real**2), np.sum(half_axes.real * half_axes.imag), np.sum(half_axes.imag**2)]


class RowMaker:
    """What the rows of a run have in common. `chain`: a KnownTable or None."""

    def __init__(self, results, windows, shots, fit, chain):
        at = results["input"]
        self.shots, self.windows, self.chain = shots, windows, chain
        self.has_phase = chain is None or chain.has_phase
        self.span_s = at["offset_s"] + at["samples"] / at["sample_rate_hz"]
        self.onsets_s = np.array([fit.onset_s(i) for i in range(len(shots))])
        self.u_onset_s = np.sqrt(sum(fit.u_onset_s(i)**2 for i in range(len(shots)))) / len(shots)

    def transforms(self, f_Hz, length_s, records, baselines):
        return [transform(record, window, f_Hz, length_s, self.span_s, baseline)
                for record, window, baseline in zip(records, self.windows, baselines)]

    def of_dut(self, f_Hz, length_s):
        return self.transforms(f_Hz, length_s, self.shots, [shot.stated["baseline"] for shot in self.shots])

    def longest_s(self):
        return max(window / shot.rate_Hz for window, shot in zip(self.windows, self.shots))

    def divided(self, row, near_rad, phases, u_delay_s):
        """With the phase, and without the chain; None outside of its table."""
        H = self.chain and self.chain.at(row.f_Hz)
        if self.chain and not H:
            return None
        row.set_phase(phases - (H.phase_rad if H and H.phase_rad is not None else 0.0), near_rad)
        if H:
            row.without_chain(H, u_delay_s)
        return row


class StepRows(RowMaker):
    """By the pressure step: S = D k."""

    def __init__(self, results, windows, shots, fit, chain):
        super().__init__(results, windows, shots, fit, chain)
        self.scale = 1.0 / np.array([stated["step_pa"] for stated in results["shock"]])
        self.low_Hz = results["response"]["f_low_hz"]

    def row(self, f_Hz, length_s, near_rad):
        one = self.of_dut(f_Hz, length_s)
        S, square = self.scale * [t.S for t in one], self.scale**2
        row = Row(f_Hz, S, square * [t.variance for t in one], square * [t.exact_variance for t in one],
                  self.scale[:, None] * [t.changes for t in one], square[:, None] * [t.of_changes for t in one],
                  np.array([len(shot.quiet) for shot in self.shots]))
        row.lines["front_unknown"] = row.magnitude * front_relative(f_Hz), np.inf
        row.u_of_fit = 2.0 * np.pi * f_Hz * self.u_onset_s
        row.timing = "onset_s", row.u_of_fit
        # The onset counts from the first sample of the sum.
        behind = self.onsets_s - [shot.time_s(shot.first - t.before) for shot, t in zip(self.shots, one)]
        return self.divided(row, near_rad, np.angle(S) + 2.0 * np.pi * f_Hz * behind, self.u_delay_s)

    @cached_property
    def u_delay_s(self):
        """What a model takes of the chain's delay for a later onset: any part of it, in the band of records and
        table."""
        if not self.chain or not self.chain.has_phase:
            return 0.0
        top_Hz = min(0.4 * min(shot.rate_Hz for shot in self.shots), self.chain.frequency_Hz[-1])
        f = np.geomspace(max(self.low_Hz, self.chain.frequency_Hz[0]), top_Hz, 400)
        return max(abs(self.chain.at(x).phase_rad) / (2.0 * np.pi * x) for x in f) / np.sqrt(3.0)


class TransducerRows(RowMaker):
    """By a reference transducer: S = S_ref D_dut / D_ref. `records` are its, `S_ref` what is known of it."""

    def __init__(self, results, windows, shots, fit, chain, records, S_ref):
        super().__init__(results, windows, shots, fit, chain)
        self.records, self.S_ref = records, S_ref
        self.has_phase = self.has_phase and S_ref.has_phase
        settings = results["recipe"]["comparison"]
        self.delay_s = settings["delay_s"]
        stated = settings["u_delay_s"]
        self.u_delay_s = 0.5e-6 / np.sqrt(3.0) if stated is None else stated

    def row(self, f_Hz, length_s, near_rad):
        S_ref = self.S_ref.at(f_Hz)
        if not S_ref:
            return None
        dut = self.of_dut(f_Hz, length_s)
        ref = self.transforms(f_Hz, length_s, self.records, [record.baseline for record in self.records])
        ratios = [Ratio(a, b) for a, b in zip(dut, ref)]
        row = Row(f_Hz, *(np.array([getattr(ratio, name) for ratio in ratios])
                          for name in ("S", "variance", "exact_variance", "changes", "of_changes")),
                  np.array([ratio.dof(len(a.quiet), len(b.quiet))
                            for ratio, a, b in zip(ratios, self.shots, self.records)]))
        row.multiply(S_ref.magnitude)
        row.lines["reference_sensitivity"] = row.magnitude * S_ref.u_relative(), S_ref.dof
        row.timing = "delay_of_reference", 2.0 * np.pi * f_Hz * self.u_delay_s
        if S_ref.phase_rad is not None:
            row.of_phase["reference_phase"] = S_ref.u_phase_rad, S_ref.dof
        # Each sum counts from its own first sample; what reaches the reference later is early in the ratio.
        later_s = np.array([b.time_s(b.first - t.before) - a.time_s(a.first - s.before)
                            for a, b, s, t in zip(self.shots, self.records, dut, ref)])
        phases = (np.angle([ratio.S for ratio in ratios]) + (S_ref.phase_rad or 0.0)
                  + 2.0 * np.pi * f_Hz * (later_s - self.delay_s))
        return self.divided(row, near_rad, phases, 0.0)


class Ratio:
    """Of the transforms of one shot's two records; relative variances add."""

    def __init__(self, dut, ref):
        self.parts = dut.variance / abs(dut.S)**2, ref.variance / abs(ref.S)**2
        self.S = dut.S / ref.S
        square = abs(self.S)**2
        self.variance = square * sum(self.parts)
        self.exact_variance = square * (dut.exact_variance / abs(dut.S)**2 + ref.exact_variance / abs(ref.S)**2)
        self.changes = abs(self.S) * (dut.changes / abs(dut.S) - ref.changes / abs(ref.S))
        self.of_changes = square * (dut.of_changes / abs(dut.S)**2 + ref.of_changes / abs(ref.S)**2)

    def dof(self, of_dut, of_ref):
        return sum(self.parts)**2 / (self.parts[0]**2 / of_dut + self.parts[1]**2 / of_ref)
