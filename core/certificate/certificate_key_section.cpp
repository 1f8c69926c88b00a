// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_key_section.h"

#include "core/certificate/certificate_monte_carlo.h"
#include "core/certificate/certificate_sensitivity.h"
#include "core/certificate/certificate_words.h"
#include "core/certificate/result_quantity.h"
#include "core/model_analysis/stated_characteristics.h"
#include "core/pipeline/calibration_kind.h"
#include "core/uncertainty/quantity_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dyncal {
namespace {

using Quantities = std::vector<ResultQuantity>;

/// What is reported of the model, with its complete uncertainty; null where it is not.
const ReportedValue *reportedOf(const CalibrationResults &results, const char *of)
{
    return results.uncertainty ? results.uncertainty->find(of) : nullptr;
}

/// Value and u of the same estimate, which the report alone has together.
ResultQuantity quantityOf(const CalibrationResults &results, const char *of)
{
    const ReportedValue *reported = reportedOf(results, of);
    if (!reported || !reported->u)
        return {valueWords(of), kUnknown, kUnknown, kUnknown, {}, whyNoResult(reported), 0.0, of};
    return {valueWords(of), reported->value, *reported->u, reported->k, reported->unit,
        whyNoResult(nullptr), reported->leastExpanded, of};
}

Message noModel()
{
    return {DYNCAL_TEXT("core", "not determined (no model)"), {}};
}

/// Of these the label alone says what is missing where the sensor has no resonance.
void addResonance(const CalibrationResults &results, Quantities &quantities)
{
    const bool isFound = sensorResonance(results.model.get(), results.assessment.get()).has_value();
    const Message none = results.model
        ? Message{DYNCAL_TEXT("core", "not determined (the model does not oscillate)"), {}}
        : noModel();
    const auto add = [&](const char *of) {
        quantities.push_back(quantityOf(results, of));
        if (!isFound)
            quantities.back().otherwise = none;
    };
    add("f0_hz");
    add("damping_ratio");
}

/// Quality factor and peak: only where they exist, because they follow from the damping ratio.
void addPeak(const CalibrationResults &results, Quantities &quantities)
{
    for (const char *of : {"q", "resonance_hz", "resonance_gain"})
        if (reportedOf(results, of))
            quantities.push_back(quantityOf(results, of));
}

const char *unitOf(const ResponseResult &response)
{
    return response.unit == "1" ? "" : response.unit.c_str();
}

Message whyNotMeasured(double magnitude)
{
    return std::isfinite(magnitude)
        ? whyNoResult(nullptr)
        : Message{DYNCAL_TEXT("core", "withheld (see the frequency response)"), {}};
}

/// What the records themselves say at the resonance, without the model.
void addMeasuredPeak(const CalibrationResults &results, Quantities &quantities)
{
    const ResponseResult *marked = results.response ? results.response->atMarks.get() : nullptr;
    if (!marked || !results.uncertainty)
        return;
    const auto mark = std::ranges::find(marked->marks, RowMark::Resonance);
    if (mark == marked->marks.end())
        return;
    const Index row = mark - marked->marks.begin();
    const RowUncertainty &rows = results.uncertainty->rowsAtMarks;
    quantities.push_back({{DYNCAL_TEXT("core", "Magnitude at the resonance, from the records"), {}},
        marked->magnitude[row], valueAt(rows.u_magnitude, row), valueAt(rows.k_magnitude, row),
        unitOf(*marked), whyNotMeasured(marked->magnitude[row]),
        marked->magnitude[row] * valueAt(rows.leastExpanded_relative, row),
        "magnitude_at_resonance"});
}

/// The model's characteristics as far as the records reach; beyond, the bound or the reason.
void addCharacteristics(const CalibrationResults &results, Quantities &quantities)
{
    const StatedCharacteristics found
        = results.response ? statedCharacteristics(*results.response) : StatedCharacteristics();
    const auto add = [&](const StatedValue &value, const char *of) {
        quantities.push_back(quantityOf(results, of));
        if (!results.response)
            quantities.back().otherwise = noModel();
        else if (!value.value)
            quantities.back().otherwise = value.words;
    };
    add(found.within5percent_Hz, "within_5_percent_hz");
    add(found.within10percent_Hz, "within_10_percent_hz");
    add(found.minus3dB_Hz, "minus_3_db_hz");
    add(found.riseTime_s, "rise_time_s");
    add(found.overshoot_percent, "overshoot_percent");
    add(found.settlingTime_s, "settling_time_s");
}

} // namespace

std::vector<ResultQuantity> keyQuantities(
    const CalibrationResults &results, const Recipe &recipe, const CertificateTemplate &layout)
{
    const bool isStep = calibrationKind(results, recipe) != CalibrationKind::FreeDecay;
    Quantities quantities;
    if (isStep)
        quantities = sensitivityQuantities(results);
    addResonance(results, quantities);
    addPeak(results, quantities);
    addMeasuredPeak(results, quantities);
    if (isStep)
        addCharacteristics(results, quantities);
    std::erase_if(quantities, [&](const ResultQuantity &q) { return !layout.states(q.of); });
    return quantities;
}

CertificateSection keyResultsSection(
    const CalibrationResults &results, const Recipe &recipe, const CertificateTemplate &layout)
{
    CertificateSection section;
    section.id = "key-results";
    section.title = {DYNCAL_TEXT("core", "Key results"), {}};
    const Quantities quantities = keyQuantities(results, recipe, layout);
    addQuantityTables(quantities, section);
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "U = k u is the expanded uncertainty, u the complete standard uncertainty, for a coverage probability of about 95 % (GUM, JCGM 100). What it is made of stands in the section \"Results in detail\"."),
            {}});
    if (monteCarloTable(results, quantities))
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "Of those quantities whose interval by Monte Carlo stands in the section \"Results in detail\", that interval is the one to use: it reaches beyond U to one side."),
                {}});
    return section;
}

} // namespace dyncal
