// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/uncertainty_words.h"

#include "core/shock/step_inputs.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct UncertaintyWords
{
    Q_DECLARE_TR_FUNCTIONS(ShockBudget)
};

struct InputRow
{
    const char *key; ///< as in the budget, without the place in brackets
    const char *name; ///< %1 = the place
    const char *unit;
    CountedIn in = CountedIn::Unit;
};

using enum CountedIn;
constexpr std::array<InputRow, 38> kInputRows{{
    {"distance_m", QT_TRANSLATE_NOOP("ShockBudget", "Distance, %1"), "m"},
    {"arrival_s", QT_TRANSLATE_NOOP("ShockBudget", "Arrival, %1"), "s"},
    {"delay_s", QT_TRANSLATE_NOOP("ShockBudget", "Delay, %1"), "s"},
    {"time_s", QT_TRANSLATE_NOOP("ShockBudget", "Time, %1"), "s"},
    {"velocity_m_s", QT_TRANSLATE_NOOP("ShockBudget", "Velocity"), "m/s"},
    {kAttenuation, QT_TRANSLATE_NOOP("ShockBudget", "Attenuation along the tube"), "1/m"},
    {"velocity_scatter", QT_TRANSLATE_NOOP("ShockBudget", "Scatter of the velocity"), "m/s"},
    {"p1_pa", QT_TRANSLATE_NOOP("ShockBudget", "p1"), "Pa"},
    {"t1_k", QT_TRANSLATE_NOOP("ShockBudget", "T1"), "K"},
    {"relative_humidity", QT_TRANSLATE_NOOP("ShockBudget", "Relative humidity"), ""},
    {"carbon_dioxide_fraction", QT_TRANSLATE_NOOP("ShockBudget", "CO₂"), ""},
    {"gamma", QT_TRANSLATE_NOOP("ShockBudget", "γ"), ""},
    {"molar_mass_kg_mol", QT_TRANSLATE_NOOP("ShockBudget", "Molar mass in kg/mol"), ""},
    {"step_relative", QT_TRANSLATE_NOOP("ShockBudget", "Typed pressure step"), "", Value},
    {"level_relative", QT_TRANSLATE_NOOP("ShockBudget", "Noise of the level"), "", Value},
    {"scatter_of_shots", QT_TRANSLATE_NOOP("ShockBudget", "Scatter of the shots"), "", Value},
    {"gain_relative", QT_TRANSLATE_NOOP("ShockBudget", "Gain of the chain"), "", Value},
    {"linearity_relative", QT_TRANSLATE_NOOP("ShockBudget", "Linearity of the chain"), "", Value},
    {"mounting_relative", QT_TRANSLATE_NOOP("ShockBudget", "Mounting of the sensor"), "", Value},
    {"clock_relative", QT_TRANSLATE_NOOP("ShockBudget", "Sample clock"), "", Value},
    {"noise", QT_TRANSLATE_NOOP("ShockBudget", "Noise of the recordings"), "", Own},
    {"end_of_record", QT_TRANSLATE_NOOP("ShockBudget", "End of the recordings"), "", Own},
    {"aliasing", QT_TRANSLATE_NOOP("ShockBudget", "Sampling"), "", Own},
    {"drift", QT_TRANSLATE_NOOP("ShockBudget", "Drift that was divided out"), "", Own},
    {"front_duration_s", QT_TRANSLATE_NOOP("ShockBudget", "Duration of the front"), "", Own},
    {"weak_mode", QT_TRANSLATE_NOOP("ShockBudget", "Weak oscillation, perhaps the mount's"), "",
        Own},
    {"front_unknown", QT_TRANSLATE_NOOP("ShockBudget", "Front of unknown duration"), "", Own},
    {"onset_s", QT_TRANSLATE_NOOP("ShockBudget", "Onset of the step"), "", Own},
    {"reference_sensitivity", QT_TRANSLATE_NOOP("ShockBudget", "Certificate of the reference"), "",
        Own},
    {"reference_phase", QT_TRANSLATE_NOOP("ShockBudget", "Certificate of the reference"), "", Own},
    {"reference_sensitivity_relative",
        QT_TRANSLATE_NOOP("ShockBudget", "Certificate of the reference"), "", Value},
    {"reference_gain_relative", QT_TRANSLATE_NOOP("ShockBudget", "Gain of the reference's chain"),
        "", Value},
    {"reference_level_relative", QT_TRANSLATE_NOOP("ShockBudget", "Noise of the reference's level"),
        "", Value},
    {"chain", QT_TRANSLATE_NOOP("ShockBudget", "Response of the chain"), "", Own},
    {"chain_phase", QT_TRANSLATE_NOOP("ShockBudget", "Response of the chain"), "", Own},
    {"chain_relative", QT_TRANSLATE_NOOP("ShockBudget", "Response of the chain"), "", Value},
    {"cmc", QT_TRANSLATE_NOOP("ShockBudget", "Least uncertainty of the laboratory (CMC)"), "", Own},
    {"delay_of_reference", QT_TRANSLATE_NOOP("ShockBudget", "Delay of the reference"), "", Own},
}};

} // namespace

InputWords inputWords(const std::string &quantity)
{
    const auto bracket = quantity.find('[');
    const std::string key = quantity.substr(0, bracket);
    for (const InputRow &row : kInputRows) {
        if (key != row.key)
            continue;
        QString name = UncertaintyWords::tr(row.name);
        if (bracket != std::string::npos)
            name = name.arg(shownText(quantity.substr(bracket + 1, quantity.size() - bracket - 2)));
        else if (name.contains(QLatin1String("%1")))
            name = name.arg(UncertaintyWords::tr("all places"));
        return {name, row.unit, row.in};
    }
    return {shownText(quantity), {}};
}

QString distributionText(Distribution distribution)
{
    switch (distribution) {
    case Distribution::Normal:
        return UncertaintyWords::tr("normal");
    case Distribution::Rectangular:
        return UncertaintyWords::tr("rectangular");
    case Distribution::Triangular:
        return UncertaintyWords::tr("triangular");
    case Distribution::UShaped:
        return UncertaintyWords::tr("u-shaped");
    }
    return {};
}

QString dofText(double dof)
{
    return std::isfinite(dof) ? shownNumber(dof, 3) : QStringLiteral("∞");
}

} // namespace dyncal
