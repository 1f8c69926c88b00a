# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What results.json states, read as a customer would: values with their U beside the truth.

Keys that older versions of the program lack (sensitivity, u_sensitivity, k_sensitivity, cause, checks,
drift, bounds) are read where they are there; without them the parts that are stated are put together.
"""
import numpy as np
from scipy.stats import t as student

from . import laboratory, switches


# The band ends where |S|/S0 first leaves these.
EDGES = {"within_5_percent_hz": (0.95, 1.05), "within_10_percent_hz": (0.9, 1.1),
         "minus_3_db_hz": (0.5**0.5, np.inf)}


def get(tree, *path):
    for key in path:
        if isinstance(tree, dict):
            tree = tree.get(key)
        elif isinstance(tree, list) and isinstance(key, int) and key < len(tree):
            tree = tree[key]
        else:
            return None
    return tree


def factor(dof):
    return float(student.ppf(0.975, dof)) if dof else 1.959964


def entry(value, u, k, true, dof=None):
    if value is None:
        return None
    return {"value": value, "u": u, "k": k, "true": true, "dof": dof}


def relative_step_u(results, shot):
    step, u = get(results, "shock", shot, "step_pa"), get(results, "shock", shot, "u_step_pa")
    return u / step if step and u is not None else None


def plateau_u(results, shot):
    """Relative, of the level alone; from the fit to the shot alone, or of the second order."""
    for shots in (get(results, "model", "per_shot"), get(results, "model", "second_order", "shots")):
        level, u = get(shots, shot, "plateau_gain"), get(shots, shot, "u_plateau_gain")
        if level and u is not None:
            return u / abs(level)
    return None


def sensitivity(results, truth):
    stated = get(results, "sensitivity")
    if isinstance(stated, dict):
        return entry(stated.get("value"), stated.get("u"), stated.get("k") or 2.0, truth["sensitivity"],
                     stated.get("dof"))
    each = [s for s in results["shots"] if s.get("included") and s.get("sensitivity") is not None]
    if not each:
        return None
    value = float(np.mean([s["sensitivity"] for s in each]))
    shots = [s["shot"] - 1 for s in each]
    steps = [relative_step_u(results, i) for i in shots]
    levels = [plateau_u(results, i) for i in shots]
    if None in steps or None in levels:
        return entry(value, None, 2.0, truth["sensitivity"])
    u = abs(value) * np.hypot(np.mean(steps), np.linalg.norm(levels) / len(levels))
    return entry(value, float(u), 2.0, truth["sensitivity"])


def voltage(results, truth, shot):
    """The level at the onset over the true one: what the record gives, without the step."""
    s, step = get(results, "shots", shot, "sensitivity"), get(results, "shock", shot, "step_pa")
    if s is None or step is None:
        return None
    value, true = s * step, truth["shots"][shot]["level_at_onset"]
    u, common = get(results, "shots", shot, "u_sensitivity"), relative_step_u(results, shot)
    part = get(results, "shots", shot, "u_level_relative")
    if part is None and u is not None and common is not None:  # as older versions have it
        part = np.sqrt(max((u / s) ** 2 - common**2, 0.0))
    elif part is None:
        part = plateau_u(results, shot)
    return entry(value, None if part is None else float(part * abs(value)), 2.0, true)


def of_shock(results, truth, shot, key, dof_key):
    shock = get(results, "shock", shot) or {}
    dof = shock.get(dof_key)
    return entry(shock.get(key), shock.get("u_" + key), factor(dof), truth["shots"][shot][key], dof)


def main_poles(results):
    """The oscillating pole of the sensor that rings longest and strongest, else its real poles."""
    poles = [p for p in get(results, "model", "poles") or [] if p["class"] == "sensor"]
    ringing = [p for p in poles if p["im"] > 0 and p["damping_ratio"]]
    def weight(p):
        return (p["amplitude"] or 0) ** 2 / (p["frequency_hz"] * abs(p["damping_ratio"]))
    return max(ringing, key=weight) if ringing else None, [p for p in poles if p["im"] == 0]


def slow_pole_hz(truth):
    f0, zeta = truth["f0_hz"], truth["zeta"]
    rates = [f0 * (zeta - np.sqrt(zeta**2 - 1))] if zeta >= 1 else []
    return min(rates + ([truth["lag_hz"]] if truth["lag_hz"] else []), default=None)


def poles(results, truth):
    """(f0, zeta); at order 1 the pole is held against the slowest of the truth."""
    main, real = main_poles(results)
    if main:
        k = main.get("coverage_factor") or 2.0
        return (entry(main["frequency_hz"], main["u_frequency_hz"], k, truth["f0_hz"]),
                entry(main["damping_ratio"], main["u_damping_ratio"], k, truth["zeta"]))
    second = get(results, "model", "second_order")
    if len(real) == 2 and isinstance(second, dict):
        k = second.get("coverage_factor") or 2.0
        a, b = (p["frequency_hz"] for p in real)
        return (entry(np.sqrt(a * b), second.get("u_f0_hz"), k, truth["f0_hz"]),
                entry((a + b) / 2 / np.sqrt(a * b), second.get("u_zeta"), k, truth["zeta"]))
    if len(real) == 1 and slow_pole_hz(truth):
        k = real[0].get("coverage_factor") or 2.0
        return entry(real[0]["frequency_hz"], real[0]["u_frequency_hz"], k, slow_pole_hz(truth)), None
    return None, None


def single_pole(results, truth):
    """Whether one real pole stands for a sensor of several: then only it is held against the truth."""
    main, real = main_poles(results)
    return main is None and len(real) == 1 and slow_pole_hz(truth) is not None


def true_response(truth, frequencies):
    dut = switches.Dut(modes=truth["modes"], lag_hz=truth["lag_hz"], ac_s=truth["ac_s"])
    return truth["sensitivity"] * laboratory.dut_system(dut).response(frequencies)


def band_edge(truth, lowest, highest):
    """The lowest frequency at which |S|/S0 leaves lowest .. highest, to 1e-7."""
    def inside(f):
        ratio = abs(true_response(truth, np.atleast_1d(f))) / truth["sensitivity"]
        return (ratio >= lowest) & (ratio <= highest)
    grid = truth["f0_hz"] * np.geomspace(1e-2, 10, 3000)
    first = int(np.argmin(inside(grid)))
    low, high = grid[first - 1], grid[first]
    while high - low > 1e-7 * low:
        middle = (low + high) / 2
        low, high = (middle, high) if inside(middle)[0] else (low, middle)
    return low


def stated_characteristics(results, true):
    """Entries of `characteristics` by the name of those in `true`."""
    return {one["quantity"]: entry(one["value"], one["u"], one["k"], true[one["quantity"]], one["dof"])
            for one in results.get("characteristics") or [] if one["quantity"] in true and one["value"] is not None}


def bands(results, truth):
    """The edges; of a model with one pole where the sensor has several, none: they are the model's."""
    if single_pole(results, truth):
        return {}
    return stated_characteristics(results, {name: band_edge(truth, *limits) for name, limits in EDGES.items()})


