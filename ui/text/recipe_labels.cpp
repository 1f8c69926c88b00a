// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/recipe_labels.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>

namespace dyncal {

namespace {

struct RecipeLabel
{
    const char *key;
    const char *label;
};

/// Every key of docs/recipe.md.
constexpr RecipeLabel kRecipeLabels[] = {
    {"schema", QT_TRANSLATE_NOOP("RecipeLabel", "kind of file")},
    {"import", QT_TRANSLATE_NOOP("RecipeLabel", "import settings")},
    {"import.format", QT_TRANSLATE_NOOP("RecipeLabel", "file format")},
    {"import.columns", QT_TRANSLATE_NOOP("RecipeLabel", "columns of the text file")},
    {"import.columns.time", QT_TRANSLATE_NOOP("RecipeLabel", "column of the times")},
    {"import.columns.dut", QT_TRANSLATE_NOOP("RecipeLabel", "column of the DUT")},
    {"import.columns.driven_side",
        QT_TRANSLATE_NOOP("RecipeLabel", "column of the driven-side sensor")},
    {"import.columns.driver", QT_TRANSLATE_NOOP("RecipeLabel", "column of the driver pressure")},
    {"import.columns.trigger", QT_TRANSLATE_NOOP("RecipeLabel", "column of the trigger")},
    {"import.columns.other", QT_TRANSLATE_NOOP("RecipeLabel", "column of another channel")},
    {"import.channels", QT_TRANSLATE_NOOP("RecipeLabel", "channel roles")},
    {"import.channels{}.role", QT_TRANSLATE_NOOP("RecipeLabel", "role of the channel")},
    {"import.channels{}.unit", QT_TRANSLATE_NOOP("RecipeLabel", "unit of the channel")},
    {"import.channels{}.scale", QT_TRANSLATE_NOOP("RecipeLabel", "factor on the channel")},
    {"import.channels{}.gain", QT_TRANSLATE_NOOP("RecipeLabel", "gain of the channel")},
    {"import.channels{}.sensitivity",
        QT_TRANSLATE_NOOP("RecipeLabel", "sensitivity of the channel")},
    {"import.channels{}.polarity",
        QT_TRANSLATE_NOOP("RecipeLabel", "inverted polarity of the channel")},
    {"import.channels{}.reference",
        QT_TRANSLATE_NOOP("RecipeLabel", "gauge or absolute pressure of the channel")},
    {"import.decimal", QT_TRANSLATE_NOOP("RecipeLabel", "decimal mark")},
    {"import.separator", QT_TRANSLATE_NOOP("RecipeLabel", "separator")},
    {"import.sample_rate_hz", QT_TRANSLATE_NOOP("RecipeLabel", "sample rate")},
    {"import.sample_rate_reason",
        QT_TRANSLATE_NOOP("RecipeLabel", "why the rate in the file is wrong")},
    {"import.unit", QT_TRANSLATE_NOOP("RecipeLabel", "unit of the DUT")},
    {"import.scale", QT_TRANSLATE_NOOP("RecipeLabel", "factor on the DUT")},
    {"import.polarity", QT_TRANSLATE_NOOP("RecipeLabel", "inverted polarity")},
    {"import.reference", QT_TRANSLATE_NOOP("RecipeLabel", "gauge or absolute pressure")},
    {"import.skip_rows", QT_TRANSLATE_NOOP("RecipeLabel", "rows before the data")},
    {"import.interpolate_invalid", QT_TRANSLATE_NOOP("RecipeLabel", "longest gap to be filled")},
    {"import.max_expansion", QT_TRANSLATE_NOOP("RecipeLabel", "memory that a file may take")},
    {"import.channel_files", QT_TRANSLATE_NOOP("RecipeLabel", "files joined as channels")},
    {"import.levels", QT_TRANSLATE_NOOP("RecipeLabel", "levels of the shots")},
    {"import.exclude", QT_TRANSLATE_NOOP("RecipeLabel", "excluded shots")},
    {"import.exclude[].shot", QT_TRANSLATE_NOOP("RecipeLabel", "excluded shot")},
    {"import.exclude[].reason", QT_TRANSLATE_NOOP("RecipeLabel", "reason for the exclusion")},
    {"import.files", QT_TRANSLATE_NOOP("RecipeLabel", "import settings of single files")},
    {"checks", QT_TRANSLATE_NOOP("RecipeLabel", "limits of findings")},
    {"checks.saturation_run",
        QT_TRANSLATE_NOOP("RecipeLabel", "equal samples that count as saturation")},
    {"checks.flat_codes",
        QT_TRANSLATE_NOOP("RecipeLabel", "scatter below which a channel is flat")},
    {"checks.min_codes", QT_TRANSLATE_NOOP("RecipeLabel", "codes that a step should use")},
    {"checks.step_sigma", QT_TRANSLATE_NOOP("RecipeLabel", "noise by which a step must stand out")},
    {"checks.rate_mismatch_percent",
        QT_TRANSLATE_NOOP("RecipeLabel", "difference allowed between two sample rates")},
    {"checks.reading_factor",
        QT_TRANSLATE_NOOP("RecipeLabel", "factor allowed between read and computed step")},
    {"shock", QT_TRANSLATE_NOOP("RecipeLabel", "reference step")},
    {"shock.enabled", QT_TRANSLATE_NOOP("RecipeLabel", "compute the step from the shock")},
    {"shock.p1_pa", QT_TRANSLATE_NOOP("RecipeLabel", "p1, absolute")},
    {"shock.t1_k", QT_TRANSLATE_NOOP("RecipeLabel", "T1")},
    {"shock.t4_k", QT_TRANSLATE_NOOP("RecipeLabel", "T4 (driver)")},
    {"shock.driven_gas", QT_TRANSLATE_NOOP("RecipeLabel", "driven gas")},
    {"shock.driven_gas.gamma", QT_TRANSLATE_NOOP("RecipeLabel", "γ of the driven gas")},
    {"shock.driven_gas.molar_mass_kg_mol",
        QT_TRANSLATE_NOOP("RecipeLabel", "molar mass of the driven gas")},
    {"shock.driven_gas.substance", QT_TRANSLATE_NOOP("RecipeLabel", "substance of the driven gas")},
    {"shock.driven_gas.heat_capacity",
        QT_TRANSLATE_NOOP("RecipeLabel", "heat capacity of the driven gas")},
    {"shock.driver_gas", QT_TRANSLATE_NOOP("RecipeLabel", "driver gas")},
    {"shock.driver_gas.gamma", QT_TRANSLATE_NOOP("RecipeLabel", "γ of the driver gas")},
    {"shock.driver_gas.molar_mass_kg_mol",
        QT_TRANSLATE_NOOP("RecipeLabel", "molar mass of the driver gas")},
    {"shock.driver_gas.substance", QT_TRANSLATE_NOOP("RecipeLabel", "substance of the driver gas")},
    {"shock.driver_gas.heat_capacity",
        QT_TRANSLATE_NOOP("RecipeLabel", "heat capacity of the driver gas")},
    {"shock.relative_humidity", QT_TRANSLATE_NOOP("RecipeLabel", "relative humidity")},
    {"shock.velocity_m_s", QT_TRANSLATE_NOOP("RecipeLabel", "velocity of the shock")},
    {"shock.step_pa", QT_TRANSLATE_NOOP("RecipeLabel", "pressure step")},
    {"shock.arrival_sensors", QT_TRANSLATE_NOOP("RecipeLabel", "arrival sensors")},
    {"shock.arrival_sensors[].channel",
        QT_TRANSLATE_NOOP("RecipeLabel", "channel of the arrival sensor")},
    {"shock.arrival_sensors[].distance_to_end_wall_m",
        QT_TRANSLATE_NOOP("RecipeLabel", "distance to end wall")},
    {"shock.arrival_sensors[].u_distance_m", QT_TRANSLATE_NOOP("RecipeLabel", "u (distance)")},
    {"shock.arrival_sensors[].arrival_s", QT_TRANSLATE_NOOP("RecipeLabel", "arrival")},
    {"shock.arrival_sensors[].u_arrival_s", QT_TRANSLATE_NOOP("RecipeLabel", "u (arrival)")},
    {"shock.arrival_sensors[].delay_s", QT_TRANSLATE_NOOP("RecipeLabel", "delay of the sensor")},
    {"shock.arrival_sensors[].u_delay_s", QT_TRANSLATE_NOOP("RecipeLabel", "u (delay)")},
    {"shock.driver_length_m", QT_TRANSLATE_NOOP("RecipeLabel", "driver section")},
    {"shock.driven_length_m", QT_TRANSLATE_NOOP("RecipeLabel", "driven section")},
    {"shock.inner_diameter_m", QT_TRANSLATE_NOOP("RecipeLabel", "inner diameter")},
    {"shock.dut_position", QT_TRANSLATE_NOOP("RecipeLabel", "place of the DUT")},
    {"shock.front_duration_s", QT_TRANSLATE_NOOP("RecipeLabel", "duration of the front")},
    {"shock.u_front_duration_s", QT_TRANSLATE_NOOP("RecipeLabel", "u (duration of the front)")},
    {"shock.state_from", QT_TRANSLATE_NOOP("RecipeLabel", "what the state follows from")},
    {"shock.p2_pa", QT_TRANSLATE_NOOP("RecipeLabel", "p2, absolute")},
    {"shock.p4_pa", QT_TRANSLATE_NOOP("RecipeLabel", "driver pressure, absolute")},
    {"shock.carbon_dioxide_fraction", QT_TRANSLATE_NOOP("RecipeLabel", "CO₂")},
    {"shock.counters", QT_TRANSLATE_NOOP("RecipeLabel", "counters")},
    {"shock.counters[].far_m", QT_TRANSLATE_NOOP("RecipeLabel", "far place of the counter")},
    {"shock.counters[].near_m", QT_TRANSLATE_NOOP("RecipeLabel", "near place of the counter")},
    {"shock.counters[].time_s", QT_TRANSLATE_NOOP("RecipeLabel", "time of the counter")},
    {"shock.counters[].u_distance_m",
        QT_TRANSLATE_NOOP("RecipeLabel", "u (length of the counter)")},
    {"shock.counters[].u_time_s", QT_TRANSLATE_NOOP("RecipeLabel", "u (time of the counter)")},
    {"shock.attenuation",
        QT_TRANSLATE_NOOP("RecipeLabel", "change of the velocity along the tube")},
    {"shock.use_dut_arrival", QT_TRANSLATE_NOOP("RecipeLabel", "use the arrival at the DUT")},
    {"shock.dut_distance_to_end_wall_m",
        QT_TRANSLATE_NOOP("RecipeLabel", "distance of the DUT to the end wall")},
    {"shock.dut_diameter_m", QT_TRANSLATE_NOOP("RecipeLabel", "diameter of the DUT")},
    {"shock.tube_length_m", QT_TRANSLATE_NOOP("RecipeLabel", "length of the tube")},
    {"shock.wall_sound_speed_m_s", QT_TRANSLATE_NOOP("RecipeLabel", "sound speed of the wall")},
    {"shock.plateau_guard_s", QT_TRANSLATE_NOOP("RecipeLabel", "guard before the plateau's end")},
    {"window", QT_TRANSLATE_NOOP("RecipeLabel", "window")},
    {"window.start", QT_TRANSLATE_NOOP("RecipeLabel", "start")},
    {"window.baseline_s", QT_TRANSLATE_NOOP("RecipeLabel", "baseline")},
    {"window.end_s", QT_TRANSLATE_NOOP("RecipeLabel", "end of the window")},
    {"window.settle_s", QT_TRANSLATE_NOOP("RecipeLabel", "settle band")},
    {"window.exclude_stretches", QT_TRANSLATE_NOOP("RecipeLabel", "stretches left out of the fit")},
    {"window.exclude_stretches[].shot", QT_TRANSLATE_NOOP("RecipeLabel", "shot of the stretch")},
    {"window.exclude_stretches[].from_s", QT_TRANSLATE_NOOP("RecipeLabel", "begin of the stretch")},
    {"window.exclude_stretches[].to_s", QT_TRANSLATE_NOOP("RecipeLabel", "end of the stretch")},
    {"window.exclude_stretches[].reason",
        QT_TRANSLATE_NOOP("RecipeLabel", "reason for leaving the stretch out")},
    {"remap", QT_TRANSLATE_NOOP("RecipeLabel", "remap to 0..1")},
    {"spectrum", QT_TRANSLATE_NOOP("RecipeLabel", "spectrum")},
    {"spectrum.taper", QT_TRANSLATE_NOOP("RecipeLabel", "window function")},
    {"spectrum.method", QT_TRANSLATE_NOOP("RecipeLabel", "estimator")},
    {"spectrum.segment", QT_TRANSLATE_NOOP("RecipeLabel", "segment length")},
    {"spectrum.detrend", QT_TRANSLATE_NOOP("RecipeLabel", "trend taken off")},
    {"spectrum.resonance_band_hz", QT_TRANSLATE_NOOP("RecipeLabel", "band of the search")},
    {"spectrum.resonance", QT_TRANSLATE_NOOP("RecipeLabel", "resonance")},
    {"pca", QT_TRANSLATE_NOOP("RecipeLabel", "principal components")},
    {"pca.components", QT_TRANSLATE_NOOP("RecipeLabel", "components kept")},
    {"pca.centre", QT_TRANSLATE_NOOP("RecipeLabel", "subtract the mean")},
    {"pca.residual_lags", QT_TRANSLATE_NOOP("RecipeLabel", "lags")},
    {"pca.residual_confidence", QT_TRANSLATE_NOOP("RecipeLabel", "confidence of the bound")},
    {"input", QT_TRANSLATE_NOOP("RecipeLabel", "model input")},
    {"input.sample_rate_hz", QT_TRANSLATE_NOOP("RecipeLabel", "rate of the model input")},
    {"input.samples", QT_TRANSLATE_NOOP("RecipeLabel", "samples of the model input")},
    {"input.offset_s", QT_TRANSLATE_NOOP("RecipeLabel", "offset of the model input")},
    {"input.combine", QT_TRANSLATE_NOOP("RecipeLabel", "how shots are combined")},
    {"input.treatment", QT_TRANSLATE_NOOP("RecipeLabel", "what the response is taken for")},
    {"realization", QT_TRANSLATE_NOOP("RecipeLabel", "realisation")},
    {"realization.order", QT_TRANSLATE_NOOP("RecipeLabel", "order")},
    {"realization.max_order", QT_TRANSLATE_NOOP("RecipeLabel", "orders offered")},
    {"realization.rows", QT_TRANSLATE_NOOP("RecipeLabel", "Hankel rows")},
    {"realization.refine", QT_TRANSLATE_NOOP("RecipeLabel", "refine the poles")},
    {"realization.nuisance_modes", QT_TRANSLATE_NOOP("RecipeLabel", "nuisance modes")},
    {"realization.nuisance_modes[].frequency_hz",
        QT_TRANSLATE_NOOP("RecipeLabel", "frequency of the nuisance mode")},
    {"realization.nuisance_modes[].shot",
        QT_TRANSLATE_NOOP("RecipeLabel", "shot of the nuisance mode")},
    {"realization.nuisance_modes[].kind",
        QT_TRANSLATE_NOOP("RecipeLabel", "kind of the nuisance mode")},
    {"realization.nuisance_modes[].label",
        QT_TRANSLATE_NOOP("RecipeLabel", "label of the nuisance mode")},
    {"realization.nuisance_modes[].reason",
        QT_TRANSLATE_NOOP("RecipeLabel", "reason for the nuisance mode")},
    {"realization.stable_frequency", QT_TRANSLATE_NOOP("RecipeLabel", "stable frequency")},
    {"realization.stable_damping", QT_TRANSLATE_NOOP("RecipeLabel", "stable damping")},
    {"realization.candidates", QT_TRANSLATE_NOOP("RecipeLabel", "pinned orders")},
    {"realization.candidate_notes", QT_TRANSLATE_NOOP("RecipeLabel", "notes on pinned orders")},
    {"realization.candidate_notes[].order", QT_TRANSLATE_NOOP("RecipeLabel", "order of the note")},
    {"realization.candidate_notes[].note", QT_TRANSLATE_NOOP("RecipeLabel", "note")},
    {"realization.adopted_reason", QT_TRANSLATE_NOOP("RecipeLabel", "reason for the order")},
    {"response", QT_TRANSLATE_NOOP("RecipeLabel", "response")},
    {"response.frequencies_hz", QT_TRANSLATE_NOOP("RecipeLabel", "frequencies of the response")},
    {"response.reference", QT_TRANSLATE_NOOP("RecipeLabel", "reference of the response")},
    {"uncertainty", QT_TRANSLATE_NOOP("RecipeLabel", "uncertainty")},
    {"uncertainty.budget", QT_TRANSLATE_NOOP("RecipeLabel", "uncertainty budget")},
    {"uncertainty.budget[].quantity", QT_TRANSLATE_NOOP("RecipeLabel", "quantity of the budget")},
    {"uncertainty.budget[].u", QT_TRANSLATE_NOOP("RecipeLabel", "u of the budget")},
    {"uncertainty.budget[].distribution",
        QT_TRANSLATE_NOOP("RecipeLabel", "distribution of the budget")},
    {"uncertainty.budget[].dof",
        QT_TRANSLATE_NOOP("RecipeLabel", "degrees of freedom of the budget")},
    {"uncertainty.monte_carlo_trials", QT_TRANSLATE_NOOP("RecipeLabel", "Monte Carlo trials")},
    {"uncertainty.seed", QT_TRANSLATE_NOOP("RecipeLabel", "seed")},
    {"uncertainty.coverage", QT_TRANSLATE_NOOP("RecipeLabel", "coverage probability")},
    {"acknowledge", QT_TRANSLATE_NOOP("RecipeLabel", "acknowledged findings")},
    {"acknowledge[].finding", QT_TRANSLATE_NOOP("RecipeLabel", "acknowledged finding")},
    {"acknowledge[].shot", QT_TRANSLATE_NOOP("RecipeLabel", "shot of the acknowledged finding")},
    {"acknowledge[].reason", QT_TRANSLATE_NOOP("RecipeLabel", "reason of the acknowledgement")},
    {"certificate", QT_TRANSLATE_NOOP("RecipeLabel", "certificate")},
    {"certificate.template", QT_TRANSLATE_NOOP("RecipeLabel", "template of the certificate")},
    {"certificate.languages", QT_TRANSLATE_NOOP("RecipeLabel", "languages of the certificate")},
    {"certificate.fields", QT_TRANSLATE_NOOP("RecipeLabel", "fields of the certificate")},
};

/// "import.exclude[12].shot" -> "import.exclude[].shot", and so for free words in braces.
QString withoutPlaces(QString key)
{
    static const QRegularExpression place(QStringLiteral("\\[\\d*\\]"));
    static const QRegularExpression word(QStringLiteral("\\{[^}]*\\}"));
    return key.replace(place, QStringLiteral("[]")).replace(word, QStringLiteral("{}"));
}

/// By the whole key, and by its last part where that is no plain word ("sample_rate_hz").
const QHash<QString, const char *> &labels()
{
    static const QHash<QString, const char *> labels = [] {
        QHash<QString, const char *> made;
        for (const RecipeLabel &one : kRecipeLabels) {
            const QString key = QString::fromLatin1(one.key);
            made.insert(key, one.label);
            const QString last = key.section('.', -1);
            if (last.contains('_') && !made.contains(last))
                made.insert(last, one.label);
        }
        return made;
    }();
    return labels;
}

} // namespace

QString recipeLabel(const QString &key)
{
    const char *label = labels().value(withoutPlaces(key), nullptr);
    return label ? QCoreApplication::translate("RecipeLabel", label) : QString();
}

QString withRecipeLabels(const QString &sentence)
{
    // Words with a '.' or '_' inside; a '.' that ends the sentence is none of a key.
    static const QRegularExpression word(QStringLiteral(
        "[a-z][a-z0-9_]*(?:\\[\\d*\\]|\\{[^}]*\\})?(?:[._][a-z0-9_]+(?:\\[\\d*\\]|\\{"
        "[^}]*\\})?)+"));
    QString shown;
    qsizetype taken = 0;
    for (auto match = word.globalMatch(sentence); match.hasNext();) {
        const auto found = match.next();
        const QString label = recipeLabel(found.captured());
        if (label.isEmpty())
            continue;
        shown += sentence.mid(taken, found.capturedStart() - taken);
        shown += QStringLiteral("“") + label + QStringLiteral("”");
        taken = found.capturedEnd();
    }
    return shown + sentence.mid(taken);
}

} // namespace dyncal
