#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An auditor's way back from a certificate's numbers to the raw samples, without any of Dyncal's code.

    tests/audit/recompute.py CAPTURE.h5 FOLDER      FOLDER: what `dyncal run CAPTURE.h5 -o FOLDER` wrote

Reads the integers of the recording and what the recording says of tube and sensors, and computes with
numpy and scipy what results.json and the tables state, by other means where there are any: the joint
least squares by scipy from a spectral peak, the shock relations in their textbook form, uncertainties of
the step by differences, spectra by scipy.signal, components by numpy's SVD. What it needs of the recipe
is where the response begins and how long the model input is. Prints every quantity as stated, as
recomputed, and the difference against what is allowed; exit code 1 where one is beyond. For step
responses of captures in Dyncal's own format, order 2, white noise, the defaults of the recipe otherwise.
Needs Debian's python3-numpy, python3-scipy, python3-h5py.
"""

import csv
import hashlib
import json
import sys
from pathlib import Path

import h5py
import numpy as np
from scipy import optimize, signal

R = 8.314462618  # J/(mol K), SI 2019
SHARE = 2e-3  # of a standard uncertainty: the program's descent ends at half of that


class Report:
    """Every comparison a line; `allowed` in the unit of the quantity."""

    def __init__(self):
        self.failed = 0

    def compare(self, name, stated, recomputed, allowed):
        difference = abs(stated - recomputed)
        passes = difference <= allowed  # false for NaN too
        self.failed += not passes
        print(f"{'ok  ' if passes else 'OFF '} {name:44s} {stated:.12g}  {recomputed:.12g}"
              f"  ({difference:.2g} of {allowed:.2g})")

    def equal(self, name, stated, recomputed):
        self.failed += stated != recomputed
        print(f"{'ok  ' if stated == recomputed else 'OFF '} {name:44s} {stated}"
              + ("" if stated == recomputed else f" is not {recomputed}"))


def relative(value, share):
    return abs(value) * share


class Shot:
    """Raw samples and circumstances of one shot, and what is computed from them."""

    def __init__(self, group, stated):
        self.stated = stated
        self.number = stated["shot"]
        self.environment = dict(group["environment"].attrs)
        self.channels = group["channels"]
        dut = self.channels["DUT"]
        self.rate_Hz = float(dut.attrs["sample_rate_Hz"])
        self.t0_s = float(dut.attrs["t0_s"])
        self.volts = dut[:] * float(dut.attrs["scale"]) + float(dut.attrs["offset"])
        self.first = round((stated["start_s"] - self.t0_s) * self.rate_Hz)

    def time_s(self, sample):
        return self.t0_s + sample / self.rate_Hz


def check_integrity(report, capture_path, results, shots):
    report.equal("SHA-256 of the capture", results["inputs"][0]["sha256"],
                 hashlib.sha256(Path(capture_path).read_bytes()).hexdigest())
    for shot in shots:
        for name, channel in shot.channels.items():
            digest = hashlib.sha256(channel[:].astype("<i2").tobytes()).hexdigest()
            report.equal(f"SHA-256 of shot {shot.number}, {name}", channel.attrs["raw_sha256"], digest)


def check_levels(report, shot):
    """Baseline and noise from a longer stretch before the start than the program takes."""
    guard = round(20e-6 * shot.rate_Hz)
    quiet = shot.volts[:shot.first - guard]
    noise = quiet.std(ddof=1)
    stated = shot.stated
    report.compare(f"shot {shot.number} noise sd (V)", stated["noise_sd"], noise, relative(noise, 0.02))
    few = 19000  # samples the program's baseline has at least
    report.compare(f"shot {shot.number} baseline (V)", stated["baseline"], quiet.mean(),
                   4.0 * noise / np.sqrt(few))


def columns(rates, t):
    """Real columns of c0 + sum over the upper halves of Re, Im e^(s t)."""
    powers = [np.exp(s * t) for s in rates]
    return np.column_stack([np.ones_like(t)] + [p for e in powers for p in (e.real, -e.imag)])


class JointFit:
    """One damped oscillation shared by all shots; level and amplitudes of each its own."""

    def __init__(self, shots, seconds):
        """`seconds`: from the start to the last sample, which takes part."""
        self.shots = shots
        self.count = [round(seconds * shot.rate_Hz) + 1 for shot in shots]
        self.y = [shot.volts[shot.first:shot.first + n] - shot.stated["baseline"]
                  for shot, n in zip(shots, self.count)]
        self.t = [np.arange(n) / shot.rate_Hz for shot, n in zip(shots, self.count)]
        self.noise = [shot.stated["noise_sd"] for shot in shots]  # see check_levels
        self.rate = self._solve(self._start())

    def _start(self):
        """The highest line of the ringing's spectrum and a damping of two per cent."""
        y, t = self.y[0], self.t[0]
        ringing = y - y[len(y) // 2:].mean()
        power = np.abs(np.fft.rfft(ringing, 8 * len(ringing)))
        omega = 2.0 * np.pi * np.fft.rfftfreq(8 * len(ringing), t[1])[power.argmax()]
        return complex(-0.02 * omega, omega)

    def _residual(self, x):
        s = complex(x[0], x[1]) * self.unit
        parts = []
        for y, t, noise in zip(self.y, self.t, self.noise):
            C = columns([s], t)
            parts.append((y - C @ np.linalg.lstsq(C, y, rcond=None)[0]) / noise)
        return np.concatenate(parts)

    def _solve(self, start):
        self.unit = abs(start)
        x = optimize.least_squares(self._residual, [start.real / self.unit, start.imag / self.unit],
                                   xtol=1e-14, ftol=1e-14, gtol=1e-14).x
        return complex(x[0], x[1]) * self.unit

    def amplitudes(self, i):
        return np.linalg.lstsq(columns([self.rate], self.t[i]), self.y[i], rcond=None)[0]

    def covariance(self):
        """(J^T J)^-1 of Re s, Im s, then per shot level, Re and Im of the amplitude; larger where the
        residual is larger than the noise."""
        n = 2 + 3 * len(self.shots)
        information = np.zeros((n, n))
        for i, (t, noise) in enumerate(zip(self.t, self.noise)):
            a = self.amplitudes(i)
            e = np.exp(self.rate * t)
            gain = complex(a[1], a[2])
            J = np.zeros((len(t), n))
            J[:, 0] = (gain * t * e).real
            J[:, 1] = -(gain * t * e).imag
            J[:, 2 + 3 * i:5 + 3 * i] = columns([self.rate], t)
            information += J.T @ J / noise**2
        residual = self._residual([self.rate.real / self.unit, self.rate.imag / self.unit])
        return np.linalg.inv(information) * max(1.0, residual @ residual / (len(residual) - n))

    def onset_s(self, i):
        """Where the response is level and near zero: it leaves with slope zero, so that the slope
        Re(c s e^(s t)) has a simple root there."""
        a = self.amplitudes(i)
        c = complex(a[1], a[2])
        roots = (0.5 * np.pi * np.arange(-9, 10, 2) - np.angle(c * self.rate)) / self.rate.imag
        low = roots[np.abs(a[0] + (c * np.exp(self.rate * roots)).real) < 0.25 * abs(a[0])]
        return self.shots[i].time_s(self.shots[i].first) + low[np.abs(low).argmin()]

    def gain(self, i, f):
        """Response to pressure at f over the plateau: c0 + sum c_i jw/(jw - s_i) at the onset."""
        a = self.amplitudes(i)
        delay = self.onset_s(i) - self.shots[i].time_s(self.shots[i].first)
        c = 0.5 * complex(a[1], a[2]) * np.exp(self.rate * delay) / a[0]
        jw = 2j * np.pi * np.asarray(f)
        return 1.0 + c * jw / (jw - self.rate) + np.conj(c) * jw / (jw - np.conj(self.rate))


def check_model(report, results, shots, fit):
    stated = results["model"]["poles"][0]
    covariance = fit.covariance()
    size, share = abs(fit.rate), fit.rate.real / abs(fit.rate)
    slope_f = np.array([fit.rate.real, fit.rate.imag]) / size / (2.0 * np.pi)
    slope_z = np.array([-1.0 + share**2, share * fit.rate.imag / size]) / size
    u_f = np.sqrt(slope_f @ covariance[:2, :2] @ slope_f)
    u_z = np.sqrt(slope_z @ covariance[:2, :2] @ slope_z)
    report.compare("f0 (Hz)", stated["frequency_hz"], size / (2.0 * np.pi), SHARE * u_f)
    report.compare("u(f0) (Hz)", stated["u_frequency_hz"], u_f, SHARE * u_f)
    report.compare("zeta", stated["damping_ratio"], -share, SHARE * u_z)
    report.compare("u(zeta)", stated["u_damping_ratio"], u_z, SHARE * u_z)
    for i, shot in enumerate(shots):
        u = np.sqrt(covariance[2 + 3 * i, 2 + 3 * i])
        level = shot.stated["sensitivity"] * results["shock"][i]["step_pa"]
        report.compare(f"shot {shot.number} plateau (V)", level, fit.amplitudes(i)[0], SHARE * u)
        report.compare(f"shot {shot.number} onset (s)", shot.stated["onset_s"], fit.onset_s(i),
                       SHARE * shot.stated["u_onset_s"])
    # The matrices hold the same model: their steady gain and their poles.
    A, B, C, D = (np.array(results["model"][k]) for k in "ABCD")
    steady = (C @ np.linalg.solve(np.eye(len(A)) - A, B) + D).item()
    report.compare("steady gain of A, B, C, D", steady, results["model"]["plateau_gain"], 1e-9)
    s = np.log(np.linalg.eigvals(A).astype(complex)) / results["model"]["dt_s"]
    report.compare("f0 of the eigenvalues of A (Hz)", stated["frequency_hz"],
                   np.abs(s[0]) / (2.0 * np.pi), relative(stated["frequency_hz"], 1e-10))


def shocked(velocity, T1, p1, gamma, molar):
    """Pressures behind the incident and the reflected shock, ideal gas."""
    mach2 = velocity**2 * molar / (gamma * R * T1)
    p2 = p1 * (1.0 + 2.0 * gamma / (gamma + 1.0) * (mach2 - 1.0))
    strength = p2 / p1
    p5 = p2 * ((3.0 * gamma - 1.0) * strength - (gamma - 1.0)) / (
        (gamma - 1.0) * strength + gamma + 1.0)
    return p2, p5


def side_arrival_s(shot, stated, model_arrival_s):
    """First crossing of half the incident step, half of the unknown delay taken off, and the delay's u.

    The reflected shock is not back yet. The delay lies between 0 and 0.85 of the 10-90 % rise time.
    """
    side = next(c for n, c in shot.channels.items() if n == stated["channel"])
    rate, t0 = float(side.attrs["sample_rate_Hz"]), float(side.attrs["t0_s"])
    y = side[:] * float(side.attrs["scale"]) + float(side.attrs["offset"])
    about = round((stated["arrival_s"] - t0) * rate)
    before = y[:about - 1000].mean()
    until = round((0.5 * (stated["arrival_s"] + model_arrival_s) - t0) * rate)
    height = y[about + 2000:until].mean()

    def crossing_s(share):
        level = before + share * (height - before)
        k = np.flatnonzero(y[about - 500:] > level)[0] + about - 500
        return t0 + (k - 1 + (level - y[k - 1]) / (y[k] - y[k - 1])) / rate

    rise = crossing_s(0.9) - crossing_s(0.1)
    return crossing_s(0.5) - 0.5 * 0.85 * rise, 0.85 * rise / np.sqrt(12.0)


def check_shock(report, results, shots, fit, tube):
    for i, shot in enumerate(shots):
        stated = results["shock"][i]
        name = f"shot {shot.number}"
        side = next(a for a in stated["arrivals"] if not a["dut"])
        arrival, u_delay = side_arrival_s(shot, side, fit.onset_s(i))
        report.compare(f"{name} arrival at the side wall (s)", side["arrival_s"], arrival,
                       3.0 * side["u_arrival_s"])
        report.compare(f"{name} u(delay) (s)", side["u_delay_s"], u_delay, 0.1 * u_delay)
        distance = float(tube["endflange_to_sensor2_m"])
        u_distance = float(tube["u_endflange_to_sensor2_m"])
        span = shot.stated["onset_s"] - side["arrival_s"]
        # t(x) = t(0) - x/W + a x^2/(2 W): two times cannot tell a, its range decides alone.
        attenuation = np.array(results["recipe"]["shock"]["attenuation_per_m"])
        bend = 0.5 * span  # d(1/W)/da
        velocity = 1.0 / (span / distance + bend * attenuation.mean())
        report.compare(f"{name} velocity (m/s)", stated["velocity_m_s"], velocity, relative(velocity, 1e-10))
        u_time = np.sqrt(
            side["u_arrival_s"]**2 + side["u_delay_s"]**2 + shot.stated["u_onset_s"]**2)
        curvature = bend * attenuation.mean() / distance
        u = velocity**2 * np.sqrt(((span / distance**2 - curvature) * u_distance)**2
                                  + (u_time / distance)**2
                                  + (bend * np.ptp(attenuation) / np.sqrt(12.0))**2)
        report.compare(f"{name} u(velocity) (m/s)", stated["u_velocity_m_s"], u, relative(u, 1e-6))
        T1, p1 = shot.environment["T1_K"], shot.environment["p1_Pa"]
        gas = stated["driven_gas"]
        state = (velocity, T1, p1, gas["gamma"], gas["molar_mass_kg_mol"])
        p2, p5 = shocked(*state)
        report.compare(f"{name} p2 (Pa)", stated["p2_pa"], p2, relative(p2, 1e-10))
        report.compare(f"{name} step (Pa)", stated["step_pa"], p5 - p1, relative(p5, 1e-10))
        # By differences: velocity, T1, p1, gamma, molar mass; the last two as the budget states them.
        budget = {line["quantity"]: line for line in stated["step_budget"]}
        u_of = (u, shot.environment["u_T1_K"], shot.environment["u_p1_Pa"], budget["gamma"]["u"],
                budget["molar_mass_kg_mol"]["u"])
        squares = 0.0
        for k, u_k in enumerate(u_of):
            ends = []
            for sign in (1.0, -1.0):
                moved = list(state)
                moved[k] += sign * 1e-4 * moved[k]
                ends.append(shocked(*moved)[1] - moved[2])
            squares += ((ends[0] - ends[1]) / (2e-4 * state[k]) * u_k)**2
        u_step = np.sqrt(squares)
        report.compare(f"{name} u(step) (Pa)", stated["u_step_pa"], u_step, relative(u_step, 1e-4))
        sensitivity = fit.amplitudes(i)[0] / (p5 - p1)
        report.compare(f"{name} sensitivity (V/Pa)", shot.stated["sensitivity"], sensitivity,
                       relative(sensitivity, 1e-7))


def check_bands(report, results, fit):
    f = np.geomspace(1e3, 1e8, 400001)
    gain = np.abs(np.mean([fit.gain(i, f) for i in range(len(fit.shots))], axis=0))
    for key, leaves in (("within_5_percent_hz", np.abs(gain - 1.0) > 0.05),
                        ("within_10_percent_hz", np.abs(gain - 1.0) > 0.10),
                        ("minus_3_db_hz", gain < np.sqrt(0.5))):
        edge = f[leaves.argmax()]
        stated = results["bands"][key]
        if stated is None:  # beyond the band: only its end is stated, and the edge lies above it
            bound = results["bands"][key.replace("_hz", "_above_hz")]
            report.compare(f"{key}, above", min(bound, edge), bound, 0.0)
        else:
            report.compare(f"{key}", stated, edge, relative(edge, 1e-4))


def check_response(report, folder, results, shots, fit):
    """The model's response against that fitted here; the response from the data from the raw samples."""
    response = results["response"]
    f = np.array(response["frequency_hz"])
    sensitivity = np.mean([s.stated["sensitivity"] for s in shots])
    model = sensitivity * np.mean([fit.gain(i, f) for i in range(len(shots))], axis=0)
    stated = np.array(response["model_magnitude"])
    # The program weighs the shots' amplitudes by their noise, this the shots alike.
    report.compare("model's magnitude, largest difference", np.abs(stated / np.abs(model) - 1.0).max(),
                   0.0, 1e-4)
    steps_Pa = [stated["step_pa"] for stated in results["shock"]]
    windows = [len(table(folder / f"response_shot_{s.number:03d}.csv")["value"]) for s in shots]
    span_s = (results["input"]["offset_s"]
              + results["input"]["samples"] / results["input"]["sample_rate_hz"])
    for f_Hz, magnitude, u, length_s in zip(f, response["magnitude"], response["u_noise_magnitude"],
                                            response["length_s"]):
        if magnitude is None:
            continue  # withheld
        own = np.mean([abs(from_record(shot, window, f_Hz, length_s, span_s)) / step
                       for shot, window, step in zip(shots, windows, steps_Pa)])
        # The program takes off what noise adds to a magnitude; all shots alike, half n u^2 over it.
        added = 0.5 * len(shots) * u**2 / magnitude
        report.compare(f"magnitude from the data at {f_Hz:.4g} Hz", magnitude + added, own,
                       0.5 * added + relative(own, 1e-9))


def from_record(shot, window, f_Hz, length_s, span_s):
    """Transform of one record's steps, continued by the mean of its own last tenth, in volts."""
    count = min(max(2, int(np.ceil(length_s * shot.rate_Hz - 1e-6))), window)
    before = max(64, int(span_s * shot.rate_Hz / 16))
    y = shot.volts[shot.first - before:shot.first + count] - shot.stated["baseline"]
    level = y[-(len(y) // 10):].mean()
    x = 2.0 * np.pi * f_Hz / shot.rate_Hz
    steps = np.diff(np.concatenate([[0.0], y, [level]]))
    return np.sum(steps * np.exp(-1j * x * np.arange(len(steps)))) * x / abs(1.0 - np.exp(-1j * x))


def table(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    return {name: np.array([float(row[i]) if row[i] else np.nan for row in rows[1:]])
            for i, name in enumerate(rows[0])}


def check_tables(report, folder, results, shots):
    responses = []
    for i, shot in enumerate(shots):
        name = f"shot {shot.number}"
        y = table(folder / f"response_shot_{shot.number:03d}.csv")["value"]
        mapped = (shot.volts[shot.first:shot.first + len(y)] - shot.stated["baseline"]) / shot.stated["step"]
        report.compare(f"{name} remapped response, largest difference", np.abs(y - mapped).max(), 0.0, 1e-12)
        spectrum = table(folder / f"spectrum_shot_{shot.number:03d}.csv")
        f, power = signal.periodogram(y, shot.rate_Hz, detrend="constant")
        report.compare(f"{name} spectrum, sum (rounding of one bin)", spectrum["psd_per_hz"][1:].sum(),
                       power[1:].sum(), relative(power[1:].sum(), 1e-9))
        at = power[1:].argmax() + 1
        report.compare(f"{name} highest line (Hz)", spectrum["frequency_hz"][at], f[at], relative(f[at], 1e-12))
        model = table(folder / f"model_shot_{shot.number:03d}.csv")
        fit = 100.0 * (1.0 - np.linalg.norm(model["measured"] - model["model"])
                       / np.linalg.norm(model["measured"] - model["measured"].mean()))
        report.compare(f"{name} FIT (%)", results["model"]["fit_per_shot_percent"][i], fit, 1e-9)
        responses.append(y)
    shortest = min(len(y) for y in responses)
    X = np.column_stack([y[:shortest] for y in responses])
    values = np.linalg.svd(X, compute_uv=False)
    explained = 100.0 * np.cumsum(values**2) / np.sum(values**2)
    for k, share in enumerate(results["pca"]["explained_cumulative_percent"]):
        report.compare(f"explained by {k + 1} components (%)", share, explained[k], 1e-9)


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: recompute.py CAPTURE.h5 FOLDER")
    capture_path, folder = sys.argv[1], Path(sys.argv[2])
    results = json.loads((folder / "results.json").read_text())
    if results["input"]["treatment"] != "step-deflated" or results["model"]["order"] != 2:
        sys.exit("recompute.py serves step responses of order 2; this is "
                 f"{results['input']['treatment']} of order {results['model']['order']}.")
    report = Report()
    with h5py.File(capture_path) as capture:
        shots = [Shot(capture[f"shots/{s['shot']:03d}"], s)
                 for s in results["shots"] if s["included"]]
        check_integrity(report, capture_path, results, shots)
        for shot in shots:
            check_levels(report, shot)
        span_s = (results["input"]["offset_s"]
                  + (results["input"]["samples"] - 1) / results["input"]["sample_rate_hz"])
        fit = JointFit(shots, span_s)
        check_model(report, results, shots, fit)
        check_shock(report, results, shots, fit, capture["setup/tube"].attrs)
        check_bands(report, results, fit)
        check_response(report, folder / "csv", results, shots, fit)
        check_tables(report, folder / "csv", results, shots)
    print(f"{report.failed} beyond what is allowed")
    return 1 if report.failed else 0


if __name__ == "__main__":
    sys.exit(main())
