# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Is a number within its U, cautioned with the right cause, or silently wrong?

inside    |value - true| <= U = k u
right     outside, but a caution or a block names one of the causes that the truth names
other     outside, with a caution or block that names none of them
withheld  nothing is stated, and nothing says why
silent    outside, and the run carries no caution
A value without any u is held against 2 % (`NO_U`). exempt: see `exempt`.
"""
import numpy as np
from scipy.stats import t as student

from . import readings

NO_U = 0.02
QUANTITIES = ("sensitivity", "step", "f0", "zeta")
CLASSES = ("inside", "right", "other", "withheld", "silent")
# What a relative deviation in the quantity of a check means for the step, about d ln step / d ln x;
# of p2 and p5 it is the rise above p1.
STEP_OF = {"velocity": 4.65, "arrival": 4.65, "mach": 4.65, "p2": 1.3, "p5": 1.0, "p4": 0.92,
           "sensitivity": 1.0, "static": 1.0, "nominal": 1.0}


def cautions(results):
    return [f for f in results.get("findings") or [] if f["severity"] in ("caution", "block")]


def causes(results):
    return sorted({c for f in cautions(results) for c in f.get("cause") or []})


def warned(results, truth):
    if set(causes(results)) & set(truth["causes"]):
        return "right"
    return "other" if cautions(results) else None


def named(results, truth):
    """What the cautions say of the cause."""
    words = set(causes(results))
    if words:
        return "right" if words & set(truth["causes"]) else "wrong"
    return "unnamed" if cautions(results) else "none"


def ratio(item):
    """|error| in units of U."""
    u = item["k"] * item["u"] if item["u"] else NO_U * abs(item["true"])
    return abs(item["value"] - item["true"]) / u


def limit(item):
    """The largest silent error allowed, in units of U."""
    if not item["dof"] or item["dof"] >= 10:
        return 3.0
    return float(student.ppf(0.99995, item["dof"])) / item["k"]


# Which checks an operator's mistake moves at all: others cannot see it, however good they are.
SEEN_BY = {"typed": ("velocity", "mach", "p2", "p5", "sensitivity"),
           "distance": ("velocity", "arrival", "mach", "p2", "p5", "sensitivity"),
           "pressure": ("p2", "p5", "sensitivity"), "scale": ("sensitivity",),
           **{cause: ("mach", "p2", "p5", "sensitivity")
              for cause in ("rate", "gas", "temperature", "humidity")}}


def smallest_visible(results, causes):
    """Relative, of the step: four combined u of the best check that the mistake moves; None without one."""
    words = {word for cause in causes for word in SEEN_BY.get(cause, ())}
    sizes = [STEP_OF[word] * abs(c["u"] / c["value_b"]) for c in results.get("checks") or []
             if c.get("u") and c.get("value_b") for word in words if word in str(c.get("of"))]
    return 4 * min(sizes) if sizes else None


def exempt(item, results, truth):
    """An operator's mistake that no check of this run could see."""
    smallest = smallest_visible(results, truth["causes"]) if truth["operator"] and item else None
    return smallest is not None and abs(item["value"] / item["true"] - 1) < smallest


def classify(item, warning):
    if item is None:
        return warning or "withheld"
    return "inside" if ratio(item) <= 1 else warning or "silent"


def judged_shot(truth, results):
    shots = [i for i, s in enumerate(results["shots"]) if s.get("included")]
    if truth["judge_shot"] is not None or not shots:
        return truth["judge_shot"] or 0
    return shots[truth["seed"] % len(shots)]


def stated(results, truth):
    shot = judged_shot(truth, results)
    f0, zeta = readings.poles(results, truth)
    return {"sensitivity": readings.sensitivity(results, truth),
            "step": readings.of_shock(results, truth, shot, "step_pa", "step_dof"), "f0": f0, "zeta": zeta,
            "velocity": readings.of_shock(results, truth, shot, "velocity_m_s", "velocity_dof"),
            "voltage": readings.voltage(results, truth, shot), **readings.bands(results, truth)}


def rows_of(error, u, k, warning):
    """Counts of the rows by class, and what the coverage studies need."""
    use = np.isfinite(error) & np.isfinite(u) & (u > 0)
    if not use.any():
        return None
    z = error[use] / u[use]
    out = np.abs(z) > k[use]
    counts = {"inside": int((~out).sum()), warning or "silent": int(out.sum())}
    worst = float(np.max(np.abs(z) / k[use])) if out.any() and not warning else 0.0
    return {"rows": counts, "worst_silent": worst, "rms_z": float(np.sqrt(np.mean(z**2)))}


def rows_by_frequency(rows, lowest=1e3):
    """[[f, z, k], ...] of the magnitude, for coverage row by row."""
    error, _, k = rows["magnitude"]
    u = rows["noise"]
    use = np.isfinite(error) & (u > 0) & (rows["f"] >= lowest)
    return [[float(f), float(e / s), float(kk)] for f, e, s, kk
            in zip(rows["f"][use], error[use], u[use], k[use])]


def bound_rows(rows):
    """How many rows the two bounds of the record hold, the noise aside: [held, all]; None without bounds."""
    error, _, k = rows["magnitude"]
    u = rows["noise"]
    use = np.isfinite(rows["bound"]) & np.isfinite(error)
    held = np.abs(error[use]) <= rows["bound"][use] + k[use] * np.nan_to_num(u[use])
    return [int(held.sum()), int(use.sum())] if use.any() else None


def judge(results, truth):
    """Everything that the tables need of one run."""
    warning, quantities = warned(results, truth), {}
    for name, item in stated(results, truth).items():
        record = {"class": classify(item, warning)}
        if item:
            record.update(item, ratio=ratio(item), limit=limit(item))
            if exempt(item, results, truth):
                record["exempt"] = True
        elif name == "zeta" and readings.single_pole(results, truth):
            record["exempt"] = True
        quantities[name] = record
    out = {"quantities": quantities, "causes": causes(results), "size": truth["size"],
           "named": named(results, truth),
           "cautions": sorted({f["id"] for f in cautions(results)}), "drift": results.get("drift"),
           "checks": results.get("checks"), "order": readings.get(results, "model", "order"),
           "shots": len(results["shots"])}
    rows = readings.response_rows(results, truth)
    if rows:
        for name in ("magnitude", "phase"):
            out["S(f) " + name] = rows_of(*rows[name], warning)
        out["response_z"], out["bounds"] = rows_by_frequency(rows), bound_rows(rows)
    return out
