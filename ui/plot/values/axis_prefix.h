// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QLocale>
#include <QString>

namespace dyncal {

/// What axis labels are divided by and how that is written: 1e-6 and "µ".
struct AxisPrefix
{
    double factor = 1.0;
    QString symbol;

    bool operator==(const AxisPrefix &) const = default;
};

/// True for units that take SI prefixes ("s", "Hz", "V/Pa"); not for "dB", "%", "kPa", "".
bool takesPrefix(const QString &unit);

/// Prefix for an axis that shows [lower, upper] SI values: the larger end reads 1..1000. Units
/// without prefixes get a power of ten (symbol "10⁻³ ") outside 1e-2..1e5, decibels never.
AxisPrefix axisPrefix(double lower, double upper, const QString &unit);

/// Prefix for a logarithmic axis: that of its middle, so that its labels read around 1. None for
/// units without prefixes, whose decades are powers of ten.
AxisPrefix decadePrefix(double lower, double upper, const QString &unit);

/// "Time / µs"; "Lag" for a quantity without unit.
QString axisLabel(const QString &quantity, const QString &unit, const AxisPrefix &prefix);

/// The locale of the program without group separators: "1000", decimal mark of the language.
QLocale plotLocale();

/// A number in that locale, but with the minus sign of tables and fields: some languages have
/// another. `format` and `precision` as for QLocale::toString.
QString plotNumber(double value, char format, int precision);

/// A power of ten as "10⁻³" for the decade `exponent`.
QString powerOfTen(int exponent);

/// SI value with prefix and unit, for readouts and marks: "2.330 MHz". Locale of the program.
QString valueWithUnit(double value, const QString &unit, int digits);

} // namespace dyncal
