# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A record's steps' transform at one frequency, by the sum as it is written, and what noise does to it."""

from functools import lru_cache

import numpy as np

CUTS = 12


@lru_cache(maxsize=4)
def turns(x, count):
    """e^(-jxn), which the shots of a row share."""
    return np.exp(-1j * x * np.arange(count))


class Transform:
    """In the unit of the record: S, its variances, what cuts change and the variances of that."""

    def __init__(self, shot, window, f_Hz, length_s, span_s, baseline):
        count = min(max(2, int(np.ceil(length_s * shot.rate_Hz - 1e-6))), window)
        self.before = max(64, int(span_s * shot.rate_Hz / 16))
        self.x = 2.0 * np.pi * f_Hz / shot.rate_Hz
        self.y = shot.volts[shot.first - self.before:shot.first + count] - baseline
        self.turn = turns(self.x, len(self.y) + 1)
        self.sums = np.cumsum(np.diff(self.y, prepend=0.0) * self.turn[:-1])
        self.bracket = 1j * self.x / (1.0 - np.exp(-1j * self.x))
        self.density = shot.noise_sd**2
        self.of_baseline = self.density / len(shot.quiet)
        self.S = self._at(len(self.y))
        self.variance, self.exact_variance = self._variance(), self._exact_variance()
        self.changes, self.of_changes = self._changes()
        del self.y, self.turn, self.sums  # it is kept, they are long

    def _at(self, end):
        """As if the record ended after so many samples, continued by the mean of its own last tenth."""
        level = self.y[end - max(1, end // 10):end].mean()
        return (self.sums[end - 1] + (level - self.y[end - 1]) * self.turn[end]) * self.bracket

    def _of_level(self, end):
        m = max(1, end // 10)
        return self.density * abs(self.bracket)**2 * max(0.0, 2.0 * np.cos(self.x * m) - 1.0) / m

    def _variance(self):
        """Of Re and of Im, docs/method/response.md with one density at all frequencies."""
        of_samples = 0.5 * self.density * self.x**2 * len(self.y)
        return of_samples + self._of_level(len(self.y)) + self.of_baseline

    def _exact_variance(self):
        """Mean of both directions, from what each sample does to the sum."""
        m = max(1, len(self.y) // 10)
        last = (1.0 - np.exp(-1j * self.x)) * self.turn[-m - 1:-1] + self.turn[-1] / m  # those of the level
        others = (len(self.y) - m) * abs(1.0 - np.exp(-1j * self.x))**2
        squares = abs(self.bracket)**2 * (others + np.sum(last.real**2 + last.imag**2))
        return 0.5 * self.density * squares

    def _changes(self):
        """By each cut, turned along S, and the variance of its Re and Im."""
        n = len(self.y)
        ends = [n - n // 3 + k * (n // 3) // CUTS for k in range(CUTS)]
        back = np.exp(-1j * np.angle(self.S))
        values = np.array([(self._at(end) - self.S) * back for end in ends])
        cut_off = np.array([0.5 * self.density * self.x**2 * (n - end) + self._of_level(end) + self._of_level(n)
                            for end in ends])
        return values, cut_off


@lru_cache(maxsize=None)
def transform(shot, window, f_Hz, length_s, span_s, baseline):
    """`window`: samples behind the detected start that there are; `span_s`: of the model input."""
    return Transform(shot, window, f_Hz, length_s, span_s, baseline)
