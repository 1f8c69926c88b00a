// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace dyncal {

/// Whether the file begins like a document, picture, archive or recording of another kind.
bool isForeignFile(std::string_view head);

/// Whether there are no control characters except blanks and line ends.
bool isPlainText(std::string_view text);

/// Why a file that no reader took cannot be read: says what it looks like by its first bytes
/// (PDF, office document, picture, empty, text without numbers, ...) and what can be read
/// (`readable`, a list for people). CAP-001.
tl::unexpected<Error> unknownFile(
    const std::string &path, std::string_view head, const std::string &readable);

} // namespace dyncal
