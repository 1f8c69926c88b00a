# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Responses that are known over frequency: a reference transducer's by table or model, the chain's by table."""

import csv
import hashlib
from pathlib import Path
from typing import NamedTuple

import numpy as np

ROUNDING = 1e-9  # of a frequency that is meant to be a row's


class Point(NamedTuple):
    """At one frequency; no phase is None."""
    magnitude: float
    u_magnitude: float
    phase_rad: float | None
    u_phase_rad: float | None
    dof: float

    def u_relative(self):
        return self.u_magnitude / self.magnitude


class KnownTable:
    """Rows of a CSV, docs/method/comparison.md: straight lines over log f, nothing outside."""

    def __init__(self, text):
        lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
        rows = list(csv.DictReader(lines, skipinitialspace=True))
        self.columns = {name: np.array([float(row[name]) if row[name] else np.inf for row in rows]) for name in rows[0]}
        self.columns.setdefault("dof", np.full(len(rows), np.inf))
        self.frequency_Hz = self.columns["frequency_hz"]
        self.has_phase = "phase_rad" in self.columns

    def at(self, f_Hz):
        if not self.frequency_Hz[0] * (1.0 - ROUNDING) <= f_Hz <= self.frequency_Hz[-1] * (1.0 + ROUNDING):
            return None
        return Point(self._between("magnitude", f_Hz), self._u("magnitude", f_Hz),
                     self._between("phase_rad", f_Hz), self._u("phase_rad", f_Hz), self._dof(f_Hz))

    def _u(self, name, f_Hz):
        """That of the rows, and what a straight line between them may miss."""
        u = self._between("u_" + name, f_Hz)
        return None if u is None else float(np.hypot(u, self._missed(self.columns[name], np.log(f_Hz)) / np.sqrt(3.0)))

    def _missed(self, y, at):
        x = np.log(self.frequency_Hz)
        above = min(max(np.searchsorted(x, at), 1), len(x) - 1)
        s = min(max((at - x[above - 1]) / (x[above] - x[above - 1]), 0.0), 1.0)
        if len(x) == 2:
            return 2.0 * s * (1.0 - s) * abs(y[1] - y[0])
        slope = np.diff(y) / np.diff(x)
        bend = np.zeros(len(x))
        bend[1:-1] = 2.0 * np.diff(slope) / (x[2:] - x[:-2])
        return (x[above] - x[above - 1])**2 * s * (1.0 - s) * np.abs(bend[above - 1:above + 1]).max()

    def _between(self, name, f_Hz):
        column = self.columns.get(name)
        return None if column is None else float(np.interp(np.log(f_Hz), np.log(self.frequency_Hz), column))

    def _dof(self, f_Hz):
        """The fewer of the row at or above and of that before it."""
        above = min(np.searchsorted(self.frequency_Hz, f_Hz), len(self.frequency_Hz) - 1)
        return self.columns["dof"][max(above - 1, 0):above + 1].min()

    def lowest(self):
        return self.at(self.frequency_Hz[0])

    def change_below(self, level_Hz):
        """Of |S| from the lowest row to 0, as an even function; 0 where the table reaches down to the level."""
        f, S = self.frequency_Hz, self.columns["magnitude"]
        if f[0] <= level_Hz:
            return 0.0
        second = min(np.searchsorted(f, 2.0 * f[0]), len(f) - 1)
        return abs(S[second] - S[0]) / ((f[second] / f[0])**2 - 1.0)


class KnownModel:
    """S0/(1 - r^2 + 2 j zeta r), r = f/f0, its u by the derivatives of its logarithm."""
    has_phase = True

    def __init__(self, stated):
        self.stated = stated

    def at(self, f_Hz):
        S0, f0, zeta = (self.stated[key] for key in ("sensitivity", "f0_hz", "zeta"))
        r = f_Hz / f0
        below = 1.0 - r**2 + 2j * zeta * r
        slopes = np.array([1.0 / S0, -(2.0 * r**2 - 2j * zeta * r) / f0 / below, -2j * r / below])
        parts = slopes * [self.stated[key] for key in ("u_sensitivity", "u_f0_hz", "u_zeta")]
        size = S0 / abs(below)
        return Point(size, size * np.linalg.norm(parts.real), -np.angle(below), np.linalg.norm(parts.imag), np.inf)

    def lowest(self):
        return self.at(0.0)

    def change_below(self, _level_Hz):
        return 0.0


def file_of(source, folders):
    """Where a recipe's relative name leads to; the hash is compared afterwards."""
    for folder in folders:
        if (Path(folder) / source).exists():
            return Path(folder) / source
    raise SystemExit(f"{source} is in none of {', '.join(map(str, folders))}.")


def known_response(report, name, settings, sha256, folders):
    """Of the recipe's section `name`; `sha256`: as results.json states it."""
    if settings.get("model"):
        return KnownModel(settings["model"])
    content = file_of(settings["source"], folders).read_bytes()
    report.equal(f"SHA-256 of {name}.source", sha256, hashlib.sha256(content).hexdigest())
    if content.lstrip().startswith(b"<"):
        raise SystemExit(f"{settings['source']}: tables are read as CSV here, not as XML.")
    return KnownTable(content.decode("utf-8"))
