# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies as plans of `dyncal batch`: the same lines as runs one by one, in any number of shards. Needs DYNCAL_BINARY."""
import argparse
import contextlib
import io
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from virtual_laboratory import comparison, coverage, plans, runs, study

PROGRAM = os.environ["DYNCAL_BINARY"]
COVERED = runs.Kind(comparison.covered, coverage.judged)


def options(**others):
    return argparse.Namespace(**{"runs": None, "only_table": False, "first_seed": 0, "seeds": None, "processes": 2,
                                 "program": PROGRAM, "plan": None, "judge": None, **others})


def everything(**others):
    """Coverage in two cells, and a comparison with its certificate beside the recording."""
    with contextlib.redirect_stderr(io.StringIO()):
        lines = (runs.collect(options(**others), "coverage", coverage.KIND, [0, 5], 1)
                 + runs.collect(options(**others), "comparison", COVERED, [2], 1))
    return [{k: v for k, v in line.items() if k != "seconds"} for line in lines]


def computed(folder, shards):
    for shard in range(1, shards + 1):
        done = subprocess.run([PROGRAM, "batch", "run", str(folder / plans.PLAN), "--shard", f"{shard}/{shards}",
                               "--jobs", "2"], capture_output=True, text=True)
        if done.returncode > 1:
            raise AssertionError(done.stderr)


def planned(folder):
    lines = everything(plan=folder)
    return lines, plans.finish(PROGRAM, folder)


class Plans(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.whole = cls.folder / "whole"
        planned(cls.whole)
        computed(cls.whole, 1)

    def test_lines_are_those_of_single_runs_in_any_number_of_shards(self):
        expected = everything()
        self.assertEqual(len(expected), 3)
        self.assertTrue(all(line["found"]["S(f), step"] for line in expected))
        self.assertEqual(everything(judge=self.whole), expected)
        parts = self.folder / "parts"
        lines, words = planned(parts)
        self.assertEqual(lines, [])  # nothing is run
        self.assertIn("3 runs are planned", words)
        self.assertEqual(everything(judge=parts), [])  # nothing is computed
        computed(parts, 3)
        self.assertEqual(everything(judge=parts), expected)

    def test_what_is_known_is_neither_planned_nor_judged_again(self):
        before = (self.whole / plans.PLANNED).read_bytes()
        everything(plan=self.whole)
        self.assertEqual((self.whole / plans.PLANNED).read_bytes(), before)
        file = self.folder / "runs.jsonl"
        lines = everything(judge=self.whole, runs=str(file))
        content = file.read_bytes()
        self.assertEqual(everything(judge=self.whole, runs=str(file)), lines)
        self.assertEqual(file.read_bytes(), content)
        nothing = self.folder / "nothing"
        self.assertEqual(everything(plan=nothing, runs=str(file)), lines)
        self.assertEqual(plans.planned(nothing), [])

    def test_wrong_use_is_said(self):
        for words in (["--judge", str(self.folder), "coverage"], ["--plan", "x", "--program", PROGRAM, "power"]):
            with self.assertRaises(SystemExit), contextlib.redirect_stderr(io.StringIO()) as told:
                study.main(words)
            self.assertIn("--plan", told.getvalue())


if __name__ == "__main__":
    unittest.main()
