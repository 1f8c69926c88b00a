// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"

namespace dyncal {

/// The number of what has none yet.
inline constexpr const char *kDccDraft = "draft";
/// The id of the item that the results are of.
inline constexpr const char *kDccItem = "item";

/// dcc:statements: that it is a draft, what the certificate states (ISO/IEC 17025, 7.8), the place,
/// the statement of conformity, and what an issued one is bound to.
XmlElement dccStatements(const DccSource &source);

} // namespace dyncal
