// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/tdms/tdms_cursor.h"
#include "core/capture/formats/tdms/tdms_types.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace dyncal {

/// Value of a property. Truth values are integers; complex numbers and void are not kept.
using TdmsValue
    = std::variant<std::monostate, std::int64_t, std::uint64_t, double, std::string, TdmsTimestamp>;

/// Properties of the file, a group or a channel, by name.
using TdmsProperties = std::map<std::string, TdmsValue, std::less<>>;

/// Reads type and value; false if they end early or the type has no known size.
bool readTdmsValue(TdmsCursor &cursor, TdmsValue &value);

/// A number of any type, if the property is there and is one.
std::optional<double> numberOf(const TdmsProperties &properties, std::string_view name);

/// An integer (not below 0) of any integer type, if the property is there and is one.
std::optional<std::uint64_t> countOf(const TdmsProperties &properties, std::string_view name);

/// A text; empty if the property is not there or no text.
std::string textOf(const TdmsProperties &properties, std::string_view name);

std::optional<TdmsTimestamp> timestampOf(const TdmsProperties &properties, std::string_view name);

/// The value for people; empty where there is none.
std::string valueText(const TdmsValue &value);

} // namespace dyncal
