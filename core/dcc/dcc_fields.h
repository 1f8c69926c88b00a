// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dyncal {

/// A field of the certificate and what it is called in a DCC, for machines: independent of the
/// DCC's version.
struct DccField
{
    /// Where it stands on the certificate: "conditions.ambient_temperature" of a field, "poles" of
    /// a table, "poles/Damping ratio" of a column or, of the key results, a row.
    const char *place;
    const char *refType;
};

std::span<const DccField> dccFields();

/// "" of a place that has none.
std::string refTypeOf(std::string_view place);

} // namespace dyncal
