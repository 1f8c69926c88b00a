#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether every number of a certificate stands in the DCC beside it, with U, k and unit.

    tests/audit/dcc_numbers.py FOLDER [LANGUAGE]      FOLDER: of a run, or DIR/NUMBER; LANGUAGE: en, sv, de

Reads certificate.pdf (pdftotext), results.json and dcc.xml (lxml) without any of Dyncal's code. Of the PDF: the
key results and the rows of S(f) with value, U, k and unit digit by digit, and every other number before the figures as a
word of the DCC; the rows of earlier calibrations with value, U and E_n. Of results.json: the reported values, velocities,
steps and amplitudes of poles with u, k and dof, in lists of one unit, every row of S(f) with u, the lines of all their budgets
and the intervals of Monte Carlo, within 1e-12.
Exit code 1 where one is missing.
"""
import json
import math
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

from lxml import etree

from printed_numbers import UNIT as UNIT_OF
from printed_numbers import NUMBER, QUANTITIES, RESPONSE, ROW, SENSITIVITY, as_core_writes, words_of

DCC, SI = "{https://ptb.de/dcc}", "{https://ptb.de/si}"
PREFIX = {"": "", "G": "\\giga", "M": "\\mega", "k": "\\kilo", "m": "\\milli", "\u00b5": "\\micro", "\u03bc": "\\micro",
          "n": "\\nano", "p": "\\pico"}
UNIT = {"": "\\one", "Hz": "\\hertz", "s": "\\second", "V/Pa": "\\volt\\pascal\\tothe{-1}", "%": "\\percent", "V": "\\volt",
        "A/Pa": "\\ampere\\pascal\\tothe{-1}", "1/Pa": "\\pascal\\tothe{-1}", "rad": "\\radian"}
RESULT_OF = {"dyncal_responseBudget": "response", "dyncal_responseBudgetAtMarks": "response.marked",
             "dyncal_comparisonBudget": "comparison", "dyncal_comparisonBudgetAtMarks": "comparison.marked"}
STEP_RESULTS = {"velocity": "velocity_m_s", "step": "step_pa"}
# A row of the earlier calibrations: day, number, value, U, E_n.
HISTORY = re.compile(rf"^(\d{{4}}-\d\d-\d\d)\s+(\d+|\u2013)\s+{NUMBER}{UNIT_OF}\s{{2,}}{NUMBER}{UNIT_OF}"
                     rf"(?: \(k = [\d.]+\))?\s{{2,}}(-?\d+(?:\.\d+)?|\u2013)")
SCALE = re.compile(r"^\s*-?\d+(?:\.\d+)?(?:\s+-?\d+(?:\.\d+)?)*\s*$")
PAGE = re.compile(r"\b\d+ (?:of|av|von) \d+\s*$|\(\d+\)\s*$")
TOKEN = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?![\w]|\.\d)")


def of_type(root, ref_type):
    return [node for node in root.iter() if ref_type in node.get("refType", "").split()]


def texts(node, name):
    return [found.text or "" for found in node.iter(SI + name)]


def numbers(node, name):
    return [[float(word) for word in text.split()] for text in texts(node, name)]


def same(a, b, tolerance=1e-12):
    if a is None or (isinstance(a, float) and math.isnan(a)):
        return math.isnan(b)
    return abs(a - b) <= tolerance * max(abs(a), abs(b))


def of_all(words, count):
    return words * count if len(words) == 1 else words


def table_of(quantity):
    """(value, unit, U, k) row by row."""
    values = texts(quantity, "valueXMLList")[0].split()
    count = len(values)
    units = of_all(texts(quantity, "unitXMLList")[0].split(), count)
    expanded = (texts(quantity, "valueExpandedMUXMLList") or ["NaN"])[0].split()
    factors = (texts(quantity, "coverageFactorXMLList") or ["NaN"])[0].split()
    return list(zip(values, units, of_all(expanded, count), of_all(factors, count)))


def check_key_results(text, root, labels, errors):
    """Each row of the PDF as one dcc:quantity."""
    stated = set()
    for quantity in of_type(root, "basic_measurementResult")[0].iter(DCC + "quantity"):
        if quantity.find(f"{SI}real") is not None:
            stated.add(tuple(texts(quantity, name)[0] if texts(quantity, name) else ""
                             for name in ("value", "unit", "valueExpandedMU", "coverageFactor")))
    found = 0
    for match in filter(None, (ROW.match(line.strip()) for line in text.splitlines())):
        label, value, prefix, unit, u, u_prefix, u_unit, k = match.groups()
        if label.strip() not in labels:
            continue
        found += 1
        wanted = (value, PREFIX[prefix or ""] + UNIT[unit or ""], u, k)
        if (prefix, unit) != (u_prefix, u_unit) or wanted not in stated:
            errors.append(f"{label.strip()}: {wanted} is not in the DCC")
    return found


def check_rows(text, root, errors):
    """Each row of S(f) of the PDF in the printed list."""
    lists = [node for node in of_type(root, "dyncal_frequencyResponse") if node.tag == DCC + "list"]
    if not lists:
        return 0
    columns = {name: table_of(of_type(lists[0], name)[0]) for name in ("dyncal_frequency", "dyncal_magnitude",
                                                                      "dyncal_phase")}
    rows = set(zip(*columns.values()))
    found = 0
    for match in filter(None, (RESPONSE.match(line.strip()) for line in text.splitlines())):
        f, f_prefix, value, prefix, unit, u, _, _, phase, u_phase = match.groups()
        found += 1
        wanted = ((f, PREFIX[f_prefix] + "\\hertz"), (value, PREFIX[prefix or ""] + UNIT[unit or ""], u),
                  (phase, "\\degree", u_phase))
        if not any(row[0][:2] == wanted[0] and row[1][:3] == wanted[1] and row[2][:3] == wanted[2]
                   and row[1][3] != "NaN" and row[2][3] != "NaN" for row in rows):
            errors.append(f"{f} {f_prefix}Hz: {wanted} is not a row of the DCC")
    return found


def check_words(text, root, language, errors):
    """Every number is a number of the DCC, or a word of one of its texts; but for those of the pages and the scales of
    the figures of earlier calibrations."""
    said = [as_core_writes(node.text or "", language) for node in root.iter(DCC + "content")]
    said += [(node.text or "").replace("E", " E") for node in root.iter() if node.tag != DCC + "content"]
    words = set(TOKEN.findall(" ".join(said)))
    found = 0
    title, with_figures = words_of(language).get("Earlier calibrations", "Earlier calibrations"), False
    for line in text.splitlines():
        with_figures = with_figures or line.strip() == title
        if with_figures and SCALE.match(line):
            continue
        for token in TOKEN.findall(PAGE.sub("", line)):
            found += 1
            if token not in words:
                errors.append(f"{token} ({line.strip()[:70]}) is not in the DCC")
    return found


def words_in(quantity):
    return [content.text for content in quantity.find(DCC + "noQuantity")]


def column(table, ref_type, name="valueXMLList"):
    return numbers(of_type(table, ref_type)[0], name)[0]


def of_shocks(results):
    """Velocity and step of each shot, by their keys."""
    return {f"shock[{i}].{key}": {"value": shot[key], "u": shot["u_" + key], "k": shot[name + "_k"],
                                  "dof": shot[name + "_dof"], "budget": shot[name + "_budget"], "shot": shot["shot"]}
            for i, shot in enumerate(results["shock"] or []) for name, key in STEP_RESULTS.items()}


def check_reported(results, root, errors):
    there = {}
    for table in (table for result in of_type(root, "dyncal_reportedValues") for table in result.iter(DCC + "list")):
        units = texts(of_type(table, "dyncal_reportedValue")[0], "unitXMLList")[0].split()
        if len(units) != 1:
            errors.append(f"reported values: a list has the units {units}")
        there |= dict(zip(words_in(of_type(table, "dyncal_reportedName")[0]),
                          zip(column(table, "dyncal_reportedValue"),
                              column(table, "dyncal_reportedValue", "valueStandardMUXMLList"),
                              column(table, "dyncal_coverageFactor"), column(table, "dyncal_degreesOfFreedom"))))
    wanted = {row["quantity"]: row for row in results["characteristics"]} | of_shocks(results)
    if results.get("sensitivity"):
        wanted["sensitivity"] = results["sensitivity"]
        wanted |= {f"sensitivity.per_level[{i}]": row for i, row in enumerate(results["sensitivity"]["per_level"])}
    found = 0
    for name, row in wanted.items():
        if row["value"] is None or row["u"] is None:
            continue
        found += 1
        stated = [row["value"], row["u"], row["k"], row["dof"]]
        if name not in there or not all(same(a, b) for a, b in zip(stated, there[name])):
            errors.append(f"results.json {name}: {stated}, DCC {there.get(name)}")
    return found


def check_response(response, root, ref_type, errors):
    """Rows of S(f), not rounded."""
    lists = of_type(root, ref_type)
    if not lists or not response or not response["magnitude"]:
        return 0
    columns = {"frequency_hz": numbers(of_type(lists[0], "dyncal_frequency")[0], "valueXMLList")[0]}
    for name, key in (("dyncal_magnitude", "magnitude"), ("dyncal_phase", "phase_rad")):
        if not of_type(lists[0], name):
            errors += [f"{key} is in results.json, not in the DCC"] * any(one is not None for one in response[key])
            continue
        quantity = of_type(lists[0], name)[0]
        columns[key] = numbers(quantity, "valueXMLList")[0]
        columns["u_" + key] = (numbers(quantity, "valueStandardMUXMLList") or [[math.nan] * len(columns[key])])[0]
    parts = [numbers(lists[0], name) for name in ("valueRealXMLList", "valueImagXMLList")]
    is_complex = all(parts)
    if is_complex:
        (real,), (imaginary,) = parts
        variances = numbers(lists[0].find(f".//{SI}covarianceMatrixXMLList"), "valueXMLList")
    for i, frequency in enumerate(response["frequency_hz"]):
        for key, column in columns.items():
            if not same(response[key][i], column[i]):
                errors.append(f"results.json {key} at {frequency}: {response[key][i]}, DCC {column[i]}")
        magnitude, u = response["magnitude"][i], response["u_magnitude"][i]
        if magnitude is None or not is_complex:
            continue
        if not same(magnitude, math.hypot(real[i], imaginary[i])):
            errors.append(f"complex value at {frequency}: {real[i]}, {imaginary[i]}")
        x, y = real[i] / magnitude, imaginary[i] / magnitude
        along = x * x * variances[0][i] + 2 * x * y * variances[1][i] + y * y * variances[3][i]
        if u is not None and response["u_phase_rad"][i] is not None and along < u * u * (1 - 1e-9):
            errors.append(f"region at {frequency}: {math.sqrt(along)} along the value, u {u}")
    return len(response["frequency_hz"])


def check_history(text, root, errors):
    """Each row of the tables of earlier calibrations: day, number, value, U and E_n."""
    stated = set()
    for table in of_type(root, "dyncal_historyOf"):
        days, certificates = (words_in(of_type(table, name)[0])
                              for name in ("dyncal_dayOfCalibration", "dyncal_earlierCertificate"))
        values = table_of(of_type(table, "dyncal_earlierValue")[0])
        quantity = of_type(table, "dyncal_normalisedError")[0]
        ratios = texts(quantity, "valueXMLList")[0].split() if texts(quantity, "valueXMLList") else ["NaN"] * len(days)
        stated |= {(day, number, *value[:3], ratio)
                   for day, number, value, ratio in zip(days, certificates, values, ratios)}
    found = 0
    for match in filter(None, (HISTORY.match(line.strip()) for line in text.splitlines())):
        day, number, value, prefix, unit, u, _, _, ratio = match.groups()
        found += 1
        wanted = (day, number, value, PREFIX[prefix or ""] + UNIT[unit or ""], u, ratio.replace("\u2013", "NaN"))
        if wanted not in stated:
            errors.append(f"earlier calibration {wanted} is not in the DCC")
    return found


def check_line(line, sources, errors):
    """A line of a budget among (source, shot, u, coefficient, contribution); u and coefficient may be unknown."""
    def fits(source):
        name, shot, u, coefficient, contribution = source
        return (name == line["quantity"] and shot == (line["shot"] or 0) and same(line["contribution"], contribution)
                and (math.isnan(u) or same(line["u"], u))
                and (math.isnan(coefficient) or same(line["sensitivity"], coefficient)))
    if not any(map(fits, sources)):
        errors.append(f"budget of {line['of']}: {line['quantity']} {line['contribution']} is not in the DCC")


def check_budgets(results, root, errors):
    """The lines of each budget in the list of its name; those of S(f) in their row of a source's column."""
    budgets = {}
    for table in (node for node in of_type(root, "dyncal_uncertaintyBudget") if node.tag == DCC + "list"):
        columns = [column(table, "dyncal_budget" + name)
                   for name in ("SourceShot", "Uncertainty", "Coefficient", "Contribution")]
        budgets[table.find(DCC + "name")[0].text] = list(
            zip(words_in(of_type(table, "dyncal_budgetSource")[0]), *columns))
    rows = {}
    for result, of in RESULT_OF.items():
        for table in (table for node in of_type(root, result) for table in node.iter(DCC + "list")):
            kind = "magnitude" if "dyncal_magnitudeBudget" in table.get("refType").split() else "phase_rad"
            rows[f"{of}.{kind}"] = [(quantity.find(DCC + "name")[0].text, numbers(quantity, "valueXMLList")[0])
                                    for quantity in of_type(table, "dyncal_budgetContribution")]
    reported = {row["quantity"] for row in results["characteristics"] if row["u"] is not None}
    reported |= {f"model.poles[{i}].amplitude" for i, pole in enumerate((results["model"] or {}).get("poles", []))
                 if pole["u_amplitude"] is not None}
    found = 0
    for of, value in of_shocks(results).items():
        for line in value["budget"] or []:
            found += 1
            shot = None if line["common_to_all_shots"] else value["shot"]
            check_line(line | {"of": of, "shot": shot}, budgets.get(of, []), errors)
    for line in results["budget"] or []:
        of, _, place = line["of"].partition("[")
        if of in rows or of.startswith(("response", "comparison")):
            at = int(place.rstrip("]"))
            if not any(name.split(",")[0] == line["quantity"] and same(line["contribution"], values[at])
                       for name, values in rows.get(of, [])):
                errors.append(f"budget of {line['of']}: {line['quantity']} {line['contribution']} is not in the DCC")
        elif line["of"].startswith(("sensitivity", "shots")) or line["of"] in reported:
            check_line(line, budgets.get(line["of"], []), errors)
        else:
            continue
        found += 1
    return found


