// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/input_preparation.h"

#include "core/base/number_text.h"
#include "core/decomposition/component_result.h"
#include "core/realization/input/rate_choice.h"
#include "core/realization/input/series_making.h"
#include "core/realization/input/series_source.h"
#include "core/signal/resampler.h"
#include "core/signal/spectrum_analysis.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace dyncal {
namespace {

using Source = SeriesSource;

constexpr Index kFewestSamples = 12; ///< a Hankel matrix of 5 rows

Result<double> reductionOf(const Source &source, double rate_Hz)
{
    if (const auto factor = reductionFactor(source.rate_Hz, rate_Hz))
        return *factor;
    return fail(ErrorKind::DataBlocked,
        Message{
            DYNCAL_TEXT("core",
                "Model input: shot %1 is recorded at %2, below the model rate of %3; choose at most %2."),
            {std::to_string(source.shot), numberWithUnit(source.rate_Hz, "Hz", 6),
                numberWithUnit(rate_Hz, "Hz", 6)}},
        "MIN-001", source.shot);
}

/// Samples of the input that fit before the window ends, the filter's second half included.
Index availableSamples(const Source &source, const AntiAliasFilter &filter, Index first)
{
    // The sample's own time lies in the window; the filter may look beyond its end.
    return outputCount(filter, first,
        std::min(source.lead + source.length - 1 + filter.halfLength(), source.values.size() - 1));
}

Message tooFewSamples(Index shot, Index found, Index needed)
{
    return {
        DYNCAL_TEXT("core",
            "Model input: shot %1 offers %2 samples before its window ends, %3 are asked for; lengthen the window or ask for fewer samples."),
        {std::to_string(shot), std::to_string(found), std::to_string(needed)}};
}

/// Share of the ringing's energy before the first sample of the input, less that of noise.
std::optional<double> lostResponse_percent(const ModelInput &input)
{
    double before = 0.0;
    double all = 0.0;
    for (const ModelSeries &series : input.series) {
        const Index count = series.fullRate.size();
        const double plateau = isStepTreatment(input.treatment)
            ? series.fullRate.tail(std::max<Index>(1, count / 4)).mean()
            : 0.0;
        const Index first = std::min(
            count, static_cast<Index>(std::llround(series.first_s * series.fullRate_Hz)));
        const Eigen::ArrayXd energy = (series.fullRate.array() - plateau).square()
            - series.fullRateNoiseSd * series.fullRateNoiseSd;
        before += energy.head(first).sum();
        all += energy.sum();
    }
    if (!(all > 0.0))
        return std::nullopt;
    return std::clamp(100.0 * before / all, 0.0, 100.0);
}

/// The rate as set, or by the rule, with its findings.
Result<void> chooseRate(const std::vector<Source> &list, const SensorTraits &traits,
    const InputSettings &settings, ModelInput &input)
{
    double lowestRate_Hz = list.front().rate_Hz;
    for (const Source &source : list)
        lowestRate_Hz = std::min(lowestRate_Hz, source.rate_Hz);
    input.sampleRate_Hz = settings.sampleRate_Hz.value
        ? *settings.sampleRate_Hz.value
        : lowestRate_Hz / static_cast<double>(chooseReduction(lowestRate_Hz, traits));
    auto findings = judgeRate(input.sampleRate_Hz, traits);
    if (!findings)
        return tl::unexpected(findings.error());
    input.findings = std::move(*findings);
    if (!traits.ringing.empty())
        input.samplesPerPeriod = input.sampleRate_Hz / traits.ringing.front().frequency_Hz;
    return {};
}

/// The filter of every source, down to the model rate.
Result<std::vector<AntiAliasFilter>> designFilters(const std::vector<Source> &list, double rate_Hz)
{
    std::vector<AntiAliasFilter> filters;
    for (const Source &source : list) {
        const auto factor = reductionOf(source, rate_Hz);
        if (!factor)
            return tl::unexpected(factor.error());
        filters.push_back(designAntiAliasFilter(*factor, source.rate_Hz));
    }
    return filters;
}

/// Half the span of the longest filter.
double longestHalf_s(const std::vector<AntiAliasFilter> &filters)
{
    double half_s = 0.0;
    for (const AntiAliasFilter &filter : filters)
        half_s = std::max(half_s, filter.span_s() / 2.0);
    return half_s;
}

/// Time of the input's first sample after the start: half the filter's span, so that the whole
/// centred filter lies after the start, and after the front.
double chooseOffset_s(const InputSettings &settings, double earliest_s, Findings &findings)
{
    const double offset_s = settings.offset_s.value.value_or(earliest_s);
    if (offset_s < earliest_s * (1.0 - 1e-9))
        findings.push_back(insideFilterFinding(offset_s, earliest_s));
    return offset_s;
}

/// The front ends no later than so long behind the detected start, which lies within it.
double longestFront_s(const FrontDuration &front)
{
    constexpr double kCoverage = 2.0;
    return front.duration_s > 0.0 ? front.duration_s + kCoverage * front.u_s : 0.0;
}

void leaveFrontOut(const FrontDuration &front, ModelInput &input)
{
    input.front = front;
    for (ModelSeries &series : input.series) {
        const Index count = std::min(series.fullRate.size(),
            static_cast<Index>(std::ceil(longestFront_s(front) * series.fullRate_Hz)));
        if (count > 0)
            series.leftOut.push_back({{0, count}, series.fullRate.head(count), true});
    }
}

/// Position of the input's first sample in every source.
Result<std::vector<Index>> firstSamples(
    const std::vector<Source> &list, const std::vector<AntiAliasFilter> &filters, double offset_s)
{
    std::vector<Index> firsts;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Index first
            = list[i].lead + static_cast<Index>(std::ceil(offset_s * list[i].rate_Hz - 1e-6));
        if (first < filters[i].halfLength()) {
            return fail(ErrorKind::DataBlocked,
                Message{
                    DYNCAL_TEXT("core",
                        "Model input: shot %1 has %2 samples before the input starts, the anti-alias filter needs %3; start later or raise the model rate."),
                    {std::to_string(list[i].shot), std::to_string(first),
                        std::to_string(filters[i].halfLength())}},
                "MIN-006", list[i].shot);
        }
        firsts.push_back(first);
    }
    return firsts;
}

