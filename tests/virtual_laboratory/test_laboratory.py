# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the laboratory itself: python3 -m unittest virtual_laboratory.test_laboratory (from tests/)."""
import unittest

import numpy as np
from scipy.integrate import solve_ivp
from scipy.signal import lsim, welch

from virtual_laboratory import (coverage, gases, laboratory, make, recorder, response, switches, unmodelled,
                                waves)

# NACA report 1135, table II (gamma 1.4): M, p2/p1, rho2/rho1, T2/T1.
NACA = ((1.05, 1.120, 1.084, 1.033), (1.20, 1.513, 1.342, 1.128), (1.50, 2.458, 1.862, 1.320),
        (2.00, 4.500, 2.667, 1.687), (3.00, 10.33, 3.857, 2.679))


def air(gamma=1.4, a=340.0, t=293.15):
    return gases.Gas(gamma, gamma * gases.R * t / a**2, a, t)


class Waves(unittest.TestCase):
    def test_normal_shock_table(self):
        for mach, pressure, density, temperature in NACA:
            s = waves.shock(mach * 340.0, air(), 1.0)
            self.assertAlmostEqual(s.p2 / pressure, 1, delta=6e-4)
            self.assertAlmostEqual(mach * 340 / (mach * 340 - s.u2) / density, 1, delta=6e-4)
            self.assertAlmostEqual((s.a2 / 340) ** 2 / temperature, 1, delta=6e-4)

    def test_reflection_closed_forms(self):
        g = 1.402
        for mach in (1.01, 1.2, 1.4906, 2.5):
            s = waves.shock(mach * 340.0, air(g), 101100.0)
            r = 1 + 2 * g / (g + 1) * (mach**2 - 1)
            self.assertAlmostEqual(s.p2 / (101100 * r), 1, delta=1e-12)
            reflected = ((3 * g - 1) * r - (g - 1)) / ((g - 1) * r + g + 1)
            self.assertAlmostEqual(s.p5 / s.p2 / reflected, 1, delta=1e-12)

    def test_conservation_across_both(self):
        g, s = 1.4, waves.shock(520.0, air(), 1e5)
        rho1, rho2, rho5 = g * 1e5 / 340**2, g * s.p2 / s.a2**2, g * s.p5 / s.a5**2
        w2, v = 520 - s.u2, s.reflected_velocity + s.u2
        def enthalpy(a):
            return a**2 / (g - 1)
        for ahead, behind in ((rho1 * 520, rho2 * w2), (1e5 + rho1 * 520**2, s.p2 + rho2 * w2**2),
                              (enthalpy(340) + 520**2 / 2, enthalpy(s.a2) + w2**2 / 2),
                              (rho2 * v, rho5 * s.reflected_velocity),
                              (s.p2 + rho2 * v**2, s.p5 + rho5 * s.reflected_velocity**2),
                              (enthalpy(s.a2) + v**2 / 2, enthalpy(s.a5) + s.reflected_velocity**2 / 2)):
            self.assertAlmostEqual(behind / ahead, 1, delta=1e-12)

    def test_driver_and_plateau(self):
        s = waves.shock(3 * 340.0, air(), 1.0)  # 632.627 at M 3, the same gas on both sides
        self.assertAlmostEqual(waves.driver_pressure(s, 1.4, 340.0), 632.627366, delta=1e-4)
        tube = waves.shock(512.82, air(1.402, 344.0577), 101100.0)
        self.assertAlmostEqual(waves.plateau(tube, 0.97), 1.626e-3, delta=1e-6)

    def test_travel_with_attenuation(self):
        travel = waves.Travel(500.0, 0.008)
        path = solve_ivp(lambda t, x: -travel.velocity(x), (0, travel.time_to_wall(0.8)), [0.8],
                         rtol=1e-11, atol=1e-13)
        self.assertAlmostEqual(path.y[0, -1], 0.0, delta=1e-9)
        self.assertAlmostEqual(waves.Travel(500.0, 1e-9).time_to_wall(0.8), 0.8 / 500, delta=1e-11)

    def test_other_laws_of_attenuation(self):
        for a in (0.01, -0.005, 0.3):  # the integrals of dx/W in closed form
            root, far = np.sqrt(complex(a)), 0.8
            exact = {"exponential": (1 - np.exp(-a * far)) / a, "early": (np.arctan(root * far) / root).real,
                     "late": (np.arctanh(root / np.sqrt(1 + a)) - np.arctanh(root * (1 - far) / np.sqrt(1 + a))).real
                     / (root * np.sqrt(1 + a)).real if a > 0 else None}
            for law, time in exact.items():
                if time is not None:
                    found = waves.Travel(500.0, a, law, 1.0).time_to_wall(far)
                    self.assertAlmostEqual(found * 500 / time, 1, delta=1e-12)
        for law in waves.LAWS:
            whole = waves.Travel(500.0, 0.004, law, 0.97)
            self.assertEqual(whole.velocity(0.0), 500.0)
            self.assertAlmostEqual(whole.velocity(0.97), 500 * (1 + 0.004 * 0.97), delta=0.005)
        slopes = [waves.Travel(1.0, 0.01, law).velocity(1e-6) - 1 for law in ("linear", "early", "late")]
        for slope, expected in zip(slopes, (1e-8, 0.0, 2e-8)):
            self.assertAlmostEqual(slope, expected, delta=1e-13)

    def test_a_law_that_is_linear_changes_no_arrival(self):
        by_sum = waves.Travel(480.0, 0.01, "exponential", 0.97).time_to_wall(0.5)
        self.assertAlmostEqual(by_sum, waves.Travel(480.0, 0.01).time_to_wall(0.5), delta=0.5 / 480 * 0.01**2)


