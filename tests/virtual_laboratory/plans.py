# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the long studies as a plan of `dyncal batch`: on any machine or cluster, in any number of shards, the same lines.

A folder has in/ID/ (recordings and recipe: a sensor of the plan), truth/ID.json, reference/ID.csv, planned.jsonl (what
each ID is), plan.jsonl and, once computed, plan.out/.
"""
import json
import os
import re
import shutil
import subprocess
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from . import runner

PLAN, PLANNED, RESULTS = "plan.jsonl", "planned.jsonl", "plan.out"


def name_of(study, cell, seed):
    return re.sub(r"[^\w.+-]+", "_", f"{study} {cell:g} {seed}")


def record(folder, kind, study, cell, seed):
    """Recordings, recipe and truth of one run."""
    name = name_of(study, cell, seed)
    sensor = folder / "in" / name
    sensor.mkdir(parents=True)
    lab, condition = kind.laboratory(cell, seed)
    runner.record(sensor, lab, condition, seed)
    shutil.move(sensor / "truth.json", folder / "truth" / f"{name}.json")
    if (sensor / "reference.csv").exists():  # beside the recording it would be one
        shutil.move(sensor / "reference.csv", folder / "reference" / f"{name}.csv")
        recipe = json.loads((sensor / "recipe.json").read_text("utf-8"))
        recipe["comparison"]["source"] = f"../../reference/{name}.csv"
        (sensor / "recipe.json").write_text(json.dumps(recipe, indent=1), encoding="utf-8")
    return {"id": name, "study": study, "cell": cell, "seed": seed}


def write(folder, kind, tasks, processes):
    """`tasks`: (study, cell, seed). What is planned already stays as it is."""
    folder = Path(folder)
    for part in ("truth", "reference"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    known = {entry["id"] for entry in planned(folder)}
    tasks = [task for task in tasks if name_of(*task) not in known]
    with ProcessPoolExecutor(processes) as pool, open(folder / PLANNED, "a", encoding="utf-8") as file:
        for entry in pool.map(record, *zip(*((folder, kind, *task) for task in tasks))) if tasks else ():
            file.write(json.dumps(entry) + "\n")
            file.flush()


def planned(folder):
    path = Path(folder) / PLANNED
    return [json.loads(line) for line in path.read_text("utf-8").splitlines()] if path.exists() else []


def finish(program, folder):
    """Makes the plan; says how it is computed and judged. RuntimeError where there is none."""
    folder = Path(folder)
    done = subprocess.run([program, "batch", "plan", str(folder / "in"), "-o", str(folder / PLAN)],
                          capture_output=True, text=True, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
    if done.returncode != 0:
        raise RuntimeError(f"{program} batch plan ended with {done.returncode}: {done.stderr.strip()[-400:]}")
    return (f"{len(planned(folder))} runs are planned. Compute them by `{program} batch run {folder / PLAN}` or by what "
            f"`{program} batch script {folder / PLAN} --for slurm` prints, then give --judge {folder}.")


def lines(folder, kind, study):
    """A line as in runs.py of each run of the study that is complete; what was blocked found nothing."""
    folder = Path(folder)
    for entry in planned(folder):
        computed = folder / RESULTS / entry["id"] / "calibration"
        if entry["study"] == study and (computed / "batch.json").exists():
            results = computed / "results.json"
            content = json.loads(results.read_text("utf-8")) if results.exists() else None
            truth = json.loads((folder / "truth" / f"{entry['id']}.json").read_text("utf-8"))
            yield {**{k: entry[k] for k in ("study", "cell", "seed")}, **kind.judged(content, truth)}
