#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The identification methods of docs/accuracy.md once more, in numpy and sharing no code with Dyncal.

    reference_methods.py printed [TRIALS [DEFINITION ...]]
        standard deviations by this implementation, for each way the noise may have been meant,
        beside those printed for the reference (20 trials each), with the Cramer-Rao bound and the
        chance that 20 trials give a number as low, or as high, as the printed one
    reference_methods.py paired FOLDER
        reads the records and Dyncal's estimates written by `method_table TRIALS FOLDER` and
        compares standard deviations on the same records
"""
import os
import sys

os.environ.setdefault("OMP_NUM_THREADS", "1")
import numpy as np  # noqa: E402
import scipy.linalg  # noqa: E402
import scipy.optimize  # noqa: E402

SAMPLES, BEFORE = 400, 200
STEPS = np.array([0.33, 0.6, 0.9])
BITS_STEP = 1.0 / 8192.0  # 14 bits over -1 .. 1
QUANTITIES = ("fn", "zeta", "plateau")


# The truth ------------------------------------------------------------------------------------
def step_response(f0, zeta, rate, first, count=SAMPLES):
    """Unit step of the second-order sensor at (first + k)/rate; 0 before the step."""
    t = (np.arange(count) + first) / rate
    w = 2 * np.pi * f0
    root = np.sqrt(1 - zeta**2)
    after = np.maximum(t, 0)
    y = 1 - np.exp(-zeta * w * after) * (np.cos(root * w * after)
                                         + zeta / root * np.sin(root * w * after))
    return np.where(t > 0, y, 0.0)


def bound(f0, zeta, rate, first, gains, noise):
    """Cramer-Rao bound of fn and zeta in per cent: pole shared by records of amplitude `gains`,
    white noise `noise` in each; plateau and amplitudes of each record free."""
    w, root = 2 * np.pi * f0, np.sqrt(1 - zeta**2)
    a, b = -zeta * w, root * w
    J = pair_jacobian(a, b, -1.0, -zeta / root, (np.arange(SAMPLES) + first) / rate)
    pole, rest = J[:, :2], J[:, 2:]
    free = pole - rest @ np.linalg.lstsq(rest, pole, rcond=None)[0]
    covariance = np.linalg.inv(free.T @ free * np.sum(np.square(gains) / np.square(noise)))
    to_fn = np.array([a, b]) / w**2
    to_zeta = np.array([-b * b, a * b]) / w**3 / zeta
    return [100 * np.sqrt(g @ covariance @ g) for g in (to_fn, to_zeta)]


# The methods ----------------------------------------------------------------------------------
def hankel(y, rows):
    return scipy.linalg.hankel(y[:rows], y[rows - 1:])


def left_vectors(H, count):
    """Leading left singular vectors and values; the noise floor is far above sqrt(rounding)."""
    values, vectors = scipy.linalg.eigh(H @ H.T, subset_by_index=[len(H) - count, len(H) - 1])
    return vectors[:, ::-1], np.sqrt(np.maximum(values[::-1], 0))


def shift_poles(U):
    return np.linalg.eigvals(np.linalg.lstsq(U[:-1], U[1:], rcond=None)[0])


def upper(poles, rate):
    """fn and zeta of the oscillating pole with the largest modulus; None without one."""
    pairs = [z for z in poles if z.imag > 1e-12]
    if not pairs:
        return None
    s = np.log(max(pairs, key=abs)) * rate
    return abs(s) / (2 * np.pi), -s.real / abs(s)


def plateau(y, z):
    """Constant of the least-squares fit of 1, z^k and its conjugate."""
    powers = z ** np.arange(len(y))
    basis = np.column_stack([np.ones(len(y)), powers.real, powers.imag])
    return np.linalg.lstsq(basis, y, rcond=None)[0]


def thesis(y, rate, order):
    """(a): the listing of appendix D. Its first sample is H_1; square matrices."""
    m = len(y) // 2 - 1
    H0, H1 = hankel(y[:2 * m - 1], m), hankel(y[1:2 * m], m)
    U, s = left_vectors(H0, order)
    V = (H0.T @ U) / s
    A = (U.T @ H1 @ V) / np.sqrt(np.outer(s, s))
    found = upper(np.linalg.eigvals(A), rate)
    return (*found, plateau(y, np.exp(pole_of(*found) / rate))[0]) if found else None


def differenced(y, rate):
    """(b): Hankel matrix of the first difference; plateau = C (I - A)^-1 B."""
    h = np.diff(y)
    H = hankel(h, len(h) // 2)
    U, _ = left_vectors(H, 2)
    A = np.linalg.lstsq(U[:-1], U[1:], rcond=None)[0]
    found = upper(np.linalg.eigvals(A), rate)
    if found is None:
        return None
    B = (U.T @ H)[:, 0]
    return (*found, y[0] + U[0] @ np.linalg.solve(np.eye(2) - A, B))


def deflated(records, rate, weights):
    """(c): rows' means taken away from each record's Hankel matrix, the matrices side by side."""
    H = np.hstack([M - M.mean(axis=1, keepdims=True)
                   for M in (w * hankel(y, len(y) // 2) for y, w in zip(records, weights))])
    U, _ = left_vectors(H, 2)
    found = upper(shift_poles(U), rate)
    if found is None:
        return None
    s = pole_of(*found)
    return (*found, np.mean([plateau(y, np.exp(s / rate))[0] for y in records]))


def pole_of(fn, zeta):
    return 2 * np.pi * fn * complex(-zeta, np.sqrt(1 - zeta**2))


def pair_jacobian(a, b, p, q, t):
    """Of c0 + e^(a t) (p cos b t + q sin b t) after a, b, c0, p, q."""
    e, c, s = np.exp(a * t), np.cos(b * t), np.sin(b * t)
    return np.column_stack([t * e * (p * c + q * s), t * e * (q * c - p * s),
                            np.ones_like(t), e * c, e * s])


def refined(records, rate, weights, start):
    """(e): nonlinear least squares over the shared pole and each record's c0, p, q."""
    t = np.arange(len(records[0])) / rate
    s = pole_of(*start[:2])
    unit = abs(s)

    def split(x):
        return x[0] * unit, x[1] * unit, x[2:].reshape(-1, 3)

    def residual(x):
        a, b, own = split(x)
        return np.concatenate([w * (c0 + np.exp(a * t) * (p * np.cos(b * t) + q * np.sin(b * t)) - y)
                               for (c0, p, q), y, w in zip(own, records, weights)])

    def jacobian(x):
        a, b, own = split(x)
        J = np.zeros((len(t) * len(records), len(x)))
        for r, ((_, p, q), w) in enumerate(zip(own, weights)):
            block = w * pair_jacobian(a, b, p, q, t)
            rows = slice(r * len(t), (r + 1) * len(t))
            J[rows, :2] = block[:, :2] * unit
            J[rows, 2 + 3 * r:5 + 3 * r] = block[:, 2:]
        return J

    x0 = [s.real / unit, s.imag / unit]
    for y in records:
        c0, p, q = plateau(y, np.exp(s / rate))
        x0 += [c0, p, q]
    x = scipy.optimize.least_squares(residual, x0, jacobian, method="lm", xtol=1e-12).x
    a, b, own = split(x)
    w = np.hypot(a, b)
    return w / (2 * np.pi), -a / w, np.mean(own[:, 0])


