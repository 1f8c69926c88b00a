#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An auditor's way back from a certificate's numbers to the raw samples, without any of Dyncal's code.

    tests/audit/recompute.py CAPTURE.h5 FOLDER      FOLDER: what `dyncal run CAPTURE.h5 -o FOLDER` wrote

Reads the integers of the recording and what the recording says of tube and sensors, and computes with
numpy and scipy what results.json and the tables state, by other means where there are any: the joint
least squares by scipy from a spectral peak, the shock relations in their textbook form, uncertainties
by differences, every row of S(f) by the sum as it is written, budgets line by line, spectra by
scipy.signal, components by numpy's SVD. What it needs of the recipe is where the response begins and how
long the model input is. Prints every quantity as stated, as recomputed, and the difference against what
is allowed; exit code 1 where one is beyond. For step responses of captures in Dyncal's own format, order
2, white noise, the defaults of the recipe otherwise. Needs Debian's python3-numpy, python3-scipy,
python3-h5py.
"""

import hashlib
import json
import sys
from pathlib import Path

import h5py
import numpy as np
from scipy import signal

from audit_budget import check_every_budget, check_resonance_budget
from audit_fit import JointFit, Shot
from audit_model import check_model_uncertainty
from audit_report import SHARE, Report, relative, table
from audit_rows import check_csv, check_rows
from audit_sensitivity import check_sensitivity
from audit_shock import check_shock


def check_integrity(report, capture_path, results, shots):
    report.equal("SHA-256 of the capture", results["inputs"][0]["sha256"],
                 hashlib.sha256(Path(capture_path).read_bytes()).hexdigest())
    for shot in shots:
        for name, channel in shot.channels.items():
            digest = hashlib.sha256(channel[:].astype("<i2").tobytes()).hexdigest()
            report.equal(f"SHA-256 of shot {shot.number}, {name}", channel.attrs["raw_sha256"], digest)


def check_levels(report, shot):
    """Mean of the baseline's samples and deviation about their line."""
    noise = shot.noise_sd
    report.compare(f"shot {shot.number} noise sd (V)", shot.stated["noise_sd"], noise, relative(noise, 1e-9))
    report.compare(f"shot {shot.number} baseline (V)", shot.stated["baseline"], shot.quiet.mean(), 1e-9 * noise)


def check_model(report, results, shots, fit):
    stated = results["model"]["poles"][0]
    covariance = fit.covariance()
    f0, zeta, u_f, u_z = fit.resonance()
    report.compare("f0 (Hz)", stated["frequency_hz"], f0, SHARE * u_f)
    report.compare("u(f0) (Hz)", stated["u_frequency_hz"], u_f, SHARE * u_f)
    report.compare("zeta", stated["damping_ratio"], zeta, SHARE * u_z)
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


def check_model_response(report, results, shots, fit):
    response = results["response"]
    f = np.array(response["frequency_hz"])
    sensitivity = np.mean([s.stated["sensitivity"] for s in shots])
    model = sensitivity * np.mean([fit.gain(i, f) for i in range(len(shots))], axis=0)
    # The program weighs the shots' amplitudes by their noise, this the shots alike.
    report.compare("model's magnitude, largest difference",
                   np.abs(np.array(response["model_magnitude"]) / np.abs(model) - 1.0).max(), 0.0, 1e-4)


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


class Recording:
    """The shots of a capture as a run used them, and the joint fit to them."""

    def __init__(self, capture, results):
        self.shots = [Shot(capture[f"shots/{s['shot']:03d}"], s) for s in results["shots"] if s["included"]]
        self.tube = capture["setup/tube"].attrs
        self.fit = JointFit(self.shots, results["input"]["offset_s"]
                            + (results["input"]["samples"] - 1) / results["input"]["sample_rate_hz"])


def check_results(report, results, folder, recording):
    """results.json and the table of the response against what the recording gives."""
    shots, fit, tube = recording.shots, recording.fit, recording.tube
    for shot in shots:
        check_levels(report, shot)
    check_model(report, results, shots, fit)
    check_shock(report, results, shots, fit, tube)
    common = check_sensitivity(report, results, shots, fit, tube)
    check_bands(report, results, fit)
    check_model_response(report, results, shots, fit)
    check_rows(report, results, folder / "csv", shots, fit, common)
    check_every_budget(report, results)
    check_resonance_budget(report, results, fit)
    check_model_uncertainty(report, results, fit)
    check_csv(report, results, folder / "csv")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: recompute.py CAPTURE.h5 FOLDER")
    folder = Path(sys.argv[2])
    results = json.loads((folder / "results.json").read_text())
    if results["input"]["treatment"] != "step-deflated" or results["model"]["order"] != 2:
        sys.exit("recompute.py serves step responses of order 2; this is "
                 f"{results['input']['treatment']} of order {results['model']['order']}.")
    report = Report()
    with h5py.File(sys.argv[1]) as capture:
        recording = Recording(capture, results)
        check_integrity(report, sys.argv[1], results, recording.shots)
        check_results(report, results, folder, recording)
        check_tables(report, folder / "csv", results, recording.shots)
    print(f"{report.failed} beyond what is allowed")
    return 1 if report.failed else 0


if __name__ == "__main__":
    sys.exit(main())
