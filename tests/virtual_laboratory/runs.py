# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the long studies as lines of JSON, so that a study can be interrupted, split and pooled.

A line is {"study", "cell", "seed", "found", "build", "cautions", "seconds"}; `found` is null where the program
gave no result, and "error" is there instead where the run broke down (a time-out): that one is made again. The
file is appended run by run, what is there is not run again, and files of other seeds are joined with cat.
"""
import json
import os
import sys
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Callable, NamedTuple

from . import plans, runner


class Kind(NamedTuple):
    """What a study runs. Its parts go to other processes, so they are functions of a module."""

    laboratory: Callable  # of (cell, seed): the laboratory, and the name of its chance
    judged: Callable  # of (results or None, truth): what a line has of the run

    def __call__(self, program, cell, seed):
        lab, name = self.laboratory(cell, seed)
        return self.judged(*runner.perform(program, lab, name, seed))


def key(line):
    return line["study"], line["cell"], line["seed"]


def is_run(line):
    return (isinstance(line, dict) and isinstance(line.get("study"), str) and isinstance(line.get("seed"), int)
            and isinstance(line.get("cell"), (int, float)) and isinstance(line.get("found"), (dict, type(None))))


def parsed(text):
    """None of what was cut off in the middle of its writing, or is no run."""
    try:
        line = json.loads(text)
    except ValueError:
        return None
    return line if is_run(line) else None


def missing(found, wanted):
    """Never run, or broken down."""
    return "error" in found.get(wanted, {"error": None})


def read(path):
    """Lines by key: the first of each that did not break down."""
    found, broken = {}, 0
    for text in Path(path).read_text("utf-8", "replace").splitlines() if path and Path(path).exists() else []:
        line = parsed(text)
        broken += bool(text.strip()) and line is None
        if line and missing(found, key(line)):
            found[key(line)] = line
    if broken:
        print(f"{path}: {broken} lines are no runs and were left out", file=sys.stderr)
    return found


def append(path, line):
    """At the beginning of a line, even behind one that was cut off."""
    with open(path, "a+b") as file:
        if file.seek(0, os.SEEK_END) and (file.seek(-1, os.SEEK_END), file.read(1))[1] != b"\n":
            file.write(b"\n")
        file.write(json.dumps(line, default=float).encode() + b"\n")


def measured(run, program, study, cell, seed):
    line, begin = {"study": study, "cell": cell, "seed": seed}, time.monotonic()
    try:
        line.update(run(program, cell, seed))
    except Exception as problem:  # whatever it is: the other runs go on, and this one is told
        line["error"] = repr(problem)[:400]
    return {**line, "seconds": round(time.monotonic() - begin, 2)}


def make(arguments, tasks):
    """`tasks`: arguments of `measured`. Yields the lines as they come, each written first."""
    with ProcessPoolExecutor(arguments.processes) as pool:
        futures = [pool.submit(measured, *task) for task in tasks]
        try:
            for future in as_completed(futures):
                line = future.result()
                if arguments.runs:
                    append(arguments.runs, line)
                yield line
        finally:
            pool.shutdown(cancel_futures=True)


def judged_plan(arguments, study, kind, found):
    """Lines of a computed plan that are not there yet; each is written."""
    for line in plans.lines(arguments.judge, kind, study):
        if missing(found, key(line)):
            if arguments.runs:
                append(arguments.runs, line)
            yield line


def collect(arguments, study, kind, cells, count):
    """All lines of a study, in the order of cell and seed: those of the file and, but for `only_table`, new ones: run,
    or taken from a plan (`judge`). With `plan` what is missing is planned in its place.

    `kind`: a Kind, or a function of (program, cell, seed); seeds from first_seed on, `count` unless given."""
    found = {k: line for k, line in read(arguments.runs).items() if k[0] == study and k[1] in cells}
    if arguments.judge:
        found.update((key(line), line) for line in judged_plan(arguments, study, kind, found))
    elif not arguments.only_table:
        seeds = range(arguments.first_seed, arguments.first_seed + (arguments.seeds or count))
        lacking = [(study, cell, seed) for seed in seeds for cell in cells if missing(found, (study, cell, seed))]
        if arguments.plan:
            plans.write(arguments.plan, kind, lacking, arguments.processes)
            lacking = []
        tasks = [(kind, arguments.program, *one) for one in lacking]
        for number, line in enumerate(make(arguments, tasks), 1):
            found[key(line)] = line
            if number % 50 == 0 or number == len(tasks):
                print(f"{study}: {number}/{len(tasks)}", file=sys.stderr, flush=True)
    return [found[k] for k in sorted(found, key=lambda k: (cells.index(k[1]), k[2]))]


def ranges(numbers):
    """'0 to 49, 70'"""
    parts, numbers = [], sorted(set(numbers))
    for n in numbers:
        if parts and n == parts[-1][1] + 1:
            parts[-1][1] = n
        else:
            parts.append([n, n])
    return ", ".join(str(a) if a == b else f"{a} to {b}" for a, b in parts)


def head(lines, cells):
    """What the table is of: runs, seeds, results that are missing, builds, time."""
    each = [sum(line["cell"] == cell for line in lines) for cell in cells]
    number = str(min(each)) if min(each) == max(each) else f"{min(each)} to {max(each)}"
    seconds = [line["seconds"] for line in lines if "seconds" in line]  # those of a plan have none
    builds = Counter(line.get("build") or "unknown" for line in lines)
    return (f"{len(lines)} runs, {number} in each of {len(cells)} cells, seeds {ranges(s['seed'] for s in lines)}; "
            f"{sum(line.get('found') is None for line in lines)} without a result, "
            f"{sum('error' in line for line in lines)} of them broke down; "
            f"build {', '.join(f'{b} ({n})' for b, n in builds.items())}; "
            f"{len(seconds)} single runs took {sum(seconds) / 60:.0f} min")
