// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>

namespace dyncal {

/// The bytes of a file that should be XML, for readXml(). Of one larger than kMostXmlBytes only so
/// many as show that it is too large. Fails (FileUnreadable) where it cannot be read.
Result<std::string> xmlFileBytes(const std::string &path);

} // namespace dyncal