def moesp(y, before, rate, block=60):
    """(d): PO-MOESP with the known step at the input, samples before it included."""
    y = np.concatenate([before, y])
    u = np.concatenate([np.zeros(len(before)), np.ones(len(y) - len(before))])
    U, Y = (hankel(x, 2 * block) for x in (u, y))
    stacked = np.vstack([U[block:], U[:block], Y[:block], Y[block:]])
    L = np.linalg.qr(stacked.T, mode="r").T
    left, _ = left_vectors(L[3 * block:, block:3 * block], 2)
    return upper(shift_poles(left), rate)


# What was printed for the reference -------------------------------------------------------------
# name, f0, zeta, rate, dB, {method: {quantity: (bias, sd, last digit of sd)}}
def cells(fn, zeta, dc=None):
    return {"fn": fn, "zeta": zeta, **({"plateau": dc} if dc else {})}


CASES = [
    ("30 kHz, zeta 0.05, 40 dB", 30e3, 0.05, 1e6, 40, {
        "a+": cells((-.002, .0115, 1e-4), (.11, .24, .01), (.09, .06, .01)),
        "b": cells((.002, .0174, 1e-4), (.23, .24, .01), (.29, .51, .01)),
        "c": cells((-.002, .0113, 1e-4), (.11, .24, .01), (.09, .06, .01)),
        "d": cells((-.005, .0132, 1e-4), (.07, .32, .01)),
        "e": cells((-.003, .0102, 1e-4), (.10, .23, .01), (.09, .06, .01))}),
    ("318 kHz, zeta 0.02, 40 dB", 318e3, 0.02, 1e6, 40, {
        "a+": cells((.002, .007, 1e-3), (-.09, .46, .01), (.03, .065, .005)),
        "b": cells((.002, .0075, 5e-4), (-.13, .46, .01), (-.18, .55, .01)),
        "c": cells((.002, .007, 1e-3), (-.09, .46, .01), (.03, .065, .005)),
        "d": cells((.002, .0075, 5e-4), (-.08, .47, .01)),
        "e": cells((.002, .007, 1e-3), (-.09, .46, .01), (.03, .065, .005))}),
    ("200 kHz at 10 MHz, zeta 0.02, 40 dB", 200e3, 0.02, 10e6, 40, {
        "a+": cells((-.0006, .005, 1e-3), (.01, .22, .01)),
        "b": cells((-.003, .009, 1e-3), (.07, .23, .01)),
        "c": cells((-.0006, .005, 1e-3), (.016, .215, .005)),
        "d": cells((.003, .005, 1e-3), (.06, .18, .01)),
        "e": cells((.001, .005, 1e-3), (.04, .13, .01))}),
    ("30 kHz, zeta 0.05, 20 dB", 30e3, 0.05, 1e6, 20, {
        "a+": cells((-.014, .11, .01), (-.4, 2.5, .1), (.06, .60, .01)),
        "b": cells((.22, .20, .01), (16., 4.2, .1), (6.7, 7.0, .1)),
        "c": cells((-.014, .11, .01), (-.4, 2.6, .1), (.06, .60, .01)),
        "d": cells((-.018, .15, .01), (-.8, 3.1, .1)),
        "e": cells((-.003, .096, 1e-3), (-.55, 2.3, .1), (.07, .60, .01))}),
    ("30 kHz, zeta 0.5, 40 dB", 30e3, 0.5, 1e6, 40, {
        "a+": cells((.07, .56, .01), (.09, .52, .01)),
        "b": cells((9.9, 6.0, .1), (35., 26., 1.)),
        "c": cells((.04, .55, .01), (.055, .51, .01)),
        "d": cells((.02, .54, .01), (.04, .50, .01)),
        "e": cells((.0005, .54, .01), (.03, .49, .01))}),
]
# Three shots of equal noise: fn, zeta.
SHOT_CASES = [
    ("30 kHz, zeta 0.05, 40 dB", 30e3, 0.05, 1e6, 40, {
        "average": cells((None, .0182, 1e-4), (None, .43, .01)),
        "weighted": cells((None, .0141, 1e-4), (None, .29, .01)),
        "stacked": cells((None, .0141, 1e-4), (None, .29, .01)),
        "best": cells((None, .0223, 1e-4), (None, .36, .01))}),
    ("318 kHz, zeta 0.02, 40 dB, starts within a sample", 318e3, 0.02, 1e6, 40, {
        "average": cells((None, .0198, 1e-4), (None, 1.06, .01)),
        "weighted": cells((None, .0141, 1e-4), (None, .69, .01)),
        "stacked": cells((None, .0120, 1e-4), (None, .65, .01))}),
]

