# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The laboratory's switches: what is there, and what the operator notes of it.

`Laboratory` is the truth, `Noted` what the capture and the recipe say. `default(rng)` draws the truth
about the noted values with the uncertainties that are noted too; a condition then changes either.
"""
from dataclasses import dataclass, field

import numpy as np

P1, T1, RATE = 101100.0, 294.15, 1e7
SPEEDS = (420.0, 470.0, 512.8)
LEVELS = ("low", "medium", "high")
PLACES = (0.8, 0.5, 0.2)
DELAY_OF_RISE = 0.85


@dataclass
class SideSensor:
    distance_m: float  # true, to the end wall
    diameter_m: float = 0.002
    f0_hz: float = 500e3
    zeta: float = 0.7
    delay_of_rise: float = 0.0  # 50 % of its step is read so many of its rise times late
    gain: float = 1.0  # of the value in Pa that is noted, to the true one
    calibrated: bool = True  # else its channel is in volts and it has no card


@dataclass
class Dut:
    modes: list = field(default_factory=lambda: [(318e3, 0.02, 1.0)])  # f0, zeta, weight
    sensitivity: float = 12.5e-9  # V/Pa at the onset
    lag_hz: float = None
    ac_s: float = None
    heat: list = field(default_factory=list)  # (share, tau)
    echo: list = field(default_factory=list)  # (share, delay)
    front: tuple = ("none", 0.0)  # kind, duration (of exponential and half_sine: 10-90 % rise)
    seat: float = 0.0  # share of the pressure that its mounting adds, at once and at all frequencies
    mount: tuple = None  # share, f0, zeta of the wall that the step shakes (response.mount)


@dataclass
class Recorder:
    rate_hz: float = RATE
    clock: float = 0.0  # relative error of the true rate
    bits: int = 14
    gain: float = 1.0
    bow_codes: float = 0.0
    before_s: float = 2e-3
    duration_s: float = 8e-3


@dataclass
class Reference:
    """A transducer beside the DUT; its certificate is a table of `certified` times the truth."""
    modes: list = field(default_factory=lambda: [(450e3, 0.3, 1.0)])
    sensitivity: float = 20e-9  # V/Pa
    gain: float = 1.0  # of its chain
    delay_s: float = 0.0  # of the step against the DUT's
    noise: float = 0.003  # of its step
    certified: float = 1.0
    certified_phase_rad: float = 0.0  # added
    u_certified: float = 0.003  # relative, and in rad
    frequencies_hz: list = field(default_factory=lambda: list(np.geomspace(100.0, 300e3, 60)))


@dataclass
class ShotPlan:
    velocity: float  # at the end wall
    level: str = ""
    gain: float = 1.0  # of the DUT in this shot


@dataclass
class Noted:
    p1: float = P1
    u_p1: float = 30.0
    t1: float = T1
    u_t1: float = 0.3
    gas: str = "air"
    gamma: float = None
    molar_mass: float = None
    humidity: float = None
    distances: list = field(default_factory=list)
    u_distance: float = 0.0002
    u_gain: float = 0.01  # of the side sensors
    card: float = 12.5e-9  # the DUT's static sensitivity
    u_card: float = 12.5e-11 / 2
    rate_factor: float = 1.0  # on the rate of all channels
    scale_factor: float = 1.0  # on the DUT's volts
    levels: list = None
    p4: bool = True
    shock: dict = field(default_factory=dict)  # further keys of the recipe's section
    recipe: dict = field(default_factory=dict)  # further sections


@dataclass
class Laboratory:
    p1: float
    t1: float
    gas: dict  # mole fractions; "air" is dry air
    humidity: float
    attenuation: float  # per metre, by the law below
    sides: list
    dut: Dut
    shots: list
    recorder: Recorder = field(default_factory=Recorder)
    noise: float = 0.01  # of each shot's own step
    noise_kind: str = "white"
    side_noise_pa: float = 150.0
    driver_length: float = 0.97
    driven_length: float = 0.97
    plateau_drop: float = 0.15
    attenuation_law: str = "linear"  # of waves.LAWS
    reference: Reference = None
    noted: Noted = field(default_factory=Noted)
    causes: list = field(default_factory=list)  # the words that are right for this fault
    size: float = 0.0  # of the fault, in the words of the condition
    judge_shot: int = None
    operator: bool = False  # a mistake of the operator's, which only comparisons can show


def default(rng, sensors=None):
    """Three shots of one sensor; 1 to 3 arrival sensors unless given, calibrated in seven of ten."""
    count, calibrated = sensors or int(rng.integers(1, 4)), bool(rng.random() < 0.7)
    noted = Noted(distances=list(PLACES[:count]), humidity=0.0)
    sides = [SideSensor(d + rng.normal(0, noted.u_distance), delay_of_rise=rng.uniform(0, DELAY_OF_RISE),
                        gain=1 + rng.normal(0, noted.u_gain), calibrated=calibrated)
             for d in noted.distances]
    shots = [ShotPlan(v * (1 + rng.normal(0, 0.003)), level) for v, level in zip(SPEEDS, LEVELS)]
    noted.card *= 1 + rng.normal(0, noted.u_card / noted.card)
    return Laboratory(p1=rng.normal(noted.p1, noted.u_p1), t1=rng.normal(noted.t1, noted.u_t1),
                      gas={"air": 1.0}, humidity=0.0, attenuation=0.0, sides=sides, dut=Dut(),
                      shots=shots, noted=noted)


def random_sensor(rng):
    """Of the kinds that are calibrated in shock tubes, within what the recorder can see."""
    f0 = np.exp(rng.uniform(np.log(50e3), np.log(600e3)))
    zeta = np.exp(rng.uniform(np.log(0.005), np.log(0.7)))
    return Dut(modes=[(f0, zeta, 1.0)], sensitivity=np.exp(rng.uniform(np.log(1e-9), np.log(1e-5))))
