# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Conditions of the record: what the samples themselves can tell."""
import numpy as np

from .conditions_laboratory import condition


def at_50_MS(lab):
    lab.recorder.rate_hz, lab.recorder.before_s, lab.recorder.duration_s = 5e7, 1e-3, 4e-3


def well_damped_and_fast(lab, zeta=0.7):
    """400 kHz at 50 MS/s and 0.3 % noise, so that a front is seen at all."""
    lab.dut.modes, lab.noise = [(400e3, zeta, 1.0)], 0.003
    at_50_MS(lab)


def front_keys(duration, u):
    return {"front_duration_s": duration, "u_front_duration_s": u}


@condition("echo")
def early_echo(lab, rng):
    """A copy of the step of up to 6 %, 50 to 200 us late."""
    size = rng.uniform(0, 0.06)
    lab.dut.echo = [(size, rng.uniform(50e-6, 200e-6))]
    return size


@condition("order")
def damping_high(lab, rng):
    """318 kHz with a damping of 0.9, 1, 1.1, 1.5 or 3."""
    zeta = (0.9, 1.0, 1.1, 1.5, 3.0)[int(rng.integers(0, 5))]
    lab.dut.modes = [(318e3, zeta, 1.0)]
    return zeta


@condition("order")
def overdamped_drift(lab, rng):
    """zeta 1.5 to 3 with heat: the drift must not take the sensor's own slow pole for its own."""
    lab.dut.modes, share = [(318e3, rng.uniform(1.5, 3), 1.0)], rng.uniform(0, 0.04)
    lab.dut.heat = [(share, 0.5e-3)]
    lab.causes = ["drift"]
    return share


@condition("front")
def front_typed(lab, rng):
    """A ramp of up to 800 ns before 400 kHz, zeta 0.7; its duration typed with 5 %."""
    duration = rng.uniform(0, 800e-9)
    well_damped_and_fast(lab)
    lab.dut.front = ("ramp", duration)
    u = 0.05 * duration + 2e-9
    lab.noted.shock = front_keys(max(0.0, duration + rng.normal(0, u)), u)
    return duration


@condition("front")
def front_unknown(lab, rng):
    """The same, and nobody typed it."""
    duration = rng.uniform(0, 800e-9)
    well_damped_and_fast(lab)
    lab.dut.front = ("ramp", duration)
    return duration


@condition("front")
def tilt_typed(lab, rng):
    """A disc of 5.5 mm tilted by up to 2 degrees: 190 ns a degree."""
    degrees = rng.uniform(0, 2)
    duration = 0.0055 * np.sin(np.radians(degrees)) / lab.shots[-1].velocity
    well_damped_and_fast(lab)
    lab.dut.front = ("tilt", duration)
    u = 0.05 * duration + 2e-9
    lab.noted.shock = front_keys(max(0.0, duration + rng.normal(0, u)), u)
    return degrees


@condition("front")
def front_fast_sensor(lab, rng):
    """2.33 MHz, zeta 0.02, at 50 MS/s, a ramp of up to 400 ns, typed with 5 %."""
    duration = rng.uniform(0, 400e-9)
    lab.dut.modes, lab.dut.front = [(2.33e6, 0.02, 1.0)], ("ramp", duration)
    at_50_MS(lab)
    u = 0.05 * duration + 2e-9
    lab.noted.shock = front_keys(max(0.0, duration + rng.normal(0, u)), u)
    return duration


@condition("noise")
def noise_ar(lab, rng):
    """AR(0.9), 0.1 to 2 % of the step."""
    lab.noise_kind, lab.noise = "ar", np.exp(rng.uniform(np.log(0.001), np.log(0.02)))
    return lab.noise


@condition("noise")
def noise_flicker(lab, rng):
    """1/f, 0.1 to 2 % of the step."""
    lab.noise_kind, lab.noise = "flicker", np.exp(rng.uniform(np.log(0.001), np.log(0.02)))
    return lab.noise


@condition("noise")
def noise_white(lab, rng):
    """White, 0.2 to 3 % of the step."""
    lab.noise = np.exp(rng.uniform(np.log(0.002), np.log(0.03)))
    return lab.noise


@condition("order")
def damping_weak(lab, rng):
    """20 kHz, zeta 0.0005, 20 to 40 periods on the record, at 1, 10 or 50 MS/s."""
    lab.dut.modes = [(20e3, 0.0005, 1.0)]
    lab.recorder.rate_hz = (1e6, 1e7, 5e7)[int(rng.integers(0, 3))]
    periods = rng.uniform(20, 40)
    lab.recorder.before_s, lab.recorder.duration_s = 1e-3, round(2.9e-3 + periods / 20e3, 6)
    return periods


@condition("order")
def slow_modes(lab, rng):
    """Modes at 30, 50 and 75 kHz ring on for 500 us beside 318 kHz."""
    size = rng.uniform(0, 0.2)
    slow = [(f, 1 / (2 * np.pi * f * 500e-6), size / 3) for f in (30e3, 50e3, 75e3)]
    lab.dut.modes = lab.dut.modes + slow
    return size


@condition("order")
def further_modes(lab, rng):
    """One or two further resonances of up to 10 %, above or below the first."""
    for _ in range(int(rng.integers(1, 3))):
        f = 318e3 * (rng.uniform(0.2, 0.6) if rng.random() < 0.5 else rng.uniform(1.5, 4))
        lab.dut.modes = lab.dut.modes + [(f, rng.uniform(0.01, 0.1), rng.uniform(0.005, 0.1))]
    return lab.dut.modes[1][2]


@condition("rate")
def clock(lab, rng):
    """The sample clock is off by up to 100 parts in a million, within what nobody states."""
    lab.recorder.clock = rng.uniform(-1e-4, 1e-4)
    return lab.recorder.clock


@condition("noise", "scale")
def converter(lab, rng):
    """8 to 12 bits, and a bow of up to 4 codes of 14 bits in the middle of the range."""
    lab.recorder.bits = int(rng.integers(8, 13))
    lab.recorder.bow_codes = rng.uniform(-4, 4) * 2.0 ** (lab.recorder.bits - 14)
    return lab.recorder.bits
