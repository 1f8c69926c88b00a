# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the lines of the long studies and of their tables, with runs made by hand."""
import argparse
import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

from virtual_laboratory import comparison, held_table, methods, runs, study, unmodelled

CELLS = [0, 1]


def by_hand(program, cell, seed):
    """Errors over U that a seed and a cell alone decide."""
    if program == "never":
        raise AssertionError("was run again")
    if program == "breaks" and seed == 1:
        raise TimeoutError("600 s")
    return {"found": {"f0_hz": [float(np.sin(3 * seed + cell))]} if seed != 2 else None, "build": "abc"}


def options(path, **others):
    return argparse.Namespace(**{"runs": str(path) if path else None, "only_table": False, "first_seed": 0,
                                 "seeds": None, "processes": 1, "program": "program", "plan": None,
                                 "judge": None, **others})


def quiet(call, *arguments):
    """Its value, and what went to stderr."""
    with contextlib.redirect_stderr(io.StringIO()) as told:
        return call(*arguments), told.getvalue()


def collected(path, **others):
    return quiet(runs.collect, options(path, **others), "by_hand", by_hand, CELLS, 4)[0]


def timeless(lines):
    return [{k: v for k, v in line.items() if k != "seconds"} for line in lines]


class Lines(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_what_is_there_is_not_run_again(self):
        path = self.folder / "runs.jsonl"
        first = collected(path)
        self.assertEqual([runs.key(line) for line in first],
                         [("by_hand", cell, seed) for cell in CELLS for seed in range(4)])
        content = path.read_bytes()
        self.assertEqual(collected(path, program="never"), first)
        self.assertEqual(collected(path, program="never", only_table=True), first)
        self.assertEqual(path.read_bytes(), content)
        self.assertEqual(len(collected(path, seeds=6)), 12)  # two seeds more, in both cells
        self.assertEqual(len(path.read_text().splitlines()), 12)
        self.assertEqual(timeless(collected(None)), timeless(first))  # without a file

    def test_split_and_joined_is_the_whole(self):
        parts = [self.folder / name for name in ("a", "b")]
        for part, seed in zip(parts, (0, 2)):
            collected(part, first_seed=seed, seeds=2)
        joined = self.folder / "joined"
        joined.write_bytes(parts[1].read_bytes() + parts[0].read_bytes() + parts[1].read_bytes())
        self.assertEqual(timeless(collected(joined, only_table=True)), timeless(collected(None)))

    def test_a_line_that_was_cut_off_is_run_again(self):
        path = self.folder / "runs.jsonl"
        whole = collected(path)
        path.write_bytes(path.read_bytes()[:-20])
        left, told = quiet(runs.read, path)
        self.assertEqual(len(left), 7)
        self.assertIn("1 lines are no runs", told)
        self.assertEqual(timeless(collected(path)), timeless(whole))
        self.assertEqual(len(quiet(runs.read, path)[0]), 8)  # the new one did not join the rest of the old

    def test_what_broke_down_is_told_and_run_again(self):
        path = self.folder / "runs.jsonl"
        lines = collected(path, program="breaks")
        self.assertIn("600 s", next(line for line in lines if line["seed"] == 1)["error"])
        self.assertIn("8 runs, 4 in each of 2 cells, seeds 0 to 3; 4 without a result, 2 of them broke down",
                      runs.head(lines, CELLS))
        again = collected(path)
        self.assertFalse(any("error" in line for line in again))
        self.assertEqual(collected(path, program="never"), again)

    def test_what_is_no_run(self):
        for text in ("", "[1]", "{}", '{"study": "a", "cell": [1], "seed": 1}',
                     '{"study": "a", "cell": 1, "seed": "1"}',
                     '{"study": "a", "cell": 1, "seed": 1, "found": 3}', '{"study": "a", "cell": 1'):
            self.assertIsNone(runs.parsed(text))
        path = self.folder / "runs.jsonl"
        path.write_bytes(b'{"study": "by_hand", "cell": 7, "seed": 1, "found": null}\n\xff\xfe\n')
        self.assertEqual(collected(path, only_table=True), [])

    def test_numbers_in_ranges(self):
        self.assertEqual(runs.ranges([3, 0, 1, 2, 7, 9, 8, 20]), "0 to 3, 7 to 9, 20")


def lines_of(values_by_cell, name="f0_hz"):
    return [{"study": "s", "cell": cell, "seed": seed, "found": {name: [float(v)]}}
            for cell, values in values_by_cell.items() for seed, v in enumerate(values)]


def columns(text, name="f0_hz"):
    return next(line for line in text.splitlines() if line.startswith(f"| {name} ")).split(" | ")


class Table(unittest.TestCase):
    def draws(self, u_over_spread=1.0, count=4000):
        return np.random.Generator(np.random.PCG64(5)).standard_normal((2, count)) / (1.959964 * u_over_spread)

    def table(self, values, **others):
        return held_table.table(lines_of(dict(enumerate(values))), CELLS, ["a", "b"], **others)

    def test_normal_errors_are_held_and_u_is_no_larger(self):
        found = columns(self.table(self.draws()))
        self.assertEqual(found[1], "8000")
        for share in found[2:5]:
            self.assertAlmostEqual(float(share), 95.0, delta=1.0)
        self.assertAlmostEqual(float(found[5]), 1.0, delta=0.02)
        self.assertEqual(found[7], "yes |")

    def test_u_too_large_or_too_small(self):
        large = columns(self.table(self.draws(1.3)))
        self.assertAlmostEqual(float(large[5]), 1.3, delta=0.02)
        self.assertEqual((large[7], columns(self.table(self.draws(0.8)))[7]), ("NO |", "NO |"))
        worst = self.draws()
        worst[1] *= 0.5
        self.assertAlmostEqual(float(columns(self.table(worst))[6]), 2.0, delta=0.06)

    def test_short_form_wants_forty_of_fifty_in_every_cell(self):
        for outside, word in ((10, "yes |"), (11, "NO |")):
            values = np.zeros((2, 50)) + 0.5
            values[1, :outside] = 1.5
            self.assertEqual(columns(self.table(values))[7], word)
        few = np.zeros((2, 50)) + 0.5
        text = held_table.table(lines_of({0: few[0], 1: [2.0] * 5}), CELLS, ["a", "b"])
        self.assertEqual(columns(text)[7], "yes |")  # five values say nothing

    def test_few_runs_are_judged_all_together(self):
        for outside, word in ((2, "yes |"), (3, "NO |")):
            values = np.zeros((2, 6)) + 0.5
            values[1, :outside] = 1.5
            self.assertEqual(columns(self.table(values))[7], word)

    def test_unmodelled_wants_ninety_percent_pooled(self):
        values = np.zeros((2, 50)) + 0.5
        values[1, :10] = 1.5
        self.assertEqual(columns(self.table(values, wanted=unmodelled.wanted))[7], "yes |")
        values[1, 10] = 1.5
        self.assertEqual(columns(self.table(values, wanted=unmodelled.wanted))[7], "NO |")

    def test_runs_without_a_result_are_not_held(self):
        lines = lines_of(dict(enumerate(np.zeros((2, 50)) + 0.5)))
        for one in lines[:11]:
            one["found"] = None
        found = columns(held_table.table(lines, CELLS, ["a", "b"]), "a result")
        self.assertEqual(found[1:5] + found[7:], ["100", "89.0", "78.0", "100.0", "NO |"])

    def test_nothing_and_not_a_number(self):
        self.assertEqual(held_table.table([], CELLS, ["a", "b"]), "no runs")
        values = np.zeros((2, 50)) + 0.5
        values[0, 0] = np.nan
        self.assertEqual(columns(self.table(values, wanted=held_table.bands))[7], "NO |")

    def test_agreement(self):
        lines = [{"study": "both_ways", "cell": wrong, "seed": s,
                  "found": {"e_n_mean": e, "u_difference_relative": 5e-3}}
                 for wrong, e in ((0.0, 0.4), (0.03, 3.0), (-0.03, 0.9)) for s in range(20)]
        text = comparison.agreement(lines)
        self.assertIn("| right | 20 | 100.0 % | 0.0 % | 0.80 | 0.50 % | yes |", text)
        self.assertIn("| +3 % | 20 | 0.0 % | 100.0 % | 6.00 | 0.50 % | yes |", text)
        self.assertIn("| -3 % | 20 | 100.0 % | 0.0 % | 1.80 | 0.50 % | NO |", text)


class Words(unittest.TestCase):
    def refused(self, *words):
        with self.assertRaises(SystemExit), contextlib.redirect_stderr(io.StringIO()) as told:
            study.parse(words)
        return told.getvalue()

    def test_what_is_refused(self):
        self.assertIn("--program must name", self.refused("coverage"))
        self.assertIn("no such program", self.refused("coverage", "--program", "no such program"))
        self.assertIn("not for clean", self.refused("clean", "--program", "true", "--runs", "x"))
        self.assertIn("no study is named covrage", self.refused("covrage", "--program", "true"))
        self.assertIn("needs --runs", self.refused("coverage", "--only-table", "--runs", "/no/such/file"))
        self.assertIn("can be written", self.refused("coverage", "--program", "true", "--runs", "/no/such/file"))

    def test_table_alone_needs_no_program(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "runs.jsonl"
            runs.append(path, {"study": "coverage", "cell": 0, "seed": 3, "found": {"f0_hz": [0.2]}})
            with contextlib.redirect_stdout(io.StringIO()) as told:
                self.assertEqual(study.main(["coverage", "--only-table", "--runs", str(path)]), 0)
            self.assertIn("0 to 1 in each of 6 cells, seeds 3", told.getvalue())
            self.assertEqual(json.loads(path.read_text())["seed"], 3)


class Methods(unittest.TestCase):
    TRUTH = {"f0_hz": 100e3, "zeta": 0.05}

    def results(self, *poles):
        keys = ("frequency_hz", "damping_ratio", "im", "amplitude", "class")
        return {"software": {"build": "abc"}, "model": {"poles": [dict(zip(keys, pole)) for pole in poles]}}

    def test_the_largest_pole_that_oscillates_is_judged(self):
        found = methods.judged(self.results((5e3, -1.0, 0.0, 9.0, "step"), (101e3, 0.06, 0.5, 0.5, "sensor"),
                                            (101e3, 0.06, -0.5, 0.5, "sensor"), (300e3, 0.1, 0.2, 0.1, "sensor")), self.TRUTH)
        self.assertAlmostEqual(found["found"]["f0"], 0.01)
        self.assertAlmostEqual(found["found"]["zeta"], 0.2)

    def test_without_one_nothing_is_found(self):
        for results in (None, {"software": {"build": "abc"}, "model": None}, self.results((2.0, -1.0, 0.0, 1.0, "step"))):
            self.assertIsNone(methods.judged(results, self.TRUTH)["found"])

    def test_methods_of_a_seed_have_the_same_records(self):
        names = {methods.laboratory(method, 1, 7)[1] for method in methods.METHODS}
        self.assertEqual(len(names), 1)
        recipes = [methods.laboratory(method, 1, 7)[0].noted.recipe for method in methods.METHODS]
        self.assertEqual(len({str(recipe) for recipe in recipes}), len(methods.METHODS))

    def test_table_has_bias_and_scatter(self):
        lines = [{"cell": 0, "found": {"f0": 0.01 + s, "zeta": 0.2}} for s in (-0.001, 0.001)] + [{"cell": 0, "found": None}]
        row = next(methods.rows("deflated", lines))
        self.assertIn("| deflated | 2 of 3 | +1.0000 ± 0.1000 | +20.0000 ± 0.0000 |", row)


if __name__ == "__main__":
    unittest.main()
