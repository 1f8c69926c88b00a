// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/json_text.h"

#include "core/base/foreign_text.h"

namespace dyncal {
namespace {

std::string textIndentedBy(int spaces, const nlohmann::json &json)
{
    return presentableJson(json.dump(spaces, ' ', false, nlohmann::json::error_handler_t::replace))
        + "\n";
}

} // namespace

std::string jsonText(const nlohmann::json &json)
{
    return textIndentedBy(2, json);
}

std::string jsonLine(const nlohmann::json &json)
{
    return textIndentedBy(-1, json); // -1: no line breaks
}

} // namespace dyncal
