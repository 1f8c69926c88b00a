# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Noise and the recorder: what stands between a sensor's output and the counts of a file."""
import numpy as np
from scipy.signal import lfilter

SERIES = [m * 10.0**e for e in range(-9, 10) for m in (1, 2, 5)]


def white(rng, count):
    return rng.standard_normal(count)


def autoregressive(rng, count, phi=0.9):
    """x_k = phi x_(k-1) + e_k with standard deviation 1, settled before the first sample."""
    lead = 1000
    e = rng.standard_normal(count + lead) * np.sqrt(1 - phi**2)
    return lfilter([1.0], [1.0, -phi], e)[lead:]


def flicker(rng, count):
    """Power per hertz as 1/f from 1/(2 count) of the rate to half of it, standard deviation 1."""
    n = 2 ** int(np.ceil(np.log2(2 * count)))
    k = np.arange(1, n // 2 + 1)
    amplitude = 1 / np.sqrt(k)
    spectrum = np.zeros(n // 2 + 1, complex)
    spectrum[1:] = amplitude * (rng.standard_normal(len(k)) + 1j * rng.standard_normal(len(k)))
    scale = np.sqrt(np.sum(amplitude**2)) * 2 / n
    return np.fft.irfft(spectrum, n)[:count] / scale


def noise(rng, count, kind):
    return {"white": white, "ar": autoregressive, "flicker": flicker}[kind](rng, count)


def range_for(largest):
    """The smallest range of the series 1-2-5 that holds it."""
    return next(r for r in SERIES if r >= largest)


def counts(values, full_range, bits, gain=1.0, bow_codes=0.0):
    """Codes of a converter of +-full_range: gain error, a bow in the middle of its range, rounding, rails."""
    code = 2 * full_range / 2**bits
    x = np.clip(values * gain / full_range, -1, 1)
    raw = values * gain / code + bow_codes * (1 - x**2)
    limit = 2 ** (bits - 1)
    return np.clip(np.rint(raw), -limit, limit - 1).astype(np.int16 if bits <= 16 else np.int32), code
