# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Linear systems and their exact response to pressures made of steps, ramps, relaxations and sines.

A system is (A, B, C, D) in real, well-scaled states. The pressure is the output of a generator (a
level, a slope, Re(e^(rate t)) for every rate) whose states jump at events. Between events the whole
obeys x' = A x, so x(t) = e^(A (t - t0)) x(t0): nothing is sampled, filtered or integrated.
"""
from dataclasses import dataclass, field

import numpy as np
from scipy.linalg import block_diag, expm


@dataclass
class System:
    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D: float = 0.0

    def response(self, frequency_hz):
        """Complex, e^(+jwt) convention."""
        eye = np.eye(len(self.A))
        return np.array([self.C @ np.linalg.solve(2j * np.pi * f * eye - self.A, self.B) + self.D
                         for f in np.atleast_1d(frequency_hz)])


def mode(f0_hz, zeta, weight=1.0):
    """weight w^2/(s^2 + 2 zeta w s + w^2), any zeta > 0."""
    w = 2 * np.pi * f0_hz
    return System(np.array([[0, w], [-w, -2 * zeta * w]]), np.array([0, w]), np.array([weight, 0.0]))


def lag(frequency_hz):
    w = 2 * np.pi * frequency_hz
    return System(np.array([[-w]]), np.array([w]), np.array([1.0]))


def ac_coupling(tau_s):
    """s/(s + 1/tau)"""
    return System(np.array([[-1 / tau_s]]), np.array([1 / tau_s]), np.array([-1.0]), 1.0)


def heat(share, tau_s):
    """1 - share/(1 + s tau): a step sags by its share with tau."""
    return System(np.array([[-1 / tau_s]]), np.array([1 / tau_s]), np.array([-share]), 1.0)


def mount(share, f0_hz, zeta):
    """1 + share s^2/(s^2 + 2 zeta w s + w^2): what the wall's acceleration adds to the pressure.

    A wall of one mode that the pressure pushes with its area has this acceleration, per area/mass; share
    is that times the sensor's acceleration sensitivity (Pa per m/s^2)."""
    wall = mode(f0_hz, zeta)  # its states: w^2/(...) and s w/(...)
    return System(wall.A, wall.B, -share * np.array([1.0, 2 * zeta]), 1 + share)


def series(first, second):
    n = len(first.A)
    A = block_diag(first.A, second.A)
    A[n:, :n] = np.outer(second.B, first.C)
    return System(A, np.concatenate([first.B, second.B * first.D]),
                  np.concatenate([second.D * first.C, second.C]), first.D * second.D)


def parallel(systems):
    return System(block_diag(*[s.A for s in systems]), np.concatenate([s.B for s in systems]),
                  np.concatenate([s.C for s in systems]), sum(s.D for s in systems))


@dataclass
class Pressure:
    """Pa over time, 0 before the first event."""

    events: list = field(default_factory=list)  # (time, level, slope, rate or None, of the part e^(rate t))

    def step(self, time, amount):
        self.events.append((time, amount, 0.0, None, 0.0))

    def relax(self, time, amount, tau_s):
        """amount (1 - e^(-t/tau))"""
        self.events.append((time, amount, 0.0, -1 / tau_s, -amount))

    def exponential(self, time, amount, rise_s):
        """amount (1 - e^(-t/tau)) with this rise from 10 to 90 %, tau before `time` on: its mean lies there."""
        tau = rise_s / np.log(9)
        self.relax(time - tau, amount, tau)

    def half_sine(self, time, amount, rise_s):
        """amount (1 - cos(pi t/T))/2 over T, with this rise from 10 to 90 %; its middle at `time`."""
        duration = rise_s * np.pi / (np.arccos(-0.8) - np.arccos(0.8))
        rate = 1j * np.pi / duration
        self.events.append((time - duration / 2, amount / 2, 0.0, rate, -amount / 2))
        self.events.append((time + duration / 2, amount / 2, 0.0, rate, -amount / 2))

    def ramp(self, time, amount, duration):
        """Linear, its middle at `time`."""
        self.events.append((time - duration / 2, 0.0, amount / duration, None, 0.0))
        self.events.append((time + duration / 2, 0.0, -amount / duration, None, 0.0))

    def sweep(self, time, amount, duration, points=48):
        """A straight front over a disc: the covered share grows from -duration/2 to duration/2.

        The convolution with 2/pi sqrt(1 - x^2) by Gauss-Chebyshev quadrature of the second kind."""
        k = np.arange(1, points + 1) * np.pi / (points + 1)
        for x, weight in zip(np.cos(k), 2 / (points + 1) * np.sin(k) ** 2):
            self.step(time + x * duration / 2, amount * weight)

    def front(self, time, amount, kind="none", duration=0.0):
        if kind == "none" or duration <= 0:
            self.step(time, amount)
        else:
            {"ramp": self.ramp, "tilt": self.sweep, "exponential": self.exponential,
             "half_sine": self.half_sine}[kind](time, amount, duration)


def of_rate(rate):
    """States whose first is Re(e^(rate t)): one, or two where the rate is complex."""
    rate = complex(rate)
    full = np.array([[rate.real, -rate.imag], [rate.imag, rate.real]])
    return full if rate.imag else full[:1, :1]


def places(rates):
    """Where each rate's states begin in the generator, and the number of its states."""
    found, after = {}, 2
    for rate in rates:
        found[rate], after = after, after + len(of_rate(rate))
    return found, after


def with_generator(system, rates):
    """A and output of generator and system joined; states: level, slope, those of the rates, system."""
    (begins, m), n = places(rates), len(system.A)
    A = np.zeros((m + n, m + n))
    A[0, 1] = 1
    drive = np.zeros(m)
    drive[0] = 1
    for rate, i in begins.items():
        block = of_rate(rate)
        A[i:i + len(block), i:i + len(block)], drive[i] = block, 1
    A[m:, m:] = system.A
    A[m:, :m] = np.outer(system.B, drive)
    return A, np.concatenate([system.D * drive, system.C])


def powers(A, x, count, interval):
    """States e^(A k interval) x for k < count, by doubling; shape (states, count)."""
    states, jump = x[:, None], expm(A * interval)
    while states.shape[1] < count:
        states, jump = np.hstack([states, jump @ states]), jump @ jump
    return states[:, :count]


def sampled(system, pressure, start, interval, count):
    """The system's output at start + k interval, exactly; shape (count,)."""
    events = sorted(pressure.events, key=lambda event: event[0])
    rates = sorted({event[3] for event in events if event[3]}, key=lambda r: (complex(r).real, complex(r).imag))
    begins, (A, output) = places(rates)[0], with_generator(system, rates)
    x, now, values = np.zeros(len(A)), events[0][0] if events else start, np.zeros(count)
    for i, (time, level, slope, rate, part) in enumerate(events):
        x, now = expm(A * (time - now)) @ x, time
        x[0] += level
        x[1] += slope
        if rate:
            x[begins[rate]] += part
        until = events[i + 1][0] if i + 1 < len(events) else np.inf
        first = max(0, int(np.ceil((time - start) / interval)))
        last = count if np.isinf(until) else min(count, int(np.ceil((until - start) / interval)))
        if last > first:
            begin = expm(A * (start + first * interval - time)) @ x
            values[first:last] = output @ powers(A, begin, last - first, interval)
    return values
