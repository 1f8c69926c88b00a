#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the self-test finds single faults that are built into core on purpose.

faults.py --build BUILD [--short] [--only TEXT]

Each fault is an edit of one line of one source of core. That source is compiled alone and linked in
front of the core library, so that its functions take the place of the right ones, into the runner of
the self-test (runner.cpp). The runner must then name the step where the fault is; without a fault all
must hold. --short: the faults marked so. BUILD: a build folder of a Ninja preset with the target
selftest_runner built. Exit code 1 where a fault is not found, or found in another step.
"""
import argparse
import concurrent.futures
import json
import shlex
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TARGET = "tests/selftest_runner"


@dataclass
class Fault:
    what: str
    source: str  # in core, without .cpp
    right: str  # must be there exactly once
    wrong: str
    step: str  # of the first deviation
    calibrations: int = 0  # virtual ones that are needed to find it
    short: bool = False


FAULTS = [
    Fault("polarity forgotten", "capture/channel", "channel.polarity * channel.userScale * value",
          "channel.userScale * value", "captures"),
    Fault("gain multiplied", "capture/channel_rules", "channel.userScale *= details.scale.value_or(1.0) / details",
          "channel.userScale *= details.scale.value_or(1.0) * details", "captures"),
    Fault("a sample of delay in a crossing", "signal/start_detection",
          "return channel.timeOf_s(begin + i)\n                    + before",
          "return channel.timeOf_s(begin + i + 1)\n                    + before", "arrivals", short=True),
    Fault("sign in Rankine-Hugoniot", "shock/shock_relations", "(states.mach - 1.0) * (states.mach + 1.0)",
          "(states.mach + 1.0) * (states.mach + 1.0)", "expected_shock"),
    Fault("sign in the reflected shock", "shock/shock_relations", "((3.0 * gamma - 1.0) * ratio2 - (gamma - 1.0))",
          "((3.0 * gamma - 1.0) * ratio2 + (gamma - 1.0))", "expected_shock"),
    Fault("half of the exponent of p4", "shock/shock_relations", "-2.0 * driver.gamma / (driver.gamma - 1.0)",
          "-1.0 * driver.gamma / (driver.gamma - 1.0)", "shock", short=True),
    Fault("contact surface runs away", "shock/shock_relations",
          "drivenLength_m - states.shocked.velocity_m_s * arrival_s",
          "drivenLength_m + states.shocked.velocity_m_s * arrival_s", "shock"),
    Fault("sign of a coefficient of moist air", "shock/moist_air", "331.5024, 0.603055, -0.000528",
          "331.5024, 0.603055, 0.000528", "shock"),
    Fault("velocity 1 % too large", "shock/velocity_fit", "fit.velocity_m_s = line.velocity();",
          "fit.velocity_m_s = 1.01 * line.velocity();", "expected_shock"),
    Fault("overshoot of a record halved", "signal/window_cutting", "100.0 * *found.overshoot",
          "50.0 * *found.overshoot", "window"),
    Fault("two-sided density", "signal/power_spectrum", "power *= 2.0 / (rate_Hz", "power *= 1.0 / (rate_Hz",
          "spectrum"),
    Fault("shares of singular values, not of their squares", "decomposition/principal_components",
          "sum += svd.singularValues[i] * svd.singularValues[i];", "sum += svd.singularValues[i];", "components"),
    Fault("a sample of delay in the decimation", "signal/resampler", "first + nearest - half, 2 * half + 1",
          "first + nearest - half + 1, 2 * half + 1", "model_input"),
    Fault("sinc squared in the filter", "signal/resampler", "weight * sinc(offset / factor)",
          "weight * sinc(offset / factor) * sinc(offset / factor)", "model_input"),
    Fault("H1 without its shift", "realization/hankel/hankel_decomposition",
          "shifted(y.tail(y.size() - 1), shape.rows", "shifted(y.head(y.size() - 1), shape.rows", "model"),
    Fault("sign of Sherman and Morrison", "realization/hankel/realized_poles", "/ (1.0 - last.squaredNorm())",
          "/ (1.0 + last.squaredNorm())", "model"),
    Fault("onset at the wrong root", "realization/exponentials/onset", "return nearestRoot(response, 1, search_s);",
          "return nearestRoot(response, 2, search_s);", "model"),
    Fault("penalty of BIC with the other sign", "realization/hankel/order_suggestion",
          "return bic + parameters * std::log(samples);", "return bic - parameters * std::log(samples);", "evidence"),
    Fault("u of zeta doubled", "realization/refinement/pole_uncertainty",
          "std::sqrt(damping.dot(covariance * damping))", "2.0 * std::sqrt(damping.dot(covariance * damping))",
          "model_assessment"),
    Fault("zeta halved in a reference's model", "reference/reference_sensitivity",
          "std::complex<double>(1.0 - r * r, 2.0 * model.zeta * r)",
          "std::complex<double>(1.0 - r * r, model.zeta * r)", "reference_transducer"),
    Fault("sign of the onset", "model_analysis/step_transform", "std::polar(1.0, w * onset_s)",
          "std::polar(1.0, -w * onset_s)", "response", short=True),
    Fault("a sample of delay in S(f)", "model_analysis/step_transform",
          "return std::complex<double>(0.0, x) / (1.0 - std::polar(1.0, -x));",
          "return std::complex<double>(0.0, x) / (std::polar(1.0, x) - 1.0);", "response"),
    Fault("sign of the poles in G(s)", "model_analysis/model_response", "/ (jw - model.poles", "/ (jw + model.poles",
          "response"),
    Fault("twice the front", "realization/exponentials/front", "0.5 * duration_s * s", "duration_s * s", "response"),
    Fault("the chain's phase added", "model_analysis/chain_correction", "point.phase_rad - chain.phase_rad",
          "point.phase_rad + chain.phase_rad", "response"),
    Fault("contradictions at half the limit", "consistency/way_comparison", "<= kContradiction * u;",
          "<= 0.5 * kContradiction * u;", "checks"),
    Fault("one-sided coverage factor", "base/propagation", "studentQuantile(0.5 * (1.0 + coverage), dof)",
          "studentQuantile(coverage, dof)", "uncertainty", short=True),
    Fault("k = 2 whatever the degrees of freedom", "uncertainty/reported_value",
          "return k > kUsualFactor ? k : kUsualFactor;", "return k > 0.0 ? kUsualFactor : kUsualFactor;",
          "uncertainty"),
    Fault("Welch-Satterthwaite with cubes", "base/uncertain_value", "std::pow(line.contribution, 4) / line.dof",
          "std::pow(line.contribution, 3) / line.dof", "uncertainty"),
    Fault("Welch-Satterthwaite with squares", "base/correlation", "shares[i] * shares[i] / parts[i].dof",
          "shares[i] / parts[i].dof", "uncertainty"),
    Fault("correlation counted once", "base/correlation", "shares[j] += crossed;", "shares[j] += 0.0 * crossed;",
          "uncertainty"),
    Fault("sensitivities twice too large", "base/propagation", "(*above - *below) / (2.0 * step)",
          "(*above - *below) / step", "uncertainty"),
    Fault("covariance at f in place of 2 f", "signal/dft_covariance",
          "spectralSums(variance, 2.0 * turns);\n    const double power",
          "spectralSums(variance, 1.0 * turns);\n    const double power", "uncertainty"),
    Fault("difference with the other sign", "uncertainty/transducer_comparison",
          "(s.magnitude[b] - t.magnitude[a]) / S", "(t.magnitude[a] - s.magnitude[b]) / S", "comparison"),
    Fault("rectangular draws too narrow", "base/input_draws", "return std::sqrt(3.0) * (2.0 * p - 1.0);",
          "return std::sqrt(2.0) * (2.0 * p - 1.0);", "monte_carlo"),
    Fault("a sample of delay in the correction", "correction/correction_filter",
          "filter.delaySamples = extent.before;", "filter.delaySamples = extent.before + 1;", "correction"),
    Fault("u rounded to one digit more", "base/rounding", "exponentOf(u) - kUncertaintyDigits + 1",
          "exponentOf(u) - kUncertaintyDigits", "certificate"),
    Fault("noise of S(f) a third of its size", "model_analysis/step_transform",
          "const double ofSamples = 0.5 * density", "const double ofSamples = 0.05 * density", "coverage", 40),
    Fault("u of the distances a tenth of its size", "shock/step_inputs", "s.distance_m, u_distance_m,",
          "s.distance_m, 0.1 * u_distance_m,", "uncertainty"),
    Fault("sensitivity 1 % too large", "model_analysis/shot_levels", "responses) * response.valueScale / *conditions",
          "responses) * 1.01 * response.valueScale / *conditions", "coverage", 40),
]


def commands_of(build):
    """How core's sources are compiled, and how the runner is linked."""
    listed = json.loads((build / "compile_commands.json").read_text())
    compiled = next(e["command"] for e in listed
                    if "dyncal_core.dir" in e["command"] and "c++-header" not in e["command"])
    words = [w for w in shlex.split(compiled) if w != "-Werror"]
    flags = words[1:words.index("-o")]
    linking = subprocess.run(["ninja", "-t", "commands", "selftest_runner"], cwd=build, check=True,
                             capture_output=True, text=True).stdout.splitlines()[-1]
    link = [w for w in shlex.split(linking.split("&&")[1])]
    return [words[0], *flags], link


