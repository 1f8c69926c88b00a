// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/left_out.h"

#include "core/base/number_text.h"
#include "core/signal/window_bands.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kLeastRun = 24; ///< samples

Index firstCentre(const ModelSeries &series)
{
    return static_cast<Index>(std::llround(series.first_s * series.fullRate_Hz));
}

/// Sample of the record that sample k of y is centred on, as decimate() has it.
Index centre(const ModelSeries &series, Index k)
{
    return firstCentre(series)
        + static_cast<Index>(std::llround(static_cast<double>(k) * series.filter.factor));
}

bool seesLeftOut(const ModelSeries &series, Index k)
{
    const Index half = series.filter.halfLength();
    const SampleRange seen{centre(series, k) - half, centre(series, k) + half + 1};
    return std::any_of(series.leftOut.begin(), series.leftOut.end(),
        [&](const LeftOut &part) { return part.samples.overlaps(seen); });
}

/// `inStead` less the recorded values within the stretches, through the filter.
template <typename Value>
Eigen::VectorXd replaced(const ModelSeries &series, const Value &inStead)
{
    const Index half = series.filter.halfLength();
    const Index origin = firstCentre(series) - half;
    const Index size = centre(series, series.y.size() - 1) + half + 2 - origin;
    Eigen::VectorXd change = Eigen::VectorXd::Zero(size);
    for (const LeftOut &part : series.leftOut) {
        for (Index i = std::max(part.samples.begin, origin);
             i < std::min(part.samples.end, origin + size); ++i)
            change[i - origin] = inStead(part, i) - part.recorded[i - part.samples.begin];
    }
    return decimate(change, series.filter, half, series.y.size());
}

/// Straight line between the samples beside the stretch; with only one neighbour, that one's level.
double interpolated(const ModelSeries &series, const LeftOut &part, Index i)
{
    const Index last = series.fullRate.size() - 1;
    const double before = series.fullRate[std::clamp<Index>(part.samples.begin - 1, 0, last)];
    if (part.samples.end > last)
        return before;
    const double after = series.fullRate[part.samples.end];
    if (part.samples.begin <= 0)
        return after;
    const double share = static_cast<double>(i - part.samples.begin + 1)
        / static_cast<double>(part.samples.size() + 1);
    return before + share * (after - before);
}

tl::unexpected<Error> notInWindow(const ExcludedStretch &stretch, double end_s)
{
    return fail(ErrorKind::Usage,
        Message{
            DYNCAL_TEXT("core",
                "window.exclude_stretches: %1 to %2 of shot %3 must begin before it ends and touch its window, which reaches from its start to %4."),
            {numberWithUnit(stretch.from_s, "s", 4), numberWithUnit(stretch.to_s, "s", 4),
                std::to_string(stretch.shot), numberWithUnit(end_s, "s", 4)}},
        {}, stretch.shot);
}

Finding leftOutFinding(const ExcludedStretch &stretch)
{
    return {.id = "WIN-007",
        .severity = Severity::Info,
        .shot = stretch.shot,
        .time_s = stretch.from_s,
        .message
        = {DYNCAL_TEXT("core", "Shot %1: %2 to %3 behind the start is left out of the fit: %4"),
            {std::to_string(stretch.shot), numberWithUnit(stretch.from_s, "s", 4),
                numberWithUnit(stretch.to_s, "s", 4), stretch.reason}}};
}

/// The stretch as samples; ranges that touch become one.
Result<void> addStretch(
    const WindowedResponse &response, const ExcludedStretch &stretch, ModelSeries &series)
{
    const double rate_Hz = response.sampleRate_Hz;
    const double end_s = static_cast<double>(response.length) / rate_Hz;
    if (!(stretch.from_s < stretch.to_s) || !(stretch.from_s < end_s) || !(stretch.to_s > 0.0))
        return notInWindow(stretch, end_s);
    SampleRange range{static_cast<Index>(std::max(0.0, std::floor(stretch.from_s * rate_Hz))),
        static_cast<Index>(std::ceil(std::min(stretch.to_s, end_s) * rate_Hz)) + 1};
    range.end = std::min(range.end, response.values.size() - response.lead);
    std::erase_if(series.leftOut, [&](const LeftOut &other) {
        const bool touches = !other.isFront && other.samples.begin <= range.end
            && range.begin <= other.samples.end;
        if (touches)
            range = {
                std::min(range.begin, other.samples.begin), std::max(range.end, other.samples.end)};
        return touches;
    });
    series.leftOut.push_back(
        {range, response.values.segment(response.lead + range.begin, range.size())});
    std::sort(series.leftOut.begin(), series.leftOut.end(),
        [](const LeftOut &a, const LeftOut &b) { return a.samples.begin < b.samples.begin; });
    return {};
}

