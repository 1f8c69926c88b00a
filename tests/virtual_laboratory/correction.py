# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Correction: is the true pressure of a customer's pulse inside the band that `dyncal correct` states?

Sensors and calibrations as in `coverage`: everything that the budget knows is drawn. Then each sensor records
a pulse of known pressure: two bursts of random place, width, height and frequency within the band, on a
slow one, made in the frequency domain with the sensor's exact response, with noise, as text. Counted are
all samples of the pulse.
"""
import json
import subprocess
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

from . import capture_file, coverage, laboratory, make, recorder, runner

COUNT, QUIET_s, BAND = 20000, 0.6e-3, 0.4  # of f0
PRESSURE_Pa = 2e5
RECIPE = {"import": {"columns": {"time": 0, "dut": 1}, "unit": "V"}}


def gauss(t, at, width, frequency=0.0):
    return np.exp(-0.5 * ((t - at) / width) ** 2) * np.cos(2 * np.pi * frequency * (t - at))


def pulse(t, band_hz, rng):
    """Bursts whose spectrum ends well below the band's end: width 1.5 to 3 over the band."""
    total = 0.5 * PRESSURE_Pa * gauss(t, 1.2e-3, 6 / band_hz)
    for _ in range(2):
        width = rng.uniform(1.5, 3.0) / band_hz
        total += PRESSURE_Pa * rng.uniform(-1, 1) * gauss(
            t, rng.uniform(1.1e-3, 1.3e-3), width, rng.uniform(0, 0.6) * band_hz)
    return total


def record(lab, t, rate_hz, pressure, rng):
    """What the sensor makes of it, with noise of 0.2 to 2 % of the largest value, white or not."""
    frequency = np.fft.rfftfreq(len(t), 1 / rate_hz)
    response = laboratory.dut_system(lab.dut, with_heat=False).response(frequency)
    voltage = np.fft.irfft(np.fft.rfft(pressure) * response, len(t)) * lab.dut.sensitivity
    kind = ["white", "ar"][rng.integers(2)]
    return voltage + recorder.noise(rng, len(t), kind) * np.abs(voltage).max() * rng.uniform(0.002, 0.02)


def corrected(program, folder, band_hz):
    (folder / "pulse.json").write_text(json.dumps(RECIPE), "utf-8")
    command = ["nice", program, "correct", str(folder / "pulse.csv"), "--recipe", str(folder / "pulse.json"), "--with", str(folder / "out"),
               "--band", f"{band_hz:.0f}", "--quiet", f"0,{QUIET_s}", "-o", str(folder / "pressure")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600)
    file = folder / "pressure" / "pressure_shot_001.csv"
    if not file.exists():
        return None, done.stderr.strip()[-300:]
    return np.genfromtxt(file, delimiter=",", names=True), ""


def one(arguments):
    """Sensor, samples inside, samples, the median U over the peak; or why there is none."""
    program, sensor, seed = arguments
    rng = make.generator(f"correction_{sensor}", seed)
    lab = coverage.drawn(sensor, 3, rng)
    with tempfile.TemporaryDirectory(prefix="virtual_laboratory_") as name:
        folder = Path(name)
        capture_file.write(folder, lab, laboratory.perform(lab, rng), f"correction_{sensor}", seed)
        if runner.calibrate(program, folder)[1] is None:
            return sensor, None, "no results"
        rate_hz, band_hz = lab.recorder.rate_hz, BAND * lab.dut.modes[0][0]
        t = np.arange(COUNT) / rate_hz
        pressure = pulse(t, band_hz, rng)
        np.savetxt(folder / "pulse.csv", np.column_stack([t, record(lab, t, rate_hz, pressure, rng)]),
                   delimiter=",", header="time (s),DUT (V)", comments="", fmt="%.17g")
        found, words = corrected(program, folder, band_hz)
    if found is None:
        return sensor, None, words
    first = round(found["time_s"][0] * rate_hz)
    truth = pressure[first:first + len(found)]
    U = found["k_pressure"] * found["u_pressure_pa"]
    isPulse = np.abs(found["time_s"] - 1.2e-3) < 0.1e-3 + 10 / band_hz
    inside = np.abs(found["pressure_pa"] - truth) <= U
    return sensor, (int(inside[isPulse].sum()), int(isPulse.sum()),
                    float(np.median(U[isPulse]) / np.abs(truth).max())), ""


def study(arguments, count=50):
    count = arguments.seeds or count
    seeds = range(arguments.first_seed, arguments.first_seed + count)
    tasks = [(arguments.program, s, seed) for s in range(len(coverage.SENSORS)) for seed in seeds]
    found, refused = {}, {}
    with ProcessPoolExecutor(arguments.processes) as pool:
        for sensor, counts, words in pool.map(one, tasks):
            (found if counts else refused).setdefault(sensor, []).append(counts or words)
    lines = ["| f0, zeta | sensors | refused | samples inside 95 % | median U over the peak |", "|---|--:|--:|--:|--:|"]
    for sensor, (f0_hz, zeta) in enumerate(coverage.SENSORS):
        counts = np.array(found.get(sensor, [(0, 1, np.nan)]))
        lines.append(f"| {f0_hz / 1e3:g} kHz, {zeta:g} | {len(found.get(sensor, []))} | "
                     f"{len(refused.get(sensor, []))} | {100 * counts[:, 0].sum() / counts[:, 1].sum():.1f} % | "
                     f"{100 * np.nanmedian(counts[:, 2]):.1f} % |")
    reasons = sorted({words for group in refused.values() for words in group})
    return "\n".join(lines + [""] + reasons)
