// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <map>
#include <optional>
#include <string>

namespace dyncal {

/// The PDF of an issued certificate as an archive, and the files inside it held against those
/// beside it (bytes by name): each that belongs inside is there, byte for byte, with its type and
/// relationship, and nothing else. Returns the first difference. PDFs that do not claim to be
/// archives (of programs before they did) have none.
std::optional<Message> checkPdfArchive(
    const std::string &pdf, const std::map<std::string, std::string> &beside);

} // namespace dyncal