/// The number asked for, or by the rule at most what every source offers.
Result<Index> chooseLength(const std::vector<Source> &list,
    const std::vector<AntiAliasFilter> &filters, const std::vector<Index> &firsts,
    const std::optional<Index> &asked, Index wanted)
{
    Index available = 0;
    Index scarcest = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Index here = availableSamples(list[i], filters[i], firsts[i]);
        if (i == 0 || here < available) {
            available = here;
            scarcest = list[i].shot;
        }
    }
    const Index samples = asked.value_or(std::min(available, wanted));
    if (samples > available || available < kFewestSamples)
        return fail(ErrorKind::DataBlocked,
            tooFewSamples(scarcest, available, std::max(samples, kFewestSamples)), "MIN-005",
            scarcest);
    return samples;
}

Finding stepAsImpulse()
{
    return {.id = "MIN-004",
        .severity = Severity::Info,
        .message
        = {DYNCAL_TEXT("core",
               "The step is treated as an impulse response (thesis method): one extra order models the step itself."),
            {}}};
}

void nameLevels(const std::vector<WindowedResponse> &responses, std::vector<ModelSeries> &series)
{
    for (ModelSeries &one : series) {
        for (const WindowedResponse &response : responses) {
            if (response.shot == one.shot) {
                one.level = response.level;
                one.step = response.step;
            }
        }
    }
}

} // namespace

Result<ModelInput> prepareModelInput(const std::vector<WindowedResponse> &responses,
    const SpectrumResult &spectrum, const ComponentResult &components,
    const InputSettings &settings, const FrontDuration &known, const JobControl &control)
{
    ModelInput input;
    input.treatment = settings.treatment;
    input.combine = settings.effectiveCombine();
    const FrontDuration front = isStepTreatment(settings.treatment) ? known : FrontDuration{};
    const std::vector<Source> list = seriesSources(responses, components, input.combine);
    const SensorTraits traits = sensorTraits(responses, spectrum);
    if (const auto rate = chooseRate(list, traits, settings, input); !rate)
        return tl::unexpected(rate.error());
    const auto filters = designFilters(list, input.sampleRate_Hz);
    if (!filters)
        return tl::unexpected(filters.error());
    const double offset_s
        = chooseOffset_s(settings, longestHalf_s(*filters) + longestFront_s(front), input.findings);
    const auto firsts = firstSamples(list, *filters, offset_s);
    if (!firsts)
        return tl::unexpected(firsts.error());
    const auto samples = chooseLength(list, *filters, *firsts, settings.samples.value,
        chooseSamples(input.sampleRate_Hz, traits));
    if (!samples)
        return tl::unexpected(samples.error());
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {});
        input.series.push_back(makeSeries(list[i], (*filters)[i], (*firsts)[i], *samples));
    }
    leaveFrontOut(front, input);
    nameLevels(responses, input.series);
    input.offset_s = input.series.front().first_s;
    input.samples = *samples;
    input.lostResponse_percent = lostResponse_percent(input);
    if (isThesisMode(input))
        input.findings.push_back(stepAsImpulse());
    return input;
}

} // namespace dyncal
