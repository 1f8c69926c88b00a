// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/budget_words.h"

#include "ui/text/level_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"
#include "ui/text/uncertainty_words.h"

#include <QCoreApplication>

#include <array>
#include <cmath>
#include <utility>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct BudgetWords
{
    Q_DECLARE_TR_FUNCTIONS(BudgetWords)
};

constexpr std::array<std::pair<const char *, const char *>, 11> kModelValues{{
    {"f0_hz", QT_TRANSLATE_NOOP("BudgetWords", "Natural frequency f₀")},
    {"damping_ratio", QT_TRANSLATE_NOOP("BudgetWords", "Damping ratio ζ")},
    {"q", QT_TRANSLATE_NOOP("BudgetWords", "Quality factor Q")},
    {"resonance_hz", QT_TRANSLATE_NOOP("BudgetWords", "Frequency of the resonance")},
    {"resonance_gain", QT_TRANSLATE_NOOP("BudgetWords", "Height of the resonance")},
    {"within_5_percent_hz", QT_TRANSLATE_NOOP("BudgetWords", "Flat ±5 % to")},
    {"within_10_percent_hz", QT_TRANSLATE_NOOP("BudgetWords", "Flat ±10 % to")},
    {"minus_3_db_hz", QT_TRANSLATE_NOOP("BudgetWords", "−3 dB at")},
    {"rise_time_s", QT_TRANSLATE_NOOP("BudgetWords", "Rise time 10–90 %")},
    {"overshoot_percent", QT_TRANSLATE_NOOP("BudgetWords", "Overshoot")},
    {"settling_time_s", QT_TRANSLATE_NOOP("BudgetWords", "Settling time ±5 %")},
}};

QString modelValueName(const std::string &of)
{
    for (const auto &[key, name] : kModelValues)
        if (of == key)
            return BudgetWords::tr(name);
    return shownText(of);
}

/// A line of the value's own unit may still be relative: that of the front over frequency.
bool isInOwnUnit(const UncertaintyLine &line, CountedIn in)
{
    return in == CountedIn::Own && line.sensitivity == 1.0;
}

} // namespace

QString quantityName(const Budget &budget)
{
    switch (budget.kind) {
    case BudgetOf::Sensitivity:
        return BudgetWords::tr("Sensitivity");
    case BudgetOf::Level:
        return BudgetWords::tr("Sensitivity, level %1").arg(levelText(budget.level));
    case BudgetOf::Magnitude:
        return BudgetWords::tr("Magnitude of S(f)");
    case BudgetOf::Phase:
        return BudgetWords::tr("Phase of S(f)");
    case BudgetOf::Model:
        break;
    }
    return modelValueName(budget.reported.of);
}

QString budgetName(const Budget &budget)
{
    if (!budget.isOverFrequency())
        return quantityName(budget);
    return BudgetWords::tr("%1 at %2")
        .arg(quantityName(budget), shownQuantity(budget.frequency_Hz, QStringLiteral("Hz"), 4));
}

QString lineName(const UncertaintyLine &line)
{
    const QString name = inputWords(line.quantity).name;
    return line.shot > 0 ? BudgetWords::tr("%1, shot %2").arg(name).arg(line.shot) : name;
}

ShownUnit unitOfU(const UncertaintyLine &line, const ReportedValue &reported)
{
    constexpr double kPercent = 0.01;
    const QString percent = QStringLiteral("%");
    const InputWords words = inputWords(line.quantity);
    if (words.in == CountedIn::Unit) {
        const PrefixedUnit prefixed = prefixedUnit(line.u, words.unit);
        return {prefixed.unit.trimmed(), prefixed.factor};
    }
    if (!isInOwnUnit(line, words.in))
        return {percent, kPercent};
    const bool isPhase = reported.unit == "\xC2\xB0";
    if (isPhase || !(std::abs(reported.value) > 0.0))
        return {shownText(reported.unit), 1.0};
    return {percent, kPercent * std::abs(reported.value)};
}

QString uText(double u, const UncertaintyLine &line, const ReportedValue &reported)
{
    const InputWords words = inputWords(line.quantity);
    if (words.in == CountedIn::Unit && std::isfinite(line.value))
        return shownResult(line.value, u, words.unit).u;
    const ShownUnit unit = unitOfU(line, reported);
    return (shownFigures(u / unit.si, 2) + QLatin1Char(' ') + unit.text).trimmed();
}

QString relativeText(double U, const Budget &budget)
{
    const double value = std::abs(budget.reported.value);
    if (budget.kind == BudgetOf::Phase || !(value > 0.0))
        return shownQuantity(U, shownText(budget.reported.unit), 2);
    return shownFigures(100.0 * U / value, 2) + QStringLiteral(" %");
}

QString factorText(const ReportedValue &reported)
{
    return shownNumber(reported.factor(), 3);
}

} // namespace dyncal
