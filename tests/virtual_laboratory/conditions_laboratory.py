# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Conditions of the tube, the gas and the operator: what the laboratory knows.

A condition changes a default laboratory; `size` runs from negligible to twice what is ordinary, and
`causes` are the words of results.json that name it rightly.
"""
import numpy as np

from . import gases, switches, waves

CONDITIONS = {}


def condition(*causes, operator=False):
    def register(function):
        def apply(lab, rng):
            lab.causes, lab.operator = list(causes), operator
            lab.size = float(function(lab, rng))
            return lab
        apply.__doc__ = function.__doc__
        CONDITIONS[function.__name__] = apply
        return function
    return register


@condition()
def clean(lab, rng):
    """Nothing is wrong."""
    return 0.0


@condition("drift")
def heat_slow(lab, rng):
    """The output sags by up to 4 % with 0.5 ms."""
    share = rng.uniform(0, 0.04)
    lab.dut.heat = [(share, 0.5e-3)]
    return share


@condition("drift")
def heat_fast(lab, rng):
    """The output sags by up to 10 % with 0.1 ms."""
    share = rng.uniform(0, 0.10)
    lab.dut.heat = [(share, 0.1e-3)]
    return share


@condition("drift")
def ac_coupling(lab, rng):
    """AC coupling from 200 ms down to 2.5 ms: size is 5 ms / tau."""
    size = rng.uniform(0.025, 2.0)
    lab.dut.ac_s = 5e-3 / size
    return size


@condition("shots")
def one_shot_off(lab, rng):
    """The sensor gives up to twice too much in one shot."""
    size, shot = rng.uniform(0, 1.0), int(rng.integers(0, len(lab.shots)))
    lab.shots[shot].gain = 1 + size
    return size


@condition("shots")
def shots_scatter(lab, rng):
    """The sensitivity scatters from shot to shot by up to 4 %."""
    size = rng.uniform(0, 0.04)
    for shot in lab.shots:
        shot.gain = 1 + size * rng.standard_normal()
    return size


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


def fill(lab, fractions, mach_of_air=True):
    """Another gas, at the Mach numbers that the speeds have in air."""
    air = gases.driven_gas({"air": 1.0}, lab.t1, lab.p1, 0.0).sound_speed
    lab.gas = fractions
    ratio = gases.driven_gas(fractions, lab.t1, lab.p1, 0.0).sound_speed / air
    for shot in lab.shots:
        shot.velocity *= ratio if mach_of_air else 1.0


@condition("gas")
def gas_recorded(lab, rng):
    """N2, Ar, CO2 or He in the tube, and recorded in the capture by name."""
    name = ("n2", "ar", "co2", "he")[int(rng.integers(0, 4))]
    fill(lab, {name: 1.0})
    lab.noted.gas = name
    return 1.0


@condition("gas")
def gas_constants_recorded(lab, rng):
    """A mixture of air and argon whose gamma and molar mass stand in the capture."""
    size = rng.uniform(0.1, 0.9)
    fill(lab, {"air": 1 - size, "ar": size})
    gas = gases.driven_gas(lab.gas, lab.t1, lab.p1, 0.0)
    lab.noted.gas, lab.noted.gamma, lab.noted.molar_mass = "mixture", gas.gamma, gas.effective_molar_mass
    return size


@condition("gas", operator=True)
def gas_wrong(lab, rng):
    """Up to pure N2, Ar or CO2 in the tube, air in the capture."""
    name, size = ("n2", "ar", "co2")[int(rng.integers(0, 3))], rng.uniform(0, 1)
    fill(lab, {"air": 1 - size, name: size})
    return size


@condition("humidity")
def humidity_recorded(lab, rng):
    """0 to 100 % relative humidity, recorded."""
    lab.humidity = rng.uniform(0, 1)
    lab.noted.humidity = round(lab.humidity, 2)
    return lab.humidity


@condition("humidity")
def humidity_unknown(lab, rng):
    """0 to 100 %, nobody noted it."""
    lab.humidity, lab.noted.humidity = rng.uniform(0, 1), None
    return lab.humidity


@condition("humidity", operator=True)
def humidity_wrong(lab, rng):
    """0 to 100 %, another value recorded."""
    lab.humidity, lab.noted.humidity = rng.uniform(0, 1), round(rng.uniform(0, 1), 2)
    return lab.humidity - lab.noted.humidity


@condition("attenuation")
def attenuation(lab, rng):
    """The velocity falls by up to 1 %/m."""
    lab.attenuation = rng.uniform(0, 0.01)
    return lab.attenuation


@condition("attenuation")
def attenuation_beyond(lab, rng):
    """By 1 to 2 %/m, more than is assumed."""
    lab.attenuation = rng.uniform(0.01, 0.02)
    return lab.attenuation


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


@condition("delay")
def delay(lab, rng):
    """The side sensors' delays are 0 to 1.7 of their rise times."""
    size = rng.uniform(0, 2)
    for side in lab.sides:
        side.delay_of_rise = switches.DELAY_OF_RISE * size
    return size


@condition()
def unlike_speeds(lab, rng):
    """Shots of speeds drawn from Mach 1.1 to 1.6."""
    for shot in lab.shots:
        shot.velocity, shot.level = rng.uniform(380, 550), ""
    return 1.0
