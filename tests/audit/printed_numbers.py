#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the numbers printed on a certificate are those of results.json beside it, to the printed digit.

    tests/audit/printed_numbers.py FOLDER [LANGUAGE]      FOLDER: DIR/NUMBER of an issued certificate; LANGUAGE: en, sv, de

Reads the text of certificate.pdf (pdftotext) without any of Dyncal's code: the table of the key results, each
row with value, U and k, and the table of S(f), as the language writes numbers; its labels are those of
translations/dyncal_LANGUAGE.ts. U and value must be those of results.json rounded to the
decimals that are printed, U = k u within its last digit and with two digits, k as stated there. Exit code 1 where
one differs, or where a value of the key results has no U or k.
"""
import json
import math
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

QUANTITIES = {
    "Undamped natural frequency": "f0_hz", "Damping ratio": "damping_ratio", "Quality factor": "q",
    "Resonance frequency (largest magnitude)": "resonance_hz",
    "Magnitude at the resonance over the level at the onset": "resonance_gain",
    "Magnitude within 5 % up to": "within_5_percent_hz", "Magnitude within 10 % up to": "within_10_percent_hz",
    "Magnitude above -3 dB up to": "minus_3_db_hz", "Rise time, 10 % to 90 %": "rise_time_s",
    "Overshoot": "overshoot_percent", "Settling time, within 5 %": "settling_time_s",
}
SENSITIVITY = "Sensitivity at the onset of the step"
PREFIXES = {"": 1.0, "G": 1e9, "M": 1e6, "k": 1e3, "m": 1e-3, "\u00b5": 1e-6, "\u03bc": 1e-6, "n": 1e-9, "p": 1e-12}
NUMBER = r"(-?\d+(?:\.\d+)?)"
UNIT = r"(?: ?([GMkm\u00b5\u03bcnp]?)(Hz|s|V/Pa|%|rad|V|A/Pa|1/Pa))?"
# A label, then value, U and k at the end of the line.
ROW = re.compile(rf"^(.*?)\s{{2,}}{NUMBER}{UNIT}\s{{2,}}{NUMBER}{UNIT}\s{{2,}}(\d+(?:\.\d+)?)\s*$")


# A row of S(f): frequency, magnitude, U, phase, U.
RESPONSE = re.compile(rf"^{NUMBER} ([GMk]?)Hz\s{{2,}}{NUMBER}{UNIT}\s{{2,}}{NUMBER}{UNIT}"
                      rf"\s{{2,}}{NUMBER} \u00b0\s{{2,}}{NUMBER} \u00b0")
DEGREE = math.pi / 180.0
SAME_FREQUENCY = 6e-4  # printed with four digits
TRANSLATIONS = Path(__file__).resolve().parents[2] / "translations"


def words_of(language):
    """From the sentences of core to those of a language."""
    if language == "en":
        return {}
    for context in ElementTree.parse(TRANSLATIONS / f"dyncal_{language}.ts").getroot().iter("context"):
        if context.findtext("name") == "core":
            return {entry.findtext("source"): entry.findtext("translation").replace("\u00ad", "")
                    for entry in context.iter("message")}
    return {}


def as_core_writes(text, language):
    """Numbers with a decimal point and without spaces between groups of digits; blanks where lines may not end are blanks."""
    text = text.replace("\u00a0", " ")
    if language == "en":
        return text
    grouped = re.sub("(?<=\\d)[ \u202f](?=\\d{1,3}(?!\\d))", "", text.replace("\u00ad", ""))
    return re.sub(r"(?<=\d),(?=\d)", ".", grouped)


def decimals(text):
    return len(text.split(".")[1]) if "." in text else 0


def printed_rows(text):
    """(label, value, U, k) with value and U as (text, scale)."""
    for line in text.splitlines():
        match = ROW.match(line.strip())
        if match:
            label, value, prefix, _, u, u_prefix, _, k = match.groups()
            yield label.strip(), (value, PREFIXES[prefix or ""]), (u, PREFIXES[u_prefix or ""]), k


def agrees(printed, stated):
    """Whether a printed number is the stated one to its last digit."""
    text, scale = printed
    return abs(float(text) * scale - stated) <= 0.5 * (1 + 1e-9) * 10 ** -decimals(text) * scale


def significant(text):
    return len(text.replace(".", "").lstrip("0"))


def check_row(label, value, u, k, stated, errors):
    factor = max(2.0, stated["k"])
    if not agrees(value, stated["value"]):
        errors.append(f"{label}: printed {value[0]}, results.json {stated['value']}")
    if not agrees(u, factor * stated["u"]):
        errors.append(f"{label}: U printed {u[0]}, results.json {factor * stated['u']}")
    if abs(float(k) - factor) > 0.005 + 1e-9:
        errors.append(f"{label}: k printed {k}, results.json {factor}")
    if significant(u[0]) > 2 or decimals(u[0]) != decimals(value[0]) or u[1] != value[1]:
        errors.append(f"{label}: value {value[0]} and U {u[0]} are not rounded alike to two digits")


def nearest_row(frequency, response):
    """Number of the row at a printed frequency; None where there is none."""
    row = min(range(len(response["frequency_hz"])), key=lambda i: abs(response["frequency_hz"][i] - frequency))
    return row if abs(response["frequency_hz"][row] / frequency - 1.0) < SAME_FREQUENCY else None


def check_response(text, response, errors):
    """Every row of S(f); how many were found."""
    seen = set()
    for match in filter(None, (RESPONSE.match(line.strip()) for line in text.splitlines())):
        f, f_prefix, value, prefix, _, u, u_prefix, _, phase, u_phase = match.groups()
        row = nearest_row(float(f) * PREFIXES[f_prefix], response)
        if row is None:
            errors.append(f"{f} {f_prefix}Hz: no such row")
            continue
        seen.add(row)
        for kind, printed, expanded in (
                ("magnitude", (value, PREFIXES[prefix or ""]), (u, PREFIXES[u_prefix or ""])),
                ("phase_rad", (phase, DEGREE), (u_phase, DEGREE))):
            factor = max(2.0, response["k_" + kind.split("_")[0]][row])
            if not agrees(printed, response[kind][row]):
                errors.append(f"{f} {f_prefix}Hz, {kind}: printed {printed[0]}, stated {response[kind][row]}")
            if not agrees(expanded, factor * response["u_" + kind][row]):
                errors.append(f"{f} {f_prefix}Hz, U of {kind}: printed {expanded[0]}, "
                              f"stated {factor * response['u_' + kind][row]}")
    stated = [i for i, value in enumerate(response["magnitude"]) if value is not None]
    errors += [f"{response['frequency_hz'][i]} Hz: not found on the certificate" for i in stated if i not in seen]
    return len(seen)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    language = sys.argv[2] if len(sys.argv) == 3 else "en"
    words = words_of(language)
    quantities = {words.get(label, label): quantity for label, quantity in QUANTITIES.items()}
    sensitivity = words.get(SENSITIVITY, SENSITIVITY)
    results = json.loads((folder / "results.json").read_text())
    text = subprocess.run(["pdftotext", "-layout", folder / "certificate.pdf", "-"], check=True,
                          capture_output=True, text=True).stdout
    text = as_core_writes(text, language)
    stated = {row["quantity"]: row for row in results["characteristics"]}
    errors, seen = [], set()
    for label, value, u, k in printed_rows(text):
        quantity = quantities.get(label)
        if quantity:
            seen.add(quantity)
            check_row(label, value, u, k, stated[quantity], errors)
        elif label == sensitivity:
            seen.add("sensitivity")
            check_row(label, value, u, k, results["sensitivity"], errors)
    for quantity in list(stated) + ["sensitivity"]:
        row = stated.get(quantity, results["sensitivity"])
        if row["value"] is not None and row["u"] is not None and quantity not in seen:
            errors.append(f"{quantity}: not found on the certificate")
    rows = check_response(text, results["response"], errors)
    print(f"{len(seen)} printed results and {rows} rows of S(f) compared with results.json, {len(errors)} differ")
    for error in errors:
        print(error)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
