# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables in Markdown of what the runs say."""
import numpy as np

from .judge import CLASSES, QUANTITIES

HEAD = ("| condition | quantity | n | inside | right cause | other caution | withheld | silent wrong "
        "| largest silent error/U | over limit | held |")
RULE = "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
ENOUGH, ENOUGH_POOLED = 0.8, 0.93


def line(condition, quantity, counts, worst, over, enough=ENOUGH):
    n = sum(counts.values())
    good = counts["inside"] + counts["right"]
    held = "yes" if n and good >= enough * n and not over else "NO"
    cells = [condition, quantity, n, *(counts[c] for c in CLASSES), f"{worst:.3g}" if worst else "–",
             over, f"{held} ({100 * good / n:.0f} %)" if n else "–"]
    return "| " + " | ".join(str(c) for c in cells) + " |"


def empty():
    return dict.fromkeys(CLASSES, 0)


def summary(records, quantity):
    """Counts by class, the largest silent error and how many exceed their limit; exempt ones left out."""
    counts, worst, over = empty(), 0.0, 0
    for record in records:
        item = record.get("quantities", {}).get(quantity)
        if item is None:
            counts["withheld"] += 1
        elif not item.get("exempt"):
            counts[item["class"]] += 1
            if item["class"] == "silent":
                worst = max(worst, item["ratio"])
                over += item["ratio"] > item["limit"]
    return counts, worst, over


def row_summary(records, name="S(f) magnitude"):
    counts, worst = empty(), 0.0
    for record in records:
        rows = record.get(name)
        for key, number in (rows or {}).get("rows", {}).items():
            counts[key] += number
        worst = max(worst, (rows or {}).get("worst_silent", 0.0))
    return counts, worst, int(worst > 3)


def by_condition(records):
    groups = {}
    for record in records:
        groups.setdefault(record["condition"], []).append(record)
    return groups


def conditions_table(records, rows=True):
    lines = [HEAD, RULE]
    for condition, group in by_condition(records).items():
        for quantity in QUANTITIES:
            lines.append(line(condition, quantity, *summary(group, quantity)))
        if rows:
            lines.append(line(condition, "S(f) rows", *row_summary(group)))
    lines += [line("**all**", q, *summary(records, q), ENOUGH_POOLED) for q in QUANTITIES]
    pooled = [summary(records, q) for q in QUANTITIES]
    total = {c: sum(p[0][c] for p in pooled) for c in CLASSES}
    lines.append(line("**all**", "**pooled**", total, max(p[1] for p in pooled),
                      sum(p[2] for p in pooled), ENOUGH_POOLED))
    if rows:
        lines.append(line("**all**", "S(f) rows", *row_summary(records), ENOUGH_POOLED))
    return "\n".join(lines)


def short_table(records):
    """Sensitivity and step of a few conditions."""
    lines = [HEAD, RULE]
    for condition, group in by_condition(records).items():
        lines += [line(condition, q, *summary(group, q)) for q in ("sensitivity", "step")]
    return "\n".join(lines)


def cautions_table(records):
    """How often the right cause is named at all, whether or not the numbers suffer."""
    lines = ["| condition | runs | right cause named | another cause | cautions without cause | none "
             "| blocked or no results | findings |", "|---|--:|--:|--:|--:|--:|--:|---|"]
    for condition, group in by_condition(records).items():
        kinds = [record.get("named", "no results") for record in group]
        ids = sorted({i for record in group for i in record.get("cautions", [])})
        cells = [condition, len(group), *(kinds.count(k) for k in ("right", "wrong", "unnamed", "none")),
                 sum(record["exit"] > 1 for record in group), " ".join(ids)]
        lines.append("| " + " | ".join(str(c) for c in cells) + " |")
    return "\n".join(lines)


def z_values(records, quantity):
    items = [r.get("quantities", {}).get(quantity) for r in records]
    return np.array([(i["value"] - i["true"]) / i["u"] for i in items if i and i.get("u")])


def coverage_line(name, quantity, records):
    """Share within U, mean and rms of z (error over u), mean relative error."""
    items = [i for i in (r.get("quantities", {}).get(quantity) for r in records) if i and i.get("u")]
    if not items:
        return f"| {name} | {quantity} | 0 | – | – | – | – | – |"
    z = z_values(records, quantity)
    inside = np.mean([i["ratio"] <= 1 for i in items])
    relative = np.array([i["value"] / i["true"] - 1 for i in items])
    largest_u = max(i["k"] * i["u"] / abs(i["value"]) for i in items)
    return (f"| {name} | {quantity} | {len(items)} | {100 * inside:.1f} % | {z.mean():+.2f} | "
            f"{np.sqrt(np.mean(z**2)):.2f} | {100 * relative.mean():+.4f} % | {100 * largest_u:.3f} % |")


COVERAGE_HEAD = ("| study | quantity | n | within U | mean z | rms z | mean error | largest U |\n"
                 "|---|---|--:|--:|--:|--:|--:|--:|")


def coverage_table(records, quantities=QUANTITIES):
    lines = [COVERAGE_HEAD]
    for name, group in by_condition(records).items():
        lines += [coverage_line(name, q, group) for q in quantities]
    return "\n".join(lines)


def cautions_line(records):
    named = sum(bool(r.get("causes")) for r in records)
    anything = sum(bool(r.get("cautions")) or r["exit"] > 1 for r in records)
    drift = sum(bool(r.get("drift")) for r in records)
    return (f"{len(records)} runs: {named} with a caution that names a cause, {anything} with any caution, "
            f"{drift} with a drift, {sum(r['exit'] > 1 for r in records)} without results.")


def rows_coverage(records):
    """Row by row over the runs: share of rows held in 90.5 to 99 %, pooled share, largest rms of z."""
    by_row = {}
    for record in records:
        for f, z, k in record.get("response_z") or []:
            by_row.setdefault(round(f, 3), []).append((z, k))
    full = {f: np.array(v) for f, v in by_row.items() if len(v) >= 0.5 * len(records)}
    if not full:
        return "no rows"
    share = np.array([np.mean(abs(v[:, 0]) <= v[:, 1]) for v in full.values()])
    pooled = np.concatenate([abs(v[:, 0]) <= v[:, 1] for v in full.values()]).mean()
    rms = max(np.sqrt(np.mean(v[:, 0] ** 2)) for v in full.values())
    good = np.mean((share >= 0.905) & (share <= 0.99))
    return (f"{len(full)} rows: {100 * good:.0f} % of them hold the truth in 90.5 to 99 % of runs, pooled "
            f"{100 * pooled:.1f} %, lowest {100 * share.min():.0f} %, largest rms z {rms:.2f}")


def bounds_line(records):
    pairs = [r["bounds"] for r in records if r.get("bounds")]
    held, total = (sum(p[i] for p in pairs) for i in (0, 1))
    return f"bounds hold in {held} of {total} rows ({len(pairs)} runs state them)"
