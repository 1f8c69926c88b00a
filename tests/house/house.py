#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/architecture.md says of the house, measured on the sources.

house.py rings ROOT   units (header and source of one name) that include each other in a ring of
                      more than two, circles of rooms (folders), sources without a header of their
                      own: none may be there.
house.py bars ROOT    lines of files and functions, lines of tests to lines of source, by layer and
                      room, as a table; fails where a file or function is too long or a room has too few
                      tests. Needs universal-ctags.
house.py names ROOT   types, and functions defined in headers, of which there are two of one full name: the
                      linker would take either for both. What only link-time types see, .ci/long odr tells.
                      Needs universal-ctags.
"""
import json
import re
import statistics
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

LAYERS = ("core", "registry", "ui", "app")
# A table of the subcommands, and the two programs' entry points.
WITHOUT_HEADER = re.compile(r"app/(main|cli/(batch|check|compare|correct|dcc|export|history|import|info|issue|recheck|registry|run|selftest|simulate|verify|withdraw))\.cpp")
# The oracles of the self-test are tests themselves (tests/selftest/faults.py tests them): the bar of their room is
# without them, that of all core with them.
ORACLES = re.compile(r"core/selftest/checks_(of|in)_\w+\.(cpp|h)")
INCLUDE = re.compile(r'#include "([^"]+)"')
MOST_FILE_LINES = 450
MOST_FUNCTION_LINES = 60
MOST_CORE_MEDIAN = 8
LEAST_TESTS = {"core": 0.95, "registry": 0.75, "ui": 0.5}
LEAST_TESTS_OF_ROOM = {"core": 0.75}
LEAST_TESTS_OF = {"ui/stages": 0.4}


def files_of(root, top, suffixes=(".h", ".cpp")):
    return sorted(p.relative_to(root) for p in (root / top).rglob("*") if p.suffix in suffixes)


def include_edges(root):
    """Units and rooms, each with those it includes."""
    units, rooms = defaultdict(set), defaultdict(set)
    for layer in LAYERS:
        for path in files_of(root, layer):
            unit = str(path.with_suffix(""))
            units[unit], rooms[str(path.parent)]
            for line in (root / path).read_text().splitlines():
                match = INCLUDE.match(line)
                if not match or match[1].split("/")[0] not in LAYERS:
                    continue
                other = Path(match[1])
                if str(other.with_suffix("")) != unit:
                    units[unit].add(str(other.with_suffix("")))
                if other.parent != path.parent:
                    rooms[str(path.parent)].add(str(other.parent))
    return units, rooms


def rings(edges):
    """Strongly connected parts of more than one node (Tarjan)."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in sorted(edges.get(node, ())):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            part = stack[stack.index(node):]
            del stack[stack.index(node):]
            if len(part) > 1:
                found.append(sorted(part))

    sys.setrecursionlimit(10000)
    for node in sorted(edges):
        if node not in index:
            visit(node)
    return found


def check_rings(root):
    units, rooms = include_edges(root)
    of_units = rings(units)
    errors = ["units in a ring: " + ", ".join(r) for r in of_units if len(r) > 2]
    errors += ["rooms in a circle: " + ", ".join(r) for r in rings(rooms)]
    for layer in LAYERS:
        for path in files_of(root, layer, (".cpp",)):
            if not (root / path).with_suffix(".h").exists() \
                    and not WITHOUT_HEADER.fullmatch(str(path)):
                errors.append(f"{path} has no header of its own name")
    print(f"{len(units)} units in {len(rooms)} rooms; pairs that include each other: "
          f"{sum(len(r) == 2 for r in of_units)}")
    return errors


def tags_of(root, kinds, *folders):
    listing = subprocess.run(
        ["ctags", "-R", "--languages=C++", "--langmap=C++:.h.cpp", f"--kinds-C++={kinds}",
         "--fields=+neSsZ", "--output-format=json", "-f", "-", *folders],
        cwd=root, check=True, capture_output=True, text=True).stdout
    return [json.loads(line) for line in listing.splitlines()]


