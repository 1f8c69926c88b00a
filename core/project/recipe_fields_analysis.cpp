// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_fields_analysis.h"

#include "core/base/number_text.h"
#include "core/project/recipe_limits.h"

#include <string_view>

namespace dyncal {
namespace {

constexpr Index kMostComponents = 1000;
constexpr Index kMostLags = 10000000;
constexpr Index kMostInputSamples = 10000000;
constexpr Index kMostOrders = 2000;
constexpr Index kMostFrequencies = 100000;
constexpr Index kLeastTrials = 100; // as propagateMonteCarlo() takes them
constexpr Index kMostTrials = 1000000;
constexpr Index kLargestSeed = 9007199254740991; // every JSON reader keeps it exactly
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
    return {"frequencies_hz",
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
        field("frequency_hz", &S::frequency_Hz, frequencyOrList(), true),
        field("shot", &S::shot, whole(0, kMostShots)),
        field("kind", &S::isTube, choice<bool>({{"tube", true}, {"other", false}})),
        field("label", &S::label, anyText()),
        field("reason", &S::reason, nonEmptyText(), true),
    });
}

Codec<OrderNote> orderNote()
{
    using S = OrderNote;
    return object<S>({
        field("order", &S::order, whole(1, kMostOrders), true),
        field("note", &S::note, nonEmptyText(), true),
    });
}

Codec<BudgetEntry> budgetEntry()
{
    using S = BudgetEntry;
    return object<S>({
        field("quantity", &S::quantity, nonEmptyText(), true),
        field("u", &S::u, nonNegativeNumber(), true),
        field("distribution", &S::distribution,
            oneOf({"normal", "rectangular", "triangular", "u-shaped"})),
        field("dof", &S::dof, orNull(positiveNumber())),
    });
}

/// 0 in the struct stands for "adaptive".
Codec<Index> trials()
{
    const auto codec = valueOr(Json("adaptive"), whole(kLeastTrials, kMostTrials));
    const auto read = [codec](const JsonAt &at) -> Result<Index> {
        return codec.read(at).map([](const std::optional<Index> &v) { return v.value_or(0); });
    };
    const auto write = [codec](const Index &value) {
        return codec.write(value > 0 ? std::optional(value) : std::nullopt);
    };
    return {codec.needs, read, write};
}

} // namespace

Codec<ComponentSettings> componentCodec()
{
    using S = ComponentSettings;
    return object<S>({
        field("components", &S::components, whole(1, kMostComponents)),
        field("centre", &S::centre, boolean()),
        field("residual_lags", &S::residualLags, whole(1, kMostLags)),
        field("residual_confidence", &S::residualConfidence, number(0.5, 1.0, Bound::Exclusive)),
    });
}

Codec<InputSettings> inputCodec()
{
    using S = InputSettings;
    const Codec<std::optional<CombineMethod>> combineOrAuto = valueOr(Json("auto"), combine());
    return object<S>({
        field("sample_rate_hz", &S::sampleRate_Hz, orAuto(positiveNumber())),
        field("samples", &S::samples, orAuto(whole(8, kMostInputSamples))),
        field("offset_s", &S::offset_s, orAuto(nonNegativeNumber())),
        field("combine", &S::combine, combineOrAuto),
        field("treatment", &S::treatment, treatment()),
    });
}

Codec<RealizationSettings> realizationCodec()
{
    using S = RealizationSettings;
    return object<S>({
        field("order", &S::order, orAuto(whole(1, kMostOrders))),
        field("max_order", &S::maxOrder, whole(1, kMostOrders)),
        field("rows", &S::rows, orAuto(whole(2, kMostInputSamples))),
        field("refine", &S::refine, boolean()),
        field("nuisance_modes", &S::nuisanceModes, list(nuisanceMode())),
        field("stable_frequency", &S::stableFrequency, number(0.0, 1.0, Bound::Exclusive)),
        field("stable_damping", &S::stableDamping, number(0.0, 1.0, Bound::Exclusive)),
        field("candidates", &S::candidates, list(whole(1, kMostOrders))),
        field("candidate_notes", &S::candidateNotes, list(orderNote())),
        field("adopted_reason", &S::adoptedReason, anyText()),
    });
}

Codec<ResponseSettings> responseCodec()
{
    using S = ResponseSettings;
    return object<S>({
        frequencies(),
        field("reference", &S::reference,
            oneOf({"computed-step", "static-sensitivity", "unit-step"})),
    });
}

Codec<UncertaintySettings> uncertaintyCodec()
{
    using S = UncertaintySettings;
    return object<S>({
        field("budget", &S::budget, list(budgetEntry())),
        field("monte_carlo_trials", &S::monteCarloTrials, trials()),
        field("seed", &S::seed, whole(0, kLargestSeed)),
        field("coverage", &S::coverage, number(0.0, 1.0, Bound::Exclusive)),
    });
}

Codec<Acknowledgement> acknowledgementCodec()
{
    using S = Acknowledgement;
    return object<S>({
        field("finding", &S::finding, nonEmptyText(), true),
        field("shot", &S::shot, whole(0, kMostShots)),
        field("reason", &S::reason, nonEmptyText(), true),
    });
}

Codec<CertificateSettings> certificateCodec()
{
    using S = CertificateSettings;
    return object<S>({
        field("template", &S::templateName, nonEmptyText()),
        field("languages", &S::languages, list(oneOf({"en", "sv"}), 1)),
        field("fields", &S::fields, dictionary(anyText(), "a field's name")),
    });
}

} // namespace dyncal
