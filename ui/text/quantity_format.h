// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

#include <optional>

namespace dyncal {

/// Numbers as the window shows them: SI prefix, the decimal mark of the language. For display only;
/// files go through core/base/number_text.h.
QString shownQuantity(double value, const QString &unit, int digits = 4);
QString shownNumber(double value, int digits = 4);

/// To so many digits, zeros at the end included: "7.0" beside "7.4"; like shownNumber() outside
/// 1e-4..1e6.
QString shownFigures(double value, int digits);
/// "–" where there is no value.
QString shownQuantity(const std::optional<double> &value, const QString &unit, int digits = 4);

/// The unit with the prefix in which `beside` is shown, and that prefix as a factor.
struct PrefixedUnit
{
    double factor = 1.0;
    QString unit; ///< with the blank before it; empty for a plain number
};
PrefixedUnit prefixedUnit(double beside, const QString &unit);

/// `value` in the unit and prefix that shownQuantity(beside, ...) uses: an uncertainty beside its
/// value.
QString shownQuantityBeside(double value, double beside, const QString &unit, int digits);

/// A value to the digits of its standard uncertainty, and that uncertainty in the same unit (GUM
/// 7.2.6, core/base/rounding.h): {"2.329980 MHz", "0.000012 MHz"}. Without a known u `digits`
/// and "–": a page is where numbers are worked with, also before their uncertainty is computed;
/// what is a result has three (kDigitsWithoutUncertainty).
struct ShownResult
{
    QString value;
    QString u;
};
inline constexpr int kDigitsOnPages = 5;
ShownResult shownResult(double value, double u, const QString &unit, int digits = kDigitsOnPages);
/// The same with the prefix that shownQuantity(beside, ...) has: rows that are read across.
ShownResult shownResultBeside(double value, double u, double beside, const QString &unit);
/// "2.329980 MHz (u = 0.000012 MHz)", as the command line has it; without a known u the value
/// alone. A standard uncertainty behind a "±" would be taken for an expanded one (GUM 7.2.2).
QString shownWithStandardU(
    double value, double u, const QString &unit, int digits = kDigitsOnPages);
QString shownWithStandardU(const ShownResult &shown);
/// "2.329980(12) MHz", u as digits of the value's last ones (GUM 7.2.2), "432.0(3.7) kPa" where u
/// has digits before the decimal mark; with a power of ten as shownWithStandardU().
QString shownConcisely(double value, double u, const QString &unit, int digits = kDigitsOnPages);
/// "2.329980 MHz ± 0.000024 MHz", for U, and for what a head of a table or a label calls ± u.
QString shownWithU(double value, double u, const QString &unit, int digits = kDigitsOnPages);
QString shownWithU(const ShownResult &shown);

/// A number, a quantity or a range of them as core writes it ("1.5 ms", "0.1 to 2e-3", "99.9 %"),
/// in the decimal mark of the language; any other text as it is.
QString inDecimalMark(const QString &text);
QString inDecimalMark(const QString &text, QChar mark);

/// "5.5×10⁻⁵" -> "5.5e-5", so that what is shown can be typed back.
QString withPlainExponent(QString text);

/// A number as people type it: ',' or '.' as decimal mark, blanks around it. Empty if it is none
/// or not finite.
std::optional<double> typedNumber(QString text);

} // namespace dyncal
