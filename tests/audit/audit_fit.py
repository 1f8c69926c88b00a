# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Raw samples of the shots, and the joint least squares of one damped oscillation."""

import numpy as np
from scipy import optimize


class Record:
    """Raw samples of a channel, from whose sample nearest to `start_s` its response counts."""

    def __init__(self, channel, start_s):
        self.rate_Hz = float(channel.attrs["sample_rate_Hz"])
        self.t0_s = float(channel.attrs["t0_s"])
        self.volts = channel[:] * float(channel.attrs["scale"]) + float(channel.attrs["offset"])
        self.first = round((start_s - self.t0_s) * self.rate_Hz)
        # The baseline's samples end a guard before the start (docs/method/window.md).
        guard = min(max(self.first // 20, 5), 1000)
        self.quiet = self.volts[max(0, self.first - guard - 20000):self.first - guard]
        i = np.arange(len(self.quiet))
        rest = self.quiet - np.polyval(np.polyfit(i, self.quiet, 1), i)
        self.noise_sd = np.sqrt(rest @ rest / (len(rest) - 2))

    def time_s(self, sample):
        return self.t0_s + sample / self.rate_Hz


class Shot(Record):
    """The DUT's record and the circumstances of one shot."""

    def __init__(self, group, stated):
        self.stated = stated
        self.number = stated["shot"]
        self.environment = dict(group["environment"].attrs)
        self.channels = group["channels"]
        super().__init__(self.channels["DUT"], stated["start_s"])


def columns(rate, t, has_level=True):
    """Real columns of c0 + Re and Im of e^(s t)."""
    e = np.exp(rate * t)
    return np.column_stack([np.ones_like(t)] * has_level + [e.real, -e.imag])


class JointFit:
    """One damped oscillation shared by all shots; level and amplitudes of each its own."""

    def __init__(self, shots, seconds, has_level=True):
        """`seconds`: from the start to the last sample, which takes part; the first does not, because the
        start was found by it. Without a level: a free decay."""
        self.shots, self.has_level = shots, has_level
        self.own = 3 if has_level else 2  # parameters of a shot alone
        self.count = [round(seconds * shot.rate_Hz) for shot in shots]
        self.y = [shot.volts[shot.first + 1:shot.first + 1 + n] - shot.stated["baseline"]
                  for shot, n in zip(shots, self.count)]
        self.t = [np.arange(1, n + 1) / shot.rate_Hz for shot, n in zip(shots, self.count)]
        self.noise = [shot.stated["noise_sd"] for shot in shots]  # see check_levels
        self.rate = self._solve(self._start())
        self._amplitudes = [self._solve_amplitudes(i) for i in range(len(shots))]
        self._covariance = None

    def _start(self):
        """The highest line of the ringing's spectrum and a damping of two per cent."""
        y, t = self.y[0], self.t[0]
        ringing = y - y[len(y) // 2:].mean()
        power = np.abs(np.fft.rfft(ringing, 8 * len(ringing)))
        omega = 2.0 * np.pi * np.fft.rfftfreq(8 * len(ringing), t[0])[power.argmax()]
        return complex(-0.02 * omega, omega)

    def _residual(self, x):
        s = complex(x[0], x[1]) * self.unit
        parts = []
        for y, t, noise in zip(self.y, self.t, self.noise):
            C = columns(s, t, self.has_level)
            parts.append((y - C @ np.linalg.lstsq(C, y, rcond=None)[0]) / noise)
        return np.concatenate(parts)

    def _solve(self, start):
        self.unit = abs(start)
        x = optimize.least_squares(self._residual, [start.real / self.unit, start.imag / self.unit],
                                   xtol=1e-14, ftol=1e-14, gtol=1e-14).x
        return complex(x[0], x[1]) * self.unit

    def amplitudes(self, i):
        return self._amplitudes[i]

    def _solve_amplitudes(self, i):
        return np.linalg.lstsq(columns(self.rate, self.t[i], self.has_level), self.y[i], rcond=None)[0]

    def covariance(self):
        if self._covariance is None:
            self._covariance = self._solve_covariance()
        return self._covariance

    def _solve_covariance(self):
        """(J^T J)^-1 of Re s, Im s, then per shot level, Re and Im of the amplitude; larger where the
        residual is larger than the noise."""
        n, own = 2 + self.own * len(self.shots), self.own
        information = np.zeros((n, n))
        for i, (t, noise) in enumerate(zip(self.t, self.noise)):
            a = self.amplitudes(i)
            e = np.exp(self.rate * t)
            gain = complex(*a[-2:])
            J = np.zeros((len(t), n))
            J[:, 0] = (gain * t * e).real
            J[:, 1] = -(gain * t * e).imag
            J[:, 2 + own * i:2 + own * (i + 1)] = columns(self.rate, t, self.has_level)
            information += J.T @ J / noise**2
        residual = self._residual([self.rate.real / self.unit, self.rate.imag / self.unit])
        return np.linalg.inv(information) * max(1.0, residual @ residual / (len(residual) - n))

    def onset_s(self, i):
        return self.onset_of(i, [self.rate.real, self.rate.imag, *self.amplitudes(i)])

    def onset_of(self, i, x):
        """Where the response is level and near zero: it leaves with slope zero, so that the slope
        Re(c s e^(s t)) has a simple root there."""
        s, level, c = complex(x[0], x[1]), x[2], complex(x[3], x[4])
        roots = (0.5 * np.pi * np.arange(-9, 10, 2) - np.angle(c * s)) / s.imag
        low = roots[np.abs(level + (c * np.exp(s * roots)).real) < 0.25 * abs(level)]
        return self.shots[i].time_s(self.shots[i].first) + low[np.abs(low).argmin()]

    def u_onset_s(self, i):
        """By differences over a tenth of each parameter's own u."""
        at = [0, 1, *range(2 + 3 * i, 5 + 3 * i)]
        V = self.covariance()[np.ix_(at, at)]
        x = np.array([self.rate.real, self.rate.imag, *self.amplitudes(i)])
        moves = np.diag(0.1 * np.sqrt(np.diag(V)))
        slope = [(self.onset_of(i, x + move) - self.onset_of(i, x - move)) / (2.0 * move.sum()) for move in moves]
        return np.sqrt(slope @ V @ slope)

    def u_level_relative(self, i):
        """Of the level at the onset, with the baseline that it is counted from."""
        quiet = self.shots[i].quiet
        of_baseline = self.shots[i].noise_sd / np.sqrt(len(quiet))
        u = np.sqrt(self.covariance()[2 + 3 * i, 2 + 3 * i])
        return np.hypot(u, of_baseline) / abs(self.amplitudes(i)[0])

    def dof(self):
        """Samples less parameters."""
        return sum(self.count) - 2 - self.own * len(self.shots)

    def resonance(self):
        """f0, zeta, u(f0), u(zeta)."""
        covariance = self.covariance()[:2, :2]
        size, share = abs(self.rate), self.rate.real / abs(self.rate)
        slope_f = np.array([self.rate.real, self.rate.imag]) / size / (2.0 * np.pi)
        slope_z = np.array([-1.0 + share**2, share * self.rate.imag / size]) / size
        return (size / (2.0 * np.pi), -share, np.sqrt(slope_f @ covariance @ slope_f),
                np.sqrt(slope_z @ covariance @ slope_z))

    def gain(self, i, f):
        """Response to pressure at f over the plateau: c0 + sum c_i jw/(jw - s_i) at the onset."""
        a = self.amplitudes(i)
        delay = self.onset_s(i) - self.shots[i].time_s(self.shots[i].first)
        c = 0.5 * complex(a[1], a[2]) * np.exp(self.rate * delay) / a[0]
        jw = 2j * np.pi * np.asarray(f)
        return 1.0 + c * jw / (jw - self.rate) + np.conj(c) * jw / (jw - np.conj(self.rate))
