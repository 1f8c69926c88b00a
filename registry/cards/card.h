// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace dyncal {

inline constexpr std::size_t kLongestCardName = 200; ///< bytes

/// What is known of a laboratory, a customer, a sensor or a reference instrument, by its name.
struct Card
{
    std::string kind; ///< one of isCardKind()
    std::string name;
    std::map<std::string, std::string> fields; ///< "address", "certificate", "due", "serial", ...

    bool operator==(const Card &) const = default;
};

/// "laboratory", "customer", "sensor" or "reference".
bool isCardKind(const std::string &kind);

/// "customer Acme": the object of its entries in the audit trail.
std::string cardObject(const Card &card);

/// The fields as JSON on one line, keys sorted, and back; empty where it is no such text.
std::string cardJson(const Card &card);
std::optional<std::map<std::string, std::string>> parseCardFields(const std::string &json);

} // namespace dyncal
