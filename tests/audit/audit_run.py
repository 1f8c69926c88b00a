# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run: the recording's shots as it used them, the joint fit to them, and what its recipe refers to."""

from pathlib import Path

from audit_fit import JointFit, Shot
from audit_known import known_response
from audit_model import u_of_gain
from audit_report import table
from audit_row import StepRows, TransducerRows
from audit_sensitivity import ShotInputs, budget_of
from audit_transducer import TransducerInputs, common_of_rows, reference_records


class Run:
    """`step_rows`, `transducer_rows`, `by_transducer` (inputs of each shot): of a step response."""

    def __init__(self, report, capture, results, capture_path, folder):
        self.folder = Path(folder)
        # Names in a recipe are relative to it; the folder of a run has a copy of the recipe, not of its files.
        self.places = self.folder, self.folder.parent, Path(capture_path).parent
        self.shots = [Shot(capture[f"shots/{s['shot']:03d}"], s) for s in results["shots"] if s["included"]]
        self.tube = capture["setup/tube"].attrs
        self.is_step = results["input"]["treatment"] != "impulse"
        self.fit = JointFit(self.shots, results["input"]["offset_s"]
                            + (results["input"]["samples"] - 1) / results["input"]["sample_rate_hz"], self.is_step)
        self.windows = [len(table(self.folder / "csv" / f"response_shot_{s.number:03d}.csv")["value"])
                        for s in self.shots]
        recipe = results["recipe"]
        self.chain = self._known(report, results, "chain") if recipe["chain"]["source"] else None
        self.records, self.S_ref = [], None
        if recipe["comparison"]["enabled"]:
            self.S_ref = self._known(report, results, "comparison")
            self.records = reference_records(self.shots, self.windows, recipe["comparison"]["channel"])
        self.take(results)

    def _known(self, report, results, name):
        return known_response(report, name, results["recipe"][name], results[name]["source_sha256"], self.places)

    def take(self, results):
        """What follows from numbers of results.json."""
        self.results = results
        for shot, stated in zip(self.shots, (s for s in results["shots"] if s["included"])):
            shot.stated = stated
        if not self.is_step:
            return
        self.step_rows = StepRows(results, self.windows, self.shots, self.fit, self.chain)
        self.by_transducer = [TransducerInputs(self.fit, i, record, self.S_ref)
                              for i, record in enumerate(self.records)]
        if self.records:
            self.transducer_rows = TransducerRows(results, self.windows, self.shots, self.fit, self.chain,
                                                  self.records, self.S_ref)

    def chain_lowest(self):
        return self.chain and self.chain.lowest()

    def is_by_transducer(self):
        return self.results["response"]["source"] == "transducer"

    def inputs_by_step(self):
        attenuation = self.results["recipe"]["shock"]["attenuation_per_m"]
        return [ShotInputs(shot, i, self.results["shock"][i], self.fit, self.tube, attenuation)
                for i, shot in enumerate(self.shots)]

    def inputs(self):
        return self.by_transducer if self.is_by_transducer() else self.inputs_by_step()

    def steps_Pa(self):
        if self.is_by_transducer():
            return [one.step_Pa for one in self.by_transducer]
        return [shock["step_pa"] for shock in self.results["shock"]]

    def common_of_step(self):
        """What all rows by the step share, relative."""
        return common_of_rows(*budget_of(self.inputs_by_step(), self.chain_lowest()), False)

    def flat_up_to_Hz(self):
        """Where the model leaves 10 %, wherever that is."""
        middle = u_of_gain(self.fit, tuple(self.results["response"]["frequency_hz"]))[2]
        return middle.characteristics(float("inf"))["within_10_percent_hz"]
