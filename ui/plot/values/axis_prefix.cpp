// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/axis_prefix.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {

namespace {

constexpr std::array<const char *, 9> kSymbols{"f", "p", "n", "µ", "m", "", "k", "M", "G"};
constexpr int kUnityPlace = 5;

/// Exponent of the prefix, a multiple of 3, for which `magnitude` reads 1..1000.
int engineeringExponent(double magnitude)
{
    // The slack keeps 999.9999999999 (a range end after a zoom) from changing the prefix.
    return 3 * static_cast<int>(std::floor(std::log10(magnitude * (1.0 + 1e-9)) / 3.0));
}

AxisPrefix prefixOfExponent(int exponent)
{
    const int place = std::clamp(exponent / 3 + kUnityPlace, 0, 8);
    return {std::pow(10.0, 3 * (place - kUnityPlace)),
        QString::fromUtf8(kSymbols[static_cast<std::size_t>(place)])};
}

} // namespace

bool takesPrefix(const QString &unit)
{
    static const std::array<const char *, 14> kUnits{
        "s", "Hz", "V", "A", "Pa", "C", "W", "N", "m", "V/Pa", "A/Pa", "C/Pa", "W/Pa", "m/s"};
    return std::any_of(
        kUnits.begin(), kUnits.end(), [&unit](const char *known) { return unit == known; });
}

AxisPrefix axisPrefix(double lower, double upper, const QString &unit)
{
    const double magnitude = std::max(std::abs(lower), std::abs(upper));
    if (!(magnitude > 0.0) || !std::isfinite(magnitude) || unit.startsWith(QLatin1String("dB")))
        return {};
    const int exponent = engineeringExponent(magnitude);
    if (takesPrefix(unit))
        return prefixOfExponent(exponent);
    if (magnitude >= 1e-2 && magnitude < 1e5)
        return {};
    return {std::pow(10.0, exponent), powerOfTen(exponent) + (unit.isEmpty() ? "" : " ")};
}

AxisPrefix decadePrefix(double lower, double upper, const QString &unit)
{
    const double middle = std::sqrt(lower) * std::sqrt(upper);
    const bool isDrawn = lower > 0.0 && std::isfinite(middle);
    return isDrawn && takesPrefix(unit) ? prefixOfExponent(engineeringExponent(middle))
                                        : AxisPrefix{};
}

QString axisLabel(const QString &quantity, const QString &unit, const AxisPrefix &prefix)
{
    const QString shown = prefix.symbol + unit;
    const bool isCompound = shown.contains('/') || shown.contains(' ');
    return shown.isEmpty() ? quantity : quantity + " / " + (isCompound ? '(' + shown + ')' : shown);
}

QLocale plotLocale()
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

QString plotNumber(double value, char format, int precision)
{
    return plotLocale().toString(value, format, precision).replace(QChar(0x2212), QChar('-'));
}

QString powerOfTen(int exponent)
{
    static const std::array<const char *, 10> kDigits{
        "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    QString text = QStringLiteral("10");
    for (const char digit : std::to_string(exponent))
        text += digit == '-' ? QStringLiteral("⁻")
                             : QString::fromUtf8(kDigits[static_cast<std::size_t>(digit - '0')]);
    return text;
}

QString valueWithUnit(double value, const QString &unit, int digits)
{
    if (!std::isfinite(value))
        return QStringLiteral("–");
    AxisPrefix prefix;
    if (takesPrefix(unit) && value != 0.0)
        prefix = prefixOfExponent(engineeringExponent(std::abs(value)));
    const double scaled = value / prefix.factor;
    const double magnitude = std::abs(scaled);
    QString number;
    if (magnitude == 0.0 || (magnitude >= 1e-3 && magnitude < 1e6)) {
        const int whole = magnitude < 1.0 ? 1 : static_cast<int>(std::log10(magnitude)) + 1;
        number = plotNumber(scaled, 'f', std::max(0, digits - whole));
    } else {
        number = plotNumber(scaled, 'e', digits - 1);
    }
    const QString shown = prefix.symbol + unit;
    return shown.isEmpty() ? number : number + QChar(0x202F) + shown;
}

} // namespace dyncal
