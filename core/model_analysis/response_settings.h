// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <string>
#include <vector>

namespace dyncal {

/// Recipe section "response".
struct ResponseSettings
{
    std::vector<double> frequencies_Hz; ///< used when `grid` is "list"
    std::string grid = "third-octave"; ///< "list", "third-octave" or "linear"
    Index linearCount = 200; ///< with "linear:N"
    std::string reference = "computed-step"; ///< or "static-sensitivity", "unit-step", "transducer"

    bool isByTransducer() const { return reference == "transducer"; }
    bool operator==(const ResponseSettings &) const = default;
};

} // namespace dyncal
