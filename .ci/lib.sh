#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Shared by ./run, ./test and .ci/run: sourced, not run. Expects `root`, the top of the tree.
# shellcheck disable=SC2154

build="$root/build-release"

say() {
    printf '==> %s\n' "$*" >&2
}

die() {
    printf '%s\n' "$*" >&2
    exit 1
}

# Package names of a list file: no comments, no empty lines.
package_names() {
    sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$1"
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo > /dev/null; then
        sudo "$@"
    else
        die "Installing packages needs root and there is no sudo; run as root: $*"
    fi
}

# Installs what is missing of the packages in the given list files. Asks the network for nothing
# when all are there.
install_packages() {
    if ! command -v dpkg-query > /dev/null; then
        say "Not Debian: the packages of packaging/debian-packages.txt must be there already."
        return
    fi
    local missing=() name
    while IFS= read -r name; do
        if [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2> /dev/null)" != installed ]; then
            missing+=("$name")
        fi
    done < <(for list in "$@"; do package_names "$list"; done)
    [ ${#missing[@]} -gt 0 ] || return 0
    say "Installing ${missing[*]}"
    as_root apt-get -o DPkg::Lock::Timeout=300 update -qq
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 \
        install -y -qq --no-install-recommends "${missing[@]}" > /dev/null
}

# Configures once; afterwards Ninja itself notices changed CMake files. A tree that was moved or
# copied is configured afresh.
configure() {
    if [ -f "$build/build.ninja" ] \
        && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
        return
    fi
    say "Configuring $build"
    mkdir -p "$build"
    if ! (cd "$root" && cmake --fresh --preset release > "$build/configure.log" 2>&1); then
        cat "$build/configure.log" >&2
        die "Configuring failed."
    fi
}

# Builds the given targets, or everything.
build_targets() {
    configure
    say "Building ${*:-everything} (release)"
    cmake --build "$build" ${1:+--target "$@"} >&2
}

# Says how many recordings the tests of the last ctest covered, and fails if a test was skipped for
# anything but a missing data folder (tests/support/measured_data.h): a skipped test proves nothing.
# Only the log knows, as ctest takes a skipped function for a passed one.
check_skips() {
    local log="$build/Testing/Temporary/LastTest.log" data="${DYNCAL_DATA:-$root/../shared/data}"
    local skipped forbidden
    [ -f "$log" ] || return 0
    sed -nE 's/^QINFO  : [^(]*\([^)]*\) (.*([0-9]+ files:|covered).*)$/\1/p' "$log" \
        | sed 's/^/Data: /' >&2
    skipped="$(grep -aE '^SKIP   : ' "$log" || true)"
    forbidden="$skipped"
    if [ ! -d "$data" ]; then
        forbidden="$(grep -avF ' NO DATA: ' <<< "$skipped" || true)"
        say "No folder of recordings ($data): $(grep -acF ' NO DATA: ' <<< "$skipped") tests skipped"
    fi
    [ -n "$forbidden" ] || return 0
    printf '%s\n' "$forbidden" >&2
    say "Skipped tests are failures: install what they need, or see why they had nothing to test."
    return 1
}

# clang-tidy (.clang-tidy) on the sources of core, registry, ui and app: all, or with --changed those that
# differ from DYNCAL_TIDY_BASE (the commit before), unless they are more than a check may wait for.
check_tidy() {
    local base="${DYNCAL_TIDY_BASE:-HEAD~1}" most=40 sources
    cmake --preset dev > /dev/null || return 1
    mapfile -t sources < <(git ls-files 'core/*.cpp' 'registry/*.cpp' 'ui/*.cpp' 'app/*.cpp')
    if [ "${1:-}" = --changed ]; then
        if ! git rev-parse --verify --quiet "$base^{commit}" > /dev/null; then
            [ -z "${DYNCAL_TIDY_BASE:-}" ] || die "There is no revision $base to compare with."
            say "No earlier revision here (a copy without history): .ci/long tidy looks at all"
            return 0
        fi
        mapfile -t sources < <(git diff --name-only --diff-filter=d "$base" -- \
            'core/*.cpp' 'registry/*.cpp' 'ui/*.cpp' 'app/*.cpp' 2> /dev/null)
        if [ ${#sources[@]} -gt "$most" ]; then
            say "${#sources[@]} sources changed: $most of them are looked at, .ci/long tidy does all"
            sources=("${sources[@]:0:most}")
        fi
    fi
    [ ${#sources[@]} -gt 0 ] || return 0
    # Its note on warnings of g++ that clang does not know would be an error.
    printf '%s\0' "${sources[@]}" | xargs -0 -n 4 -P "$(nproc)" clang-tidy -p "$root/build-dev" \
        --quiet --extra-arg=-Wno-unknown-warning-option 2> /dev/null
}

# Every header compiles by itself, without a precompiled one: all, or with --changed those that differ
# from DYNCAL_HEADERS_BASE (100 commits before), unless they are more than a check may wait for. Eigen and
# Qt make each take two seconds.
check_headers() {
    local base="${DYNCAL_HEADERS_BASE:-HEAD~100}" most=80 objects headers=()
    configure
    mapfile -t objects < <(ninja -C "$build" -t targets all \
        | sed -nE 's/^(\S+_verify_interface_header_sets\/\S+\.o): .*/\1/p')
    if [ "${1:-}" = --changed ] && git rev-parse --verify --quiet "$base^{commit}" > /dev/null; then
        mapfile -t headers < <(git diff --name-only --diff-filter=d "$base" -- '*.h')
        mapfile -t objects < <(printf '%s\n' "${objects[@]}" \
            | grep -F -f <(printf '_sets/%s.cxx.o\n' "${headers[@]}"))
        if [ ${#objects[@]} -gt "$most" ]; then
            say "${#objects[@]} headers changed: $most of them are looked at, .ci/long headers does all"
            mapfile -t objects < <(shuf -n "$most" -e "${objects[@]}" --random-source="$root/.ci/lib.sh")
        fi
    fi
    say "${#objects[@]} headers"
    [ ${#objects[@]} -gt 0 ] || return 0
    printf '%s\0' "${objects[@]}" | xargs -0 cmake --build "$build" --target >&2
}
