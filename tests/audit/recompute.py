#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An auditor's way back from a certificate's numbers to the raw samples, without any of Dyncal's code.

    tests/audit/recompute.py CAPTURE.h5 FOLDER      FOLDER: what `dyncal run CAPTURE.h5 -o FOLDER` wrote

Reads the integers of the recording and what the recording says of tube and sensors, and computes with
numpy and scipy what results.json and the tables state, by other means where there are any: the joint
least squares by scipy from a spectral peak, the shock relations in their textbook form, uncertainties
by differences, every row of S(f) by the sum as it is written, by the step or by a reference transducer,
with the chain divided out, budgets line by line, the CMC, the statement of conformity, spectra by
scipy.signal, components by numpy's SVD. What it needs of the recipe is where the response begins, how
long the model input is, and the tables that it names: they are looked for in FOLDER, beside FOLDER and
beside the capture, as CSV. Prints every quantity as stated, as recomputed, and the difference against
what is allowed; exit code 1 where one is beyond. For step responses and free decays of captures in
Dyncal's own format, order 2, white noise, the recipe's sections chain, comparison, uncertainty.cmc and
certificate.decision, the defaults otherwise. Needs Debian's python3-numpy, python3-scipy, python3-h5py.
"""

import hashlib
import json
import sys
from functools import lru_cache
from pathlib import Path

import h5py
import numpy as np
from scipy import signal

from audit_budget import check_delay, check_every_budget, check_resonance_budget, check_sources
from audit_capability import check_capability
from audit_comparison import check_comparison
from audit_conformity import check_conformity
from audit_model import check_characteristics, check_marks, check_model_rows
from audit_report import SHARE, Report, relative, table
from audit_rows import check_csv, check_section
from audit_run import Run
from audit_sensitivity import check_sensitivity
from audit_shock import check_shock
from audit_transducer import check_settled, common_of_rows, u_common_of_model


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


def check_resonance(report, results, fit):
    stated = results["model"]["poles"][0]
    f0, zeta, u_f, u_z = fit.resonance()
    report.compare("f0 (Hz)", stated["frequency_hz"], f0, SHARE * u_f)
    report.compare("u(f0) (Hz)", stated["u_frequency_hz"], u_f, SHARE * u_f)
    report.compare("zeta", stated["damping_ratio"], zeta, SHARE * u_z)
    report.compare("u(zeta)", stated["u_damping_ratio"], u_z, SHARE * u_z)


def check_model(report, results, run):
    for i, shot in enumerate(run.shots):
        u = np.sqrt(run.fit.covariance()[2 + 3 * i, 2 + 3 * i])
        level = shot.stated["sensitivity"] * run.steps_Pa()[i]
        report.compare(f"shot {shot.number} plateau (V)", level, run.fit.amplitudes(i)[0], SHARE * u)
        report.compare(f"shot {shot.number} onset (s)", shot.stated["onset_s"], run.fit.onset_s(i),
                       SHARE * shot.stated["u_onset_s"])
        u_onset = run.fit.u_onset_s(i)
        report.compare(f"shot {shot.number} u(onset) (s)", shot.stated["u_onset_s"], u_onset, relative(u_onset, SHARE))
    # The matrices hold the same model: their steady gain and their poles.
    stated = results["model"]["poles"][0]
    A, B, C, D = (np.array(results["model"][k]) for k in "ABCD")
    steady = (C @ np.linalg.solve(np.eye(len(A)) - A, B) + D).item()
    report.compare("steady gain of A, B, C, D", steady, results["model"]["plateau_gain"], 1e-9)
    s = np.log(np.linalg.eigvals(A).astype(complex)) / results["model"]["dt_s"]
    report.compare("f0 of the eigenvalues of A (Hz)", stated["frequency_hz"],
                   np.abs(s[0]) / (2.0 * np.pi), relative(stated["frequency_hz"], 1e-10))


@lru_cache(maxsize=1)
def gain_of(fit):
    f = np.geomspace(1e3, 1e8, 400001)
    return f, np.abs(np.mean([fit.gain(i, f) for i in range(len(fit.shots))], axis=0))


def check_bands(report, results, fit):
    f, gain = gain_of(fit)
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


def check_tables(report, folder, results, shots, is_step):
    responses = []
    for i, shot in enumerate(shots):
        name = f"shot {shot.number}"
        y = table(folder / f"response_shot_{shot.number:03d}.csv")["value"]
        step = shot.stated["step"] if is_step else 1.0  # a free decay is not divided by one
        mapped = (shot.volts[shot.first:shot.first + len(y)] - shot.stated["baseline"]) / step
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


def check_results(report, results, run):
    """results.json and the table of the response against what the recording gives."""
    for shot in run.shots:
        check_levels(report, shot)
    check_resonance(report, results, run.fit)
    check_every_budget(report, results)
    check_sources(report, results)
    check_resonance_budget(report, results, run.fit)
    check_capability(report, results)
    if run.is_step:
        check_step_response(report, results, run)


def check_step_response(report, results, run):
    is_by_transducer = results["response"]["source"] == "transducer"
    check_model(report, results, run)
    check_shock(report, results, run.shots, run.fit, run.tube)
    if not is_by_transducer:
        check_delay(report, results)
    mean, lines = check_sensitivity(report, results, run.inputs(), run.shots, run.chain_lowest())
    common = common_of_rows(mean, lines, is_by_transducer)
    maker = run.transducer_rows if is_by_transducer else run.step_rows
    both = check_section(report, results, "response", maker, common, "response")
    for name, found in zip(("response", "response.marked"), both):
        check_model_rows(report, results, name, run.fit, mean, u_common_of_model(mean, lines), found, run.chain)
    rows = [row for found in both for _, row in found]
    check_characteristics(report, results, run.fit)
    check_marks(report, results, run.fit)
    check_bands(report, results, run.fit)
    check_conformity(report, results, run.folder, rows, lines, mean)
    if run.by_transducer:
        check_settled(report, run.shots, run.windows)
        check_comparison(report, results, run)
    check_csv(report, results, run.folder / "csv")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: recompute.py CAPTURE.h5 FOLDER")
    results = json.loads((Path(sys.argv[2]) / "results.json").read_text())
    if results["input"]["treatment"] not in ("step-deflated", "impulse") or results["model"]["order"] != 2:
        sys.exit("recompute.py serves step responses and free decays of order 2; this is "
                 f"{results['input']['treatment']} of order {results['model']['order']}.")
    report = Report()
    with h5py.File(sys.argv[1]) as capture:
        run = Run(report, capture, results, sys.argv[1], sys.argv[2])
        check_integrity(report, sys.argv[1], results, run.shots)
        check_results(report, results, run)
        check_tables(report, run.folder / "csv", results, run.shots, run.is_step)
    print(f"{report.failed} beyond what is allowed")
    return 1 if report.failed else 0


if __name__ == "__main__":
    sys.exit(main())
