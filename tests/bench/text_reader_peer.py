#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Reading a CSV: Dyncal against numpy.loadtxt, on the same file, alternating, medians of 5 runs.

Usage: tests/bench/text_reader_peer.py BUILD_FOLDER
Needs numpy, g++ and a release build (target dyncal_core). Each run is a process of its own, so both
start from the same state; only the reading is timed. Prints wall and processor time: on a busy
machine only the latter means something.
"""

import pathlib
import statistics
import subprocess
import sys
import tempfile

import numpy as np

RUNS = 5
ROWS = 1_500_000
LAYOUTS = {"8 decimals": ["%.9e", "%.8f", "%.8f", "%.8f"], "%.9e": "%.9e", "%.18e (numpy's own)": "%.18e"}
PEER = """
import sys, time
import numpy as np
wall, used = time.perf_counter(), time.process_time()
table = np.loadtxt(sys.argv[1], delimiter=",", skiprows=1)
wall, used = time.perf_counter() - wall, time.process_time() - used
print(wall, used, repr(float(table[:, 1:].sum())))
"""


def build(folder: pathlib.Path, program: pathlib.Path) -> None:
    source = pathlib.Path(__file__).with_name("text_reader_peer.cpp")
    root = source.parent.parent.parent
    hdf5 = "/usr/lib/x86_64-linux-gnu/hdf5/serial"
    subprocess.run(
        ["g++", "-std=c++20", "-O2", "-I", root, "-isystem", "/usr/include/eigen3", source, "-o", program,
         folder / "core/libdyncal_core.a", "-L", hdf5, "-lhdf5", "-lfftw3", "-lcrypto", "-lz", "-lpthread"],
        check=True)


def run(command: list) -> tuple[float, float, float]:
    words = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    return float(words[0]), float(words[1]), float(words[2])


def main() -> None:
    build_folder = pathlib.Path(sys.argv[1])
    random = np.random.default_rng(1)
    table = np.column_stack([np.arange(ROWS) * 1e-8, random.normal(size=(ROWS, 3))])
    with tempfile.TemporaryDirectory(dir="/dev/shm") as folder:
        program = pathlib.Path(folder) / "text_reader_peer"
        build(build_folder, program)
        for name, layout in LAYOUTS.items():
            file = pathlib.Path(folder) / "table.csv"
            np.savetxt(file, table, fmt=layout, delimiter=",", header="time (s),a (V),b (V),c (V)", comments="")
            ours, peer = [], []
            for _ in range(RUNS):
                ours.append(run([program, file]))
                peer.append(run([sys.executable, "-c", PEER, file]))
            assert abs(ours[0][2] - peer[0][2]) < 1e-6, "the readers disagree"
            wall = [statistics.median(times[0] for times in side) for side in (ours, peer)]
            used = [statistics.median(times[1] for times in side) for side in (ours, peer)]
            print(f"{name}: {file.stat().st_size / 1e6:.0f} MB, {table.size / 1e6:.0f} M values; "
                  f"wall {wall[0]:.3f} s against {wall[1]:.3f} s ({wall[1] / wall[0]:.1f}x), "
                  f"processor {used[0]:.3f} s against {used[1]:.3f} s ({used[1] / used[0]:.1f}x)")


if __name__ == "__main__":
    main()
