// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/printed_value.h"

#include "core/base/number_text.h"
#include "core/dcc/si_unit.h"

namespace dyncal {
namespace {

constexpr std::string_view kPlusMinus = " \xC2\xB1 ";
constexpr std::string_view kPowerOfTen = "\xC3\x97"
                                         "10^";
constexpr std::string_view kFactor = " (k = ";
constexpr std::string_view kHardSpace = "\xC2\xA0";

bool isPlainNumber(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("-.0123456789eE+") == std::string_view::npos
        && parseNumber(text).has_value();
}

/// Takes the text up to a blank away.
std::string_view takeWord(std::string_view &text)
{
    const std::size_t plain = text.find(' ');
    const std::size_t hard = text.find(kHardSpace);
    const std::size_t end = std::min({plain, hard, text.size()});
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    if (!text.empty())
        text.remove_prefix(end == hard ? kHardSpace.size() : 1);
    return word;
}

/// "2.33 MHz", "1.5 x10^-7 V/Pa"
std::optional<PrintedValue> numberAndUnit(std::string_view text)
{
    PrintedValue printed;
    printed.value = takeWord(text);
    if (!isPlainNumber(printed.value))
        return std::nullopt;
    if (text.starts_with(kPowerOfTen)) {
        const std::string_view exponent = takeWord(text).substr(kPowerOfTen.size());
        if (!isPlainNumber(exponent))
            return std::nullopt;
        printed.value.append("E").append(exponent);
    }
    const std::optional<std::string> unit = dsiUnitOf(text);
    if (!unit)
        return std::nullopt;
    printed.unit = *unit;
    return printed;
}

/// Takes " (k = 4.30)" away; empty where it is not there.
std::string takeFactor(std::string_view &text)
{
    const std::size_t at = text.rfind(kFactor);
    if (at == std::string_view::npos || !text.ends_with(')'))
        return {};
    const std::string_view factor
        = text.substr(at + kFactor.size(), text.size() - at - kFactor.size() - 1);
    if (!isPlainNumber(factor))
        return {};
    text = text.substr(0, at);
    return std::string(factor);
}

} // namespace

std::optional<PrintedValue> printedValue(std::string_view text)
{
    const std::string factor = takeFactor(text);
    const std::size_t at = text.find(kPlusMinus);
    std::optional<PrintedValue> printed = numberAndUnit(text.substr(0, at));
    if (!printed)
        return std::nullopt;
    printed->factor = factor;
    if (at == std::string_view::npos)
        return printed;
    const auto expanded = numberAndUnit(text.substr(at + kPlusMinus.size()));
    if (!expanded || expanded->unit != printed->unit || factor.empty())
        return std::nullopt;
    printed->expanded = expanded->value;
    return printed;
}

std::optional<PrintedValue> printedValue(const Message &cell)
{
    constexpr std::string_view kNumbers = "%L1";
    if (cell.text != kNumbers || cell.arguments.size() != 1 || !cell.below.empty())
        return std::nullopt;
    return printedValue(cell.arguments.front());
}

} // namespace dyncal
