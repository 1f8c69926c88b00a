// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_fields_analysis.h"

#include "core/base/number_text.h"
#include "core/project/document_languages.h"
#include "core/project/recipe_limits.h"

#include <string_view>

namespace dyncal {
namespace {

constexpr Index kMostInputSamples = 10000000;
constexpr Index kMostOrders = 2000;
constexpr Index kMostFrequencies = 100000;
constexpr std::string_view kLinear = "linear:";

Codec<ResponseTreatment> treatment()
{
    std::vector<std::pair<std::string, ResponseTreatment>> names;
    for (const ResponseTreatment t :
        {ResponseTreatment::StepDeflated, ResponseTreatment::StepAsImpulse,
            ResponseTreatment::Differenced, ResponseTreatment::Impulse})
        names.emplace_back(responseTreatmentName(t), t);
    return choice(names);
}

Codec<CombineMethod> combine()
{
    return choice<CombineMethod>(
        {{"stacked", CombineMethod::Stacked}, {"pca-average", CombineMethod::PcaAverage}});
}

std::optional<Index> linearCount(const Json &value)
{
    if (!value.is_string())
        return std::nullopt;
    const std::string_view text = value.get_ref<const std::string &>();
    if (!text.starts_with(kLinear))
        return std::nullopt;
    const std::optional<double> count = parseNumber(text.substr(kLinear.size()));
    if (!count || !(*count >= 2.0 && *count <= static_cast<double>(kMostFrequencies)))
        return std::nullopt;
    const auto whole = static_cast<Index>(*count);
    return static_cast<double>(whole) == *count ? std::optional(whole) : std::nullopt;
}

/// A list, "third-octave" or "linear:N"; three members share the key.
Field<ResponseSettings> frequencies()
{
    const auto values = list(positiveNumber(), 1);
    const std::string needs = "\"third-octave\", \"linear:N\" with N between 2 and "
        + std::to_string(kMostFrequencies) + " or a list of frequencies in hertz";
    return {"frequencies_hz", DYNCAL_TEXT("RecipeLabel", "frequencies of the response"),
        [=](const JsonAt &at, ResponseSettings &response) -> Result<void> {
            const std::optional<Index> count = linearCount(at.value);
            if (at.value == "third-octave") {
                response.grid = "third-octave";
            } else if (count) {
                response.grid = "linear";
                response.linearCount = *count;
            } else if (at.value.is_array()) {
                Result<std::vector<double>> listed = values.read(at);
                if (!listed)
                    return tl::unexpected<Error>(listed.error());
                response.grid = "list";
                response.frequencies_Hz = std::move(*listed);
            } else {
                return mismatch(at, needs);
            }
            return {};
        },
        [values](const ResponseSettings &response) {
            if (response.grid == "list")
                return values.write(response.frequencies_Hz);
            if (response.grid == "linear")
                return Json(std::string(kLinear) + std::to_string(response.linearCount));
            return Json(response.grid);
        }};
}

/// One number, or one per shot.
Codec<std::vector<double>> frequencyOrList()
{
    const std::string needs = "a frequency in hertz or a list of one per shot";
    const Codec<double> one = positiveNumber();
    const Codec<std::vector<double>> several = list(one, 1);
    const auto read = [=](const JsonAt &at) -> Result<std::vector<double>> {
        if (at.value.is_array())
            return several.read(at);
        if (!at.value.is_number())
            return mismatch(at, needs);
        return one.read(at).map([](double value) { return std::vector<double>{value}; });
    };
    const auto write = [=](const std::vector<double> &values) {
        return values.size() == 1 ? one.write(values.front()) : several.write(values);
    };
    return {needs, read, write};
}

Codec<NuisanceMode> nuisanceMode()
{
    using S = NuisanceMode;
    return object<S>({
        field("frequency_hz", DYNCAL_TEXT("RecipeLabel", "frequency of the nuisance mode"),
            &S::frequency_Hz, frequencyOrList(), true),
        field("shot", DYNCAL_TEXT("RecipeLabel", "shot of the nuisance mode"), &S::shot,
            whole(0, kMostShots)),
        field("kind", DYNCAL_TEXT("RecipeLabel", "kind of the nuisance mode"), &S::isTube,
            choice<bool>({{"tube", true}, {"other", false}})),
        field("label", DYNCAL_TEXT("RecipeLabel", "label of the nuisance mode"), &S::label,
            anyText()),
        field("reason", DYNCAL_TEXT("RecipeLabel", "reason for the nuisance mode"), &S::reason,
            nonEmptyText(), true),
    });
}

Codec<OrderNote> orderNote()
{
    using S = OrderNote;
    return object<S>({
        field("order", DYNCAL_TEXT("RecipeLabel", "order of the note"), &S::order,
            whole(1, kMostOrders), true),
        field("note", DYNCAL_TEXT("RecipeLabel", "note"), &S::note, nonEmptyText(), true),
    });
}

Codec<InputSettings> inputCodec()
{
    using S = InputSettings;
    const Codec<std::optional<CombineMethod>> combineOrAuto = valueOr(Json("auto"), combine());
    return object<S>({
        field("sample_rate_hz", DYNCAL_TEXT("RecipeLabel", "rate of the model input"),
            &S::sampleRate_Hz, orAuto(positiveNumber())),
        field("samples", DYNCAL_TEXT("RecipeLabel", "samples of the model input"), &S::samples,
            orAuto(whole(8, kMostInputSamples))),
        field("offset_s", DYNCAL_TEXT("RecipeLabel", "offset of the model input"), &S::offset_s,
            orAuto(nonNegativeNumber())),
        field("combine", DYNCAL_TEXT("RecipeLabel", "how shots are combined"), &S::combine,
            combineOrAuto),
        field("treatment", DYNCAL_TEXT("RecipeLabel", "what the response is taken for"),
            &S::treatment, treatment()),
    });
}

Codec<RealizationSettings> realizationCodec()
{
    using S = RealizationSettings;
    return object<S>({
        field(
            "order", DYNCAL_TEXT("RecipeLabel", "order"), &S::order, orAuto(whole(1, kMostOrders))),
        field("max_order", DYNCAL_TEXT("RecipeLabel", "orders offered"), &S::maxOrder,
            whole(1, kMostOrders)),
        field("rows", DYNCAL_TEXT("RecipeLabel", "Hankel rows"), &S::rows,
            orAuto(whole(2, kMostInputSamples))),
        field("refine", DYNCAL_TEXT("RecipeLabel", "refine the poles"), &S::refine, boolean()),
        field("nuisance_modes", DYNCAL_TEXT("RecipeLabel", "nuisance modes"), &S::nuisanceModes,
            list(nuisanceMode())),
        field("stable_frequency", DYNCAL_TEXT("RecipeLabel", "stable frequency"),
            &S::stableFrequency, number(0.0, 1.0, Bound::Exclusive)),
        field("stable_damping", DYNCAL_TEXT("RecipeLabel", "stable damping"), &S::stableDamping,
            number(0.0, 1.0, Bound::Exclusive)),
        field("candidates", DYNCAL_TEXT("RecipeLabel", "pinned orders"), &S::candidates,
            list(whole(1, kMostOrders))),
        field("candidate_notes", DYNCAL_TEXT("RecipeLabel", "notes on pinned orders"),
            &S::candidateNotes, list(orderNote())),
        field("adopted_reason", DYNCAL_TEXT("RecipeLabel", "reason for the order"),
            &S::adoptedReason, anyText()),
    });
}

Codec<KnownSensitivity> knownSensitivity()
{
    using S = KnownSensitivity;
    return object<S>({
        field("label", DYNCAL_TEXT("RecipeLabel", "name of a known value"), &S::label,
            nonEmptyText(), true),
        field("frequency_hz", DYNCAL_TEXT("RecipeLabel", "frequency of a known value"),
            &S::frequency_Hz, nonNegativeNumber()),
        field("magnitude", DYNCAL_TEXT("RecipeLabel", "known value"), &S::magnitude,
            positiveNumber(), true),
        field("u", DYNCAL_TEXT("RecipeLabel", "u of a known value"), &S::u, positiveNumber(), true),
        field("unit", DYNCAL_TEXT("RecipeLabel", "unit of a known value"), &S::unit, nonEmptyText(),
            true),
        field("dof", DYNCAL_TEXT("RecipeLabel", "degrees of freedom of a known value"), &S::dof,
            orNull(positiveNumber())),
        field("certificate", DYNCAL_TEXT("RecipeLabel", "certificate of a known value"),
            &S::certificate, textOrNull()),
    });
}

Codec<ResponseSettings> responseCodec()
{
    using S = ResponseSettings;
    return object<S>({
        frequencies(),
        field("reference", DYNCAL_TEXT("RecipeLabel", "reference of the response"), &S::reference,
            oneOf({"computed-step", "static-sensitivity", "unit-step", "transducer"})),
        field("known", DYNCAL_TEXT("RecipeLabel", "values of other calibrations"), &S::known,
            list(knownSensitivity())),
    });
}

Codec<Acknowledgement> acknowledgementCodec()
{
    using S = Acknowledgement;
    return object<S>({
        field("finding", DYNCAL_TEXT("RecipeLabel", "acknowledged finding"), &S::finding,
            nonEmptyText(), true),
        field("shot", DYNCAL_TEXT("RecipeLabel", "shot of the acknowledged finding"), &S::shot,
            whole(0, kMostShots)),
        field("reason", DYNCAL_TEXT("RecipeLabel", "reason of the acknowledgement"), &S::reason,
            nonEmptyText(), true),
    });
}

Codec<DecisionSettings> decisionCodec()
{
    using S = DecisionSettings;
    return object<S>({
        field("rule", DYNCAL_TEXT("RecipeLabel", "decision rule"), &S::rule,
            choice<DecisionRule>({{"simple", DecisionRule::Simple},
                {"guard-band", DecisionRule::GuardBand}, {"risk", DecisionRule::Risk}}),
            true),
        field("within_percent", DYNCAL_TEXT("RecipeLabel", "limit of the claim"),
            &S::within_percent, positiveNumber(), true),
        field("from_hz", DYNCAL_TEXT("RecipeLabel", "lowest frequency of the claim"), &S::from_Hz,
            positiveNumber(), true),
        field("to_hz", DYNCAL_TEXT("RecipeLabel", "highest frequency of the claim"), &S::to_Hz,
            positiveNumber(), true),
        field("max_risk_percent", DYNCAL_TEXT("RecipeLabel", "largest risk of the claim"),
            &S::maxRisk_percent, number(0.0, 50.0, Bound::Exclusive)),
    });
}

Codec<CertificateSettings> certificateCodec()
{
    using S = CertificateSettings;
    return object<S>({
        field("template", DYNCAL_TEXT("RecipeLabel", "template of the certificate"),
            &S::templateName, nonEmptyText()),
        field("languages", DYNCAL_TEXT("RecipeLabel", "languages of the certificate"),
            &S::languages, documentLanguageList()),
        field("fields", DYNCAL_TEXT("RecipeLabel", "fields of the certificate"), &S::fields,
            dictionary(anyText(), "a field's name")),
        field("decision", DYNCAL_TEXT("RecipeLabel", "decision on conformity"), &S::decision,
            orNull(decisionCodec())),
    });
}

} // namespace

std::vector<Field<Recipe>> analysisSections()
{
    return {
        field("input", DYNCAL_TEXT("RecipeLabel", "model input"), &Recipe::input, inputCodec()),
        field("realization", DYNCAL_TEXT("RecipeLabel", "realisation"), &Recipe::realization,
            realizationCodec()),
        field(
            "response", DYNCAL_TEXT("RecipeLabel", "response"), &Recipe::response, responseCodec()),
        field("acknowledge", DYNCAL_TEXT("RecipeLabel", "acknowledged findings"),
            &Recipe::acknowledge, list(acknowledgementCodec())),
        field("certificate", DYNCAL_TEXT("RecipeLabel", "certificate"), &Recipe::certificate,
            certificateCodec()),
    };
}

} // namespace dyncal
