// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/json_merge.h"

namespace dyncal {
namespace {

void putChannelOver(Json &lower, const Json &upper)
{
    if (lower.is_object() && upper.is_string()) {
        lower["role"] = upper;
        return;
    }
    if (lower.is_string() && upper.is_object())
        lower = Json::object({{"role", lower}});
    putOver(lower, upper);
}

} // namespace

void putOver(Json &lower, const Json &upper, std::string_view key)
{
    if (!lower.is_object() || !upper.is_object()) {
        lower = upper;
        return;
    }
    for (const auto &[name, value] : upper.items()) {
        if (key == "channels")
            putChannelOver(lower[name], value);
        else
            putOver(lower[name], value, name);
    }
}

} // namespace dyncal
