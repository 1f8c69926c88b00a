# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Conditions of the operator: what is typed, noted or named wrongly."""
import numpy as np

from . import gases, waves
from .conditions_laboratory import condition, fill


def spread_speeds(lab, factor):
    for shot in lab.shots:
        shot.velocity = 470.0 + factor * (shot.velocity - 470.0)


@condition("typed", operator=True)
def one_velocity_for_all(lab, rng):
    """The last shot's velocity is typed once and serves all; size 1: 420 to 512.8 m/s."""
    size = rng.uniform(0, 2)
    spread_speeds(lab, size)
    lab.noted.shock = {"velocity_m_s": round(lab.shots[-1].velocity, 1)}
    lab.noted.recipe = {"uncertainty": {"budget": [{"quantity": "velocity_m_s", "u": 0.5}]}}
    lab.judge_shot = 0
    return size


@condition("typed", operator=True)
def one_step_for_all(lab, rng):
    """The last shot's step is typed once and serves all."""
    size = rng.uniform(0, 2)
    spread_speeds(lab, size)
    gas = gases.driven_gas(lab.gas, lab.t1, lab.p1, lab.humidity)
    step = waves.shock(lab.shots[-1].velocity, gas, lab.p1).step
    lab.noted.shock = {"step_pa": float(f"{step:.4g}")}
    lab.noted.recipe = {"uncertainty": {"budget": [{"quantity": "step_relative", "u": 0.005}]}}
    lab.judge_shot = 0
    return size


@condition("typed", operator=True)
def velocity_misread(lab, rng):
    """Three shots alike, their velocity typed up to 6 % wrong."""
    size = rng.uniform(-0.06, 0.06)
    for shot in lab.shots:
        shot.velocity, shot.level = 480.0 * (1 + rng.normal(0, 0.0005)), "medium"
    lab.noted.shock = {"velocity_m_s": round(480.0 * (1 + size), 1)}
    lab.noted.recipe = {"uncertainty": {"budget": [{"quantity": "velocity_m_s", "u": 0.5}]}}
    return size


def listed(lab, rng):
    lab.noted.recipe = {"uncertainty": {"budget": [{"quantity": "velocity_m_s", "u": 0.5}]}}
    return [float(round(shot.velocity + rng.normal(0, 0.5), 2)) for shot in lab.shots]


@condition("typed")
def velocities_listed(lab, rng):
    """A velocity for every shot, each within its u."""
    lab.noted.shock = {"velocity_m_s": listed(lab, rng)}
    return 0.0


@condition("typed", operator=True)
def one_of_the_list_misread(lab, rng):
    """The same, one of them up to 6 % wrong."""
    velocities, size = listed(lab, rng), rng.uniform(-0.06, 0.06)
    lab.judge_shot = int(rng.integers(0, len(velocities)))
    velocities[lab.judge_shot] *= 1 + size
    lab.noted.shock = {"velocity_m_s": velocities}
    return size


@condition("gas", operator=True)
def gas_wrong(lab, rng):
    """Up to pure N2, Ar or CO2 in the tube, air in the capture."""
    name, size = ("n2", "ar", "co2")[int(rng.integers(0, 3))], rng.uniform(0, 1)
    fill(lab, {"air": 1 - size, name: size})
    return size


@condition("humidity", operator=True)
def humidity_wrong(lab, rng):
    """0 to 100 %, another value recorded."""
    lab.humidity, lab.noted.humidity = rng.uniform(0, 1), round(rng.uniform(0, 1), 2)
    return lab.humidity - lab.noted.humidity


@condition("distance", operator=True)
def distance_misread(lab, rng):
    """The first arrival sensor's distance is noted up to 30 mm wrong."""
    size = rng.uniform(-0.03, 0.03)
    lab.noted.distances[0] = round(lab.noted.distances[0] + size, 4)
    return size


@condition("temperature", operator=True)
def temperature_misread(lab, rng):
    """T1 is noted up to 20 K wrong."""
    size = rng.uniform(-20, 20)
    lab.noted.t1 += size
    return size


@condition("pressure", operator=True)
def pressure_misread(lab, rng):
    """p1 is noted up to 10 % wrong."""
    size = rng.uniform(-0.1, 0.1)
    lab.noted.p1 *= 1 + size
    return size


@condition("rate", operator=True)
def rate_wrong(lab, rng):
    """The rate of all channels is stated a quarter to four times the true one."""
    lab.noted.rate_factor = float(np.exp(rng.uniform(-1, 1) * np.log(4)))
    return lab.noted.rate_factor


@condition("rate", operator=True)
def rate_doubled(lab, rng):
    """The rate of all channels is stated twice the true one."""
    lab.noted.rate_factor = 2.0
    return 2.0


@condition("scale", operator=True)
def scale_wrong(lab, rng):
    """The DUT's volts are stated wrong by 10, 1000 or their inverse, or by up to 30 %."""
    factor = (1e-3, 0.1, 10.0, 1e3, np.exp(rng.uniform(-0.3, 0.3)))[int(rng.integers(0, 5))]
    lab.noted.scale_factor = float(factor)
    return factor


@condition("order", operator=True)
def levels_swapped(lab, rng):
    """Two levels are named for each other."""
    i, j = rng.choice(len(lab.shots), 2, replace=False)
    lab.noted.levels = [shot.level for shot in lab.shots]
    lab.noted.levels[i], lab.noted.levels[j] = lab.noted.levels[j], lab.noted.levels[i]
    return 1.0
