# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the judge on results made by hand, with and without the keys that older versions lack."""
import copy
import unittest

from virtual_laboratory import judge, power, readings, tables

TRUTH = {"condition": "x", "seed": 1, "causes": ["rate", "gas"], "size": 0.1, "operator": True,
         "judge_shot": None, "sensitivity": 1e-8, "f0_hz": 1e5, "zeta": 0.02, "modes": [(1e5, 0.02, 1.0)],
         "lag_hz": None, "ac_s": None,
         "shots": [{"velocity_m_s": 500.0, "step_pa": 4e5, "gain": 1.0, "level_at_onset": 4e-3}] * 2}


def results():
    shot = {"shot": 1, "included": True, "sensitivity": 1.01e-8, "onset_s": 0.0}
    shock = {"step_pa": 4e5, "u_step_pa": 4e2, "velocity_m_s": 500.0, "u_velocity_m_s": 0.1}
    pole = {"class": "sensor", "im": 0.5, "amplitude": 1.0, "frequency_hz": 1.001e5, "u_frequency_hz": 20.0,
            "damping_ratio": 0.02, "u_damping_ratio": 1e-4, "coverage_factor": 2.0}
    level = {"plateau_gain": 1.0, "u_plateau_gain": 5e-4}
    return {"shots": [shot, {**shot, "shot": 2}], "shock": [shock, shock], "findings": [],
            "model": {"poles": [pole], "order": 2, "per_shot": [level, level]},
            "response": {"frequency_hz": [1e3], "magnitude": [1.0001e-8], "u_magnitude": [1e-12],
                         "phase_rad": [0.0], "u_phase_rad": [1e-3]}}


def caution(*causes, severity="caution"):
    return {"id": "CHK-001", "severity": severity, "cause": list(causes)}


def class_of(r, quantity="sensitivity"):
    return judge.judge(r, TRUTH)["quantities"][quantity]["class"]


class Judge(unittest.TestCase):
    def test_without_the_new_keys(self):
        item = judge.judge(results(), TRUTH)["quantities"]["sensitivity"]
        self.assertAlmostEqual(item["u"] / 1.01e-8, (1e-6 + 0.5 * 25e-8) ** 0.5, delta=1e-9)
        self.assertEqual(item["class"], "silent")
        self.assertEqual(class_of(results(), "step"), "inside")
        self.assertEqual(class_of(results(), "f0"), "silent")

    def test_stated_sensitivity_wins(self):
        r = {**results(), "sensitivity": {"value": 1.01e-8, "u": 6e-11, "k": 2.0, "dof": 50}}
        self.assertEqual(class_of(r), "inside")

    def test_causes(self):
        for finding, word in ((caution("gas"), "right"), (caution("typed", "rate"), "right"),
                              (caution("echo"), "other"), (caution(), "other"),
                              (caution("gas", severity="info"), "silent"),
                              (caution("rate", severity="block"), "right")):
            self.assertEqual(class_of({**results(), "findings": [finding]}), word)

    def test_nothing_stated(self):
        r = copy.deepcopy(results())
        for shot in r["shots"]:
            shot["sensitivity"] = None
        self.assertEqual(class_of(r), "withheld")
        self.assertEqual(class_of({**r, "findings": [caution("gas")]}), "right")

    def test_few_degrees_of_freedom(self):
        self.assertEqual(judge.limit({"dof": 10, "k": 2.0}), 3.0)
        self.assertAlmostEqual(judge.limit({"dof": 2, "k": 4.303}), 99.99 / 4.303, delta=0.01)

    def test_exempt_below_what_the_best_check_sees(self):
        check = {"of": "p2", "value_a": 2e5, "value_b": 2e5, "u": 2e3, "e_n": 0.2}
        seen = judge.judge({**results(), "checks": [check]}, TRUTH)["quantities"]["sensitivity"]
        self.assertTrue(seen["exempt"])  # 1 % off, 4 x 1 % x 1.3 could be seen
        fine = judge.judge({**results(), "checks": [{**check, "u": 20.0}]}, TRUTH)
        self.assertNotIn("exempt", fine["quantities"]["sensitivity"])
        self.assertEqual(power.combined({"checks": [check]}), {"p2": 0.01})

    def test_one_real_pole_of_several_has_no_damping(self):
        pole = {"class": "sensor", "im": 0.0, "re": -3.5e5, "frequency_hz": 5.6e4, "u_frequency_hz": 300.0,
                "damping_ratio": 1.0, "u_damping_ratio": None, "coverage_factor": 2.0, "amplitude": 1.0}
        r = copy.deepcopy(results())
        r["model"]["poles"] = [pole]
        truth = {**TRUTH, "f0_hz": 318e3, "zeta": 3.0, "lag_hz": None}
        self.assertTrue(judge.judge(r, truth)["quantities"]["zeta"]["exempt"])
        self.assertNotIn("exempt", judge.judge(r, {**truth, "zeta": 0.02})["quantities"]["zeta"])

    def test_voltage_without_the_step(self):
        r = copy.deepcopy(results())
        r["shots"][1]["u_sensitivity"] = 1.01e-8 * 2e-3
        item = judge.judge(r, TRUTH)["quantities"]["voltage"]
        self.assertAlmostEqual(item["u"] / item["value"], 3**0.5 * 1e-3, delta=1e-9)

    def test_rows_and_bounds(self):
        r = copy.deepcopy(results())
        self.assertEqual(judge.judge(r, TRUTH)["S(f) magnitude"]["rows"], {"inside": 1, "silent": 0})
        r["response"].update(bound_alias=[1e-12], bound_end=[1e-12])
        self.assertEqual(judge.judge(r, TRUTH)["bounds"], [1, 1])

    def test_band_edges_of_a_second_order_sensor(self):
        truth = {**TRUTH, "zeta": 0.5**0.5, "modes": [(1e5, 0.5**0.5, 1.0)]}  # |S| = 1/sqrt(1 + r^4)
        self.assertAlmostEqual(readings.band_edge(truth, 0.5**0.5, 9.0), 1e5, delta=0.1)
        self.assertAlmostEqual(readings.band_edge(truth, 0.9, 1.1), 1e5 * (1 / 0.81 - 1) ** 0.25, delta=0.1)
        one = {"quantity": "within_10_percent_hz", "value": 7e4, "u": 50.0, "k": 2.0, "dof": None}
        item = judge.judge({**results(), "characteristics": [one]}, truth)["quantities"]["within_10_percent_hz"]
        self.assertEqual(item["class"], "silent")  # 0.8 % off

    def test_table(self):
        record = {"condition": "x", "exit": 0, **judge.judge(results(), TRUTH)}
        failed = {"condition": "x", "exit": 4, "error": "no such key"}
        text = tables.conditions_table([record, failed])
        self.assertIn("| x | step | 2 | 1 | 0 | 0 | 1 | 0 |", text)
        self.assertIn("| x | 2 | 0 | 0 | 0 | 1 | 1 |", tables.cautions_table([record, failed]))


if __name__ == "__main__":
    unittest.main()