Result<void> checkWhatIsLeft(const ModelSeries &series)
{
    Index counted = 0;
    for (const SampleRange &range : countedSamples(series))
        counted += range.size();
    if (2 * counted >= series.y.size())
        return {};
    return fail(ErrorKind::DataBlocked,
        Message{
            DYNCAL_TEXT("core",
                "Shot %1: only %2 of the %3 samples of the model input are free of stretches left out; at least half are needed. Mark less, or exclude the shot."),
            {std::to_string(series.shot), std::to_string(counted),
                std::to_string(series.y.size())}},
        "WIN-008", series.shot);
}

} // namespace

Result<void> leaveOut(ModelInput &input, const std::vector<WindowedResponse> &responses,
    const std::vector<ExcludedStretch> &stretches)
{
    if (stretches.empty())
        return {};
    if (input.combine == CombineMethod::PcaAverage) {
        input.findings.push_back({.id = "WIN-009",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "The average of the shots is formed before the fit: the stretches to be left out are in it. Combine the shots as \"stacked\"."),
                {}}});
        return {};
    }
    for (const ExcludedStretch &stretch : stretches) {
        const auto response = std::find_if(responses.begin(), responses.end(),
            [&](const WindowedResponse &r) { return r.shot == stretch.shot; });
        if (response == responses.end())
            continue; // the shot is not used
        ModelSeries &series = input.series[static_cast<std::size_t>(response - responses.begin())];
        if (auto added = addStretch(*response, stretch, series); !added)
            return added;
        input.leftOut.push_back(stretch);
        input.findings.push_back(leftOutFinding(stretch));
    }
    for (ModelSeries &series : input.series) {
        if (std::ranges::all_of(series.leftOut, &LeftOut::isFront))
            continue;
        if (auto enough = checkWhatIsLeft(series); !enough)
            return enough;
        series.correction = replaced(
            series, [&](const LeftOut &part, Index i) { return interpolated(series, part, i); });
    }
    return {};
}

std::vector<SampleRange> usedSamples(const ModelSeries &series)
{
    std::vector<SampleRange> used;
    if (series.leftOut.empty())
        return used;
    Index free = 0;
    for (const LeftOut &part : series.leftOut) {
        const Index begin = std::min(part.samples.begin, series.fullRate.size());
        if (begin > free)
            used.push_back({free, begin});
        free = std::min(part.samples.end, series.fullRate.size());
    }
    if (series.fullRate.size() > free)
        used.push_back({free, series.fullRate.size()});
    return used;
}

std::vector<SampleRange> countedSamples(const ModelSeries &series)
{
    std::vector<SampleRange> counted;
    for (Index k = 0; k < series.y.size(); ++k) {
        if (seesLeftOut(series, k))
            continue;
        if (!counted.empty() && counted.back().end == k)
            ++counted.back().end;
        else
            counted.push_back({k, k + 1});
    }
    return counted;
}

Eigen::VectorXd countedValues(const ModelSeries &series, const Eigen::VectorXd &values)
{
    if (series.leftOut.empty())
        return values;
    Eigen::VectorXd kept(values.size());
    Index size = 0;
    for (const SampleRange &range : countedSamples(series)) {
        kept.segment(size, range.size()) = values.segment(range.begin, range.size());
        size += range.size();
    }
    return kept.head(size);
}

Eigen::VectorXd bridge(const ModelSeries &series, const ExponentialSum &sensor)
{
    return replaced(series, [&](const LeftOut &, Index i) {
        const double t_s = static_cast<double>(i) / series.fullRate_Hz;
        double value = sensor.value(t_s);
        for (const NuisanceTerm &term : series.nuisance)
            value += term.value(t_s);
        return value;
    });
}

ModelInput cleanRun(const ModelInput &input)
{
    ModelInput cut = input;
    Index length = input.samples;
    std::vector<Index> begins;
    for (const ModelSeries &series : input.series) {
        const std::vector<SampleRange> counted = countedSamples(series);
        const auto longest = std::max_element(counted.begin(), counted.end(),
            [](const SampleRange &a, const SampleRange &b) { return a.size() < b.size(); });
        length = std::min(length, longest == counted.end() ? 0 : longest->size());
        begins.push_back(longest == counted.end() ? 0 : longest->begin);
    }
    if (length < kLeastRun || 8 * length < input.samples)
        return {};
    for (std::size_t r = 0; r < cut.series.size(); ++r) {
        cut.series[r].y = input.series[r].y.segment(begins[r], length).eval();
        cut.series[r].first_s += static_cast<double>(begins[r]) / input.sampleRate_Hz;
    }
    cut.samples = length;
    return cut;
}

} // namespace dyncal
