// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <span>

namespace dyncal {

/// A refType of our own, declared in dcc:refTypeDefinitions.
struct DccRefType
{
    const char *refType;
    const char *meaning; ///< in English
};

/// Each that a DCC of ours may have.
std::span<const DccRefType> dccRefTypes();

} // namespace dyncal
