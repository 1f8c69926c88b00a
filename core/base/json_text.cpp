// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/json_text.h"

#include "core/base/foreign_text.h"

namespace dyncal {

std::string jsonText(const nlohmann::json &json)
{
    return presentableJson(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace))
        + "\n";
}

} // namespace dyncal
