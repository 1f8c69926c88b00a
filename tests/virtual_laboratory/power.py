# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Power of the checks: faults of a given number of the combined u that each check states.

A clean run with the same seed says what u a check has; the same calibration is then made with a fault
of `size` times that u, in the quantity that the check is of.
"""
import copy

from . import judge, make, runner, switches

SIZES = (0.5, 5.0)


def noted_sound_speed(lab, relative):
    lab.noted.t1 *= 1 + 2 * relative


def side_reading(lab, relative):
    for side in lab.sides:
        side.gain *= 1 + relative


def card(lab, relative):
    lab.noted.card *= 1 + relative


def distance(lab, relative):
    lab.noted.distances[0] *= 1 + relative


# A word of a check's `of`, and the fault that moves one of its ways by a relative size.
FAULTS = {"velocity": distance, "arrival": distance, "mach": noted_sound_speed, "p2": side_reading,
          "p5": side_reading, "sensitivity": card, "static": card}


def combined(results):
    """Relative combined u of every check, by the word of FAULTS that its `of` holds; the smallest."""
    sizes = {}
    for check in (results or {}).get("checks") or []:
        for word in FAULTS:
            if word in str(check.get("of")) and check.get("u") and check.get("value_b"):
                size = abs(check["u"] / check["value_b"])
                sizes[word] = min(size, sizes.get(word, size))
    return sizes


def caught(results):
    return bool(judge.causes(results)) if results else True


def study(arguments):
    count, tally = arguments.seeds or 200, {}
    for seed in range(arguments.first_seed, arguments.first_seed + count):
        lab = switches.default(make.generator("power", seed), 3)
        sizes = combined(runner.perform(arguments.program, lab, "power", seed)[0])
        for word, u in sizes.items():
            for size in SIZES:
                faulty = copy.deepcopy(lab)
                FAULTS[word](faulty, size * u)
                found = caught(runner.perform(arguments.program, faulty, "power", seed)[0])
                tally.setdefault((word, size), []).append(found)
        if not sizes:
            return "This version states no checks with an uncertainty."
    lines = ["| check | fault, combined u | runs | caught |", "|---|--:|--:|--:|"]
    return "\n".join(lines + [f"| {w} | {s} | {len(v)} | {100 * sum(v) / len(v):.0f} % |"
                              for (w, s), v in sorted(tally.items())])
