// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/nuisance_table.h"

#include "ui/text/quantity_format.h"

#include <cmath>

namespace dyncal {

namespace {

QStringList sideRow(const QString &name, const NuisanceEffect::Side &side)
{
    return {name, shownQuantity(side.f0_Hz, "Hz", 7), shownNumber(side.zeta, 4),
        shownNumber(100.0 * side.plateauGain, 5) + " %",
        shownNumber(100.0 * side.residualRms, 3) + " %", shownNumber(side.fit_percent, 4) + " %"};
}

QStringList modeRow(const NuisanceMode &mode, const NuisanceOfShot &shot)
{
    const QString name
        = mode.label.empty() ? NuisanceTable::tr("mode") : QString::fromStdString(mode.label);
    return {NuisanceTable::tr("%1, shot %2").arg(name).arg(shot.shot),
        shownQuantity(shot.term.frequency_Hz(), "Hz", 5), shownNumber(shot.term.dampingRatio(), 3),
        shownNumber(100.0 * shot.relativeAmplitude, 3) + " %", {}, {}};
}

} // namespace

NuisanceTable::NuisanceTable(QWidget *parent)
    : ValueTable("nuisanceTable", tr("Oscillations left out of the model"), parent)
{
    hide();
}

void NuisanceTable::showModel(const SensorModel *model)
{
    QVector<QStringList> rows;
    if (model && model->nuisanceEffect) {
        rows << sideRow(tr("Sensor, oscillations left in"), model->nuisanceEffect->before)
             << sideRow(tr("Sensor, oscillations left out"), model->nuisanceEffect->after);
    }
    if (model)
        for (const NuisanceResult &mode : model->nuisance)
            for (const NuisanceOfShot &shot : mode.perShot)
                rows << modeRow(mode.mode, shot);
    setValues({tr("What"), tr("Frequency"), tr("Damping ratio"), tr("Plateau, or size"),
                  tr("Residual"), tr("FIT")},
        rows);
    setVisible(!rows.isEmpty());
}

} // namespace dyncal
