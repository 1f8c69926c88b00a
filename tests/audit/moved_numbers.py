#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether recompute.py notices: one number of results.json after the other is moved, and must come out as OFF.

    tests/audit/moved_numbers.py [--every N] CAPTURE.h5 FOLDER [WORD...]

File and folder as of recompute.py, which must find nothing in them. With words only the numbers whose name has
one of them; of these the first, and every N-th after it.
Prints each number with the lines that were out; exit code 1 where none was, or where one was without a move.
"""

import argparse
import contextlib
import io
import json
import sys
from pathlib import Path

import h5py

from audit_report import Report
from audit_run import Run
from recompute import check_results

A_LITTLE, OF_U = 3e-4, 0.01


def line_of(of, quantity, key):
    """Place of a number in the budget."""
    return lambda results: next((line, key) for line in results["budget"]
                                if line["of"] == of and line["quantity"] == quantity)


def place(*keys):
    def find(results):
        at = results
        for key in keys[:-1]:
            at = at[key]
        return at, keys[-1]
    return find


def row_moves(results, *section):
    """Of a section with rows: (keys, share)."""
    at, _ = place(*section, "at")(results)
    k = max(i for i, value in enumerate(at["magnitude"]) if value is not None) // 2
    of_u = ["u_magnitude", "u_noise_magnitude", "u_model_magnitude", "e_n", "k_magnitude"]
    found = [((*section, key, k), A_LITTLE) for key in ("magnitude", "model_magnitude")]
    if at["phase_rad"][k] is not None:
        of_u += ["u_phase_rad", "u_noise_phase_rad", "u_model_phase_rad", "k_phase"]
        found.append(((*section, "phase_rad", k), 0.02 * at["u_phase_rad"][k] / at["phase_rad"][k]))
        var_re, _, var_im = at["covariance_re_im"][k]
        found.append(((*section, "covariance_re_im", k, 0 if var_re > var_im else 2), OF_U))
    found += [((*section, key, k), OF_U) for key in of_u] + [((*section, "u_common_relative"), OF_U)]
    return found + [((*section, "dof", k), 0.05)] if at["dof"][k] is not None else found


def moves_of_sections(results):
    """What only some runs have."""
    found = row_moves(results, "response", "marked")
    found.append((("response", "marked", "frequency_hz", 1), A_LITTLE))
    if results["comparison"]:
        found += row_moves(results, "comparison") + row_moves(results, "comparison", "marked")
        found += [(("comparison", key), OF_U) for key in ("difference_relative", "u_difference_relative", "e_n_mean")]
        found.append((("comparison", "e_n_step", 3), OF_U))
    if results["conformity"] and results["conformity"]["worst"]:
        found += [(("conformity", "worst", key), OF_U) for key in ("deviation_percent", "u_percent", "k",
                                                                  "frequency_hz")]
        found.append((("conformity", "rows"), 1.0))
        if results["conformity"]["worst"]["risk_percent"] > 1e-3:
            found.append((("conformity", "worst", "risk_percent"), 0.2))
    return {".".join(map(str, keys)): (place(*keys), share) for keys, share in found}


def moves_of_lines(results, last):
    found = {}
    wanted = [("sensitivity", name) for name in ("gain_relative", "t1_k", "reference_sensitivity_relative",
                                                 "reference_level_relative", "chain_relative", "cmc")]
    wanted += [("f0_hz", "noise"), ("f0_hz", "cmc"), ("within_5_percent_hz", "noise"),
               ("overshoot_percent", "front_unknown"), ("minus_3_db_hz", "mounting_relative"),
               (f"response.magnitude[{last}]", "front_unknown")]
    wanted += [(f"response.{of}[5]", name) for of, names in (
        ("magnitude", ("noise", "chain", "reference_sensitivity", "reference_gain_relative", "cmc")),
        ("phase_rad", ("onset_s", "chain_phase", "reference_phase", "delay_of_reference", "cmc"))) for name in names]
    there = {(line["of"], line["quantity"]) for line in results["budget"]}
    for of, quantity in wanted:
        if (of, quantity) in there:
            for key in ("u", "contribution"):
                found[f"budget: {of}, {quantity}, {key}"] = line_of(of, quantity, key), OF_U
    return found


def moves(results):
    """Name -> (place, share)."""
    last = len(results["response"]["frequency_hz"]) - 1
    middle = last // 2
    found = {f"shock[0].{key}": (place("shock", 0, key), A_LITTLE) for key in ("velocity_m_s", "step_pa", "u_step_pa")}
    for key in ("sensitivity", "onset_s"):
        found[f"shots[0].{key}"] = place("shots", 0, key), A_LITTLE
    found["response.phase_rad"] = place("response", "phase_rad", middle), A_LITTLE
    for keys in (("sensitivity", "u"), ("sensitivity", "per_level", 1, "u"), ("shots", 1, "u_sensitivity"),
                 ("shots", 1, "k_sensitivity"), ("shots", 2, "u_level_relative"), ("characteristics", 0, "u"),
                 ("response", "u_common_relative"), ("response", "u_magnitude", 0), ("response", "u_magnitude", last),
                 ("response", "u_phase_rad", middle), ("response", "u_noise_magnitude", middle),
                 ("response", "covariance_re_im", middle, 0), ("response", "u_model_magnitude", middle),
                 ("response", "e_n", middle)):
        found[".".join(map(str, keys))] = place(*keys), OF_U
    return {**found, **moves_of_sections(results), **moves_of_lines(results, last)}


def lines_out(results, run):
    """Names of what does not agree."""
    run.take(results)
    with contextlib.redirect_stdout(io.StringIO()) as text:
        check_results(Report(), results, run)
    return [line[5:50].strip() for line in text.getvalue().splitlines() if line.startswith("OFF ")]


def chosen(results, words, every):
    """(name, place, share) of the moves asked for."""
    asked = [(name, *move) for name, move in moves(results).items()
             if not words or any(word in name for word in words)]
    return asked[::every]


def parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("capture")
    parser.add_argument("folder")
    parser.add_argument("words", nargs="*")
    return parser.parse_args()


def main():
    arguments = parse()
    text = (Path(arguments.folder) / "results.json").read_text()
    results = json.loads(text)
    missed = 0
    with h5py.File(arguments.capture) as capture:
        run = Run(Report(), capture, results, arguments.capture, arguments.folder)
        unmoved = lines_out(results, run)
        print(f"{'OFF ' if unmoved else 'ok  '} nothing moved: {unmoved}")
        for name, find, share in chosen(results, arguments.words, arguments.every):
            moved = json.loads(text)
            holder, key = find(moved)
            holder[key] *= 1.0 + share
            out = lines_out(moved, run)
            missed += not out
            print(f"{'ok  ' if out else 'OFF '} {name} moved by {share:g}: {len(out)} out, {out[:2]}")
    return 1 if missed or unmoved else 0


if __name__ == "__main__":
    sys.exit(main())
