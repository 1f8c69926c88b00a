// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/kept_message.h"

#include <string>

namespace dyncal {

/// The sentence for a person who reads what a command prints: in the language of the environment
/// variable DYNCAL_LANGUAGE ("sv"), numbers with its decimal mark; else in English. What is
/// written to files stays in English (english()).
std::string spoken(const Message &message);

/// One that was kept; `otherwise` where there is none.
std::string spoken(const KeptMessage &message, const std::string &otherwise);

} // namespace dyncal
