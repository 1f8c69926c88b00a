#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether recompute.py notices: one number of results.json after the other is moved, and must come out as OFF.

    tests/audit/moved_numbers.py CAPTURE.h5 FOLDER      as of recompute.py, which must find nothing in them

Prints each number with the lines that were out; exit code 1 where none was, or where one was without a move.
"""

import contextlib
import io
import json
import sys
from pathlib import Path

import h5py

from audit_report import Report
from recompute import Recording, check_results

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


def moves(results):
    """Name -> (place, share)."""
    last = len(results["response"]["frequency_hz"]) - 1
    middle = last // 2
    found = {f"shock[0].{key}": (place("shock", 0, key), A_LITTLE) for key in ("velocity_m_s", "step_pa", "u_step_pa")}
    for key in ("sensitivity", "onset_s"):
        found[f"shots[0].{key}"] = place("shots", 0, key), A_LITTLE
    found["response.phase_rad"] = place("response", "phase_rad", middle), A_LITTLE
    for keys in (("sensitivity", "u"), ("sensitivity", "per_level", 1, "u"), ("shots", 1, "u_sensitivity"),
                 ("shots", 2, "u_level_relative"), ("characteristics", 0, "u"), ("response", "u_common_relative"),
                 ("response", "u_magnitude", 0), ("response", "u_magnitude", last), ("response", "u_phase_rad", middle),
                 ("response", "u_noise_magnitude", middle), ("response", "covariance_re_im", middle, 0),
                 ("response", "u_model_magnitude", middle), ("response", "e_n", middle)):
        found[".".join(map(str, keys))] = place(*keys), OF_U
    for of, quantity in (("sensitivity", "gain_relative"), ("sensitivity", "t1_k"), ("f0_hz", "noise"),
                         ("within_5_percent_hz", "noise"), ("overshoot_percent", "front_unknown"),
                         (f"response.magnitude[{last}]", "front_unknown"), ("response.magnitude[5]", "noise")):
        for key in ("u", "contribution"):
            found[f"budget: {of}, {quantity}, {key}"] = line_of(of, quantity, key), OF_U
    return found


def lines_out(results, folder, recording):
    """Names of what does not agree."""
    for shot, stated in zip(recording.shots, (s for s in results["shots"] if s["included"])):
        shot.stated = stated
    with contextlib.redirect_stdout(io.StringIO()) as text:
        check_results(Report(), results, folder, recording)
    return [line[5:50].strip() for line in text.getvalue().splitlines() if line.startswith("OFF ")]


def main():
    folder = Path(sys.argv[2])
    text = (folder / "results.json").read_text()
    results = json.loads(text)
    missed = 0
    with h5py.File(sys.argv[1]) as capture:
        recording = Recording(capture, results)
        unmoved = lines_out(results, folder, recording)
        print(f"{'OFF ' if unmoved else 'ok  '} nothing moved: {unmoved}")
        for name, (find, share) in moves(results).items():
            moved = json.loads(text)
            holder, key = find(moved)
            holder[key] *= 1.0 + share
            out = lines_out(moved, folder, recording)
            missed += not out
            print(f"{'ok  ' if out else 'OFF '} {name} moved by {share:g}: {len(out)} out, {out[:2]}")
    return 1 if missed or unmoved else 0


if __name__ == "__main__":
    sys.exit(main())
