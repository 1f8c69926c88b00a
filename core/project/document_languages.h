// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/json_codec.h"

#include <string>
#include <vector>

namespace dyncal {

/// The languages that a certificate can be written in: "en", "sv", "de".
const std::vector<std::string> &documentLanguageCodes();

/// One of them, or two: the second stands beside the first.
Codec<std::vector<std::string>> documentLanguageList();

} // namespace dyncal
