// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace dyncal {

/// A message that files and processes hand on, so that whoever shows it can say it in his language.
/// Its text need be no literal of this program: one of another version stays as it is.
struct KeptMessage
{
    std::string text; ///< empty: none
    std::vector<std::string> arguments = {};
    std::vector<KeptMessage> below = {};

    /// As long as this lives.
    Message message() const;
    bool operator==(const KeptMessage &) const = default;
};

KeptMessage keptMessage(const Message &message);

/// {"text", "arguments", "below"}, the last two where there are any; null for none.
nlohmann::json messageJson(const KeptMessage &message);

/// Of null, none. Throws what the JSON library throws where it is no message, or one with sentences
/// within sentences without end.
KeptMessage messageOfJson(const nlohmann::json &json);

} // namespace dyncal
