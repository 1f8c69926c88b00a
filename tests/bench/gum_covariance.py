#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""S(f) of a step's record at listed frequencies with its GUM covariance: Dyncal against numpy, the same sums.

Usage: tests/bench/gum_covariance.py BUILD_FOLDER [ROUNDS [SAMPLES [FREQUENCIES]]]
Needs numpy, g++ and a release build (target dyncal_core). For each frequency f: F(f) = sum y_n e^(-jwn),
C(2f) = sum var_n e^(-2jwn), T(f) = sum var_n e^(-jwn) over the last tenth, of which the level is the mean that
continues the record, and C(0); from these S, var Re, cov, var Im follow (docs/method/dft-covariance.md).
numpy in the three ways that it
has for sums at frequencies of any choice:
    exp      e^(-jwn) of 65 536 samples at a time, as the formula is written
    blocks   the record as 1000 rows: a matrix product with e^(-jwm) of one row for all frequencies, then the
             rows turned into place (a rotation from anchors); BLAS does most of the work
    pairs    the same with Dyncal's halving: sums and differences of samples about the middle of each row
Every run is a process of its own; the candidates alternate; medians are printed, and the ratio to the fastest
way of numpy. Dyncal's values are compared with sums in long double at five of the frequencies: numpy's own
are less precise, because it rounds angles of many turns. Exit code 1 where the ratio is more than 0.5, or
Dyncal's values differ from long double by more than 1e-12.
"""

import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

import numpy as np

MOST = 0.5
LARGEST_DIFFERENCE = 1e-12
PEER = """
import sys, time
import numpy as np
file, way, samples, count = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
data = np.fromfile(file)
y, variance, turns = data[:samples], data[samples:2 * samples], data[2 * samples:]

def exponentials(values, r, chunk=65536):
    n = np.arange(chunk)
    total = np.zeros(len(r), complex)
    for first in range(0, len(values), chunk):
        part = values[first:first + chunk]
        for k, one in enumerate(r):
            total[k] += np.exp(-2j * np.pi * one * first) * (part @ np.exp(-2j * np.pi * one * n[:len(part)]))
    return total

def blocks(values, r, length=1000):
    rows = values.reshape(-1, length)
    angle = 2.0 * np.pi * np.outer(np.arange(length), r)
    of_rows = rows @ np.cos(angle) - 1j * (rows @ np.sin(angle))
    first = np.arange(len(rows))[:, None] * length
    return (of_rows * np.exp(-2j * np.pi * ((first * r) % 1.0))).sum(axis=0)

def pairs(values, r, length=1000):
    rows = values.reshape(-1, length)
    half = length // 2
    later, earlier = rows[:, half:], rows[:, half - 1::-1]
    angle = 2.0 * np.pi * np.outer(np.arange(half) + 0.5, r)
    of_rows = (later + earlier) @ np.cos(angle) - 1j * ((later - earlier) @ np.sin(angle))
    middle = np.arange(len(rows))[:, None] * length + (half - 0.5)
    return (of_rows * np.exp(-2j * np.pi * ((middle * r) % 1.0))).sum(axis=0)

