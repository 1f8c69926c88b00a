# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Conditions of the coverage studies: fixed faults, or all inputs drawn from their stated uncertainty."""
import numpy as np

from . import laboratory, switches
from .conditions_laboratory import condition

# The prior on the attenuation: rectangular, per metre.
ATTENUATION = (-0.005, 0.01)


@condition()
def clean_any(lab, rng):
    """Random sensor, noise 0.2 to 3 %, 1 to 6 shots, everything else drawn from its stated range."""
    lab.dut = switches.random_sensor(rng)
    lab.noted.u_card = 0.005 * lab.dut.sensitivity
    lab.noted.card = lab.dut.sensitivity + rng.normal(0, lab.noted.u_card)
    lab.noise = np.exp(rng.uniform(np.log(0.002), np.log(0.03)))
    count = int(rng.integers(1, 7))
    nominal = rng.integers(0, 3, count)
    lab.shots = [switches.ShotPlan(switches.SPEEDS[i] * (1 + rng.normal(0, 0.003)), switches.LEVELS[i])
                 for i in nominal]
    lab.attenuation = rng.uniform(*ATTENUATION)
    lab.humidity = rng.uniform(0, 1)
    lab.noted.humidity = None if rng.random() < 0.5 else round(lab.humidity, 2)
    return 0.0


@condition()
def bounds_any(lab, rng):
    """Hardly any noise, low rates, windows of 5 to 40 time constants, a mode of 2 % that no model has."""
    f0, rate = ((2.33e6, 1e7), (2.33e6, 1e8), (318e3, 1e6), (318e3, 2e6), (318e3, 1e7))[int(rng.integers(0, 5))]
    lab.dut.modes = [(f0, 0.02, 1.0), (f0 * rng.uniform(1.5, 6), rng.uniform(0.01, 0.05), 0.02)]
    lab.noise, lab.recorder.bits = 1e-6, 24
    fast(lab, rate)
    if rate > 5e7:
        lab.recorder.before_s, lab.recorder.duration_s = 0.5e-3, 3.5e-3
    windows = rng.uniform(5, 40)
    end = max(windows / (2 * np.pi * f0 * 0.02), 300 / rate)
    lab.noted.recipe = {"window": {"end_s": float(f"{end:.4g}")}, "realization": {"order": 2}}
    return windows


def fixed(name, causes, text, change):
    def function(lab, rng):
        return change(lab, rng) or 0.0
    function.__name__, function.__doc__ = name, text
    condition(*causes)(function)


def set_heat(share, tau):
    def change(lab, rng):
        lab.dut.heat = [(share, tau)]
        return share
    return change


def set_ac(tau):
    def change(lab, rng):
        lab.dut.ac_s = tau
        return tau
    return change


def fast(lab, rate):
    """A higher rate, over a shorter time."""
    lab.recorder.rate_hz = rate
    if rate > 2e7:
        lab.recorder.before_s, lab.recorder.duration_s = 1e-3, 4e-3


def set_modes(modes, lag_hz=None, rate=1e7):
    def change(lab, rng):
        lab.dut.modes, lab.dut.lag_hz = modes, lag_hz
        fast(lab, rate)
    return change


def set_tube(sensors, alpha):
    """alpha None: drawn from the prior. The sensors are made anew, as their number is given."""
    def change(lab, rng):
        other = switches.default(rng, sensors)
        lab.sides, lab.noted.distances = other.sides, other.noted.distances
        lab.attenuation = rng.uniform(*ATTENUATION) if alpha is None else alpha
        gas = laboratory.driven(lab)  # recorded, so that the velocity alone decides
        lab.noted.gamma, lab.noted.molar_mass = gas.gamma, gas.effective_molar_mass
        return lab.attenuation
    return change


def set_noise(kind):
    def change(lab, rng):
        lab.noise_kind, lab.noise = kind, 0.005
    return change


def set_front(modes, duration, noise):
    def change(lab, rng):
        lab.dut.modes, lab.dut.front = modes, ("ramp", duration)
        u = 0.05 * duration
        lab.noted.shock = {"front_duration_s": duration + rng.normal(0, u), "u_front_duration_s": u}
        lab.noise = noise
        fast(lab, 5e7)
        return duration
    return change


DRIFT = {"onset_heat_2_percent_500us": set_heat(0.02, 0.5e-3),
         "onset_heat_5_percent_100us": set_heat(0.05, 0.1e-3),
         "onset_ac_20ms": set_ac(20e-3), "onset_ac_5ms": set_ac(5e-3)}
STILL = {"onset_optic1": set_modes([(400e3, 0.7, 1.0)]),
         "onset_optic4": set_modes([(2.78e6, 0.02, 1.0)], 250e3, 5e7),
         "onset_zeta_1.1": set_modes([(318e3, 1.1, 1.0)]), "onset_zeta_3": set_modes([(318e3, 3.0, 1.0)])}
TUBE = {"tube_3_sensors_prior": set_tube(3, None), "tube_1_sensor_prior": set_tube(1, None),
        **{f"tube_3_sensors_{int(a * 1e4) / 100:g}_percent": set_tube(3, a)
           for a in (0.0, 0.002, 0.004, 0.008)}}
DAMPING = {f"damping_{z:g}": set_modes([(318e3, z, 1.0)]) for z in (0.9, 1.0, 1.1, 1.5, 3.0)}
NOISE = {f"response_{kind}": set_noise(kind) for kind in ("white", "ar", "flicker")}
FRONT = {"front_200ns": set_front([(2.33e6, 0.02, 1.0)], 200e-9, 0.01),
         "front_400ns": set_front([(400e3, 0.7, 1.0)], 400e-9, 0.003)}

for table, causes in ((DRIFT, ("drift",)), (STILL, ()), (TUBE, ("attenuation",)), (DAMPING, ("order",)),
                      (NOISE, ("noise",)), (FRONT, ("front",))):
    for name, change in table.items():
        fixed(name, causes, name.replace("_", " "), change)
