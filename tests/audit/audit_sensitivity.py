# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The mean sensitivity and its complete uncertainty, from what the capture states of tube and gas."""

import numpy as np

from audit_capability import Capability, held, with_line
from audit_report import SHARE, check_lines, combined, or_infinite, relative
from audit_shock import shocked

# Unless the recipe states them (docs/method/uncertainty.md, docs/method/shock.md).
U_GAMMA, U_MOLAR_MASS = 0.0005, 1e-5
# With the sign of dS/S: a gain that is larger than stated makes S smaller.
CHAIN = {"gain_relative": -0.005 / np.sqrt(3.0), "linearity_relative": 0.001 / np.sqrt(3.0), "mounting_relative": 0.001}
CLOCK_RELATIVE = 50e-6 / np.sqrt(3.0)


class ShotInputs:
    """One shot's level and the inputs of its step, each with its u: name -> (value, u, of all shots?)."""

    def __init__(self, shot, i, shock, fit, tube, attenuation):
        side = next(a for a in shock["arrivals"] if not a["dut"])
        rise = f"[{side['channel']}]"
        dut = f"[{next(a for a in shock['arrivals'] if a['dut'])['channel']}]"
        at = shot.environment
        gas = shock["driven_gas"]
        self.shot = shot.number
        self.level = fit.amplitudes(i)[0]
        self.names = [f"distance_m{rise}", f"arrival_s{rise}", f"delay_s{rise}", f"arrival_s{dut}",
                      "attenuation_per_m", "t1_k", "p1_pa", "gamma", "molar_mass_kg_mol"]
        self.values = np.array([
            float(tube["endflange_to_sensor2_m"]), side["arrival_s"], 0.0, fit.onset_s(i), np.mean(attenuation),
            at["T1_K"], at["p1_Pa"], gas["gamma"], gas["molar_mass_kg_mol"]])
        self.u = np.array([
            float(tube["u_endflange_to_sensor2_m"]), side["u_arrival_s"], side["u_delay_s"], fit.u_onset_s(i),
            np.ptp(attenuation) / np.sqrt(12.0), at["u_T1_K"], at["u_p1_Pa"], U_GAMMA, U_MOLAR_MASS])
        self.is_own = [name.startswith("arrival_s") for name in self.names]
        self.u_level_relative = fit.u_level_relative(i)

    def sensitivity(self, move=0.0):
        """With the inputs moved by so much."""
        distance, side, delay, onset, attenuation, T1, p1, gamma, molar = self.values + move
        span = onset - (side - delay)
        velocity = 1.0 / (span / distance + 0.5 * span * attenuation)  # first order in the attenuation
        return self.level / (shocked(velocity, T1, p1, gamma, molar)[1] - p1)

    def contribution_relative(self, k):
        """Of input k, by the difference over a tenth of its u to either side."""
        move = np.zeros(len(self.values))
        move[k] = 0.1 * self.u[k]
        return (self.sensitivity(move) - self.sensitivity(-move)) / 0.2 / self.sensitivity()


    def step_lines(self):
        """(name, is of this shot alone) -> (contribution, relative; degrees of freedom) of the step."""
        return {(name, own): (self.contribution_relative(k), np.inf)
                for k, (name, own) in enumerate(zip(self.names, self.is_own))}


def budget_of(shots, chain_lowest=None):
    """(quantity, shot or None) -> (contribution to the plain mean of these shots, degrees of freedom)
    (docs/method/sensitivity.md). `chain_lowest`: the lowest row of the chain's table, where there is one."""
    n = len(shots)
    mean = np.mean([shot.sensitivity() for shot in shots])
    lines = {}
    for shot in shots:
        for (name, is_own), (c, dof) in shot.step_lines().items():
            place = (name, shot.shot if is_own else None)
            lines[place] = lines.get(place, (0.0, dof))[0] + mean * c / n, dof
        lines["level_relative", shot.shot] = shot.u_level_relative * mean / n, np.inf
    lines.update({(name, None): (u * mean, np.inf) for name, u in CHAIN.items()})
    if chain_lowest:
        lines["chain_relative", None] = chain_lowest.u_relative() * mean, np.inf
    return mean, lines


def share_of_line(quantity):
    """The program lets distances and times change the straight path alone, not the attenuation's curvature
    (a thousandth of it here) with them."""
    return 2e-3 if quantity.startswith(("distance_m", "arrival_s", "delay_s")) else 2e-4


def check_mean(report, name, stated, mean, lines, capability):
    u, dof, k = held(*combined(lines.values()), capability.least("sensitivity", mean))
    report.compare(f"{name} (V/Pa)", stated["value"], mean, relative(mean, 1e-7))
    report.compare(f"u of {name} (V/Pa)", stated["u"], u, relative(u, 2e-4))
    report.compare(f"dof of {name}", or_infinite(stated["dof"]), dof, relative(dof, 1e-3) if dof < np.inf else 0.0)
    report.compare(f"k of {name}", stated["k"], k, 1e-5)


def check_shot(report, one, shot, chain_lowest, capability):
    value, lines = budget_of([one], chain_lowest)
    u, _, k = held(*combined(lines.values()), capability.least("sensitivity", value))
    report.compare(f"shot {one.shot} sensitivity (V/Pa)", shot.stated["sensitivity"], value, relative(value, 1e-7))
    report.compare(f"shot {one.shot} u(sensitivity)", shot.stated["u_sensitivity"], u, relative(u, 2e-4))
    report.compare(f"shot {one.shot} k(sensitivity)", shot.stated["k_sensitivity"], k, 1e-5)
    report.compare(f"shot {one.shot} u(level), relative", shot.stated["u_level_relative"],
                   one.u_level_relative, relative(one.u_level_relative, SHARE))


def check_sensitivity(report, results, inputs, shots, chain_lowest):
    """`inputs` of each shot: ShotInputs, or those by a transducer. Returns mean and lines."""
    capability = Capability(results)
    mean, lines = budget_of(inputs, chain_lowest)
    stated = results["sensitivity"]
    check_mean(report, "mean sensitivity", stated, mean, lines, capability)
    for level in stated["per_level"]:
        own = [i for i, shot in zip(inputs, shots) if shot.stated["level"] == level["level"]]
        check_mean(report, f"sensitivity of level {level['level']}", level, *budget_of(own, chain_lowest), capability)
    for one, shot in zip(inputs, shots):
        check_shot(report, one, shot, chain_lowest, capability)
    lines_with_cmc = with_line(lines, capability.least("sensitivity", mean))
    check_lines(report, "sensitivity", results["budget"], lines_with_cmc, share_of_line)
    return mean, lines
