# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One calibration in the laboratory: from the switches to the records and their truth."""
from dataclasses import dataclass

import numpy as np

from . import gases, recorder, response, waves

DROP_TAU = 0.3e-3
SIDE_SENSITIVITY = 7e-6  # V/Pa
TRUTH_FREQUENCIES = np.geomspace(300.0, 4e6, 200)


@dataclass
class Channel:
    name: str
    role: str
    unit: str
    counts: np.ndarray
    scale: float
    adc_bits: int


@dataclass
class Record:
    channels: list
    t0_s: float
    truth: dict
    p4_pa: float


def dut_system(dut, disturbed=True):
    """Unit sensitivity; undisturbed by seat, heat and mount it is what S(f) is of."""
    modes = response.parallel([response.mode(*m) for m in dut.modes])
    total = sum(m[2] for m in dut.modes)
    modes.C, modes.D = modes.C / total, dut.seat if disturbed else 0.0
    system = response.series(response.lag(dut.lag_hz), modes) if dut.lag_hz else modes
    if dut.ac_s:
        system = response.series(response.ac_coupling(dut.ac_s), system)
    for share, tau in dut.heat if disturbed else []:
        system = response.series(response.heat(share, tau), system)
    if dut.mount and disturbed:
        system = response.series(response.mount(*dut.mount), system)
    return system


def reference_system(reference):
    modes = response.parallel([response.mode(*m) for m in reference.modes])
    modes.C = modes.C / sum(m[2] for m in reference.modes)
    return modes


def dut_pressure(laboratory, state, arrival):
    dut, pressure = laboratory.dut, response.Pressure()
    pressure.front(arrival, state.step, *dut.front)
    for share, delay in dut.echo:
        pressure.front(arrival + delay, share * state.step, *dut.front)
    end = arrival + waves.plateau(state, laboratory.driven_length)
    pressure.relax(end, -laboratory.plateau_drop * state.step, DROP_TAU)
    return pressure


def side_times(side, state, travel, arrival):
    """When the incident and the reflected front pass the middle of its diaphragm."""
    return (arrival - travel.time_to_wall(side.distance_m),
            arrival + side.distance_m / state.reflected_velocity)


def own_step(side, velocity):
    """Rise time (10-90 %) and 50 % time of the sensor, swept by a front of this velocity, without delay."""
    sweep = side.diameter_m / velocity
    span = sweep + 4 / side.f0_hz
    pressure = response.Pressure()
    pressure.sweep(0.0, 1.0, sweep)
    times = np.linspace(-sweep / 2, span, 4001)
    values = response.sampled(response.mode(side.f0_hz, side.zeta), pressure, times[0],
                              times[1] - times[0], len(times))
    low, half, high = (np.interp(level, values[:values.argmax() + 1], times[:values.argmax() + 1])
                       for level in (0.1, 0.5, 0.9))
    return high - low, half


def side_values(laboratory, side, state, travel, arrival, clock):
    """Pa above p1, as its stated sensitivity reads it."""
    local = waves.shock(travel.velocity(side.distance_m), driven(laboratory), laboratory.p1)
    incident, reflected = side_times(side, state, travel, arrival)
    rise, half = own_step(side, local.velocity)
    late = side.delay_of_rise * rise - half
    pressure = response.Pressure()
    pressure.sweep(incident + late, local.p2 - local.p1, side.diameter_m / local.velocity)
    pressure.sweep(reflected + late, state.p5 - local.p2, side.diameter_m / state.reflected_velocity)
    end = arrival + waves.plateau(state, laboratory.driven_length) + side.distance_m / state.a5
    pressure.relax(end, -laboratory.plateau_drop * state.step, DROP_TAU)
    return side.gain * response.sampled(response.mode(side.f0_hz, side.zeta), pressure, *clock)


def driven(laboratory):
    return gases.driven_gas(laboratory.gas, laboratory.t1, laboratory.p1, laboratory.humidity)


