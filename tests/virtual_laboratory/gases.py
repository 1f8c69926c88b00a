# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gases: heat capacity, molar mass and sound speed of mixtures, from statistical mechanics.

Molecules are rigid rotators with harmonic vibrations in equilibrium at the gas's temperature:
cp/R = 5/2 + rotation + sum of Einstein terms. The sound speed of a real gas is that of the ideal one
with the second virial coefficient of Tsonopoulos (AIChE J. 20 (1974) 263), acoustic form:
a^2 = gamma R T/M [1 + 2p/(RT) (B + (gamma-1) T B' + (gamma-1)^2/(2 gamma) T^2 B'')].
Water's vapour pressure: Wagner and Pruss, J. Phys. Chem. Ref. Data 22 (1993) 783.
"""
from dataclasses import dataclass

import numpy as np

R = 8.314462618  # J/(mol K), CODATA 2018


@dataclass(frozen=True)
class Molecule:
    molar_mass: float  # kg/mol
    rotation: float  # of cp/R
    vibrations_K: tuple = ()
    critical: tuple = None  # K, Pa, acentric factor


MOLECULES = {
    "n2": Molecule(0.0280134, 1.0, (3393.0,), (126.2, 3.398e6, 0.037)),
    "o2": Molecule(0.0319988, 1.0, (2273.0,), (154.6, 5.043e6, 0.022)),
    "ar": Molecule(0.039948, 0.0, (), (150.9, 4.898e6, 0.0)),
    "co2": Molecule(0.0440095, 1.0, (960.0, 960.0, 1997.0, 3380.0), (304.1, 7.375e6, 0.225)),
    "he": Molecule(0.0040026, 0.0),
    "h2o": Molecule(0.0180153, 1.5, (2295.0, 5261.0, 5404.0)),
}
DRY_AIR = {"n2": 0.78084, "o2": 0.20946, "ar": 0.0093, "co2": 0.0004}
AIR_CRITICAL = (132.53, 3.786e6, 0.035)


@dataclass(frozen=True)
class Gas:
    """A driven gas as the shock sees it: constant gamma, and the sound speed ahead of the shock."""

    gamma: float
    molar_mass: float  # kg/mol
    sound_speed: float  # m/s, at the temperature it was made for
    temperature: float  # K

    @property
    def effective_molar_mass(self):
        """That gives this sound speed to an ideal gas of this gamma."""
        return self.gamma * R * self.temperature / self.sound_speed**2


def heat_capacity(fractions, t_K):
    """cp/R of a mixture of mole fractions."""
    def one(molecule):
        x = np.array(molecule.vibrations_K) / t_K
        einstein = np.sum(x**2 * np.exp(-x) / (1 - np.exp(-x)) ** 2) if x.size else 0.0
        return 2.5 + molecule.rotation + einstein
    total = sum(fractions.values())
    return sum(part / total * one(MOLECULES[name]) for name, part in fractions.items())


def molar_mass(fractions):
    total = sum(fractions.values())
    return sum(part / total * MOLECULES[name].molar_mass for name, part in fractions.items())


def saturation_pressure(t_K):
    """Pa, of water over the liquid (Wagner and Pruss 1993)."""
    tau = 1 - t_K / 647.096
    powers = (1, 1.5, 3, 3.5, 4, 7.5)
    factors = (-7.85951783, 1.84408259, -11.7866497, 22.6807411, -15.9618719, 1.80122502)
    return 22.064e6 * np.exp(647.096 / t_K * sum(a * tau**n for a, n in zip(factors, powers)))


def virial(t_K, critical):
    """B and its first two derivatives by T, m3/mol."""
    t_c, p_c, omega = critical
    def b(t):
        r = t / t_c
        simple = 0.1445 - 0.330 / r - 0.1385 / r**2 - 0.0121 / r**3 - 0.000607 / r**8
        other = 0.0637 + 0.331 / r**2 - 0.423 / r**3 - 0.008 / r**8
        return R * t_c / p_c * (simple + omega * other)
    h = 1.0
    return b(t_K), (b(t_K + h) - b(t_K - h)) / (2 * h), (b(t_K + h) - 2 * b(t_K) + b(t_K - h)) / h**2


def mixture(fractions, t_K, p_Pa=None, critical=None):
    """Gas of mole fractions; with `critical` the sound speed is that of the real gas at p."""
    cp = heat_capacity(fractions, t_K)
    gamma, mass = cp / (cp - 1), molar_mass(fractions)
    a2 = gamma * R * t_K / mass
    if critical:
        b, b1, b2 = virial(t_K, critical)
        g = gamma - 1
        a2 *= 1 + 2 * p_Pa / (R * t_K) * (b + g * t_K * b1 + g**2 / (2 * gamma) * t_K**2 * b2)
    return Gas(gamma, mass, float(np.sqrt(a2)), t_K)


def humid_air(t_K, p_Pa, relative_humidity):
    vapour = relative_humidity * 1.004 * saturation_pressure(t_K) / p_Pa
    fractions = {name: part * (1 - vapour) for name, part in DRY_AIR.items()}
    return mixture({**fractions, "h2o": vapour}, t_K, p_Pa, AIR_CRITICAL)


def driven_gas(fractions, t_K, p_Pa, relative_humidity):
    """Pure air is a real gas with its humidity; anything else an ideal mixture."""
    if set(fractions) == {"air"}:
        return humid_air(t_K, p_Pa, relative_humidity)
    share = fractions.get("air", 0.0)
    parts = {name: part * share for name, part in DRY_AIR.items()}
    for name, part in fractions.items():
        if name != "air":
            parts[name] = parts.get(name, 0.0) + part
    return mixture(parts, t_K)
