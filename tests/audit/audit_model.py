# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The model's response and characteristics with their u, from the joint fit's own covariance by differences."""

from functools import lru_cache

import numpy as np
from scipy import optimize

from audit_report import relative
from audit_rows import FRONT_S
from audit_sensitivity import CLOCK_RELATIVE

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


def check_model_uncertainty(report, results, fit):
    response = results["response"]
    f, model = np.array(response["frequency_hz"]), np.array(response["model_magnitude"])
    own, of_phase, middle = u_of_gain(fit, tuple(f))
    front = np.log(middle.behind_front(FRONT_S).gain(f) / middle.gain(f)) / np.sqrt(5.0)
    u = model * np.sqrt(own**2 + front.real**2 + response["u_common_relative"]**2)
    report.compare_all("u of the model's magnitude", response["u_model_magnitude"], u, 1e-3 * u)
    u_phase = np.hypot(of_phase, front.imag)
    report.compare_all("u of the model's phase (rad)", response["u_model_phase_rad"], u_phase, 2e-3 * u_phase)
    check_e_n(report, response, model, own * model)
    check_characteristics(report, results, fit, middle)


def check_e_n(report, response, model, own):
    """Both from one noise: the difference has the variance of the one less that of the other, and the bounds."""
    stated = [k for k, value in enumerate(response["magnitude"]) if value is not None]
    column = {key: np.array([response[key][k] for k in stated])
              for key in ("magnitude", "u_noise_magnitude", "bound_end", "bound_alias", "e_n")}
    u = np.sqrt(np.abs(column["u_noise_magnitude"]**2 - own[stated]**2)
                + (column["bound_end"]**2 + column["bound_alias"]**2) / 3.0)
    expected = (column["magnitude"] - model[stated]) / (1.959963984540054 * u)
    report.compare_all("E_n", column["e_n"], expected, 1e-3 * np.abs(expected) + 1e-6)


def check_characteristics(report, results, fit, middle):
    """Each value and its lines; of what is stated."""
    f_max = results["response"]["f_high_hz"]
    values = middle.characteristics(f_max)
    names = [one["quantity"] for one in results["characteristics"] if one["quantity"] in values]
    u = u_of_characteristics(fit, tuple(names), 2.0 * f_max)
    later = middle.behind_front(FRONT_S).characteristics(2.0 * f_max)
    for name, noise in zip(names, u):
        stated = next(one for one in results["characteristics"] if one["quantity"] == name)
        lines = {line["quantity"]: line["contribution"] for line in results["budget"] if line["of"] == name}
        expected = {"noise": noise, "front_unknown": abs(later[name] - values[name]) / np.sqrt(5.0)}
        if name.endswith(("_hz", "_s")):
            expected["clock_relative"] = values[name] * CLOCK_RELATIVE
        # The program weighs the shots' amplitudes by their noise, this the shots alike.
        report.compare(name, stated["value"], values[name], 0.2 * noise + relative(values[name], 1e-9))
        report.equal(f"lines of {name}", sorted(lines), sorted(expected))
        for quantity, value in expected.items():
            report.compare(f"{name}: {quantity}", lines[quantity], value, relative(value, 2e-3))
