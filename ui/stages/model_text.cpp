// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/model_text.h"

#include "ui/text/quantity_format.h"

#include <QCoreApplication>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct ModelText
{
    Q_DECLARE_TR_FUNCTIONS(ModelText)
};

QString classText(PoleClass poleClass)
{
    switch (poleClass) {
    case PoleClass::Sensor:
        return ModelText::tr("sensor");
    case PoleClass::Step:
        return ModelText::tr("step");
    case PoleClass::Nyquist:
        return ModelText::tr("Nyquist");
    case PoleClass::Unstable:
        return ModelText::tr("unstable");
    case PoleClass::Other:
        break;
    }
    return ModelText::tr("other");
}

} // namespace

QString fitText(const SensorModel &model)
{
    if (model.diverges)
        return ModelText::tr("diverges");
    const QString attainable = shownNumber(model.fitAttainable_percent, 3);
    if (model.fit_percent < 0.0)
        return ModelText::tr("< 0 % of attainable %1 %").arg(attainable);
    return ModelText::tr("%1 % of attainable %2 %")
        .arg(shownNumber(model.fit_percent, 3), attainable);
}

QStringList poleHeaders(PoleColumns columns)
{
    if (columns == PoleColumns::Few)
        return {ModelText::tr("Frequency"), ModelText::tr("Damping"), ModelText::tr("Class")};
    return {ModelText::tr("Frequency"), ModelText::tr("u(f)"), ModelText::tr("Damping ratio"),
        ModelText::tr("u(ζ)"), ModelText::tr("k"), ModelText::tr("Amplitude"),
        ModelText::tr("Class"), ModelText::tr("Flags")};
}

QVector<QStringList> poleRows(const SensorModel *model, PoleColumns columns)
{
    QVector<QStringList> rows;
    if (!model)
        return rows;
    for (const Pole &pole : model->poles) {
        if (pole.z.imag() < 0.0)
            continue; // shown with its conjugate
        QStringList flags;
        for (const std::string &flag : pole.flags)
            flags << QString::fromStdString(flag);
        const QString kind = classText(pole.poleClass)
            + (pole.z.imag() > 0.0 ? ModelText::tr(" (pair)") : QString());
        const QString frequency = shownQuantity(pole.frequency_Hz, "Hz", 5);
        const QString damping = shownNumber(pole.dampingRatio, 4);
        if (columns == PoleColumns::Few)
            rows.push_back({frequency, damping, kind});
        else
            rows.push_back({frequency, shownQuantity(pole.u_frequency_Hz, "Hz", 2), damping,
                shownNumber(pole.u_dampingRatio, 2), shownNumber(pole.coverageFactor, 3),
                shownNumber(pole.amplitude, 3), kind, flags.join(", ")});
    }
    return rows;
}

} // namespace dyncal
