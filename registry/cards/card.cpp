// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/cards/card.h"

#include "core/base/json_text.h"

#include <algorithm>
#include <array>

namespace dyncal {

bool isCardKind(const std::string &kind)
{
    constexpr std::array<std::string_view, 4> kKinds{
        "laboratory", "customer", "sensor", "reference"};
    return std::ranges::find(kKinds, kind) != kKinds.end();
}

std::string cardObject(const Card &card)
{
    return card.kind + ' ' + card.name;
}

std::string cardJson(const Card &card)
{
    std::string text = jsonLine(card.fields);
    text.pop_back(); // the line break
    return text;
}

std::optional<std::map<std::string, std::string>> parseCardFields(const std::string &json)
{
    try {
        return nlohmann::json::parse(json).get<std::map<std::string, std::string>>();
    } catch (const nlohmann::json::exception &) {
        return std::nullopt;
    }
}

} // namespace dyncal
