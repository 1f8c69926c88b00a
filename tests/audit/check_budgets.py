#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the budgets of results.json stand by themselves, for every kind of calibration, without its recording.

    tests/audit/check_budgets.py FOLDER...      each of them what `dyncal run` wrote

Of every value with a budget: each contribution is the sensitivity coefficient times u, the squares add up to u^2 and
the shares to 100 %, the degrees of freedom are those of Welch and Satterthwaite, k is Student's factor for 95 % (2 at
least where a CMC acts); no value lacks its lines, no line its value, no budget what every one of its kind has; no U is
below its CMC. Prints every comparison; exit code 1 where one is off.
"""

import json
import sys
from pathlib import Path

from audit_budget import check_every_budget, check_sources
from audit_capability import check_capability
from audit_report import Report


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: check_budgets.py FOLDER...")
    report = Report()
    for folder in sys.argv[1:]:
        results = json.loads((Path(folder) / "results.json").read_text())
        print(f"{folder}: {results['kind']}" + (", chain divided out" if results["chain"] else ""))
        check_every_budget(report, results)
        check_sources(report, results)
        check_capability(report, results)
    print(f"{report.failed} off")
    return 1 if report.failed else 0


if __name__ == "__main__":
    sys.exit(main())
