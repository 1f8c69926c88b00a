// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model_input.h"

#include "core/base/number_text.h"
#include "core/realization/rate_choice.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// What one series is made of before it is resampled: samples from `lead` on are the response.
struct Source
{
    Index shot = 0;
    Eigen::Ref<const Eigen::VectorXd> values;
    Index lead = 0;
    Index length = 0;
    double rate_Hz = 0.0;
    Eigen::VectorXd noise;
    double leastNoiseSd = 0.0; ///< of rounding, at the record's rate
    double roundingSd = 0.0; ///< of it what averaging leaves
};

/// What is less than this share of the largest value is rounding of the arithmetic.
constexpr double kArithmetic = 1e-11;

double standardDeviation(const Eigen::VectorXd &values)
{
    if (values.size() < 2)
        return 0.0;
    const double mean = values.mean();
    return std::sqrt(
        (values.array() - mean).square().sum() / static_cast<double>(values.size() - 1));
}

/// Noise of the average: the shots' noise averaged point by point, as the reconstructions are.
Eigen::VectorXd averageNoise(const std::vector<WindowedResponse> &responses, double rate_Hz)
{
    Eigen::VectorXd sum;
    Index count = 0;
    for (const WindowedResponse &response : responses) {
        if (std::abs(response.sampleRate_Hz - rate_Hz) > 1e-9 * rate_Hz)
            continue;
        const Index size
            = sum.size() ? std::min(sum.size(), response.noise.size()) : response.noise.size();
        if (sum.size() == 0)
            sum = Eigen::VectorXd::Zero(size);
        sum = (sum.head(size) + response.noise.head(size)).eval();
        ++count;
    }
    return count ? Eigen::VectorXd(sum / static_cast<double>(count)) : sum;
}

/// Of the errors that rounding makes in a record, in the unit of its values.
struct Rounding
{
    double sd = 0.0;
    double lastingSd = 0.0; ///< of what averaging does not remove
};

/// Unknown like the noise where there is no quiet stretch.
Rounding roundingOf(const WindowedResponse &response)
{
    if (response.noise.size() < 2)
        return {};
    const double resolution = std::abs(response.resolution / response.valueScale);
    const double arithmetic = kArithmetic * response.window().cwiseAbs().maxCoeff();
    return {std::max(resolution / std::sqrt(12.0), arithmetic),
        std::max(response.roundingSd, arithmetic)};
}

/// Of the average: the shots are rounded apart from each other.
Rounding averageRounding(const std::vector<WindowedResponse> &responses)
{
    Rounding squares;
    for (const WindowedResponse &response : responses) {
        const Rounding one = roundingOf(response);
        squares.sd += one.sd * one.sd;
        squares.lastingSd += one.lastingSd * one.lastingSd;
    }
    const double count = static_cast<double>(responses.size());
    return {std::sqrt(squares.sd) / count, std::sqrt(squares.lastingSd) / count};
}

std::vector<Source> sources(const std::vector<WindowedResponse> &responses,
    const ComponentResult &components, CombineMethod combine)
{
    std::vector<Source> list;
    if (combine == CombineMethod::PcaAverage) {
        list.push_back({0, components.average, 0, components.average.size(),
            components.sampleRate_Hz, averageNoise(responses, components.sampleRate_Hz)});
        const Rounding rounding = averageRounding(responses);
        list.back().leastNoiseSd = rounding.sd;
        list.back().roundingSd = rounding.lastingSd;
        return list;
    }
    for (const WindowedResponse &response : responses) {
        const Rounding rounding = roundingOf(response);
        list.push_back({response.shot, response.values, response.lead, response.length,
            response.sampleRate_Hz, response.noise, rounding.sd, rounding.lastingSd});
    }
    return list;
}

