// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/model/model_text.h"

#include "ui/text/quantity_column.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <string_view>
#include <utility>

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

/// The flags of results.json in words; one that has none here as it is.
QString flagText(const std::string &flag)
{
    static constexpr std::pair<std::string_view, const char *> kWords[]{
        {"step", QT_TRANSLATE_NOOP("ModelText", "the step itself")},
        {"nyquist", QT_TRANSLATE_NOOP("ModelText", "from sampling")},
        {"unstable", QT_TRANSLATE_NOOP("ModelText", "grows")},
        {kBelowNoiseFlag, QT_TRANSLATE_NOOP("ModelText", "below the noise")},
        {kShotsDisagreeFlag, QT_TRANSLATE_NOOP("ModelText", "differs between the shots")},
        {kTubeModeFlag, QT_TRANSLATE_NOOP("ModelText", "tube mode?")},
        {"near-cancelled", QT_TRANSLATE_NOOP("ModelText", "nearly cancelled by a zero")},
        {"integrator", QT_TRANSLATE_NOOP("ModelText", "as slow as a drift")},
    };
    const auto found
        = std::ranges::find(kWords, flag, &std::pair<std::string_view, const char *>::first);
    return found == std::end(kWords) ? rawText(flag) : ModelText::tr(found->second);
}

QString flagTexts(const Pole &pole)
{
    QStringList flags;
    for (const std::string &flag : pole.flags)
        flags << flagText(flag);
    return flags.join(", ");
}

QString kindText(const Pole &pole)
{
    return classText(pole.poleClass) + (pole.z.imag() > 0.0 ? ModelText::tr(" (pair)") : QString());
}

/// Attainable FIT below which FIT and its limit are both mostly noise.
constexpr double kNoiseLimit_percent = 10.0;

} // namespace

QString fitText(const SensorModel &model)
{
    if (model.diverges)
        return ModelText::tr("diverges");
    const QString attainable = shownNumber(model.fitAttainable_percent, 3);
    if (model.fit_percent < 0.0)
        return ModelText::tr("< 0 % of attainable %1 %").arg(attainable);
    // A low FIT tells nothing against the model where the noise allows no more.
    return (model.fitAttainable_percent < kNoiseLimit_percent
            ? ModelText::tr("%1 % of attainable %2 %: at the noise limit")
            : ModelText::tr("%1 % of attainable %2 %"))
        .arg(shownNumber(model.fit_percent, 3), attainable);
}

QString noiseText(const SensorModel &model)
{
    QString text = rawText(model.uncertaintyMethod);
    const bool isOfResidual = text.endsWith(QStringLiteral(" of the residual"));
    text = text.section(' ', 0, 0);
    if (text == QStringLiteral("white"))
        text = ModelText::tr("white");
    return isOfResidual ? ModelText::tr("%1, of the residual").arg(text) : text;
}

QStringList poleHeaders()
{
    return {ModelText::tr("Frequency"), ModelText::tr("u(f)"), ModelText::tr("k"),
        ModelText::tr("Damping ratio"), ModelText::tr("u(ζ)"), ModelText::tr("k"),
        ModelText::tr("Amplitude"), ModelText::tr("u(amplitude)"), ModelText::tr("Class"),
        ModelText::tr("Flags")};
}

QVector<QStringList> poleRows(
    const std::vector<Pole> &poles, const std::vector<PoleUncertainty> &stated)
{
    std::vector<Estimate> frequencies;
    std::vector<Estimate> dampings;
    std::vector<Estimate> amplitudes;
    frequencies.reserve(poles.size());
    dampings.reserve(poles.size());
    amplitudes.reserve(poles.size());
    for (std::size_t i = 0; i < poles.size(); ++i) {
        frequencies.push_back({poles[i].frequency_Hz, stated[i].u_frequency_Hz});
        dampings.push_back({poles[i].dampingRatio, stated[i].u_dampingRatio});
        amplitudes.push_back({poles[i].amplitude, stated[i].u_amplitude});
    }
    const std::vector<ShownResult> shownFrequencies = shownColumn(frequencies, "Hz");
    const std::vector<ShownResult> shownDampings = shownColumn(dampings, {});
    const std::vector<ShownResult> shownAmplitudes = shownColumn(amplitudes, {});
    QVector<QStringList> rows;
    for (std::size_t i = 0; i < poles.size(); ++i) {
        const Pole &pole = poles[i];
        if (pole.z.imag() < 0.0)
            continue; // shown with its conjugate
        rows.push_back(
            {shownFrequencies[i].value, shownFrequencies[i].u, shownNumber(stated[i].kFrequency, 3),
                shownDampings[i].value, shownDampings[i].u, shownNumber(stated[i].kDamping, 3),
                shownAmplitudes[i].value, shownAmplitudes[i].u, kindText(pole), flagTexts(pole)});
    }
    return rows;
}

} // namespace dyncal