class Gases(unittest.TestCase):
    def test_humid_air_against_measured_sound_speeds(self):
        # Cramer, J. Acoust. Soc. Am. 93 (1993) 2510, at 101.1 kPa: an independent source.
        for t, h, a in ((20, 0, 343.3594), (20, 0.5, 343.9882), (21, 0, 343.9432), (21, 1, 345.2829)):
            self.assertAlmostEqual(gases.humid_air(t + 273.15, 101100, h).sound_speed / a, 1, delta=1.5e-4)

    def test_pure_gases(self):
        self.assertAlmostEqual(gases.mixture({"ar": 1}, 293).gamma, 5 / 3, delta=1e-12)
        # NIST-JANAF tables, 298.15 K, J/(mol K); stretching and anharmonicity are not modelled.
        for name, cp in (("n2", 29.124), ("o2", 29.376), ("co2", 37.129), ("h2o", 33.590)):
            self.assertAlmostEqual(gases.heat_capacity({name: 1}, 298.15) * gases.R / cp, 1, delta=4e-3)
        self.assertAlmostEqual(gases.molar_mass(gases.DRY_AIR), 0.028965, delta=2e-6)
        self.assertAlmostEqual(gases.saturation_pressure(293.15) / 2339.2, 1, delta=1e-4)


def sensor():
    dut = switches.Dut(modes=[(30e3, 0.05, 1.0), (110e3, 0.2, 0.1)], lag_hz=90e3, ac_s=1e-3,
                       heat=[(0.03, 2e-4)])
    return laboratory.dut_system(dut)


