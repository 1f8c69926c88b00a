// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/kept_message.h"

namespace dyncal {
namespace {

using MessageJson = nlohmann::json;

constexpr int kDeepest = 8; ///< ours have two levels

KeptMessage messageAt(const MessageJson &json, int depth)
{
    if (depth > kDeepest)
        throw MessageJson::other_error::create(501, "too deep", nullptr);
    KeptMessage message{json.at("text").get<std::string>(),
        json.value("arguments", std::vector<std::string>()), {}};
    for (const MessageJson &sentence : json.value("below", MessageJson::array()))
        message.below.push_back(messageAt(sentence, depth + 1));
    return message;
}

} // namespace

Message KeptMessage::message() const
{
    Message view{text.c_str(), arguments, {}};
    for (const KeptMessage &sentence : below)
        view.below.push_back(sentence.message());
    return view;
}

KeptMessage keptMessage(const Message &message)
{
    KeptMessage kept{message.text, message.arguments, {}};
    for (const Message &sentence : message.below)
        kept.below.push_back(keptMessage(sentence));
    return kept;
}

nlohmann::json messageJson(const KeptMessage &message)
{
    if (message.text.empty())
        return {};
    MessageJson json{{"text", message.text}};
    if (!message.arguments.empty())
        json["arguments"] = message.arguments;
    for (const KeptMessage &sentence : message.below)
        json["below"].push_back(messageJson(sentence));
    return json;
}

KeptMessage messageOfJson(const nlohmann::json &json)
{
    return json.is_null() ? KeptMessage() : messageAt(json, 0);
}

} // namespace dyncal