def functions_of(root, layer):
    """(lines, path, name) of every function."""
    return [(t["end"] - t["line"] + 1, t["path"], t["name"])
            for t in tags_of(root, "f", layer) if "end" in t]


def check_names(root):
    """Names of an anonymous namespace are a file's own."""
    places = defaultdict(set)
    for tag in tags_of(root, "csguf", *LAYERS):
        name = f'{tag.get("scope", "")}::{tag["name"]}'
        if "__anon" in name or tag["kind"] == "function" and not tag["path"].endswith(".h"):
            continue
        places[name + tag.get("signature", "")].add(f'{tag["path"]}:{tag["line"]}')
    print(f"{len(places)} names")
    return [f"{name} is defined more than once: {', '.join(sorted(where))}"
            for name, where in places.items() if len(where) > 1]


def lines_of(root, paths):
    return {p: len((root / p).read_text().splitlines()) for p in paths}


def p90(values):
    return sorted(values)[int(0.9 * (len(values) - 1))]


def check_sizes(root, layer, errors):
    lines = lines_of(root, files_of(root, layer))
    functions = functions_of(root, layer)
    lengths = [f[0] for f in functions]
    print(f"{layer:6} files {len(lines):4}: median {statistics.median(lines.values()):4.0f}, "
          f"p90 {p90(lines.values()):4}, most {max(lines.values()):4}   "
          f"functions {len(functions):5}: median {statistics.median(lengths):3.0f}, "
          f"p90 {p90(lengths):3}, most {max(lengths):3}")
    errors += [f"{p}: {n} lines, at most {MOST_FILE_LINES}"
               for p, n in lines.items() if n > MOST_FILE_LINES]
    errors += [f"{path}: {name} has {n} lines, at most {MOST_FUNCTION_LINES}"
               for n, path, name in functions if n > MOST_FUNCTION_LINES]
    if layer == "core" and statistics.median(lengths) > MOST_CORE_MEDIAN:
        errors.append(f"median of core's functions above {MOST_CORE_MEDIAN} lines")


def sums_by_room(lines, root_parts):
    """Lines by room and by every room above it."""
    sums = defaultdict(int)
    for path, n in lines.items():
        for depth in range(root_parts, len(path.parts)):
            sums["/".join(path.parts[root_parts - 1:depth])] += n
    return sums


def show_tests(root, layer, errors):
    sources = [p for p in files_of(root, layer) if not ORACLES.fullmatch(str(p))]
    source = sums_by_room(lines_of(root, sources), 1)
    source[layer] = sum(lines_of(root, files_of(root, layer)).values())
    tests = sums_by_room(lines_of(root, files_of(root, f"tests/{layer}")), 2)
    for room in sorted(source):
        ratio = tests[room] / source[room]
        least = (LEAST_TESTS.get(room) or LEAST_TESTS_OF.get(room)
                 or LEAST_TESTS_OF_ROOM.get(layer, 0.0))
        print(f"  {room:38} {source[room]:6} {tests[room]:6}  {ratio:5.2f}")
        if ratio < least:
            errors.append(f"{room}: {ratio:.2f} lines of tests to a line of source, {least} at least")


def check_bars(root):
    errors = []
    for layer in LAYERS:
        check_sizes(root, layer, errors)
    print(f"\n  {'room':38} {'source':>6} {'tests':>6}  ratio")
    for layer in ("core", "registry", "ui"):
        show_tests(root, layer, errors)
    window = root / "ui/shell/main_window.cpp"
    print(f"\nmain_window.cpp: {len(window.read_text().splitlines())} lines")
    return errors


def main():
    checks = {"rings": check_rings, "bars": check_bars, "names": check_names}
    if len(sys.argv) != 3 or sys.argv[1] not in checks:
        sys.exit(__doc__)
    errors = checks[sys.argv[1]](Path(sys.argv[2]))
    for error in errors:
        print(error)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