sums = dict(exp=exponentials, blocks=blocks, pairs=pairs)[way]
wall, used = time.perf_counter(), time.process_time()
F, C, power = sums(y, turns), sums(variance, 2.0 * turns), variance.sum()
first, m = samples - samples // 10, samples // 10
T = sums(variance[first:], turns) * np.exp(-2j * np.pi * ((first * turns) % 1.0)) / m
V = variance[first:].sum() / m**2
a = 2j * np.pi * turns
b = a * np.exp(-2j * np.pi * ((samples * turns) % 1.0)) / (1.0 - np.exp(-2j * np.pi * turns))
S = a * F + b * y[first:].mean()
P = np.abs(a)**2 * power + np.abs(b)**2 * V + 2.0 * (a * b.conj() * T).real
Q = a**2 * C + b**2 * V + 2.0 * a * b * T
lines = np.column_stack([S.real, S.imag, 0.5 * (P + Q.real), 0.5 * Q.imag, 0.5 * (P - Q.real)])
wall, used = time.perf_counter() - wall, time.process_time() - used
print(wall, used, *map(repr, map(float, lines.ravel())))
"""


def build(folder: pathlib.Path, program: pathlib.Path) -> None:
    source = pathlib.Path(__file__).with_name("gum_covariance.cpp")
    root = source.parent.parent.parent
    subprocess.run(
        ["g++", "-std=c++20", "-O2", "-I", root, "-isystem", "/usr/include/eigen3", source, "-o", program,
         folder / "core/libdyncal_core.a", "-lfftw3", "-lcrypto", "-lpthread"], check=True)


def run(command: list) -> list[float]:
    return [float(word) for word in subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()]


def largest_difference(found: np.ndarray, other: np.ndarray) -> float:
    """Of a value to its size, of a covariance to the sum of both variances."""
    found, other = found.reshape(-1, 5), other.reshape(-1, 5)
    values = np.abs(found[:, :2] - other[:, :2]) / np.linalg.norm(found[:, :2], axis=1)[:, None]
    power = (found[:, 2] + found[:, 4])[:, None]
    return max(values.max(), (np.abs(found[:, 2:] - other[:, 2:]) / power).max())


def in_long_double(y: np.ndarray, variance: np.ndarray, turns: float) -> list[float]:
    """The five numbers of one frequency, from what each sample does to S."""
    n = np.arange(len(y) + 1).astype(np.longdouble)
    r, pi = np.longdouble(turns), np.longdouble("3.14159265358979323846264338327950288")
    angle = 2 * pi * ((n * r) % 1)
    turn = np.cos(angle) - 1j * np.sin(angle)
    weight = turn[:-1] - turn[1:]
    m = len(y) // 10
    weight[-m:] += turn[-1] / m
    weight = weight * (2j * pi * r / (1 - turn[1]))
    S, re, im = (y * weight).sum(), weight.real, weight.imag
    return [float(x) for x in (S.real, S.imag, (variance * re * re).sum(), (variance * re * im).sum(),
                               (variance * im * im).sum())]


def main() -> int:
    build_folder = pathlib.Path(sys.argv[1])
    rounds, samples, count = (int(word) for word in (sys.argv[2:] + ["7", "1000000", "60"][len(sys.argv) - 2:]))
    random = np.random.default_rng(1)
    with tempfile.TemporaryDirectory(dir="/dev/shm") as name:
        program, file = pathlib.Path(name) / "gum_covariance", pathlib.Path(name) / "record"
        build(build_folder, program)
        step = 1.0 - np.exp(-np.arange(samples) / 200.0) * np.cos(0.3 * np.arange(samples))
        noise = 0.01 * (1.0 + 0.5 * np.arange(samples) / samples)  # grows: u differs from sample to sample
        y, variance, turns = step + noise * random.normal(size=samples), noise**2, np.geomspace(1e-4, 0.4, count)
        np.concatenate([y, variance, turns]).tofile(file)
        commands = {"Dyncal": [program, file, str(samples), str(count)]}
        for way in ("exp", "blocks", "pairs"):
            commands[f"numpy, {way}"] = [sys.executable, "-c", PEER, file, way, str(samples), str(count)]
        results = {candidate: [] for candidate in commands}
        for _ in range(rounds):
            for candidate, command in commands.items():
                results[candidate].append(run(command))
    medians = {candidate: [statistics.median(one[i] for one in runs) for i in (0, 1)]
               for candidate, runs in results.items()}
    own = np.array(results["Dyncal"][0][2:])
    for candidate, (wall, used) in medians.items():
        differs = largest_difference(own, np.array(results[candidate][0][2:]))
        print(f"{candidate}: wall {wall:.4f} s, processor {used:.4f} s; Dyncal's wall time is "
              f"{medians['Dyncal'][0] / wall:.3f} of it; values differ by {differs:.1e} at most")
    some = np.linspace(0, count - 1, min(5, count)).astype(int)
    exact = np.array([in_long_double(y, variance, turns[k]) for k in some])
    worst = largest_difference(own.reshape(-1, 5)[some], exact)
    print(f"Dyncal against long double: {worst:.1e} at most (allowed {LARGEST_DIFFERENCE})")
    fastest = min(medians[candidate][0] for candidate in medians if candidate != "Dyncal")
    ratio = medians["Dyncal"][0] / fastest
    print(f"N = {samples}, {count} frequencies, {rounds} rounds: {ratio:.3f} of numpy's fastest (at most {MOST}); "
          f"load average {os.getloadavg()[0]:.1f}")
    return 0 if ratio <= MOST and worst <= LARGEST_DIFFERENCE else 1


if __name__ == "__main__":
    sys.exit(main())
