# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The model's response and characteristics with their u, from the joint fit's own covariance by differences."""

from functools import lru_cache

import numpy as np
from scipy import optimize

from audit_capability import Capability, with_line
from audit_report import relative
from audit_row import FRONT_S
from audit_sensitivity import CHAIN, CLOCK_RELATIVE

MOUNTING = CHAIN["mounting_relative"]
STEP = 0.1  # of a parameter's u


class Oscillation:
    """The mean over the shots, level 1 and onset at 0: y(t) = 1 + 2 Re(c e^(s t))."""

    def __init__(self, s, c):
        self.s, self.c = s, c

    def gain(self, f):
        jw = 2j * np.pi * np.asarray(f)
        return 1.0 + self.c * jw / (jw - self.s) + np.conj(self.c) * jw / (jw - np.conj(self.s))

    def step(self, t):
        return 1.0 + 2.0 * (self.c * np.exp(self.s * np.asarray(t))).real

    def behind_front(self, duration_s):
        """As it would be if what was taken for a sharp step had risen for so long (docs/method/front.md)."""
        half = 0.5 * self.s * duration_s
        return Oscillation(self.s, self.c * half / np.sinh(half))

    def with_level(self, added):
        """Beside a level of which a share is not its own all that rings is smaller (docs/method/uncertainty.md)."""
        return Oscillation(self.s, self.c / (1.0 + added))

    def first(self, values, axis, function):
        """Where `function` first changes its sign, to full precision."""
        k = np.flatnonzero(np.diff(np.sign(values)))[0]
        return optimize.brentq(function, axis[k], axis[k + 1], xtol=1e-15 * axis[-1], rtol=1e-14)

    def characteristics(self, f_max):
        """By their names in results.json; band edges above f_max are left out."""
        f0 = abs(self.s) / (2.0 * np.pi)
        f = np.linspace(0.0, 3.0 * f0, 3001)
        gain = np.abs(self.gain(f))
        edge = {"within_5_percent_hz": lambda g: np.minimum(0.05 - (g - 1.0), g - 0.95),
                "within_10_percent_hz": lambda g: np.minimum(0.10 - (g - 1.0), g - 0.90),
                "minus_3_db_hz": lambda g: g - np.sqrt(0.5)}
        found = {name: self.first(inside(gain), f, lambda x, inside=inside: inside(np.abs(self.gain(x))))
                 for name, inside in edge.items()}
        found = {name: value for name, value in found.items() if value <= f_max}
        top = f[gain.argmax()]
        found["resonance_hz"] = optimize.brentq(self._slope_of_power, 0.98 * top, 1.02 * top, xtol=1e-9 * f0)
        found["resonance_gain"] = abs(self.gain(found["resonance_hz"]))
        return {**found, **self._of_step(f0)}

    def _slope_of_power(self, f):
        """d|G|^2/dw: 2 Re(G* G'), where the derivative of jw/(jw - s) is -s/(jw - s)^2 j."""
        jw = 2j * np.pi * f
        slope = -1j * (self.c * self.s / (jw - self.s)**2
                       + np.conj(self.c * self.s) / (jw - np.conj(self.s))**2)
        return (np.conj(self.gain(f)) * slope).real

    def _of_step(self, f0):
        t = np.arange(0.0, 6.0 / -self.s.real, 2e-3 / f0)
        y = self.step(t)
        cross = {level: self.first(y - level, t, lambda x, level=level: self.step(x) - level) for level in (0.1, 0.9)}
        angle = np.angle(self.c * self.s)  # the slope is zero where it and Im(s) t make a quarter turn
        tops = (0.5 * np.pi + np.pi * np.arange(-2, 3) - angle) / self.s.imag
        top = min(x for x in tops if x > 0.2 / f0)
        last = np.flatnonzero(np.abs(y - 1.0) > 0.05)[-1]
        settled = optimize.brentq(lambda x: abs(self.step(x) - 1.0) - 0.05, t[last], t[last + 1], xtol=1e-18)
        return {"rise_time_s": cross[0.9] - cross[0.1], "overshoot_percent": 100.0 * (self.step(top) - 1.0),
                "settling_time_s": settled}


