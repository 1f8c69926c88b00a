# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Conditions of the sensor, the tube and the gas: what the laboratory knows.

A condition changes a default laboratory; `size` runs from negligible to twice what is ordinary, and
`causes` are the words of results.json that name it rightly.
"""
from . import gases, switches

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


@condition("attenuation")
def attenuation(lab, rng):
    """The velocity falls by up to 1 %/m."""
    lab.attenuation = rng.uniform(0, 0.01)
    return lab.attenuation


def three_sensors(lab, rng):
    other = switches.default(rng, 3)
    lab.sides, lab.noted.distances = other.sides, other.noted.distances


@condition("attenuation")
def attenuation_beyond(lab, rng):
    """By 1 to 2 %/m, more than is assumed, before three sensors: fewer cannot see it."""
    three_sensors(lab, rng)
    lab.attenuation = rng.uniform(0.01, 0.02)
    return lab.attenuation


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
