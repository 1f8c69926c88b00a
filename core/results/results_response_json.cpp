// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_response_json.h"

#include "core/base/constants.h"
#include "core/model_analysis/stated_characteristics.h"
#include "core/results/results_known_json.h"
#include "core/results/results_uncertainty_json.h"

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

const char *withheldReason(WithheldReason reason)
{
    switch (reason) {
    case WithheldReason::None:
        break;
    case WithheldReason::End:
        return "The error by the end of the record (bound_end) may exceed both the uncertainty and 2 % of the value.";
    case WithheldReason::Alias:
        return "The error by sampling (bound_alias) may exceed both the uncertainty and 2 % of the value.";
    case WithheldReason::AboveRate:
        return "The records do not hold frequencies above 0.4 of the lowest sample rate.";
    case WithheldReason::NotCalibrated:
        return "The reference transducer was not calibrated at this frequency.";
    case WithheldReason::ChainUnknown:
        return "The response of the chain is not stated at this frequency.";
    }
    return nullptr;
}

const char *bandEnd(BandEnd end)
{
    switch (end) {
    case BandEnd::Window:
        return "One over the shortest window.";
    case BandEnd::Noise:
        return "Above, the noise exceeds 10 % of the magnitude.";
    case BandEnd::Rate:
        return "0.4 of the lowest sample rate.";
    case BandEnd::ModelRate:
        return "Half the model's rate.";
    case BandEnd::Reference:
        return "Beyond, the reference transducer was not calibrated.";
    case BandEnd::Chain:
        return "Outside, the response of the chain is not stated.";
    }
    return "Not determined.";
}

void addWithheld(JsonRecord &section, const ResponseResult &response)
{
    Json reasons = Json::array();
    for (const WithheldReason reason : response.withheld) {
        const char *words = withheldReason(reason);
        reasons.push_back(words ? Json(words) : Json(nullptr));
    }
    section.set("withheld_reason", std::move(reasons));
    section.set("withheld_reason_reason", "null where the value is stated.");
}

/// The measured half: noise, the bounds of what sampling and the end of the records make, and why
/// a value is withheld. The complete uncertainties: results_uncertainty_json.
void addMeasured(JsonRecord &section, const ResponseResult &response)
{
    const char *none = response.magnitude.size() == 0
        ? "This treatment of the response gives no frequency response of a step."
        : "Withheld, see withheld_reason.";
    section.numbers("magnitude", response.magnitude, none);
    section.numbers("u_noise_magnitude", response.u_noiseMagnitude, none);
    section.numbers("phase_rad", response.phase_rad, none);
    const char *noPhase = response.magnitude.size() == 0
        ? none
        : "Withheld, or the uncertainty of the onset is not known.";
    section.numbers("u_noise_phase_rad", response.u_noisePhase_rad, noPhase);
    const char *noBound = response.magnitude.size() == 0 ? none : "Above 0.4 of the lowest rate.";
    section.numbers("bound_end", response.boundEnd, noBound);
    section.numbers("bound_alias", response.boundAlias, noBound);
    section.numbers("length_s", response.length_s, noBound);
    section.set("bound_alias_assumes",
        "Above half the sample rate the response is nowhere stronger than its largest value between 0.4 and 0.5 of it.");
    addWithheld(section, response);
}

void addCurves(JsonRecord &section, const ResponseResult &response)
{
    const char *noModel
        = "The model gives no response here: it diverges, or of a free decay the frequency is above half the model's rate.";
    section.numbers("frequency_hz", response.frequency_Hz,
        "None of the frequencies asked for lies in the usable band.");
    addMeasured(section, response);
    section.numbers("model_magnitude", response.modelMagnitude, noModel);
    section.numbers("model_phase_rad", response.modelPhase_rad, noModel);
}

const char *markName(RowMark mark)
{
    switch (mark) {
    case RowMark::LowEnd:
        return "f_low";
    case RowMark::Within5percent:
        return "within_5_percent";
    case RowMark::Within10percent:
        return "within_10_percent";
    case RowMark::Minus3dB:
        return "minus_3_db";
    case RowMark::Resonance:
        return "resonance";
    case RowMark::Known:
        return "known";
    case RowMark::HighEnd:
        break;
    }
    return "f_high";
}

/// The rows at the ends of the band, its edges and the resonance; keys as of the other rows.
void addMarked(JsonRecord &section, const ResponseResult &response, const UncertaintyReport *report,
    const std::string &whyMissing)
{
    if (!response.atMarks) {
        section.missing("marked", "Nothing was measured over frequency.");
        return;
    }
    const ResponseResult &marked = *response.atMarks;
    JsonRecord rows;
    Json names = Json::array();
    for (const RowMark mark : marked.marks)
        names.push_back(markName(mark));
    rows.set("at", std::move(names));
    addCurves(rows, marked);
    addRowUncertainty(rows, marked, report ? &report->rowsAtMarks : nullptr, whyMissing);
    section.set("marked", rows.take());
}

/// The edge, or the end of the band of the response that it lies beyond.
void addBand(JsonRecord &section, const std::string &name, const StatedValue &edge)
{
    const std::string reason = english(edge.words);
    const std::string noBound = edge.value ? "The value is stated." : reason;
    section.number(name + "_hz", edge.value, reason);
    section.number(name + "_above_hz", edge.above, noBound);
    section.number(name + "_below_hz", edge.below, noBound);
}

} // namespace

JsonRecord responseSection(
    const ResponseResult &response, const UncertaintyReport *report, const std::string &whyMissing)
{
    JsonRecord section;
    addCurves(section, response);
    addRowUncertainty(section, response, report ? &report->rows : nullptr, whyMissing);
    addMarked(section, response, report, whyMissing);
    section.number("f_low_hz", response.fLow_Hz, "Not determined.");
    section.set("f_low_reason", bandEnd(response.lowEnd));
    section.number("f_high_hz", response.fHigh_Hz, "Not determined.");
    section.set("f_high_reason", bandEnd(response.highEnd));
    section.set("front_duration_s", response.front.duration_s);
    section.set("u_front_duration_s", response.front.u_s);
    section.text("unit", response.unit, "The recordings state no unit.");
    section.set("source", response.isByTransducer ? "transducer" : "step");
    section.set("known", knownJson(report ? report->known : std::vector<KnownValue>()));
    return section;
}

void addResponse(JsonRecord &root, const ResultsContext &context)
{
    const auto response = context.results().response;
    if (!response) {
        root.missing("response", context.whyMissing());
        return;
    }
    root.set("response",
        responseSection(*response, context.results().uncertainty.get(), context.whyMissing())
            .take());
}

void addBands(JsonRecord &root, const ResultsContext &context)
{
    const auto response = context.results().response;
    if (!response) {
        root.missing("bands", context.whyMissing());
        return;
    }
    const StatedCharacteristics found = statedCharacteristics(*response);
    JsonRecord section;
    addBand(section, "within_5_percent", found.within5percent_Hz);
    addBand(section, "within_10_percent", found.within10percent_Hz);
    addBand(section, "minus_3_db", found.minus3dB_Hz);
    section.number("limit_hz", answersEnd_Hz(*response), "Not determined.");
    section.set("source", "model");
    root.set("bands", section.take());
}

} // namespace dyncal