def oscillation(fit, x):
    """Of parameters as in JointFit.covariance(); every shot's onset is found again."""
    s, amplitudes = complex(x[0], x[1]), []
    for i, shot in enumerate(fit.shots):
        level, re, im = x[2 + 3 * i:5 + 3 * i]
        behind = fit.onset_of(i, [x[0], x[1], level, re, im]) - shot.time_s(shot.first)
        amplitudes.append(0.5 * complex(re, im) * np.exp(s * behind) / level)
    return Oscillation(s, np.mean(amplitudes))


def u_by_differences(fit, value):
    """Of an array that `value` makes of an Oscillation."""
    x = np.concatenate([[fit.rate.real, fit.rate.imag]] + [fit.amplitudes(i) for i in range(len(fit.shots))])
    V = fit.covariance()
    J = []
    for move in np.diag(STEP * np.sqrt(np.diag(V))):
        J.append((value(oscillation(fit, x + move)) - value(oscillation(fit, x - move))) / (2.0 * move.sum()))
    return np.sqrt(np.einsum("kf,kl,lf->f", J, V, J)), oscillation(fit, x)


@lru_cache(maxsize=4)
def u_of_gain(fit, frequencies_Hz):
    """Of magnitude, relative, and of phase."""
    own, middle = u_by_differences(fit, lambda one: np.log(np.abs(one.gain(frequencies_Hz))))
    of_phase, _ = u_by_differences(fit, lambda one: np.unwrap(np.angle(one.gain(frequencies_Hz))))
    return own, of_phase, middle


@lru_cache(maxsize=4)
def u_of_characteristics(fit, names, f_max):
    return u_by_differences(fit, lambda one: np.array([one.characteristics(f_max)[name] for name in names]))[0]


def check_model_rows(report, results, name, fit, sensitivity, u_common, rows, chain):
    """The model's curve at the rows of results[name] or at the marked ones (`name` "response.marked"), its u, and E_n
    of the measured against it. `chain`: its table (KnownTable), or None."""
    section = results[name.split(".")[0]]
    section = section["marked"] if name.endswith(".marked") else section
    title, capability = name, Capability(results)
    f = np.array(section["frequency_hz"])
    own, of_phase, middle = u_of_gain(fit, tuple(f))
    H = [chain.at(x) if chain else None for x in f]
    size = np.array([h.magnitude if h else 1.0 for h in H])
    u_chain = np.array([h.u_relative() if h else 0.0 for h in H])
    u_chain_phase = np.array([h.u_phase_rad or 0.0 if h else 0.0 for h in H])
    model = np.array(section["model_magnitude"])
    # The program weighs the shots' amplitudes by their noise, this the shots alike.
    gain = np.abs(np.mean([fit.gain(i, f) for i in range(len(fit.shots))], axis=0))
    report.compare(f"{title}: model's magnitude, largest difference",
                   np.abs(model * size / sensitivity / gain - 1.0).max(), 0.0, 1e-4)
    front = np.log(middle.behind_front(FRONT_S).gain(f) / middle.gain(f)) / np.sqrt(5.0)
    u = model * np.sqrt(own**2 + front.real**2 + u_common**2 + u_chain**2)
    u = np.maximum(u, [0.5 * capability.least("magnitude", m, x) for m, x in zip(model, f)])
    report.compare_all(f"{title}: u of the model's magnitude", section["u_model_magnitude"], u, 1e-3 * u)
    check_e_n(report, section, title, model, own * model, rows)
    if chain and not chain.has_phase:
        report.equal(f"{title}: phases of the model", set(section["u_model_phase_rad"]), {None})
        return
    u_phase = np.sqrt(of_phase**2 + front.imag**2 + u_chain_phase**2)
    u_phase = np.maximum(u_phase, [0.5 * capability.least("phase_rad", 1.0, x) for x in f])
    report.compare_all(f"{title}: u of the model's phase (rad)", section["u_model_phase_rad"], u_phase, 2e-3 * u_phase)