class Response(unittest.TestCase):
    def test_second_order_step(self):
        pressure = response.Pressure()
        pressure.step(3.7e-8, 2.0)
        for zeta in (0.02, 0.7, 1.0, 3.0):
            t = np.arange(20000) * 1e-7
            y = response.sampled(response.mode(318e3, zeta), pressure, 0.0, 1e-7, len(t))
            s, w = np.maximum(t - 3.7e-8, 0), 2 * np.pi * 318e3
            if zeta == 1.0:
                exact = 2 * (1 - np.exp(-w * s) * (1 + w * s))
            else:
                root = np.sqrt(complex(zeta**2 - 1))
                a, b = -w * (zeta - root), -w * (zeta + root)
                exact = 2 * (1 + (b * np.exp(a * s) - a * np.exp(b * s)) / (a - b)).real
            self.assertLess(np.abs(y - exact).max(), 1e-9)

    def test_against_lsim_and_ode(self):
        system, pressure = sensor(), response.Pressure()
        pressure.ramp(2.00e-5, 1.0, 1.0e-5)
        pressure.relax(6.0e-5, -0.4, 5e-5)
        t = np.arange(0, 2e-4, 5e-8)
        y = response.sampled(system, pressure, 0.0, 5e-8, len(t))
        def p(s):
            late = np.maximum(s - 6e-5, 0)
            return np.clip((s - 1.5e-5) / 1e-5, 0, 1) - 0.4 * (1 - np.exp(-late / 5e-5))
        _, by_lsim, _ = lsim((system.A, system.B[:, None], system.C[None], [[system.D]]), p(t), t)
        self.assertLess(np.abs(y - by_lsim).max(), 2e-4)  # lsim draws straight lines between samples
        ode = solve_ivp(lambda s, x: system.A @ x + system.B * p(s), (0, t[-1]), np.zeros(len(system.A)),
                        "Radau", t_eval=t, rtol=1e-9, atol=1e-12, max_step=5e-7)
        self.assertLess(np.abs(y - (system.C @ ode.y + system.D * p(t))).max(), 1e-6)

    def test_frequency_response_is_that_of_the_step(self):
        system = response.mode(30e3, 0.3)
        pressure = response.Pressure()
        pressure.step(0.0, 1.0)
        y = response.sampled(system, pressure, 0.0, 1e-8, 40000)
        f = np.array([1e3, 2e4, 5e4])
        d, k = np.diff(y), np.arange(len(y) - 1) + 0.5
        by_step = np.exp(-2j * np.pi * f[:, None] * k * 1e-8) @ d / np.sinc(f * 1e-8)
        self.assertLess(np.abs(by_step / system.response(f) - 1).max(), 1e-5)

    def test_fronts_of_another_shape(self):
        w, zeta, rise, begin = 2 * np.pi * 40e3, 0.2, 8e-6, 3.3e-7
        t = np.arange(4000) * 1e-8
        pressures = {}
        for kind in ("exponential", "half_sine"):
            pressure = response.Pressure()
            pressure.front(1e-5 + begin, 2.0, kind, rise)
            seen = response.sampled(response.mode(1e9, 1.0), pressure, 0.0, 1e-8, len(t))  # the pressure itself
            low, high = np.interp([0.2, 1.8], seen[:3000], t[:3000])
            self.assertAlmostEqual((high - low) / rise, 1, delta=2e-3)
            self.assertAlmostEqual(np.sum(2.0 - seen) * 1e-8 / 2, 1e-5 + begin, delta=4e-8)  # the mean of the front
            pressures[kind] = response.sampled(response.mode(40e3, zeta), pressure, 0.0, 1e-8, len(t))
        tau = rise / np.log(9)
        root = w * (-zeta + 1j * np.sqrt(1 - zeta**2))
        def by_parts(residues, s):  # sum of r e^(p s): the inverse of a rational function
            return sum(r * np.exp(p * np.maximum(s, 0)) for p, r in residues).real * (s >= 0)
        poles = [0.0, -1 / tau, root, root.conjugate()]
        exact = by_parts([(p, 2 / tau * w**2 / np.prod([p - q for q in poles if q != p])) for p in poles],
                         t - (1e-5 + begin - tau))
        self.assertLess(np.abs(pressures["exponential"] - exact).max(), 1e-9)
        length = rise * np.pi / (np.arccos(-0.8) - np.arccos(0.8))
        turn = 1j * np.pi / length  # (1 - cos)/2 is (-turn^2/2)/(s (s^2 - turn^2)), twice: the second one later
        poles = [0.0, turn, -turn, root, root.conjugate()]
        parts = [(p, -2 * turn**2 / 2 * w**2 / np.prod([p - q for q in poles if q != p])) for p in poles]
        first = 1e-5 + begin - length / 2
        exact = by_parts(parts, t - first) + by_parts(parts, t - first - length)
        self.assertLess(np.abs(pressures["half_sine"] - exact).max(), 1e-9)

    def test_wall_that_the_step_shakes(self):
        f, zeta, share = 7e3, 0.03, 0.005
        t, w = np.arange(30000) * 1e-7, 2 * np.pi * 7e3
        pressure = response.Pressure()
        pressure.step(2.3e-8, 4e5)
        y = response.sampled(response.mount(share, f, zeta), pressure, 0.0, 1e-7, len(t)) / 4e5
        s, damped = t - 2.3e-8, w * np.sqrt(1 - zeta**2)
        ring = np.exp(-zeta * w * s) * (np.cos(damped * s) - zeta * w / damped * np.sin(damped * s))
        self.assertLess(np.abs(y - np.where(s >= 0, 1 + share * ring, 0)).max(), 1e-9)
        force, mass, feels = 3e3, 4.0, 1.2  # a wall of one mode in m/s^2, by its own equation
        wall = solve_ivp(lambda _, x: [x[1], force / mass - w**2 * x[0] - 2 * zeta * w * x[1]], (0, 1e-3), [0, 0],
                         t_eval=[0, 1e-4, 5e-4, 1e-3], rtol=1e-11, atol=1e-14)
        by_wall = feels * (force / mass - w**2 * wall.y[0] - 2 * zeta * w * wall.y[1])
        at = wall.t
        closed = np.exp(-zeta * w * at) * (np.cos(damped * at) - zeta * w / damped * np.sin(damped * at))
        self.assertLess(np.abs(by_wall - feels * force / mass * closed).max(), 1e-4)

    def test_mount_is_in_the_record_and_not_in_the_truth(self):
        dut = switches.Dut(mount=(0.005, 7e3, 0.03))
        self.assertTrue(np.array_equal(laboratory.dut_system(dut, disturbed=False).response([7e3]),
                                       laboratory.dut_system(switches.Dut()).response([7e3])))
        ratio = laboratory.dut_system(dut).response([7e3]) / laboratory.dut_system(switches.Dut()).response([7e3])
        self.assertAlmostEqual(abs(ratio[0] - (1 + 0.005j / 0.06)), 0, delta=1e-12)

    def test_seat_adds_to_the_level_and_does_not_ring(self):
        plain, dut = switches.Dut(lag_hz=None), switches.Dut(seat=1e-3)
        self.assertTrue(np.array_equal(laboratory.dut_system(dut, disturbed=False).response([7e3]),
                                       laboratory.dut_system(plain).response([7e3])))
        f = [1e2, 3e5, 2e6]
        added = laboratory.dut_system(dut).response(f) - laboratory.dut_system(plain).response(f)
        self.assertLess(np.abs(added - 1e-3).max(), 1e-15)

    def test_sweep_is_the_covered_share_of_a_disc(self):
        pressure = response.Pressure()
        pressure.sweep(0.0, 1.0, 2.0, 400)
        for x in (-0.9, -0.3, 0.0, 0.5):
            share = 0.5 + (x * np.sqrt(1 - x * x) + np.arcsin(x)) / np.pi
            seen = sum(e[1] for e in pressure.events if e[0] <= x)
            self.assertAlmostEqual(seen, share, delta=4e-3)

    def test_level_at_the_onset_with_heat(self):
        system = laboratory.dut_system(switches.Dut(heat=[(0.05, 1e-4)]))
        pressure = response.Pressure()
        pressure.step(0.0, 1.0)
        late = response.sampled(system, pressure, 0.0, 1e-5, 200)
        self.assertAlmostEqual(late[-1], 0.95, delta=1e-8)  # 1.99 ms: 20 time constants


