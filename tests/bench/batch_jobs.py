#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""A batch on one and on two jobs, and what it takes beside `dyncal run` of each sensor.

Usage: tests/bench/batch_jobs.py PROGRAM [SENSORS [ROUNDS]]      on an idle machine of two cores or more
Simulated sensors of one short record each, in a folder that is removed; 100 trials of the Monte Carlo. In every
round the plan is run from nothing by `--jobs 1` and by `--jobs 2`, and every fifth sensor by `dyncal run`: one
after the other, and by two shells at once, which is what the machine gives to programs that share nothing. Medians
are printed. Exit code 1 where two jobs are less than 1.8 times as fast as one, or where the batch takes more
than 1.05 times the processor time of the single runs.
"""

import json
import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

FASTER, OVERHEAD = 1.8, 1.05
PLAIN_EVERY = 5


def timed(*words):
    """(wall, processor) seconds of a command."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode not in (0, 1):  # 1: with cautions
        sys.exit(f"{' '.join(map(str, words))} ended with {done.returncode}: {done.stderr[-400:]}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.monotonic() - begin, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def prepare(program, folder, count):
    for seed in range(1, count + 1):
        sensor = folder / "in" / f"SN-{seed:04d}"
        sensor.mkdir(parents=True)
        timed(program, "simulate", "--preset", "piezo", "--duration-s", "0.003", "--sample-rate-hz", "1e7",
              "--shots", "low", "--seed", str(seed), "-o", str(sensor / "shot.h5"))
    (folder / "quick.json").write_text(json.dumps({"uncertainty": {"monte_carlo_trials": 100}}))
    timed(program, "batch", "plan", str(folder / "in"), "--recipe", str(folder / "quick.json"),
          "-o", str(folder / "night.jsonl"))


def batch(program, folder, jobs):
    shutil.rmtree(folder / "night.out", ignore_errors=True)
    return timed(program, "batch", "run", str(folder / "night.jsonl"), "--jobs", str(jobs))


def single(program, folder, shells):
    """(wall, processor) seconds for one by `dyncal run`, of every fifth sensor, in so many shells at once."""
    chosen = sorted((folder / "in").iterdir())[::PLAIN_EVERY]
    text = "".join(f'{program} run {sensor} --recipe {folder}/quick.json -o {folder}/plain/{sensor.name} || [ $? = 1 ]\n'
                   for sensor in chosen)
    lines = text.splitlines()
    parts = ["set -e\n" + "\n".join(lines[i::shells]) for i in range(shells)]
    whole = " & ".join(f"sh -c '{part}'" for part in parts) + " & wait"
    seconds = timed("sh", "-c", whole)
    if len(list((folder / "plain").iterdir())) != len(chosen):
        sys.exit("not every single run gave a result")
    shutil.rmtree(folder / "plain")
    return [s / len(chosen) for s in seconds]


def main():
    program = os.path.abspath(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    wall, processor, apart = ({1: [], 2: []} for _ in range(3))
    with tempfile.TemporaryDirectory(prefix="batch_jobs_") as name:
        folder = Path(name)
        prepare(program, folder, count)
        for _ in range(rounds):
            for jobs in (1, 2):
                seconds = batch(program, folder, jobs)
                wall[jobs].append(seconds[0] / count)
                processor[jobs].append(seconds[1] / count)
                apart[jobs].append(single(program, folder, jobs))
    faster, given = ratio(wall), ratio({jobs: [s[0] for s in apart[jobs]] for jobs in apart})
    overhead = {jobs: statistics.median(b / s[1] for b, s in zip(processor[jobs], apart[jobs])) for jobs in (1, 2)}
    for jobs in (1, 2):
        print(f"{count} sensors, --jobs {jobs}: {statistics.median(wall[jobs]) * 1e3:.0f} ms each, "
              f"{statistics.median(processor[jobs]) * 1e3:.0f} ms of processor time, {overhead[jobs]:.3f} times that "
              f"of dyncal run in as many shells ({statistics.median(s[1] for s in apart[jobs]) * 1e3:.0f} ms)")
    print(f"two jobs are {faster:.2f} times as fast as one ({FASTER} wanted), two shells {given:.2f} times")
    return int(faster < FASTER or max(overhead.values()) > OVERHEAD)


def ratio(seconds):
    return statistics.median(one / two for one, two in zip(seconds[1], seconds[2]))


sys.exit(main())