def response_rows(results, truth):
    """Arrays f, error, u, k of the magnitude (relative to the true step), and of the phase; u of the noise alone."""
    answer = results.get("response") or {}
    f = answer.get("frequency_hz") or []
    shots = [i for i, s in enumerate(results["shots"]) if s.get("included")]
    steps = [(get(results, "shock", i, "step_pa"), truth["shots"][i]) for i in shots]
    if not f or any(step is None for step, _ in steps):
        return None
    # S is the mean over the shots of what each has over its step.
    ratio = 1 / np.mean([true["step_pa"] * true["gain"] / step for step, true in steps])
    def column(name):
        return np.array([np.nan if v is None else v for v in answer.get(name) or [None] * len(f)], float)
    true = true_response(truth, f)
    magnitude, u = column("magnitude"), column("u_magnitude")
    common = answer.get("u_common_relative") or 0.0
    part = np.sqrt(np.maximum(u**2 - (common * magnitude) ** 2, 0))
    noise = column("u_noise_magnitude")
    noise = np.where(np.isfinite(noise), noise, part)
    k, k_phase = (np.where(np.isfinite(column(n)), column(n), 2.0) for n in ("k_magnitude", "k_phase"))
    u_phase = column("u_phase_rad")
    return {"f": np.array(f), "magnitude": (magnitude * ratio - abs(true), part * ratio, k),
            "phase": (np.angle(np.exp(1j * (column("phase_rad") - np.angle(true)))), u_phase, k_phase),
            "noise": noise * ratio, "bound": (column("bound_alias") + column("bound_end")) * ratio, "true": true}