class Recorder(unittest.TestCase):
    def test_spectra(self):
        rng = make.generator("spectra", 1)
        n = 2**18
        ar = recorder.autoregressive(rng, n)
        self.assertAlmostEqual(ar.std(), 1, delta=0.02)
        f, power = welch(ar, nperseg=1024)
        exact = 2 * 0.19 / np.abs(1 - 0.9 * np.exp(-2j * np.pi * f)) ** 2
        self.assertLess(np.abs(power[5:-5] / exact[5:-5] - 1).max(), 0.4)
        self.assertAlmostEqual(np.mean(power[5:-5] / exact[5:-5]), 1, delta=0.03)
        one_over_f = recorder.flicker(rng, n)
        f, power = welch(one_over_f, nperseg=4096)
        slope = np.polyfit(np.log(f[8:-8]), np.log(power[8:-8]), 1)[0]
        self.assertAlmostEqual(slope, -1, delta=0.05)
        spread = [recorder.flicker(rng, 4096).std() for _ in range(200)]
        self.assertTrue(0.6 < np.mean(spread) < 1.0)  # below 1: the slowest part is a mean of the record

    def test_converter(self):
        values = np.array([-2.0, -1.0, 0.0, 0.4e-3, 0.7e-3, 0.5, 2.0])
        codes, code = recorder.counts(values, 1.0, 12)
        self.assertEqual(code, 2.0 / 4096)
        self.assertEqual(codes.tolist(), [-2048, -2048, 0, 1, 1, 1024, 2047])
        bowed, _ = recorder.counts(np.array([-1.0, 0.0, 0.5]), 1.0, 14, bow_codes=4.0)
        self.assertEqual(bowed.tolist(), [-8192, 4, 4099])
        self.assertEqual(recorder.range_for(0.0102), 0.02)
        noise = recorder.counts(np.linspace(-0.9, 0.9, 100001), 1.0, 10)
        error = noise[0] * noise[1] - np.linspace(-0.9, 0.9, 100001)
        self.assertAlmostEqual(error.std() / noise[1], 12**-0.5, delta=2e-3)


