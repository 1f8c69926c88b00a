// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/typed_quantity.h"

#include "core/base/number_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <utility>
#include <vector>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct TypedQuantityText
{
    Q_DECLARE_TR_FUNCTIONS(TypedQuantityText)
};

/// SI value = number * factor + zero.
struct TypedUnit
{
    const char *text;
    double factor = 1.0;
    double zero = 0.0;
};
using Units = std::vector<TypedUnit>;

constexpr double kPsi_Pa = 6894.757; ///< NIST SP 811, as core/shock/pressure_units
constexpr double kIceK = 273.15;
constexpr double kFahrenheit_K = 5.0 / 9.0;
constexpr double kFahrenheitZero_K = kIceK - 32.0 * kFahrenheit_K;

/// One list per kind of quantity.
const std::vector<Units> &kinds()
{
    static const std::vector<Units> kinds{
        {{"s"}, {"ms", 1e-3}, {"µs", 1e-6}, {"ns", 1e-9}},
        {{"Hz"}, {"kHz", 1e3}, {"MHz", 1e6}, {"GHz", 1e9}, {"mHz", 1e-3}, {"S/s"}, {"kS/s", 1e3},
            {"MS/s", 1e6}, {"GS/s", 1e9}},
        {{"Pa"}, {"hPa", 1e2}, {"kPa", 1e3}, {"MPa", 1e6}, {"mPa", 1e-3}, {"mbar", 1e2},
            {"bar", 1e5}, {"psi", kPsi_Pa}},
        {{"K"}, {"°C", 1.0, kIceK}, {"C", 1.0, kIceK}, {"°F", kFahrenheit_K, kFahrenheitZero_K},
            {"F", kFahrenheit_K, kFahrenheitZero_K}},
        {{"m"}, {"cm", 1e-2}, {"mm", 1e-3}, {"µm", 1e-6}, {"in", 0.0254}, {"ft", 0.3048}},
        {{"m/s"}, {"km/s", 1e3}, {"mm/µs", 1e3}, {"km/h", 1.0 / 3.6}, {"ft/s", 0.3048}},
        {{"%", 1e-2}, {"‰", 1e-3}, {"ppm", 1e-6}},
        {{"kg/mol"}, {"g/mol", 1e-3}},
        {{"V/Pa"}, {"mV/Pa", 1e-3}, {"µV/Pa", 1e-6}, {"nV/Pa", 1e-9}, {"V/kPa", 1e-3},
            {"mV/kPa", 1e-6}, {"V/MPa", 1e-6}, {"V/bar", 1e-5}, {"mV/bar", 1e-8},
            {"mV/psi", 1e-3 / kPsi_Pa}},
    };
    return kinds;
}

const Units *kindOf(const QString &unit)
{
    for (const Units &kind : kinds())
        for (const TypedUnit &one : kind)
            if (unit == QString::fromUtf8(one.text))
                return &kind;
    return nullptr;
}

/// One way of writing what keyboards and documents write in several.
QString plainUnit(QString unit)
{
    unit.replace(QChar(0x03bc), QChar(0x00b5)); // Greek mu: micro sign
    unit.replace(QChar(0x02da), QChar(0x00b0)); // ring above, masculine ordinal: degree sign
    unit.replace(QChar(0x00ba), QChar(0x00b0));
    unit.remove(' ');
    if (unit == "us" || unit == "um" || unit.startsWith("uV/"))
        unit.replace(0, 1, QChar(0x00b5));
    return unit;
}

/// By its very letters, or in the other case where that leaves one meaning only.
const TypedUnit *unitCalled(const QString &typed, const Units &kind)
{
    const TypedUnit *found = nullptr;
    bool several = false;
    for (const TypedUnit &unit : kind) {
        const QString text = QString::fromUtf8(unit.text);
        if (typed == text)
            return &unit;
        if (typed.compare(text, Qt::CaseInsensitive) == 0) {
            several = found != nullptr;
            found = &unit;
        }
    }
    return several ? nullptr : found;
}

bool mayBeThousands(QString number)
{
    while (!number.isEmpty() && !number.front().isDigit())
        number.remove(0, 1);
    const bool comma = QLocale().decimalPoint() == QLatin1String(",");
    return mayBeGrouped(number.toStdString(), comma ? ',' : '.');
}

TypedQuantity refused(const QString &fault)
{
    return {{}, fault};
}

TypedQuantity noSuchUnit(const QString &typed, const ShownUnit &field)
{
    const QStringList units = understoodUnits(field);
    if (units.isEmpty())
        return refused(
            TypedQuantityText::tr("“%1”: this is a number without a unit.").arg(shownText(typed)));
    return refused(TypedQuantityText::tr("The unit “%1” is not understood here. Understood are %2.")
                       .arg(shownText(typed), units.join(QStringLiteral(", "))));
}

} // namespace

TypedQuantity typedQuantity(const QString &text, const ShownUnit &field)
{
    static const QRegularExpression form(
        QStringLiteral("^([+\\-\u2212]?[0-9.,]+(?:[eE][+\\-\u2212]?[0-9]+)?)\\s*(\\D.*)?$"));
    const auto match = form.match(withPlainExponent(text.trimmed()));
    const QString written = match.captured(1);
    const std::optional<double> number = typedNumber(written);
    if (!number)
        return refused(TypedQuantityText::tr("“%1” cannot be read as a number.")
                           .arg(shownText(text.trimmed())));
    if (mayBeThousands(written)) {
        QString digits = written;
        const QString whole = digits.remove(',').remove('.');
        return refused(TypedQuantityText::tr("“%1” can be read as %2 or as %3. Write one of these.")
                           .arg(shownText(written), shownNumber(*number, 15), whole));
    }
    const QString unit = plainUnit(match.captured(2));
    if (unit.isEmpty() || unit == field.text)
        return {*number, {}};
    const Units *kind = kindOf(field.text);
    const TypedUnit *known = kind ? unitCalled(unit, *kind) : nullptr;
    if (!known)
        return noSuchUnit(match.captured(2), field);
    return {(*number * known->factor + known->zero) / field.si, {}};
}

QStringList understoodUnits(const ShownUnit &field)
{
    if (field.text.isEmpty())
        return {};
    QStringList units{field.text};
    if (const Units *kind = kindOf(field.text))
        for (const TypedUnit &unit : *kind)
            units << QString::fromUtf8(unit.text);
    units.removeDuplicates();
    return units;
}

} // namespace dyncal
