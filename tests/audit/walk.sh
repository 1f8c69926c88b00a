#!/bin/sh
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# An assessor's walk (docs/registry.md): from the number on a certificate to the raw samples.
#   tests/audit/walk.sh DYNCAL FOLDER REGISTRY ARCHIVE
# DYNCAL: the program; FOLDER: DIR/NUMBER of an issued certificate; ARCHIVE: a folder with its recordings.
# Every step prints what it found; the first that does not hold ends the walk with exit code 1.
set -eu
dyncal=$1 folder=$2 registry=$3 archive=$4
here=$(dirname "$0")

fail() { echo "The walk ends here: $1" >&2; exit 1; }
text=$(pdftotext -layout "$folder/certificate.pdf" - | tr -d '\n ')
on_page() { case $text in *"$1"*) echo "on the page: $1" ;; *) fail "the page lacks $1" ;; esac; }

echo "1. The page names number, results and audit trail"
number=$(basename "$folder")
on_page "No.$number"
on_page "$(sha256sum "$folder/results.json" | cut -d' ' -f1)"
on_page "$(tail -n 1 "$folder/audit.jsonl" | python3 -c 'import json,sys; print(json.load(sys.stdin)["sha256"])')"

echo "2. Every file is the one of the manifest"
(cd "$folder" && python3 -c '
import json
for name, digest in json.load(open("manifest.json"))["files"].items():
    print(digest, "", name)' | sha256sum -c) || fail "a file was changed"

echo "3. The registry knows this certificate, and the recordings are those that were evaluated"
code=0
"$dyncal" verify "$folder" "$registry" --registry "$registry" --recordings "$archive" || code=$?
[ "$code" -le 1 ] || fail "dyncal verify says so"

echo "4. Every number on the first page is that of results.json, to the digit"
python3 "$here/printed_numbers.py" "$folder" || fail "page and results.json differ"

echo "5. The recordings give these results again"
"$dyncal" recheck "$folder" --recordings "$archive" || fail "something differs by more than its U"