Result<double> reductionOf(const Source &source, double rate_Hz)
{
    if (const auto factor = reductionFactor(source.rate_Hz, rate_Hz))
        return *factor;
    return fail(ErrorKind::DataBlocked,
        Message{DYNCAL_TEXT("core",
                    "Model input: shot %1 is recorded at %2, below the model rate of %3; choose at "
                    "most %2."),
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

Eigen::VectorXd filteredNoise(const Source &source, const AntiAliasFilter &filter)
{
    const Index half = filter.halfLength();
    const Index count = outputCount(filter, half, source.noise.size() - 1);
    return count >= 8 ? decimate(source.noise, filter, half, count) : Eigen::VectorXd();
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

/// Of the mean of a noise record: its spectral density at frequency 0 over its length.
double uncertaintyOfMean(const NoiseCovariance &noise)
{
    if (noise.count == 0)
        return 0.0;
    const AutoregressiveModel model
        = chooseAutoregressiveModels({noise}, kLargestNoiseModelOrder).front();
    return std::sqrt(model.innovationVariance / static_cast<double>(noise.count))
        / std::abs(1.0 + model.coefficients.sum());
}

/// What the errors of rounding are like in a response of so many samples, which the record before
/// the start does not tell: from sample to sample another one where it moves, one and the same for
/// long where it comes to rest (docs/method/order.md).
NoiseCovariance withRounding(
    const NoiseCovariance &noise, double leastSd, double lastingSd, Index samples)
{
    constexpr double kShareAlike = 0.1; // of the response, in which these errors are alike
    NoiseCovariance result = noise;
    if (noise.count == 0)
        return result;
    const double length = kShareAlike * static_cast<double>(samples);
    for (Index lag = 0; lag < result.values.size(); ++lag)
        result.values[lag] = lastingSd * lastingSd * std::exp(-static_cast<double>(lag) / length);
    result.values[0] += std::max(noise.values[0], leastSd * leastSd);
    return result;
}

struct Cut
{
    double offset_s = 0.0;
    Index samples = 0;
};

ModelSeries makeSeries(
    const Source &source, const AntiAliasFilter &filter, Index first, const Cut &cut)
{
    ModelSeries series;
    series.shot = source.shot;
    series.filter = filter;
    series.y = decimate(source.values, filter, first, cut.samples);
    series.first_s = static_cast<double>(first - source.lead) / source.rate_Hz;
    series.noise = filteredNoise(source, filter);
    series.fullRateNoiseSd = std::max(standardDeviation(source.noise), source.leastNoiseSd);
    series.fullRateNoise = noiseCovariance(source.noise, kLargestNoiseModelOrder);
    series.roundingSd = source.roundingSd;
    series.u_baseline = std::hypot(uncertaintyOfMean(series.fullRateNoise), series.roundingSd);
    series.noiseSd = std::hypot(series.noise.size() ? standardDeviation(series.noise)
                                                    : series.fullRateNoiseSd * filter.taps.norm(),
        series.roundingSd);
    const Index last = first
        + static_cast<Index>(
            std::floor(static_cast<double>(cut.samples - 1) * filter.factor + 1e-9));
    series.fullRate = source.values.segment(source.lead, last - source.lead + 1);
    series.fullRate_Hz = source.rate_Hz;
    if (roundingCounts(series))
        series.fullRateNoise = withRounding(
            series.fullRateNoise, source.leastNoiseSd, source.roundingSd, series.fullRate.size());
    return series;
}

/// Share of the ringing's energy that lies before the first sample of the input, noise taken off.
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

Message tooFewSamples(Index shot, Index found, Index needed)
{
    return {DYNCAL_TEXT("core",
                "Model input: shot %1 offers %2 samples before its window ends, %3 are asked for; "
                "lengthen the window or ask for fewer samples."),
        {std::to_string(shot), std::to_string(found), std::to_string(needed)}};
}

constexpr Index kFewestSamples = 12; ///< a Hankel matrix of 5 rows

} // namespace

bool roundingCounts(const ModelSeries &series)
{
    constexpr double kShare = 0.1; // of the noise
    return series.roundingSd > kShare * series.noiseSd;
}

Result<ModelInput> prepareModelInput(const std::vector<WindowedResponse> &responses,
    const SpectrumResult &spectrum, const ComponentResult &components,
    const InputSettings &settings, const JobControl &control)
{
    ModelInput input;
    input.treatment = settings.treatment;
    input.combine = settings.effectiveCombine();
    const std::vector<Source> list = sources(responses, components, input.combine);

    const SensorTraits traits = sensorTraits(responses, spectrum);
    double lowestRate_Hz = list.front().rate_Hz;
    for (const Source &source : list)
        lowestRate_Hz = std::min(lowestRate_Hz, source.rate_Hz);
    input.sampleRate_Hz = settings.sampleRate_Hz.value
        ? *settings.sampleRate_Hz.value
        : lowestRate_Hz / static_cast<double>(chooseReduction(lowestRate_Hz, traits));
    if (auto findings = judgeRate(input.sampleRate_Hz, traits))
        input.findings = std::move(*findings);
    else
        return tl::unexpected(findings.error());
    if (traits.resonance_Hz)
        input.samplesPerPeriod = input.sampleRate_Hz / *traits.resonance_Hz;

    std::vector<AntiAliasFilter> filters;
    double filterHalf_s = 0.0;
    for (const Source &source : list) {
        const auto factor = reductionOf(source, input.sampleRate_Hz);
        if (!factor)
            return tl::unexpected(factor.error());
        filters.push_back(designAntiAliasFilter(*factor, source.rate_Hz));
        filterHalf_s = std::max(filterHalf_s, filters.back().span_s() / 2.0);
    }

    // A centred filter sees nothing of the time before the start once half of it lies behind the
    // sample's own time: the whole filter, both halves, then lies behind the onset.
    Cut cut;
    cut.offset_s = settings.offset_s.value.value_or(filterHalf_s);
    if (cut.offset_s < filterHalf_s * (1.0 - 1e-9))
        input.findings.push_back(insideFilterFinding(cut.offset_s, filterHalf_s));

    std::vector<Index> firsts;
    Index available = 0;
    Index scarcest = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Index first
            = list[i].lead + static_cast<Index>(std::ceil(cut.offset_s * list[i].rate_Hz - 1e-6));
        if (first < filters[i].halfLength()) {
            return fail(ErrorKind::DataBlocked,
                Message{DYNCAL_TEXT("core",
                            "Model input: shot %1 has %2 samples before the input starts, the "
                            "anti-alias filter needs %3; start later or raise the model rate."),
                    {std::to_string(list[i].shot), std::to_string(first),
                        std::to_string(filters[i].halfLength())}},
                "MIN-006", list[i].shot);
        }
        firsts.push_back(first);
        const Index here = availableSamples(list[i], filters[i], first);
        if (i == 0 || here < available) {
            available = here;
            scarcest = list[i].shot;
        }
    }
    cut.samples = settings.samples.value.value_or(
        std::min(available, chooseSamples(input.sampleRate_Hz, traits)));
    if (cut.samples > available || available < kFewestSamples)
        return fail(ErrorKind::DataBlocked,
            tooFewSamples(scarcest, available, std::max(cut.samples, kFewestSamples)), "MIN-005",
            scarcest);

    for (std::size_t i = 0; i < list.size(); ++i) {
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {});
        input.series.push_back(makeSeries(list[i], filters[i], firsts[i], cut));
    }
    nameLevels(responses, input.series);
    input.offset_s = input.series.front().first_s;
    input.samples = cut.samples;
    input.lostResponse_percent = lostResponse_percent(input);
    if (isStepTreatment(input.treatment) && input.treatment == ResponseTreatment::StepAsImpulse)
        input.findings.push_back({"MIN-004", Severity::Info, 0, {}, {},
            {DYNCAL_TEXT("core",
                 "The step is treated as an impulse response (thesis method): one extra order "
                 "models the step itself."),
                {}},
            {}, {}});
    return input;
}

} // namespace dyncal
