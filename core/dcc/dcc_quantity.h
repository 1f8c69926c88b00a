// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/message.h"
#include "core/dcc/dcc_words.h"
#include "core/dcc/printed_value.h"

#include <string>
#include <vector>

namespace dyncal {

/// Coverage probability of every U: k = 2, or Student's factor of 95 %.
inline constexpr const char *kDccProbability = "0.95";
/// What stands in a list where there is no value.
inline constexpr const char *kDccNone = "NaN";

/// refType of the words that stand beside the numbers of a list.
inline constexpr const char *kDccRemarks = "dyncal_remarks";

/// A column of a list, as texts: numbers, or words.
struct DccColumn
{
    Message name;
    std::string refType = {};
    std::vector<std::string> values = {}; ///< none of a column of words
    std::vector<std::string> units = {}; ///< of each value, D-SI
    std::vector<std::string> expanded = {}; ///< U of each value; empty: none has one
    std::vector<std::string> factors = {}; ///< k of each U
    std::vector<std::string> standard = {}; ///< u in place of U
    Message description = {"", {}}; ///< of the values
    std::vector<Message> words = {}; ///< beside the values, or in place of them; one each
};

/// Attribute refType; none where it is empty.
XmlElement withRefType(std::string name, const std::string &refType);

/// A dcc:result with its name; description and data follow.
XmlElement dccResult(const DccWords &words, const Message &name, const std::string &refType);

/// si:real inside dcc:quantity; a k that is not stated is `factor`.
XmlElement dccQuantity(const DccWords &words, const Message &name, const std::string &refType,
    const PrintedValue &printed, const std::string &factor = "2");

/// Words in place of a number: dcc:noQuantity.
XmlElement dccWordsQuantity(const DccWords &words, const Message &name, const std::string &refType,
    const std::vector<Message> &said);

/// A number if it is one (printedValue()), else its words.
XmlElement dccQuantityOf(
    const DccWords &words, const Message &name, const std::string &refType, const Message &printed);

/// Adds the quantities that a column is to a dcc:list: its values, and its words where it has any.
void addDccColumn(const DccWords &words, const DccColumn &column, XmlElement &list);

/// "1 2 3": what a DCC calls an XML list. A list of equal texts may stand once (`isOnce`).
std::string dccList(const std::vector<std::string> &texts, bool isOnce = false);

/// A coverage factor as the D-SI wants it, without exponent; NaN where it is none or below 1.
std::string dccFactor(const std::string &printed);

/// Shortest text that reads back as the same number; NaN where it is not finite.
std::string dccNumber(double value);

} // namespace dyncal
