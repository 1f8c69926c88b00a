// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/instruments/scope_bin.h"
#include "tests/fuzz/fuzz_reader.h"

DYNCAL_FUZZ_READER(&dyncal::readKeysightBin)
