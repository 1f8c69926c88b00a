# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shock waves in a tube, from the conservation laws of a gas of constant gamma.

Incident shock (Prandtl): the velocities ahead of and behind the shock, seen from it, have the product
a*^2 = (2 a1^2 + (gamma-1) W^2)/(gamma+1). Mass and momentum give the rest: rho2 = rho1 W/w2,
p2 = p1 + rho1 W (W - w2). Reflected shock: it runs with V into a gas that comes at u2 and must stop it:
V^2 - (gamma+1)/2 u2 V - a2^2 = 0, p5 = p2 + rho2 V u2. Driver: the unsteady expansion keeps
u + 2a/(gamma4-1), so p4 = p2 (1 - (gamma4-1)/2 u2/a4)^(-2 gamma4/(gamma4-1)).
"""
from dataclasses import dataclass

import numpy as np
from scipy.integrate import quad


@dataclass(frozen=True)
class Shock:
    """States around one shock: 1 ahead, 2 behind it, 5 behind its reflection."""

    velocity: float
    mach: float
    p1: float
    p2: float
    p5: float
    u2: float
    a2: float
    a5: float
    reflected_velocity: float

    @property
    def step(self):
        return self.p5 - self.p1


def shock(velocity, gas, p1):
    """gas: gases.Gas at the temperature ahead; density by gamma p/a^2."""
    g, a1 = gas.gamma, gas.sound_speed
    rho1 = g * p1 / a1**2
    w2 = (2 * a1**2 + (g - 1) * velocity**2) / (g + 1) / velocity
    u2, rho2 = velocity - w2, rho1 * velocity / w2
    p2 = p1 + rho1 * velocity * u2
    a2 = np.sqrt(g * p2 / rho2)
    quarter = (g + 1) / 4 * u2
    relative = quarter + np.hypot(quarter, a2)
    p5 = p2 + rho2 * relative * u2
    rho5 = rho2 * relative / (relative - u2)
    return Shock(velocity, velocity / a1, p1, p2, p5, u2, a2, np.sqrt(g * p5 / rho5), relative - u2)


def driver_pressure(state, gamma4, a4):
    """p4, Pa; nan where no driver pressure reaches this shock."""
    rest = 1 - (gamma4 - 1) / 2 * state.u2 / a4
    return state.p2 * rest ** (-2 * gamma4 / (gamma4 - 1)) if rest > 0 else float("nan")


def plateau(state, driven_length):
    """s behind the step at the end wall: reflected shock to the contact surface and back."""
    gap = driven_length - state.u2 * driven_length / state.velocity
    meeting = gap / (state.reflected_velocity + state.u2)
    return meeting * (1 + state.reflected_velocity / state.a5)


# W(x)/W by alpha, x m from the end wall and the tube's length; over the tube they all change by about alpha
# times its length. early: all of it behind the diaphragm, late: before the end wall.
LAWS = {"linear": lambda alpha, x, length: 1 + alpha * x,
        "exponential": lambda alpha, x, length: np.exp(alpha * x),
        "early": lambda alpha, x, length: 1 + alpha * x**2 / length,
        "late": lambda alpha, x, length: 1 + alpha * (2 * x - x**2 / length)}


@dataclass(frozen=True)
class Travel:
    """The shock on its way to the end wall: positive alpha (per m) is a shock that slows down."""

    end_velocity: float
    alpha: float = 0.0
    law: str = "linear"
    length: float = 1.0

    def velocity(self, x):
        return self.end_velocity * LAWS[self.law](self.alpha, x, self.length)

    def time_to_wall(self, x):
        """s from x to the end wall: the integral of dx/W."""
        if abs(self.alpha) < 1e-12:
            return x / self.end_velocity
        if self.law == "linear":
            return np.log1p(self.alpha * x) / (self.alpha * self.end_velocity)
        return quad(lambda y: 1 / self.velocity(y), 0, x, epsabs=0, epsrel=1e-13)[0]
