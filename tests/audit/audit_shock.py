# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrivals, velocity, the pressure step and its uncertainty."""

from functools import lru_cache

import numpy as np

from audit_report import relative

R = 8.314462618  # J/(mol K), SI 2019


def shocked(velocity, T1, p1, gamma, molar):
    """Pressures behind the incident and the reflected shock, ideal gas."""
    mach2 = velocity**2 * molar / (gamma * R * T1)
    p2 = p1 * (1.0 + 2.0 * gamma / (gamma + 1.0) * (mach2 - 1.0))
    strength = p2 / p1
    p5 = p2 * ((3.0 * gamma - 1.0) * strength - (gamma - 1.0)) / (
        (gamma - 1.0) * strength + gamma + 1.0)
    return p2, p5


@lru_cache(maxsize=None)
def side_arrival_s(shot, channel, stated_s, model_arrival_s):
    """First crossing of half the incident step, half of the unknown delay taken off, and the delay's u.

    The reflected shock is not back yet. The delay lies between 0 and 0.85 of the 10-90 % rise time.
    """
    side = shot.channels[channel]
    rate, t0 = float(side.attrs["sample_rate_Hz"]), float(side.attrs["t0_s"])
    about = round((stated_s - t0) * rate)
    until = round((0.5 * (stated_s + model_arrival_s) - t0) * rate)
    y = side[:until] * float(side.attrs["scale"]) + float(side.attrs["offset"])
    before = y[:about - 1000].mean()
    height = y[about + 2000:].mean()

    def crossing_s(share):
        level = before + share * (height - before)
        k = np.flatnonzero(y[about - 500:] > level)[0] + about - 500
        return t0 + (k - 1 + (level - y[k - 1]) / (y[k] - y[k - 1])) / rate

    rise = crossing_s(0.9) - crossing_s(0.1)
    return crossing_s(0.5) - 0.5 * 0.85 * rise, 0.85 * rise / np.sqrt(12.0)


def check_shock(report, results, shots, fit, tube):
    for i, shot in enumerate(shots):
        stated = results["shock"][i]
        name = f"shot {shot.number}"
        side = next(a for a in stated["arrivals"] if not a["dut"])
        arrival, u_delay = side_arrival_s(shot, side["channel"], side["arrival_s"], fit.onset_s(i))
        report.compare(f"{name} arrival at the side wall (s)", side["arrival_s"], arrival,
                       3.0 * side["u_arrival_s"])
        report.compare(f"{name} u(delay) (s)", side["u_delay_s"], u_delay, 0.1 * u_delay)
        distance = float(tube["endflange_to_sensor2_m"])
        u_distance = float(tube["u_endflange_to_sensor2_m"])
        span = shot.stated["onset_s"] - side["arrival_s"]
        # t(x) = t(0) - x/W + a x^2/(2 W): two times cannot tell a, its range decides alone.
        attenuation = np.array(results["recipe"]["shock"]["attenuation_per_m"])
        bend = 0.5 * span  # d(1/W)/da
        velocity = 1.0 / (span / distance + bend * attenuation.mean())
        report.compare(f"{name} velocity (m/s)", stated["velocity_m_s"], velocity, relative(velocity, 1e-10))
        u_time = np.sqrt(
            side["u_arrival_s"]**2 + side["u_delay_s"]**2 + shot.stated["u_onset_s"]**2)
        curvature = bend * attenuation.mean() / distance
        u = velocity**2 * np.sqrt(((span / distance**2 - curvature) * u_distance)**2
                                  + (u_time / distance)**2
                                  + (bend * np.ptp(attenuation) / np.sqrt(12.0))**2)
        report.compare(f"{name} u(velocity) (m/s)", stated["u_velocity_m_s"], u, relative(u, 1e-6))
        T1, p1 = shot.environment["T1_K"], shot.environment["p1_Pa"]
        gas = stated["driven_gas"]
        state = (velocity, T1, p1, gas["gamma"], gas["molar_mass_kg_mol"])
        p2, p5 = shocked(*state)
        report.compare(f"{name} p2 (Pa)", stated["p2_pa"], p2, relative(p2, 1e-10))
        report.compare(f"{name} step (Pa)", stated["step_pa"], p5 - p1, relative(p5, 1e-10))
        # By differences: velocity, T1, p1, gamma, molar mass; the last two as the budget states them.
        budget = {line["quantity"]: line for line in stated["step_budget"]}
        u_of = (u, shot.environment["u_T1_K"], shot.environment["u_p1_Pa"], budget["gamma"]["u"],
                budget["molar_mass_kg_mol"]["u"])
        squares = 0.0
        for k, u_k in enumerate(u_of):
            ends = []
            for sign in (1.0, -1.0):
                moved = list(state)
                moved[k] += sign * 1e-4 * moved[k]
                ends.append(shocked(*moved)[1] - moved[2])
            squares += ((ends[0] - ends[1]) / (2e-4 * state[k]) * u_k)**2
        u_step = np.sqrt(squares)
        report.compare(f"{name} u(step) (Pa)", stated["u_step_pa"], u_step, relative(u_step, 1e-4))