def check_e_n(report, section, title, model, own, rows):
    """Both from one noise: the difference has the variance of the one less that of the other, the bounds, and what
    is known of a transducer's sensitivity, which is the measured row's alone."""
    stated = [k for k, _ in rows]
    column = {key: np.array([section[key][k] for k in stated])
              for key in ("magnitude", "u_noise_magnitude", "bound_end", "bound_alias", "e_n")}
    of_reference = np.array([row.lines.get("reference_sensitivity", (0.0, 0.0))[0] for _, row in rows])
    u = np.sqrt(np.abs(column["u_noise_magnitude"]**2 - own[stated]**2) + of_reference**2
                + (column["bound_end"]**2 + column["bound_alias"]**2) / 3.0)
    expected = (column["magnitude"] - model[stated]) / (1.959963984540054 * u)
    report.compare_all(f"{title}: E_n", column["e_n"], expected, 1e-3 * np.abs(expected) + 1e-6)


def check_characteristics(report, results, fit):
    """Each value and its lines; of what is stated."""
    f_max, capability = results["response"]["f_high_hz"], Capability(results)
    middle = u_of_gain(fit, tuple(results["response"]["frequency_hz"]))[2]
    values = middle.characteristics(f_max)
    names = [one["quantity"] for one in results["characteristics"] if one["quantity"] in values]
    u = u_of_characteristics(fit, tuple(names), 2.0 * f_max)
    later = middle.behind_front(FRONT_S).characteristics(2.0 * f_max)
    more, less = (middle.with_level(added).characteristics(2.0 * f_max) for added in (MOUNTING, -MOUNTING))
    for name, noise in zip(names, u):
        stated = next(one for one in results["characteristics"] if one["quantity"] == name)
        lines = {line["quantity"]: line["contribution"] for line in results["budget"] if line["of"] == name}
        front = abs(later[name] - values[name]) / np.sqrt(5.0)
        expected = {"noise": (noise, fit.dof()), "front_unknown": (front, np.inf),
                    "mounting_relative": (0.5 * (more[name] - less[name]), np.inf)}
        if name.endswith(("_hz", "_s")):
            expected["clock_relative"] = values[name] * CLOCK_RELATIVE, np.inf
        expected = with_line(expected, capability.least(name, values[name]))
        # The program weighs the shots' amplitudes by their noise, this the shots alike.
        report.compare(name, stated["value"], values[name], 0.2 * noise + relative(values[name], 1e-9))
        report.equal(f"lines of {name}", sorted(lines), sorted(expected))
        for quantity in lines:
            value = expected.get(quantity, (np.nan, 0.0))[0]
            report.compare(f"{name}: {quantity}", lines[quantity], value, relative(value, 2e-3))


def check_marks(report, results, fit):
    """Frequencies of the marked rows: ends of the band; edges and resonance inside it, which with the chain divided
    out are not those of the curve."""
    response, marked = results["response"], results["response"]["marked"]
    low, high = response["f_low_hz"], response["f_high_hz"]
    middle = u_of_gain(fit, tuple(response["frequency_hz"]))[2]
    values = middle.characteristics(high)
    expected = {} if results["chain"] else {key.replace("_hz", ""): values[key] for key in values
                                            if key.startswith(("within", "minus", "resonance_hz"))}
    expected.update({"f_low": low, "f_high": high})
    expected = {name: f for name, f in expected.items() if low <= f <= high}
    report.equal("marks", sorted(marked["at"]), sorted(expected))
    for name, f in zip(marked["at"], marked["frequency_hz"]):
        at = expected.get(name, np.nan)
        share = 0.0 if name in ("f_low", "f_high") else 1e-4
        report.compare(f"frequency of the mark {name} (Hz)", f, at, relative(at, share))
