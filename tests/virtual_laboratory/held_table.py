# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of the coverage studies: how often U holds the truth, and whether U is larger than it need be.

Values are error/U. U over k times the known spread of the errors is 1/(1.96 rms(error/U)); of few degrees of
freedom, where k is above 1.96, it says too much, and one far error makes it small: the share tells of that.
"""
import numpy as np

from . import runs

LONG = 500  # runs in a cell, from which the bands of the long form are judged
ENOUGH = 20  # values, or runs; a share of fewer in one cell says nothing
LARGEST_EXCESS = 1.2


def bands(name, count):
    """Shares wanted, pooled and in every cell, and the largest excess, of `count` runs in each cell."""
    if count < ENOUGH:  # a cell alone says nothing
        return (0.8, 1.0), (0.0, 1.0), np.inf
    if count < LONG:
        return (0.0, 1.0), (0.8, 1.0), np.inf
    return (0.94, 0.96) if name == "S(f), noise" else (0.925, 0.975), (0.92, 0.98), LARGEST_EXCESS


def share(values):
    return float(np.mean(np.abs(values) <= 1)) if len(values) else None


def excess(values):
    """U over k times the known spread."""
    return float(1 / (1.96 * np.sqrt(np.mean(np.square(values)))))


def percent(value):
    return "–" if value is None else f"{100 * value:.1f}"


def by_quantity(lines):
    """{quantity: {cell: values}}"""
    found = {}
    for one in lines:
        for name, values in (one.get("found") or {}).items():
            found.setdefault(name, {}).setdefault(one["cell"], []).extend(values)
    return found


def held(shares, pooled, worst, wanted):
    whole, each, largest = wanted
    good = (whole[0] <= pooled <= whole[1] and all(each[0] <= s <= each[1] for s in shares) and worst <= largest)
    return "yes" if good else "NO"


def line(columns):
    return "| " + " | ".join(str(c) for c in columns) + " |"


def result_row(lines, cells, wanted):
    """How many runs have a result at all; a study without any must not look held."""
    there = {cell: [one.get("found") is not None for one in lines if one["cell"] == cell] for cell in cells}
    shares = {cell: float(np.mean(values)) if values else None for cell, values in there.items()}
    pooled = float(np.mean([one.get("found") is not None for one in lines]))
    return line(["a result", len(lines), percent(pooled), *map(percent, shares.values()), "–", "–",
                 held([s for s in shares.values() if s is not None], pooled, 0.0,
                      ((wanted[0][0], 1.0), (wanted[1][0], 1.0), 0.0))])


def row(name, by_cell, cells, wanted):
    everything = np.concatenate([by_cell.get(cell, []) for cell in cells])
    if not len(everything):
        return None
    full = [by_cell[cell] for cell in cells if len(by_cell.get(cell, [])) >= ENOUGH]
    worst = max([excess(values) for values in full], default=excess(everything))
    columns = [name, len(everything), percent(share(everything)),
               *(percent(share(by_cell.get(cell, []))) for cell in cells),
               f"{excess(everything):.2f}", f"{worst:.2f}",
               held([share(values) for values in full], share(everything), worst, wanted)]
    return line(columns)


def table(lines, cells, labels, wanted=bands):
    """Markdown; `labels` of the cells; `wanted` as `bands`."""
    if not lines:
        return "no runs"
    count = min(sum(one["cell"] == cell for one in lines) for cell in cells)
    rows = [result_row(lines, cells, wanted("a result", count))]
    rows += [row(name, by_cell, cells, wanted(name, count)) for name, by_cell in by_quantity(lines).items()]
    return "\n".join([runs.head(lines, cells) + "; % within U", "",
                      f"| quantity | n | all | {' | '.join(labels)} | U / spread | worst cell | held |",
                      f"|---|--:|--:|{'--:|' * (len(cells) + 3)}", *filter(None, rows)])
