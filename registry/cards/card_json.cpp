// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/cards/card_json.h"

#include "core/base/json_text.h"

#include <set>

namespace dyncal {

using Json = nlohmann::json;

std::string cardsJson(const std::vector<Card> &cards)
{
    Json list = Json::array();
    for (const Card &card : cards)
        list.push_back({{"name", card.name}, {"fields", card.fields}});
    return jsonText(list);
}

Result<std::vector<Card>> parseCardsJson(const std::string &json, const std::string &kind)
{
    std::vector<Card> cards;
    try {
        for (const Json &one : Json::parse(json))
            cards.push_back({kind, one.at("name").get<std::string>(),
                one.at("fields").get<std::map<std::string, std::string>>()});
    } catch (const Json::exception &) {
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The cards are not a JSON list of names with fields; write it as dyncal registry cards --json does."),
                {}});
    }
    std::set<std::string> names;
    for (Card &card : cards) {
        std::erase_if(card.fields, [](const auto &field) { return field.second.empty(); });
        const bool isNamed = !card.name.empty() && card.name.size() <= kLongestCardName;
        if (!isNamed || !names.insert(card.name).second)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "The card \"%1\" has no name of its own: it is empty, longer than 200 bytes or there twice; give every card a name."),
                    {card.name}});
    }
    return cards;
}

} // namespace dyncal
