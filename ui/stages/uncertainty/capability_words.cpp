// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/capability_words.h"

#include "ui/stages/uncertainty/budget_words.h"
#include "ui/text/quantity_format.h"

#include <QCoreApplication>

#include <array>
#include <numbers>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct CapabilityWords
{
    Q_DECLARE_TR_FUNCTIONS(CapabilityWords)
};

const std::string kPhase = "phase_rad";
constexpr int kCapabilityDigits = 4;

bool isPerPressure(const std::string &of)
{
    return of == "sensitivity" || of == "magnitude";
}

/// The key of a model's value ends with its unit.
ShownUnit unitOfModelValue(const std::string &of)
{
    if (of.ends_with("_hz"))
        return {QStringLiteral("kHz"), 1e3};
    if (of.ends_with("_s"))
        return {QStringLiteral("µs"), 1e-6};
    return {of.ends_with("_percent") ? QStringLiteral("%") : QString(), 1.0};
}

QString bandText(const CapabilityEntry &entry)
{
    const QString from = shownQuantity(entry.from_Hz, QStringLiteral("Hz"), kCapabilityDigits);
    if (entry.to_Hz)
        return CapabilityWords::tr(", from %1 to %2")
            .arg(from, shownQuantity(*entry.to_Hz, QStringLiteral("Hz"), kCapabilityDigits));
    return entry.from_Hz > 0.0 ? CapabilityWords::tr(", from %1").arg(from) : QString();
}

} // namespace

bool isOverFrequency(const CapabilityEntry &entry)
{
    return entry.of == "magnitude" || entry.of == kPhase;
}

ShownUnit capabilityUnit(const CapabilityEntry &entry, const QString &unitOfSensitivity)
{
    if (entry.of == kPhase)
        return {QStringLiteral("°"), std::numbers::pi / 180.0};
    if (entry.isRelative)
        return {QStringLiteral("%"), 0.01};
    return isPerPressure(entry.of) ? ShownUnit{unitOfSensitivity, 1.0} : unitOfModelValue(entry.of);
}

QString capabilityName(const std::string &of)
{
    Budget budget;
    budget.kind = of == "sensitivity" ? BudgetOf::Sensitivity
        : of == "magnitude"           ? BudgetOf::Magnitude
        : of == kPhase                ? BudgetOf::Phase
                                      : BudgetOf::Model;
    budget.reported.of = of;
    return quantityName(budget);
}

QString capabilityText(const CapabilityEntry &entry, const QString &unitOfSensitivity)
{
    const ShownUnit unit = capabilityUnit(entry, unitOfSensitivity);
    const QString U = shownNumber(entry.expanded / unit.si, kCapabilityDigits);
    return CapabilityWords::tr("%1: U ≥ %2%3")
        .arg(capabilityName(entry.of), unit.text.isEmpty() ? U : U + QLatin1Char(' ') + unit.text,
            bandText(entry));
}

} // namespace dyncal