def check_drawn(results, root, errors):
    """The intervals of Monte Carlo, each as often as it is stated."""
    ends = Counter(value for name in ("intervalMinXMLList", "intervalMaxXMLList") for row in numbers(root, name)
                   for value in row)
    drawn = (results["monte_carlo"] or {}).get("quantities", [])
    for row in drawn:
        for key in ("low", "high"):
            if row[key] is None:
                continue
            ends[row[key]] -= 1
            if ends[row[key]] < 0:
                errors.append(f"Monte Carlo, {row['of']}: {row[key]} is not in the DCC")
    return len(drawn)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    language = sys.argv[2] if len(sys.argv) == 3 else "en"
    words = words_of(language)
    results = json.loads((folder / "results.json").read_text())
    root = etree.parse(str(folder / "dcc.xml")).getroot()
    text = subprocess.run(["pdftotext", "-layout", folder / "certificate.pdf", "-"], check=True, capture_output=True,
                          text=True).stdout
    text = as_core_writes(text, language)
    labels = {words.get(label, label) for label in list(QUANTITIES) + [SENSITIVITY, SENSITIVITY + ", mean of the shots"]}
    figures = re.compile(r"\n\s*(?:\d+ )?" + re.escape(words.get("Figures", "Figures")) + r"\s*\n")
    before = figures.split(text)[0]
    errors = []
    counts = [check_key_results(text, root, labels, errors), check_rows(text, root, errors),
              check_words(before, root, language, errors), check_reported(results, root, errors),
              check_response(results["response"], root, "dyncal_complexResponse", errors),
              check_response((results["response"] or {}).get("marked"), root, "dyncal_complexResponseAtMarks", errors),
              check_budgets(results, root, errors), check_drawn(results, root, errors),
              check_history(before, root, errors)]
    print(f"{counts[0]} key results, {counts[1]} printed rows, {counts[2]} printed numbers, {counts[3]} reported values, "
          f"{counts[4]} + {counts[5]} rows of S(f), {counts[6]} lines of budgets, {counts[7]} intervals of Monte Carlo, "
          f"{counts[8]} earlier values: {len(errors)} not found")
    for error in errors:
        print(error)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