def with_fault(fault):
    text = (ROOT / "core" / f"{fault.source}.cpp").read_text()
    if text.count(fault.right) != 1:
        raise ValueError(f"{fault.what}: {text.count(fault.right)} places in {fault.source}.cpp")
    return text.replace(fault.right, fault.wrong)


def found(runner, calibrations):
    done = subprocess.run([str(runner), str(calibrations)], capture_output=True, text=True, timeout=600)
    return done.stdout.strip() if done.returncode == 0 else f"ended with {done.returncode}: {done.stdout}"


def judged(fault, build, compile_words, link_words, folder):
    """The line for this fault, and whether it was found in its step."""
    source, faulty, runner = folder / "fault.cpp", folder / "fault.o", folder / "runner"
    source.write_text(with_fault(fault))
    subprocess.run([*compile_words, "-o", str(faulty), "-c", str(source)], cwd=build, check=True)
    link = list(link_words)
    link[link.index("-o") + 1] = str(runner)
    first = next(i for i, word in enumerate(link) if word.endswith(".o"))
    link[first:first] = ["-Wl,--allow-multiple-definition", str(faulty)]
    subprocess.run(link, cwd=build, check=True)
    answer = found(runner, fault.calibrations)
    is_found = answer.startswith(fault.step + ":")
    return f"{'found' if is_found else 'MISSED':7}{fault.what:52}{answer}", is_found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    build = options.build.resolve()
    faults = [f for f in FAULTS if (f.short or not options.short) and options.only in f.what]
    compile_words, link_words = commands_of(build)
    without = found(build / TARGET, max((f.calibrations for f in faults), default=0))
    print(f"without a fault: {without}")
    failed = without != "holds"

    def tried(fault):
        with tempfile.TemporaryDirectory(prefix="selftest_fault_") as folder:
            return judged(fault, build, compile_words, link_words, Path(folder))

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for line, is_found in pool.map(tried, faults):
            print(line, flush=True)
            failed |= not is_found
    print(f"{len(faults)} faults")
    sys.exit(1 if failed or not faults else 0)


if __name__ == "__main__":
    main()