class Calibration(unittest.TestCase):
    def test_same_seed_same_record(self):
        def counts(seed):
            rng = make.generator("clean", seed)
            return laboratory.perform(switches.default(rng), rng)[0].channels[0].counts
        self.assertTrue(np.array_equal(counts(3), counts(3)))
        self.assertFalse(np.array_equal(counts(3), counts(4)))

    def test_side_sensor_is_late_by_the_share_of_its_rise(self):
        lab = switches.default(make.generator("late", 1), 1)
        side, gas = lab.sides[0], laboratory.driven(lab)
        side.delay_of_rise, side.gain, interval = 0.6, 1.0, 2e-8
        state, travel = waves.shock(500.0, gas, lab.p1), waves.Travel(500.0)
        passing = -travel.time_to_wall(side.distance_m)
        y = laboratory.side_values(lab, side, state, travel, 0.0, (passing - 1e-5, interval, 2000))
        at = np.interp([0.1, 0.5, 0.9], y[:1200] / (state.p2 - state.p1), passing - 1e-5
                       + interval * np.arange(1200))
        self.assertAlmostEqual((at[1] - passing) / (at[2] - at[0]), 0.6, delta=0.01)

    def test_unmodelled_effects_stay_in_their_ranges(self):
        for effect in unmodelled.EFFECTS:
            for seed in range(20):
                lab = unmodelled.disturbed(effect, seed % 6, make.generator("effects", seed))
                plain = coverage.drawn(*coverage.of_cell(seed % 6), make.generator("effects", seed))
                self.assertEqual(lab.attenuation, plain.attenuation)
                self.assertEqual(lab.noise, plain.noise)
                if effect == "mounting":
                    self.assertTrue(7e-5 < abs(lab.dut.mount[0]) < 5.6e-3)
                    self.assertTrue(2e3 <= lab.dut.mount[1] <= 40e3 and 0.005 <= lab.dut.mount[2] <= 0.05)
                if effect == "front":
                    self.assertLessEqual(lab.dut.front[1], 80e-9)
                    self.assertNotEqual(lab.dut.front[0], "ramp")
                self.assertEqual(effect == "attenuation", lab.attenuation_law != "linear")

    def test_every_condition_makes_a_laboratory(self):
        for name, change in make.CONDITIONS.items():
            rng = make.generator(name, 7)
            lab = change(switches.default(rng), rng)
            gas = laboratory.driven(lab)
            for shot in lab.shots:
                self.assertGreater(shot.velocity / gas.sound_speed, 1.04, name)


if __name__ == "__main__":
    unittest.main()
