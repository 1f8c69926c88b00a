// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/model/model_tables.h"

#include "ui/stages/candidates/candidate_text.h"
#include "ui/text/level_text.h"
#include "ui/text/quantity_column.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <cmath>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct ModelTables
{
    Q_DECLARE_TR_FUNCTIONS(ModelTables)
};

QString shotText(Index shot)
{
    return shot > 0 ? ModelTables::tr("Shot %1").arg(shot) : ModelTables::tr("Average");
}

/// A column of the fits, value ± u.
QStringList trendColumn(const std::vector<const LevelPole *> &poles, double LevelPole::*value,
    double LevelPole::*u, const QString &unit)
{
    std::vector<Estimate> column;
    column.reserve(poles.size());
    for (const LevelPole *pole : poles)
        column.push_back({pole->*value, pole->*u});
    return shownColumnWithU(column, unit);
}

QString levelName(const LevelPole &pole)
{
    QStringList shots;
    for (const Index shot : pole.shots)
        shots << QString::number(shot);
    return ModelTables::tr("%1 (shots %2)").arg(levelText(pole.level), shots.join(", "));
}

} // namespace

ShownTable trendTable(const ModelAssessment *assessment)
{
    ShownTable table{
        {ModelTables::tr("Fitted to"), ModelTables::tr("f₀ ± u"), ModelTables::tr("ζ ± u"),
            ModelTables::tr("Plateau ± u"), ModelTables::tr("k")},
        {}};
    if (!assessment)
        return table;
    std::vector<const LevelPole *> poles;
    QStringList names;
    poles.reserve(assessment->perShot.size() + assessment->perLevel.size());
    for (const LevelPole &pole : assessment->perShot) {
        poles.push_back(&pole);
        names << shotText(pole.shots.empty() ? 0 : pole.shots.front());
    }
    for (const LevelPole &pole : assessment->perLevel) {
        poles.push_back(&pole);
        names << levelName(pole);
    }
    const QStringList frequencies
        = trendColumn(poles, &LevelPole::frequency_Hz, &LevelPole::u_frequency_Hz, "Hz");
    const QStringList dampings
        = trendColumn(poles, &LevelPole::dampingRatio, &LevelPole::u_dampingRatio, {});
    const QStringList plateaus
        = trendColumn(poles, &LevelPole::plateauGain, &LevelPole::u_plateauGain, {});
    for (qsizetype i = 0; i < names.size(); ++i)
        table.rows.push_back({names[i], frequencies[i], dampings[i], plateaus[i],
            shownNumber(poles[static_cast<std::size_t>(i)]->coverageFactor, 3)});
    return table;
}

ShownTable nuisanceTable(const SensorModel *model, const ModelAssessment *assessment)
{
    ShownTable table{{ModelTables::tr("Mode"), ModelTables::tr("Shot"), ModelTables::tr("f ± u"),
                         ModelTables::tr("ζ ± u"), ModelTables::tr("Amplitude")},
        {}};
    if (!model)
        return table;
    for (const NuisanceResult &mode : model->nuisance)
        for (const NuisanceOfShot &shot : mode.perShot)
            table.rows.push_back({shownText(mode.mode.label), shotText(shot.shot),
                shownWithU(shot.term.frequency_Hz(), shot.u_frequency_Hz, "Hz"),
                shownWithU(shot.term.dampingRatio(), shot.u_dampingRatio, {}),
                shownNumber(100.0 * shot.relativeAmplitude, 3) + QStringLiteral(" %")});
    if (assessment && assessment->nuisanceEffect) {
        const auto side = [&](const QString &name, const NuisanceEffect::Side &at) {
            table.rows.push_back(
                {name, ModelTables::tr("FIT %1 %").arg(shownNumber(at.fit_percent, 4)),
                    shownWithU(at.f0_Hz, at.u_f0_Hz, "Hz"), shownWithU(at.zeta, at.u_zeta, {}),
                    ModelTables::tr("plateau %1").arg(shownNumber(at.plateauGain, 5))});
        };
        side(ModelTables::tr("Sensor, modes left in"), assessment->nuisanceEffect->before);
        side(ModelTables::tr("Sensor, modes taken out"), assessment->nuisanceEffect->after);
    }
    return table;
}

ShownTable secondOrderTable(const ModelAssessment *assessment)
{
    const bool isModel = assessment && assessment->secondOrder && assessment->secondOrder->isModel;
    ShownTable table{
        {isModel ? ModelTables::tr("2nd order (the model)") : ModelTables::tr("2nd order"),
            ModelTables::tr("Value ± u")},
        {}};
    if (!assessment || !assessment->secondOrder)
        return table;
    const SecondOrderModel &fit = *assessment->secondOrder;
    table.rows = {{ModelTables::tr("f₀"), shownWithU(fit.f0_Hz, fit.u_f0_Hz, "Hz")},
        {ModelTables::tr("ζ"), shownWithU(fit.zeta, fit.u_zeta, {})},
        {ModelTables::tr("FIT"), shownNumber(fit.fit_percent, 4) + QStringLiteral(" %")}};
    for (const SecondOrderShot &shot : fit.shots)
        table.rows.push_back({ModelTables::tr("Plateau, %1").arg(shotText(shot.shot)),
            shownWithU(shot.plateauGain, shot.u_plateauGain, {})});
    return table;
}

QString homogeneityText(const ModelAssessment &assessment)
{
    if (!assessment.homogeneity)
        return {};
    const QString p = probabilityShown(assessment.homogeneity->probability);
    return assessment.homogeneity->passed
        ? ModelTables::tr("The shots share their poles (p %1).").arg(p)
        : ModelTables::tr(
            "The shots do not share the pole at %1 (p %2); the uncertainty is their scatter.")
              .arg(shownQuantity(assessment.homogeneity->frequency_Hz, "Hz", 4), p);
}

} // namespace dyncal
