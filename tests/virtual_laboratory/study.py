# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The studies: which conditions, how many seeds, and what is printed of them.

python3 -m virtual_laboratory.study --program build-release/app/dyncal [STUDY...] [--seeds N] [--json FILE]
"""
import argparse
import json
import shutil
import sys
from pathlib import Path

from . import (comparison, correction, coverage, methods, orders, plans, power, readings, runner,
               studies_conditions as sc, tables, unmodelled)
from .conditions_laboratory import CONDITIONS

SPECIAL = {"clean_any", *sc.DRIFT, *sc.STILL, *sc.TUBE, *sc.DAMPING, *sc.NOISE, *sc.FRONT, "bounds_any"}
ORDINARY = [name for name in CONDITIONS if name not in SPECIAL]
SHORT = ["heat_slow", "one_velocity_for_all", "gas_recorded", "humidity_recorded", "rate_doubled",
         "temperature_misread", "pressure_misread", "scale_wrong"]
RESUMABLE = {"coverage": coverage, "comparison": comparison, "unmodelled": unmodelled,
             "methods": methods}  # with lines of `runs`
ALONE = {"power": power, "orders": orders, "correction": correction, **RESUMABLE}  # with tables of their own
# conditions, runs each, quantities
STUDIES = {
    "conditions": (ORDINARY, 40, tables.QUANTITIES),
    "short": (SHORT, 2, tables.QUANTITIES),
    "clean": (["clean_any"], 400, tables.QUANTITIES),
    "onset": ([*sc.DRIFT, *sc.STILL], 40, ("voltage", "sensitivity")),
    "tube": (list(sc.TUBE), 500, ("velocity", "step")),
    "damping": ([*sc.DAMPING, "damping_weak"], 200, ("f0", "zeta", *readings.EDGES)),
    "front": (list(sc.FRONT), 200, ("f0", "zeta")),
    "response": (list(sc.NOISE), 500, ()),
    "bounds": (["bounds_any"], 200, ()),
}


def report(name, records):
    """Markdown of one study."""
    if name == "short":  # rows of S(f), f0 and zeta are the long form's
        return tables.short_table(records)
    if name == "conditions":
        return tables.conditions_table(records) + "\n\n" + tables.cautions_table(records)
    parts = [tables.coverage_table(records, STUDIES[name][2])] if STUDIES[name][2] else []
    for condition, group in tables.by_condition(records).items():
        parts.append(f"{condition}: {tables.cautions_line(group)}")
        if name == "response":
            parts.append(f"{condition}: {tables.rows_coverage(group)}")
        if name == "bounds":
            parts.append(tables.bounds_line(group))
    return "\n\n".join(parts)


def show(done, total, record):
    if sys.stderr.isatty() or done % 50 == 0 or done == total:
        print(f"\r{done}/{total} {record['condition']:<32}", end="", file=sys.stderr, flush=True)


def run(name, arguments):
    conditions, count, _ = STUDIES[name]
    chosen = [c for c in conditions if not arguments.only or c in arguments.only]
    seeds = range(arguments.first_seed, arguments.first_seed + (arguments.seeds or count))
    records = runner.run_all(arguments.program, [(c, s) for c in chosen for s in seeds],
                             arguments.processes, arguments.keep, show)
    print(file=sys.stderr)
    return records


def check(parser, arguments):
    """Ends with what is wrong."""
    other = [name for name in arguments.studies if name not in RESUMABLE]
    unknown = [name for name in other if name not in (*STUDIES, *ALONE)]
    if unknown:
        parser.error(f"no study is named {', '.join(unknown)}; there are {', '.join((*STUDIES, *ALONE))}")
    if (arguments.runs or arguments.only_table or arguments.plan or arguments.judge) and other:
        parser.error(f"--runs, --only-table, --plan and --judge are for {', '.join(RESUMABLE)}, not for {', '.join(other)}")
    if arguments.judge and not plans.planned(arguments.judge):
        parser.error(f"--judge must name the folder of a --plan, not {arguments.judge}")
    if arguments.only_table and not (arguments.runs and Path(arguments.runs).is_file()):
        parser.error("--only-table needs --runs with a file that is there")
    if not (arguments.only_table or arguments.judge) and not shutil.which(arguments.program or ""):
        parser.error(f"--program must name a program that can be run, not {arguments.program}")
    if arguments.runs and not arguments.only_table:
        try:
            open(arguments.runs, "ab").close()
        except OSError as problem:
            parser.error(f"--runs must name a file that can be written: {problem}")


def parse(argv):
    parser = argparse.ArgumentParser(prog="virtual_laboratory.study", description=__doc__)
    parser.add_argument("studies", nargs="*", default=["conditions"],
                        help=f"of {', '.join((*STUDIES, *ALONE))}; conditions unless given")
    parser.add_argument("--program", help="dyncal as built; needed unless --only-table or --judge")
    parser.add_argument("--seeds", type=int, help="runs per condition (each study has its own default)")
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--only", nargs="*", help="only these conditions, or effects of unmodelled")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--keep", help="folder where captures and results stay")
    parser.add_argument("--json", help="every run as JSON")
    parser.add_argument("--runs", metavar="FILE", help=f"lines of {', '.join(RESUMABLE)}: what is there is not "
                        "run again, what is run is appended; the table is of all that it has")
    parser.add_argument("--only-table", action="store_true", help="runs nothing: the table of --runs")
    parser.add_argument("--plan", metavar="FOLDER", help="runs nothing: recordings of what --runs lacks, and their plan for "
                        "dyncal batch")
    parser.add_argument("--judge", metavar="FOLDER", help="runs nothing: takes what dyncal batch has computed of a --plan")
    parser.add_argument("--strict", action="store_true", help="exit code 1 where the table says NO")
    arguments = parser.parse_args(argv)
    check(parser, arguments)
    return arguments


def main(argv=None):
    arguments = parse(argv)
    everything, text = [], []
    if arguments.plan:
        for name in arguments.studies:
            ALONE[name].study(arguments)
        print(plans.finish(arguments.program, arguments.plan))
        return 0
    for name in arguments.studies:
        if name in ALONE:
            text.append(f"## {name}\n\n" + ALONE[name].study(arguments))
        else:
            records = run(name, arguments)
            everything += records
            text.append(f"## {name}\n\n" + report(name, records))
        print(text[-1] + "\n", flush=True)
    if arguments.json:
        Path(arguments.json).write_text(json.dumps(everything, indent=0) + "\n", encoding="utf-8")
    return int(arguments.strict and any("| NO" in part or "no runs" in part for part in text))


def interruptible():
    try:
        return main()
    except KeyboardInterrupt:
        print("\nInterrupted; with --runs the same command goes on where it was.", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(interruptible())
