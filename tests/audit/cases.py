#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Recordings, tables and recipes that the audit is tried on, from two simulated captures of the same shots.

    tests/audit/cases.py DUT.h5 REFERENCE.h5 FOLDER

`both.h5`: the DUT with the other's DUT beside it as a reference transducer; `decay.h5`: a free decay in place of the
DUT's record; `reference.csv`, `amplifier.csv`; and one recipe NAME.json for each of CASES.
"""

import hashlib
import json
import shutil
import sys
from pathlib import Path

import h5py
import numpy as np

MODEL = {"sensitivity": 8e-6, "u_sensitivity": 2.4e-8, "f0_hz": 4e5, "u_f0_hz": 400.0, "zeta": 0.7, "u_zeta": 0.002}
BY_TABLE = {"enabled": True, "source": "reference.csv", "correlation_with_step": 0.3}
BY_MODEL = {"enabled": True, "model": MODEL, "u_delay_s": 5e-8, "delay_s": 3e-7}
CHAIN = {"source": "amplifier.csv"}
CMC = [{"of": "sensitivity", "expanded": 0.03}, {"of": "magnitude", "expanded": 0.05, "from_hz": 1e4},
       {"of": "magnitude", "expanded": 2e-7, "relative": False}, {"of": "phase_rad", "expanded": 0.01},
       {"of": "f0_hz", "expanded": 500, "relative": False}, {"of": "damping_ratio", "expanded": 0.01},
       {"of": "within_5_percent_hz", "expanded": 0.1}, {"of": "rise_time_s", "expanded": 0.02},
       {"of": "q", "expanded": 1e-9}]


def decision(rule, within_percent, to_hz, **more):
    return {"decision": {"rule": rule, "within_percent": within_percent, "from_hz": 1e3, "to_hz": to_hz, **more}}


BY_TRANSDUCER = {"reference": "transducer"}
CASES = {
    "table": {"comparison": BY_TABLE, "certificate": decision("simple", 5, 4e5)},
    "model": {"comparison": BY_MODEL, "response": BY_TRANSDUCER,
              "certificate": decision("risk", 4, 4.1e5, max_risk_percent=5)},
    "chain": {"chain": CHAIN, "comparison": BY_MODEL, "certificate": decision("guard-band", 6, 4.95e5)},
    "chain_transducer": {"chain": CHAIN, "comparison": BY_TABLE, "response": BY_TRANSDUCER,
                         "certificate": decision("simple", 5, 9e6)},
    "high_table": {"comparison": {**BY_TABLE, "source": "high.csv"}, "response": BY_TRANSDUCER},
    "cmc": {"comparison": BY_TABLE, "uncertainty": {"cmc": CMC}, "certificate": decision("guard-band", 9, 6e5)},
    "decay": {"input": {"treatment": "impulse"}, "shock": {"enabled": False},
              "uncertainty": {"cmc": [{"of": "damping_ratio", "expanded": 0.05}]}},
    "decay_compared": {"input": {"treatment": "impulse"}, "comparison": BY_MODEL}}


def write_table(path, f_Hz, response, u_relative, u_phase_rad, dof):
    with open(path, "w", encoding="utf-8") as file:
        file.write("# made for the audit\nfrequency_hz,magnitude,u_magnitude,phase_rad,u_phase_rad,dof\n")
        for row in zip(f_Hz, np.abs(response), u_relative * np.abs(response), np.unwrap(np.angle(response)),
                       u_phase_rad, dof):
            file.write(",".join("" if np.isinf(value) else f"{value:.9g}" for value in row) + "\n")


def write_tables(folder):
    f_Hz = np.geomspace(100.0, 3e6, 60)
    r = f_Hz / MODEL["f0_hz"]
    reference = MODEL["sensitivity"] / (1.0 - r**2 + 2j * MODEL["zeta"] * r)
    write_table(folder / "reference.csv", f_Hz, reference, np.linspace(0.003, 0.006, 60), 0.002 + 1e-9 * f_Hz,
                50.0 + np.arange(60))
    high = f_Hz > 1e5  # begins above the level of the step
    write_table(folder / "high.csv", f_Hz[high], reference[high], np.full(high.sum(), 0.003), 0.002 + 1e-9 * f_Hz[high],
                np.full(high.sum(), 50.0))
    f_Hz = np.geomspace(100.0, 2e6, 40)
    amplifier = (1.0 + 0.02 * (f_Hz / 2e6)**2) / (1.0 + 1j * f_Hz / 2.5e7)
    amplifier /= abs(amplifier[0])
    write_table(folder / "amplifier.csv", f_Hz, amplifier, 0.001 + 2e-9 * f_Hz, 0.001 + 1e-9 * f_Hz,
                np.where(np.arange(40) % 2, np.inf, 20.0 + np.arange(40)))


def opened(source, path):
    """A copy that says no longer what it held when it was written."""
    shutil.copy(source, path)
    file = h5py.File(path, "r+")
    for name in ("content_list", "content_sha256"):
        del file.attrs[name]
    return file


def write_both(dut, reference, path):
    with opened(dut, path) as file, h5py.File(reference, "r") as other:
        for number, shot in file["shots"].items():
            record = other[f"shots/{number}/channels/DUT"]
            channel = shot["channels"].create_dataset("Reference", data=record[:])
            channel.attrs.update({**record.attrs, "role": "reference"})


def write_decay(dut, path):
    """318 kHz, damping 0.02, another size in each shot."""
    rng, omega, zeta = np.random.default_rng(7), 2.0 * np.pi * 318e3, 0.02
    with opened(dut, path) as file:
        for number, shot in file["shots"].items():
            channel = shot["channels/DUT"]
            at = channel.attrs
            t = np.arange(len(channel)) / at["sample_rate_Hz"] + at["t0_s"] - 0.001234567
            rate = omega * complex(-zeta, np.sqrt(1.0 - zeta**2))
            volts = (t > 0.0) * (0.5 + 0.1 * int(number)) * np.exp(rate * np.maximum(t, 0.0)).imag
            counts = np.round((volts + rng.normal(0.0, 0.01, len(t))) / at["scale"]).astype("<i2")
            channel[:] = counts
            at["raw_sha256"] = hashlib.sha256(counts.tobytes()).hexdigest()


def main():
    if len(sys.argv) != 4:
        sys.exit("usage: cases.py DUT.h5 REFERENCE.h5 FOLDER")
    dut, reference, folder = (Path(name) for name in sys.argv[1:])
    write_both(dut, reference, folder / "both.h5")
    write_decay(dut, folder / "decay.h5")
    write_tables(folder)
    for name, recipe in CASES.items():
        # Nothing here is of the Monte Carlo, which takes longest.
        recipe = {**recipe, "uncertainty": {"monte_carlo_trials": 1000, **recipe.get("uncertainty", {})}}
        (folder / f"{name}.json").write_text(json.dumps(recipe))


if __name__ == "__main__":
    main()
