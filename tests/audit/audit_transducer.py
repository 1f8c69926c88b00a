# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A reference transducer's records, and the pressure steps that it saw."""

import numpy as np

from audit_fit import Record
from audit_report import relative
from audit_sensitivity import CHAIN

U_GAIN = 0.005 / np.sqrt(3.0)  # of its chain, unless the recipe states it
ROLE = "reference"


class ReferenceRecord(Record):
    """Beside the DUT's record of one shot."""

    def __init__(self, shot, channel, window):
        """`window`: samples behind the start, of which the settled level takes 60 to 95 %."""
        super().__init__(channel, shot.stated["start_s"])
        self.shot = shot.number
        self.baseline = self.quiet.mean()
        self.settled = self.volts[self.first + settle_from(window):self.first + settle_to(window)]
        self.step = self.settled.mean() - self.baseline
        self.level_Hz = self.rate_Hz / window

    def u_step_relative(self):
        """Of white noise."""
        return self.noise_sd * np.sqrt(1.0 / len(self.settled) + 1.0 / len(self.quiet)) / abs(self.step)


def settle_from(window):
    return int(0.6 * window)


def settle_to(window):
    return int(0.95 * window)


def reference_channel(shot, name):
    """`name`: of the recipe; None: the one with the role."""
    return next(channel for n, channel in shot.channels.items()
                if (n == name if name else channel.attrs["role"] == ROLE))


def reference_records(shots, windows, name):
    return [ReferenceRecord(shot, reference_channel(shot, name), window) for shot, window in zip(shots, windows)]


class TransducerInputs:
    """One shot's level and what its step by the transducer rests on."""

    def __init__(self, fit, i, record, S_ref):
        self.shot = record.shot
        self.level = fit.amplitudes(i)[0]
        self.u_level_relative = fit.u_level_relative(i)
        self.lowest = S_ref.lowest()
        self.step_Pa = abs(record.step) / self.lowest.magnitude
        self.u_record = record.u_step_relative()
        self.u_lowest = np.hypot(self.lowest.u_relative(), S_ref.change_below(record.level_Hz) / self.lowest.magnitude)
        self.u_gain = U_GAIN

    def sensitivity(self):
        return self.level / self.step_Pa

    def step_lines(self):
        """As of ShotInputs: what makes the step larger makes the sensitivity smaller."""
        return {("reference_sensitivity_relative", False): (self.u_lowest, self.lowest.dof),
                ("reference_gain_relative", False): (self.u_gain, np.inf),
                ("reference_level_relative", True): (-self.u_record, np.inf)}


def common_of_rows(mean, lines, is_by_transducer):
    """What every row of S(f) shares, relative: of the step all but the levels' noise, of a transducer both gains."""
    if not is_by_transducer:
        return {place: c / mean for place, (c, _) in lines.items()
                if place[0] not in ("level_relative", "chain_relative")}
    shared = ("reference_gain_relative", *CHAIN)
    return {place: c / mean for place, (c, _) in lines.items() if place[0] in shared}


def u_common_of_model(mean, lines):
    """Of the model's curve, relative: all of the sensitivity but the noise of the DUT's levels."""
    return np.sqrt(sum((c / mean)**2 for place, (c, _) in lines.items()
                       if place[0] not in ("level_relative", "chain_relative")))


def check_settled(report, shots, windows):
    """The band of the settled level, by the DUT's own, which is stated."""
    for shot, window in zip(shots, windows):
        band = shot.volts[shot.first + settle_from(window):shot.first + settle_to(window)]
        step = band.mean() - shot.stated["baseline"]
        report.compare(f"shot {shot.number} settled level less baseline (V)", shot.stated["step"], step,
                       relative(step, 1e-9))
