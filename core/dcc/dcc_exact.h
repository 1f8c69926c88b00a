// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"

#include <vector>

namespace dyncal {

/// The id of the list of the whole response, which the printed one refers to.
inline constexpr const char *kDccResponse = "response";

/// What results.json has beside the pages, not rounded, as dcc:result elements: S(f) as complex
/// numbers with their regions, and that of a comparison beside it.
std::vector<XmlElement> dccExactResults(const DccSource &source);

} // namespace dyncal
