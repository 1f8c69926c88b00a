// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_reference.h"

#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"

namespace dyncal {

namespace {

/// What the reference is taken for: the file that says it, or the numbers that stand in its place.
Message sourceText(const ReferenceRecords &records, const ComparisonSettings &settings)
{
    if (!records.sourceSha256.empty())
        return {DYNCAL_TEXT("core", "file with SHA-256 %1"), {records.sourceSha256}};
    const ReferenceModel model = settings.model.value_or(ReferenceModel());
    const auto words = [](double value, double u, const std::string &unit) {
        return english(printedWithUncertainty(value, u, unit));
    };
    return {
        DYNCAL_TEXT("core",
            "second-order sensor, as stated by the laboratory: sensitivity %L1, natural frequency %L2, damping ratio %L3"),
        {words(model.sensitivity, model.u_sensitivity, settings.unit),
            words(model.f0_Hz, model.u_f0_Hz, "Hz"), words(model.zeta, model.u_zeta, "")}};
}

} // namespace

std::vector<CertificateField> referenceFields(
    const CalibrationResults &results, const Recipe &recipe)
{
    const ReferenceRecords *records = results.reference ? results.reference->transducer() : nullptr;
    if (!records)
        return {};
    std::vector<CertificateField> fields{
        {"reference_channel", {DYNCAL_TEXT("core", "Reference transducer, channel"), {}},
            verbatim(records->channel), false}};
    fields.push_back(
        {"reference_source", {DYNCAL_TEXT("core", "Sensitivity of the reference transducer"), {}},
            sourceText(*records, recipe.comparison), false});
    return fields;
}

std::optional<Message> comparisonSentence(const CalibrationResults &results)
{
    if (!results.comparison || !results.comparison->againstStep)
        return std::nullopt;
    const StepAgainstTransducer &found = *results.comparison->againstStep;
    const RoundedValue percent
        = roundedValue(100.0 * found.difference_relative, 200.0 * found.u_relative, "%");
    return Message{
        DYNCAL_TEXT("core",
            "Check by the second way: the sensitivity against the computed pressure step less that against the reference transducer is %1 %, with an expanded uncertainty of %2 % (k = 2)."),
        {percent.value, percent.u}};
}

} // namespace dyncal
