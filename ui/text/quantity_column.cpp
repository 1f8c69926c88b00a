// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/quantity_column.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "ui/text/first_place.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

const QString kNoValue = QStringLiteral("–");

/// Power of ten of the prefix that `shown` has before `unit`; none if it is no prefix.
std::optional<int> prefixExponent(const std::string &shown, const std::string &unit)
{
    static const std::pair<const char *, int> prefixes[] = {{"", 0}, {"f", -15}, {"p", -12},
        {"n", -9}, {"µ", -6}, {"m", -3}, {"k", 3}, {"M", 6}, {"G", 9}};
    for (const auto &[symbol, exponent] : prefixes)
        if (shown == symbol + unit)
            return exponent;
    return std::nullopt;
}

std::string unitText(const QString &unit)
{
    return unit == QLatin1String("1") ? std::string() : presentable(unit.toStdString());
}

int decimalsOf(const std::string &number)
{
    const std::size_t point = number.find('.');
    return point == std::string::npos ? 0 : static_cast<int>(number.size() - point - 1);
}

QString withUnit(const std::string &number, const std::string &unit)
{
    const QString text = QString::fromStdString(number).replace('.', QLocale().decimalPoint());
    return unit.empty() ? text : text + QLatin1Char(' ') + QString::fromStdString(unit);
}

/// Decimals for all numbers of a column, from the largest and the smallest that is not zero.
int columnDecimals(double largest, double smallest, int digits)
{
    constexpr int kMorePlaces = 3;
    constexpr int kMostDecimals = 15;
    const int decimals = std::clamp(digits - 1 - firstPlace(largest), 0, kMostDecimals);
    return std::clamp(1 - firstPlace(smallest), decimals, decimals + kMorePlaces);
}

} // namespace

QStringList shownColumn(const std::vector<double> &values, const QString &unit, int digits)
{
    double largest = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    for (const double value : values) {
        if (!std::isfinite(value) || value == 0.0)
            continue;
        largest = std::max(largest, std::abs(value));
        smallest = std::min(smallest, std::abs(value));
    }
    const std::string base = unitText(unit);
    const std::string shownUnit = roundedValue(largest, 0.0, base).unit;
    const std::optional<int> exponent = prefixExponent(shownUnit, base);
    QStringList shown;
    for (const double value : values) {
        if (!std::isfinite(value))
            shown << kNoValue;
        else if (!exponent || largest == 0.0) // a power of ten of its own
            shown << shownQuantity(value, unit, digits);
        else {
            const double scale = std::pow(10.0, *exponent);
            const int decimals = columnDecimals(largest / scale, smallest / scale, digits);
            shown << withUnit(fixedText(value / scale, decimals), shownUnit);
        }
    }
    return shown;
}

QStringList shownColumn(
    const std::vector<std::optional<double>> &values, const QString &unit, int digits)
{
    std::vector<double> known;
    known.reserve(values.size());
    for (const std::optional<double> &value : values)
        known.push_back(value.value_or(Estimate().value));
    return shownColumn(known, unit, digits);
}

std::vector<ShownResult> shownColumn(const std::vector<Estimate> &values, const QString &unit)
{
    const std::string base = unitText(unit);
    std::vector<RoundedValue> rounded;
    rounded.reserve(values.size());
    std::optional<int> highest;
    std::string shownUnit = base;
    for (const Estimate &one : values) {
        rounded.push_back(roundedValue(one.value, one.u, base, kDigitsOnPages));
        const std::optional<int> exponent = prefixExponent(rounded.back().unit, base);
        if (std::isfinite(one.value) && one.value != 0.0 && exponent
            && (!highest || *exponent > *highest)) {
            highest = exponent;
            shownUnit = rounded.back().unit;
        }
    }
    std::vector<ShownResult> shown;
    shown.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const RoundedValue &one = rounded[i];
        const std::optional<int> exponent = prefixExponent(one.unit, base);
        if (!std::isfinite(values[i].value) || !exponent || !highest) {
            shown.push_back(shownResult(values[i].value, values[i].u, unit));
            continue;
        }
        // Rounded already: the same digits, the point elsewhere.
        const auto moved = [&](const std::string &number) {
            const double value = parseNumber(number).value_or(0.0);
            return withUnit(fixedText(value * std::pow(10.0, *exponent - *highest),
                                decimalsOf(number) + *highest - *exponent),
                shownUnit);
        };
        shown.push_back({moved(one.value), one.u.empty() ? kNoValue : moved(one.u)});
    }
    return shown;
}

QStringList shownColumnWithU(const std::vector<Estimate> &values, const QString &unit)
{
    QStringList shown;
    for (const ShownResult &one : shownColumn(values, unit))
        shown << (one.u == kNoValue ? one.value : one.value + QStringLiteral(" ± ") + one.u);
    return shown;
}

} // namespace dyncal