# Noise sd of a shot over its own step, by what "SNR" refers to (y: the response to a unit step).
DEFINITIONS = {
    "step": lambda y: np.ones(3),
    "rms": lambda y: np.full(3, np.sqrt(np.mean(y**2))),
    "peak": lambda y: np.full(3, y.max()),
    "ringing": lambda y: np.full(3, y.std()),
    "range": lambda y: 1.0 / STEPS,
}
# Noise sd in units of the range, the same in all shots.
SHOT_DEFINITIONS = {"range": 1.0, "largest step": 0.9, "mean step": STEPS.mean(),
                    "smallest step": 0.33}


# Trials -------------------------------------------------------------------------------------------
def shots(case, noise, starts, rng):
    """Three records, 200 samples before the step and 400 from it on, in units of the range."""
    _, f0, zeta, rate, _, _ = case
    records = [a * step_response(f0, zeta, rate, first - BEFORE, BEFORE + SAMPLES)
               + sd * rng.standard_normal(BEFORE + SAMPLES)
               for a, sd, first in zip(STEPS, noise, starts)]
    return [np.round(y / BITS_STEP) * BITS_STEP for y in records]


def remapped(y):
    """0 .. 1: less the mean before the step, over the mean of the last fifth."""
    y = y - y[:BEFORE].mean()
    return y / y[-SAMPLES // 5:].mean()


def method_trial(case, noise, rng):
    rate = case[3]
    whole = np.mean([remapped(y) for y in shots(case, noise, np.zeros(3), rng)], axis=0)
    before, y = whole[:BEFORE], whole[BEFORE:]
    one = [1.0]
    step = deflated([y], rate, one)
    return {"a": thesis(y, rate, 2), "a+": thesis(y, rate, 3), "b": differenced(y, rate),
            "c": step, "d": moesp(y, before, rate),
            "e": refined([y], rate, one, step) if step else None}


def shot_trial(case, noise, rng):
    rate = case[3]
    starts = rng.random(3) if "starts" in case[0] else np.zeros(3)
    raw = shots(case, noise, starts, rng)
    raw = [y - y[:BEFORE].mean() for y in raw]
    records = [y[BEFORE:] for y in raw]
    over = [y / y[-SAMPLES // 5:].mean() for y in records]
    square = STEPS**2 / np.sum(STEPS**2)
    one = [1.0]
    return {"average": deflated([np.mean(over, axis=0)], rate, one),
            "weighted": deflated([np.einsum("i,ij", square, over)], rate, one),
            "stacked": deflated(records, rate, np.ones(3)),
            "best": deflated([records[2]], rate, one)}


def per_cent(estimate, case, quantity):
    """Error in per cent; nan where the method gave nothing."""
    i = QUANTITIES.index(quantity)
    if estimate is None or len(estimate) <= i:
        return np.nan
    truth = (case[1], case[2], 1.0)[i]
    return 100 * (estimate[i] / truth - 1)


def errors(case, noise, trial, trials, seed):
    """{(method, quantity): errors of all trials}."""
    rng = np.random.default_rng(seed)
    found = [trial(case, noise, rng) for _ in range(trials)]
    return {(m, q): np.array([per_cent(f[m], case, q) for f in found])
            for m in found[0] for q in QUANTITIES}


def chances(values, sd, digit, rng, draws=20000):
    """Chance that the sd of 20 trials is at most, and at least, the printed one (as rounded)."""
    values = values[~np.isnan(values)]
    of20 = np.std(rng.choice(values, (draws, 20)), axis=1, ddof=1)
    return np.mean(of20 < sd + digit / 2), np.mean(of20 > sd - digit / 2)


def compare(case, found, limits):
    """Rows of the table; `limits` gives the bound of fn and zeta by method."""
    rng = np.random.default_rng(7)
    for method, quantities in case[5].items():
        for quantity, (bias, sd, digit) in quantities.items():
            values = found[method, quantity]
            own, mean = np.nanstd(values, ddof=1), np.nanmean(values)
            low, high = chances(values, sd, digit, rng)
            has_bound = quantity != "plateau" and method in limits
            limit = "%.4f" % limits[method][QUANTITIES.index(quantity)] if has_bound else ""
            shift = "" if bias is None else "%+.1f" % ((bias - mean) / (own / np.sqrt(20)))
            print("| %s | %s | %s | %.4g | %+.4f +- %.4f | %s | %.2f | %.3f | %.3f | %s |" % (
                case[0], method, quantity, sd, mean, own, limit, sd / own, low, high, shift),
                flush=True)


def pooled(case_errors, methods):
    """rms of printed over found sd of independent numbers, and the chance of less and of more."""
    rng = np.random.default_rng(8)
    ratios, simulated = [], []
    for case, found in case_errors:
        for quantity in ("fn", "zeta"):
            for method in methods:
                if method not in case[5]:
                    continue
                values = found[method, quantity]
                values = values[~np.isnan(values)]
                own = values.std(ddof=1)
                ratios.append(case[5][method][quantity][1] / own)
                of20 = np.std(rng.choice(values, (20000, 20)), axis=1, ddof=1)
                simulated.append(of20 / own)
    rms = np.sqrt(np.mean(np.square(ratios)))
    drawn = np.sqrt(np.mean(np.square(simulated), axis=0))
    return rms, np.mean(drawn <= rms), np.mean(drawn >= rms)


HEADER = ("| case | method | quantity | printed sd | found bias +- sd, % | bound | printed/found "
          "| P(20 <=) | P(20 >=) | (bias - found)/u |\n|---|---|---|---|---|---|---|---|---|---|")


def print_printed(trials, wanted):
    for name, scale in DEFINITIONS.items():
        if wanted and name not in wanted:
            continue
        print("\n## 2.3, noise relative to: %s; %d trials\n%s" % (name, trials, HEADER))
        all_errors = []
        for number, case in enumerate(CASES):
            y = step_response(*case[1:4], 0.0)
            relative = 10 ** (-case[4] / 20) * scale(y)
            found = errors(case, relative * STEPS, method_trial, trials, number)
            # The average of three with equal weights, which is what all these methods see.
            mean_sd = np.sqrt(np.sum(relative**2)) / 3
            limit = bound(*case[1:4], 0.0, [1.0], [mean_sd])
            compare(case, found, dict.fromkeys(case[5], limit))
            pairless = np.mean(np.isnan(found["a", "fn"]))
            print("method a: no pair in %.1f %%; method b: none in %.1f %%"
                  % (100 * pairless, 100 * np.mean(np.isnan(found["b", "fn"]))))
            all_errors.append((case, found))
        for methods in (("c",), ("e",)):
            print("pooled %s: printed/found %.3f, P(<=) %.4f, P(>=) %.4f"
                  % (methods[0], *pooled(all_errors, methods)), flush=True)
    for name, factor in SHOT_DEFINITIONS.items():
        if wanted and "shots:" + name not in wanted:
            continue
        print("\n## 2.4, noise relative to: %s; %d trials\n%s" % (name, trials, HEADER))
        for number, case in enumerate(SHOT_CASES):
            noise = np.full(3, 10 ** (-case[4] / 20) * factor)
            found = errors(case, noise, shot_trial, trials, 100 + number)
            compare(case, found, shot_limits(case, noise))


def shot_limits(case, noise):
    """Bounds by method: of the stacked shots, the average with equal weights, the largest alone."""
    starts = "starts" in case[0]
    first = 0.5 if starts else 0.0
    stacked = bound(*case[1:4], first, STEPS, noise)
    mean_sd = np.sqrt(np.sum(np.square(noise / STEPS))) / 3
    limits = {"stacked": stacked, "best": bound(*case[1:4], first, STEPS[2:], noise[2:])}
    if not starts:  # an average of shots that start apart is no response of the sensor
        limits.update(weighted=stacked, average=bound(*case[1:4], first, [1.0], [mean_sd]))
    return limits


# Same records -------------------------------------------------------------------------------------
def sd_ratio(ours, theirs):
    """Ratio of two standard deviations of paired errors with its 95 % interval (Pitman-Morgan)."""
    ok = ~(np.isnan(ours) | np.isnan(theirs))
    x, y = ours[ok], theirs[ok]
    n = len(x)
    ratio = np.var(x, ddof=1) / np.var(y, ddof=1)
    r = np.corrcoef(x, y)[0, 1]
    K = 1 + 2 * (1 - r * r) * 1.96**2 / (n - 2)
    root = np.sqrt(K * K - 1)
    return np.sqrt(ratio), np.sqrt(ratio * (K - root)), np.sqrt(ratio * (K + root)), r


def print_paired(folder):
    print("| case | method | quantity | Dyncal sd, % | numpy sd, % | ratio (95 %) | correlation "
          "| bound, % | Dyncal/bound |\n|---|---|---|---|---|---|---|---|---|")
    for name in sorted(os.listdir(folder)):
        if name.endswith(".txt"):
            print_paired_case(os.path.join(folder, name))


def print_paired_case(path):
    with open(path) as text:
        title = text.readline().strip()
        f0, zeta, rate, first = text.readline().split()
        noise = np.array(text.readline().split(), float)
        estimates = np.loadtxt(text)
    f0, zeta, rate, first = float(f0), float(zeta), float(rate), float(first)
    case = (title, f0, zeta, rate)
    raw = np.fromfile(path[:-4] + ".f64").reshape(len(estimates), 3, SAMPLES)
    weights = 1.0 / noise
    found = {"deflated": [], "refined": []}
    for records in raw:
        start = deflated(records, rate, weights)
        end = refined(records, rate, weights, start) if start else None
        for method, estimate in (("deflated", start), ("refined", end)):
            found[method].append(estimate)
    limits = bound(f0, zeta, rate, first, STEPS, noise)
    for column, (method, list_) in enumerate(found.items()):
        for i, quantity in enumerate(("fn", "zeta")):
            theirs = np.array([per_cent(e, case, quantity) for e in list_])
            ours = 100 * (estimates[:, 2 * column + i] / case[1 + i] - 1)
            ratio = sd_ratio(ours, theirs)
            print("| %s | %s | %s | %.4f | %.4f | %.4f (%.4f to %.4f) | %.4f | %.4f | %.3f |" % (
                title, method, quantity, np.nanstd(ours, ddof=1), np.nanstd(theirs, ddof=1),
                *ratio, limits[i], np.nanstd(ours, ddof=1) / limits[i]), flush=True)


if __name__ == "__main__":
    if sys.argv[1:2] == ["paired"]:
        print_paired(sys.argv[2])
    elif sys.argv[1:2] == ["printed"]:
        print_printed(int(sys.argv[2]) if len(sys.argv) > 2 else 2000, sys.argv[3:])
    else:
        sys.exit(__doc__)