def perform_shot(laboratory, plan, rng):
    """Volts and pascals on the true clock; the counts come when the ranges of all shots are known."""
    gas, rec = driven(laboratory), laboratory.recorder
    state = waves.shock(plan.velocity, gas, laboratory.p1)
    travel = waves.Travel(plan.velocity, laboratory.attenuation, laboratory.attenuation_law,
                          laboratory.driven_length)
    interval = 1 / (rec.rate_hz * (1 + rec.clock))
    count = int(round(rec.duration_s * rec.rate_hz))
    # The trigger is the first side sensor, which the shock passes within 20 us of it.
    arrival = travel.time_to_wall(max(s.distance_m for s in laboratory.sides)) + rng.uniform(-2e-5, 2e-5)
    clock = (-rec.before_s, interval, count)
    volts = plan.gain * laboratory.dut.sensitivity * response.sampled(
        dut_system(laboratory.dut), dut_pressure(laboratory, state, arrival), *clock)
    sd = laboratory.noise * laboratory.dut.sensitivity * plan.gain * state.step
    volts += sd * recorder.noise(rng, count, laboratory.noise_kind)
    sides = [side_values(laboratory, side, state, travel, arrival, clock)
             + laboratory.side_noise_pa * rng.standard_normal(count) for side in laboratory.sides]
    return state, arrival, volts, sides, reference_volts(laboratory, state, arrival, clock, rng)


def reference_volts(laboratory, state, arrival, clock, rng):
    """None without one; it draws nothing then."""
    ref = laboratory.reference
    if ref is None:
        return None
    pressure = dut_pressure(laboratory, state, arrival + ref.delay_s)
    volts = ref.gain * ref.sensitivity * response.sampled(reference_system(ref), pressure, *clock)
    return volts + ref.noise * ref.sensitivity * state.step * rng.standard_normal(clock[2])


def perform(laboratory, rng):
    """All shots: list of Record."""
    rec = laboratory.recorder
    shots = [perform_shot(laboratory, plan, rng) for plan in laboratory.shots]
    full = recorder.range_for(1.02 * max(np.abs(volts).max() for _, _, volts, _, _ in shots))
    side_full = recorder.range_for(1.02 * max(np.abs(s).max() for _, _, _, sides, _ in shots for s in sides))
    return [to_record(laboratory, plan, shot, full, side_full, rng)
            for plan, shot in zip(laboratory.shots, shots)]


def to_record(laboratory, plan, shot, full, side_full, rng):
    state, arrival, volts, sides, reference = shot
    rec = laboratory.recorder
    dut_counts, code = recorder.counts(volts, full, rec.bits, rec.gain, rec.bow_codes)
    channels = [Channel("DUT", "dut", "V", dut_counts, code, rec.bits)]
    for i, values in enumerate(sides):
        c, side_code = recorder.counts(values, side_full, 14)
        per_pascal = 1.0 if laboratory.sides[i].calibrated else SIDE_SENSITIVITY
        channels.append(Channel(f"Side {i + 1}", "driven_side", "V" if per_pascal < 1 else "Pa", c,
                                side_code * per_pascal, 14))
    if reference is not None:
        c, code = recorder.counts(reference, recorder.range_for(1.02 * np.abs(reference).max()), 14)
        channels.append(Channel("Reference", "reference", "V", c, code, 14))
    p4 = waves.driver_pressure(state, driven(laboratory).gamma, driven(laboratory).sound_speed)
    truth = {"velocity_m_s": state.velocity, "mach": state.mach, "step_pa": state.step, "p2_pa": state.p2,
             "p5_pa": state.p5, "p4_pa": p4, "a1_m_s": driven(laboratory).sound_speed,
             "gamma": driven(laboratory).gamma, "arrival_s": arrival, "gain": plan.gain,
             "level_at_onset": laboratory.dut.sensitivity * plan.gain * state.step,
             "plateau_s": waves.plateau(state, laboratory.driven_length)}
    return Record(channels, -rec.before_s, truth, p4 * (1 + rng.normal(0, 0.02)))
