// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/quantity_format.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "ui/text/first_place.h"

#include <QLocale>
#include <QRegularExpression>

#include <cmath>

namespace dyncal {

namespace {

constexpr char16_t kSuperscripts[] = u"⁰¹²³⁴⁵⁶⁷⁸⁹";
const QString kTimesTen = QStringLiteral("×10");

/// "5.5e-05" -> "5,5×10⁻⁵".
QString inLanguage(const std::string &number)
{
    QString text = QString::fromStdString(number).replace('.', QLocale().decimalPoint());
    const auto mark = text.indexOf('e');
    if (mark < 0)
        return text;
    const QString exponent = QString::number(text.mid(mark + 1).toInt());
    text.truncate(mark);
    text += kTimesTen;
    for (const QChar digit : exponent)
        text += digit == '-' ? QChar(u'⁻') : QChar(kSuperscripts[digit.digitValue()]);
    return text;
}

const QString &nothing()
{
    static const QString text = QStringLiteral("–");
    return text;
}

} // namespace

PrefixedUnit prefixedUnit(double beside, const QString &unit)
{
    constexpr int kAllDigits = 17;
    if (unit.isEmpty() || unit == "1" || !std::isfinite(beside) || beside == 0.0)
        return {};
    const std::string other = numberWithUnit(beside, presentable(unit.toStdString()), kAllDigits);
    const auto blank = other.find(' ');
    const double number = parseNumber(other.substr(0, blank)).value_or(beside);
    return {std::pow(10.0, std::round(std::log10(beside / number))),
        QString::fromStdString(other.substr(blank))};
}

QString shownQuantity(double value, const QString &unit, int digits)
{
    if (!std::isfinite(value))
        return nothing();
    if (unit.isEmpty() || unit == "1")
        return shownNumber(value, digits);
    const QString text
        = QString::fromStdString(numberWithUnit(value, presentable(unit.toStdString()), digits));
    const auto blank = text.indexOf(' '); // units may hold a '.', numbers come first
    return inLanguage(text.left(blank).toStdString()) + text.mid(blank);
}

QString shownQuantityBeside(double value, double beside, const QString &unit, int digits)
{
    const PrefixedUnit prefixed = prefixedUnit(beside, unit);
    if (!std::isfinite(value) || prefixed.unit.isEmpty())
        return shownQuantity(value, unit, digits);
    return shownNumber(value / prefixed.factor, digits) + prefixed.unit;
}

QString shownNumber(double value, int digits)
{
    return std::isfinite(value) ? inLanguage(numberText(value, digits)) : nothing();
}

QString shownFigures(double value, int digits)
{
    constexpr double kLeast = 1e-4, kMost = 1e6;
    const double magnitude = std::abs(value);
    if (!(magnitude >= kLeast && magnitude < kMost))
        return shownNumber(value, digits);
    // Rounding may make it ten times as large: 0.996 to two digits.
    const double unit = std::pow(10.0, firstPlace(magnitude) - (digits - 1));
    const double rounded = std::round(magnitude / unit) * unit;
    return inLanguage(fixedText(value, std::max(digits - 1 - firstPlace(rounded), 0)));
}

QString shownQuantity(const std::optional<double> &value, const QString &unit, int digits)
{
    return value ? shownQuantity(*value, unit, digits) : nothing();
}

ShownResult shownResult(double value, double u, const QString &unit, int digits)
{
    if (!std::isfinite(value))
        return {nothing(), nothing()};
    const RoundedValue rounded = roundedValue(
        value, u, unit == "1" ? std::string() : presentable(unit.toStdString()), digits);
    const auto shown = [&rounded](const std::string &number) {
        const QString text = inLanguage(number);
        return rounded.unit.empty()
            ? text
            : text + QLatin1Char(' ') + QString::fromStdString(rounded.unit);
    };
    return {shown(rounded.value), rounded.u.empty() ? nothing() : shown(rounded.u)};
}

ShownResult shownResultBeside(double value, double u, double beside, const QString &unit)
{
    const PrefixedUnit prefixed = prefixedUnit(beside, unit);
    if (prefixed.unit.isEmpty())
        return shownResult(value, u, unit);
    const ShownResult shown = shownResult(value / prefixed.factor, u / prefixed.factor, {});
    const auto withUnit = [&prefixed](const QString &number) {
        return number == nothing() ? number : number + prefixed.unit;
    };
    return {withUnit(shown.value), withUnit(shown.u)};
}

QString shownWithStandardU(double value, double u, const QString &unit, int digits)
{
    return shownWithStandardU(shownResult(value, u, unit, digits));
}

QString shownWithStandardU(const ShownResult &shown)
{
    return shown.u == nothing()
        ? shown.value
        : shown.value + QStringLiteral(" (u = ") + shown.u + QLatin1Char(')');
}

QString shownConcisely(double value, double u, const QString &unit, int digits)
{
    const ShownResult shown = shownResult(value, u, unit, digits);
    static const QRegularExpression parts(QStringLiteral("^(-?\\d+(?:[.,]\\d+)?)( \\D.*)?$"));
    static const QRegularExpression leading(QStringLiteral("^0[.,]0*"));
    const auto number = parts.match(shown.value);
    const auto spread = parts.match(shown.u);
    if (!number.hasMatch() || !spread.hasMatch())
        return shownWithStandardU(shown);
    return QStringLiteral("%1(%2)%3")
        .arg(number.captured(1), spread.captured(1).remove(leading), number.captured(2));
}

QString shownWithU(double value, double u, const QString &unit, int digits)
{
    return shownWithU(shownResult(value, u, unit, digits));
}

QString shownWithU(const ShownResult &shown)
{
    return shown.u == nothing() ? shown.value : shown.value + QStringLiteral(" ± ") + shown.u;
}

QString inDecimalMark(const QString &text)
{
    return inDecimalMark(text, QLocale().decimalPoint().front());
}

QString inDecimalMark(const QString &text, QChar mark)
{
    if (mark == QLatin1Char('.'))
        return text;
    // A unit has no digits but exponents and no '.': "2.5.1" is a version, "1.5 a.csv" a name.
    static const QRegularExpression quantity(QStringLiteral(
        "^([<>\u2264\u2265] ?)?[-+\u2212\u00b1]?\\d+(\\.\\d+)?(e[-+]?\\d+)?( ?[^\\d\\s.]{1,8})?"
        "([ ,\u2013][^.\\d]{0,6}[-+]?\\d+(\\.\\d+)?(e[-+]?\\d+)?( ?[^\\d\\s.]{1,8})?)*$"));
    if (!quantity.match(text).hasMatch())
        return text;
    QString shown = text;
    return shown.replace('.', mark);
}

QString withPlainExponent(QString text)
{
    const auto mark = text.indexOf(kTimesTen);
    if (mark < 0)
        return text;
    text.replace(mark, kTimesTen.size(), "e");
    text.replace(u'⁻', '-');
    for (int digit = 0; digit < 10; ++digit)
        text.replace(QChar(kSuperscripts[digit]), QString::number(digit));
    return text;
}

std::optional<double> typedNumber(QString text)
{
    text = withPlainExponent(text.trimmed());
    text.replace(',', '.');
    text.replace(QChar(0x2212), '-'); // minus sign
    const std::optional<double> number = parseNumber(text.toStdString());
    return number && std::isfinite(*number) ? number : std::nullopt;
}

} // namespace dyncal
