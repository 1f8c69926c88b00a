# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs calibrations of the virtual laboratory through dyncal, several at a time."""
import json
import os
import shutil
import subprocess
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from . import capture_file, judge, laboratory, make


def calibrate(program, folder, extra=()):
    """Exit code and results.json (None where there is none) of `dyncal run` on a written calibration."""
    env = {**os.environ, "OMP_NUM_THREADS": "1", "QT_QPA_PLATFORM": "offscreen"}
    command = ["nice", program, "run", str(folder / "capture.h5"), "--recipe", str(folder / "recipe.json"),
               *extra, "-o", str(folder / "out")]
    done = subprocess.run(command, capture_output=True, text=True, env=env, timeout=600)
    results = folder / "out" / "results.json"
    content = json.loads(results.read_text("utf-8")) if results.exists() else None
    return done.returncode, content, done.stderr.strip()[-400:]


def record(folder, lab, name, seed):
    """Writes recordings, recipe and truth of one calibration; the chance is that of name and seed."""
    records = laboratory.perform(lab, make.generator(name + " records", seed))
    capture_file.write(folder, lab, records, name, seed)


def perform(program, lab, name, seed):
    """results.json and truth of one calibration in this laboratory; the chance is that of name and seed.

    RuntimeError where the program could not be run or was killed: that is no answer of its."""
    with tempfile.TemporaryDirectory(prefix="virtual_laboratory_") as folder:
        record(folder, lab, name, seed)
        truth = json.loads((Path(folder) / "truth.json").read_text("utf-8"))
        code, results, words = calibrate(program, Path(folder))
        if code < 0 or code >= 126:
            raise RuntimeError(f"{program} ended with {code}: {words}")
        return results, truth


def one(program, name, seed, keep=None):
    """One run judged; the folder goes unless `keep` names where it stays."""
    folder = Path(keep) / f"{name}_{seed:03d}" if keep else Path(tempfile.mkdtemp(prefix="virtual_laboratory_"))
    begin = time.monotonic()
    try:
        make.make(name, seed, folder)
        truth = json.loads((folder / "truth.json").read_text("utf-8"))
        code, results, words = calibrate(program, folder)
        record = {"condition": name, "seed": seed, "exit": code}
        if results is None:
            record["error"] = words
        else:
            record.update(judge.judge(results, truth))
        return {**record, "seconds": round(time.monotonic() - begin, 2)}
    finally:
        if not keep:
            shutil.rmtree(folder, ignore_errors=True)


def task(arguments):
    return one(*arguments)


def run_all(program, jobs, processes=2, keep=None, progress=None):
    """jobs: (condition, seed) pairs. Records in the same order."""
    tasks = [(program, name, seed, keep) for name, seed in jobs]
    records = []
    with ProcessPoolExecutor(processes) as pool:
        for record in pool.map(task, tasks):
            records.append(record)
            if progress:
                progress(len(records), len(tasks), record)
    return records
