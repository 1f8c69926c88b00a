#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Leading singular triplets of a Hankel matrix: Dyncal against numpy's dense svd, ARPACK (eigsh) and
PROPACK (svds) on the same record, the latter two with the same FFT product and the same tolerance.

Usage: tests/bench/decomposition_peer.py BUILD_FOLDER [ROUNDS [CASE ...]]
Needs numpy, scipy >= 1.8, g++ and a release build (target dyncal_core). Every run is a process of its
own; the candidates alternate, and medians are printed: wall time, processor time, peak memory. On a
busy machine only the processor time means something. Cases: 4000 100000 stacked million (all).
"""

import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

import numpy as np

TOLERANCE = 1e-8  # of the residual, relative to the value; Dyncal's own
PEER = """
import resource, sys, time
import numpy as np, scipy.fft
from scipy.sparse.linalg import LinearOperator, eigsh, svds
y, name, k = np.fromfile(sys.argv[1]), sys.argv[2], int(sys.argv[3])
wall, used = time.perf_counter(), time.process_time()
m = len(y) // 2 - 1
if name == "numpy":
    i = np.arange(m)
    values = np.linalg.svd(y[i[:, None] + i[None, :]])[1][:k]
else:
    length = scipy.fft.next_fast_len(2 * m - 1, real=True)
    spectrum = scipy.fft.rfft(y[:2 * m - 1], length)
    def times(x):
        return scipy.fft.irfft(spectrum * scipy.fft.rfft(x.ravel(), length).conj(), length)[:m]
    H = LinearOperator((m, m), matvec=times, rmatvec=times, dtype=float)
    if name == "arpack":
        values = np.sort(np.abs(eigsh(H, k, tol=%g)[0]))[::-1]
    else:
        values = np.sort(svds(H, k, solver="propack", tol=%g)[1])[::-1]
wall, used = time.perf_counter() - wall, time.process_time() - used
memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
print(wall, used, memory, len(values), *map(repr, map(float, values)))
""" % (TOLERANCE, TOLERANCE)


def record(samples: int, seed: int) -> np.ndarray:
    """A step response, 30 kHz, zeta 0.05 at 1 MHz, with noise of 1 %."""
    w = 2 * np.pi * 0.03
    wd = w * np.sqrt(1 - 0.05**2)
    t = np.arange(samples)
    step = 1 - np.exp(-0.05 * w * t) * (np.cos(wd * t) + 0.05 * w / wd * np.sin(wd * t))
    return step + 0.01 * np.random.default_rng(seed).normal(size=samples)


def build(folder: pathlib.Path, program: pathlib.Path) -> None:
    source = pathlib.Path(__file__).with_name("decomposition_peer.cpp")
    root = source.parent.parent.parent
    subprocess.run(
        ["g++", "-std=c++20", "-O2", "-I", root, "-isystem", "/usr/include/eigen3", source, "-o", program,
         folder / "core/libdyncal_core.a", "-lfftw3", "-lcrypto", "-lpthread"], check=True)


def run(command: list) -> list[float] | str:
    """The numbers it prints, or the last line of what it complains about."""
    environment = dict(os.environ, SCIPY_USE_PROPACK="1")
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    if done.returncode != 0:
        return (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1]
    return [float(word) for word in done.stdout.split()]


def compare(name: str, commands: dict, rounds: int) -> None:
    """Prints one line per candidate; Dyncal is the first."""
    results = {candidate: [] for candidate in commands}
    for _ in range(rounds):
        for candidate, command in commands.items():
            outcome = run(command)
            if isinstance(outcome, str):
                print(f"{name}, {candidate}: {outcome}")
                return compare(name, {c: words for c, words in commands.items() if c != candidate}, rounds)
            results[candidate].append(outcome)
    medians = {candidate: [statistics.median(r[i] for r in runs) for i in range(3)]
               for candidate, runs in results.items()}
    own = next(iter(commands))
    values = np.array(results[own][0][4:])
    for candidate, (wall, used, memory) in medians.items():
        line = f"{name}, {candidate}: wall {wall:.4f} s, processor {used:.4f} s, memory {memory:.0f} MB"
        if candidate == own:
            line += f", {results[own][0][3]:.0f} of {len(values)} converged"
        else:
            other = np.array(results[candidate][0][4:])
            worst = np.max(np.abs(other / values - 1))
            line += (f"; {wall / medians[own][0]:.1f} x the wall time and {used / medians[own][1]:.1f} x the "
                     f"processor time of {own}; values differ by {worst:.1e} at most")
        print(line, flush=True)
    print(f"load average {os.getloadavg()[0]:.1f}", flush=True)


def main() -> None:
    build_folder = pathlib.Path(sys.argv[1])
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    cases = sys.argv[3:] or ["4000", "100000", "stacked", "million"]
    with tempfile.TemporaryDirectory(dir="/dev/shm") as name:
        folder = pathlib.Path(name)
        program = folder / "decomposition_peer"
        build(build_folder, program)
        file = folder / "records"

        def dyncal(records: int, k: int) -> dict:
            return {"Dyncal": [program, file, str(records), str(k)]}

        def peers(names: list, k: int) -> dict:
            return {peer: [sys.executable, "-c", PEER, file, peer, str(k)] for peer in names}

        if "4000" in cases:
            record(4000, 1).tofile(file)
            for k in (20, 120):
                compare(f"N = 4000, k = {k}", dyncal(1, k) | peers(["numpy", "arpack", "propack"], k), rounds)
        if "100000" in cases:
            record(100_000, 1).tofile(file)
            for k in (20, 120):
                compare(f"N = 100 000, k = {k}", dyncal(1, k) | peers(["arpack", "propack"], k), rounds)
        if "stacked" in cases:
            for samples in (1000, 4000, 10_000, 100_000):
                np.concatenate([record(samples, seed) for seed in (1, 2, 3)]).tofile(file)
                for k in (40, 120):
                    compare(f"N = {samples}, three shots stacked and projected, k = {k}", dyncal(3, k), rounds)
        if "million" in cases:
            record(1_000_000, 1).tofile(file)
            compare("N = 1 000 000, k = 20", dyncal(1, 20), 1)


if __name__ == "__main__":
    main()
