// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/sensor_response.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/base/propagation.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/record_response.h"
#include "core/model_analysis/sensor_record.h"
#include "core/model_analysis/shot_levels.h"
#include "core/model_analysis/step_transform.h"
#include "core/model_analysis/unwrapped_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace dyncal {
namespace {

constexpr double kLargestNoise = 0.1; ///< of the magnitude: with more, the data are useless
constexpr double kHighestOfRate = 0.4;
constexpr double kLargestBound = 0.02; ///< of the magnitude: with more, a value is withheld
constexpr Index kCurvePoints = 600;
constexpr double kRoundingOfLimit = 1e-9;

double inputSpan_s(const ModelInput &input)
{
    return input.offset_s + static_cast<double>(input.samples) / input.sampleRate_Hz;
}

/// Whether the response is in the DUT's unit per pascal: the recipe asks for it, all shots have one
/// unit, and every step is known.
bool isPerPressure(const std::vector<WindowedResponse> &responses, const ShockConditionsSet &shock,
    const ResponseSettings &settings)
{
    return settings.reference == "computed-step" && shareOneUnit(responses)
        && std::all_of(responses.begin(), responses.end(), [&](const WindowedResponse &response) {
               const ShockConditions *conditions = shock.ofShot(response.shot);
               return conditions && conditions->step_Pa;
           });
}

/// The step as the record has it: the mean of its last tenth.
double levelOfRecord(const SensorRecord &record)
{
    return transformEnds(record.values, 0).back().level;
}

/// What S(f) takes of the shots; relative to the pressure step or to each record's own.
RecordResponse recordResponse(const std::vector<WindowedResponse> &responses,
    const ModelInput &input, const SensorModel &model, const ShockConditionsSet &shock,
    bool isAbsolute, const DriftResult &drift)
{
    std::vector<RecordOfShot> shots;
    for (const WindowedResponse &response : responses) {
        const SeriesFit *fit = fitOfShot(model, response.shot);
        RecordOfShot shot{&response, sensorRecord(response, model, fit, drift)};
        shot.scale = isAbsolute ? response.valueScale / *shock.ofShot(response.shot)->step_Pa
                                : 1.0 / levelOfRecord(shot.record);
        if (fit)
            shot.onset_s = fit->onset_s;
        if (fit)
            shot.u_onset_s = fit->u_onset_s;
        shots.push_back(std::move(shot));
    }
    return {std::move(shots), inputSpan_s(input), input.front};
}

Eigen::VectorXd frequencyGrid(const ResponseSettings &settings, double low_Hz, double high_Hz)
{
    std::vector<double> list;
    if (settings.grid == "list") {
        list = settings.frequencies_Hz;
    } else if (settings.grid == "linear") {
        for (Index k = 1; k <= settings.linearCount; ++k) {
            list.push_back(low_Hz
                + (high_Hz - low_Hz) * static_cast<double>(k)
                    / static_cast<double>(settings.linearCount));
        }
    } else {
        // Base-ten third octaves, ISO 266: 10^(k/10).
        for (int k = static_cast<int>(std::ceil(10.0 * std::log10(low_Hz) - 1e-9));
             k <= static_cast<int>(std::floor(10.0 * std::log10(high_Hz) + 1e-9)); ++k)
            list.push_back(std::pow(10.0, k / 10.0));
    }
    return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Index>(list.size()));
}

double lowestRate_Hz(const std::vector<WindowedResponse> &responses)
{
    double rate_Hz = responses.front().sampleRate_Hz;
    for (const WindowedResponse &response : responses)
        rate_Hz = std::min(rate_Hz, response.sampleRate_Hz);
    return rate_Hz;
}

double shortestWindow_s(const std::vector<WindowedResponse> &responses)
{
    double window_s = std::numeric_limits<double>::infinity();
    for (const WindowedResponse &response : responses)
        window_s
            = std::min(window_s, static_cast<double>(response.length) / response.sampleRate_Hz);
    return window_s;
}

/// Upper end of the band: the last third-octave point before the noise takes over.
double upperLimit_Hz(const RecordResponse &records, double low_Hz, double rate_Hz)
{
    double limit_Hz = low_Hz;
    for (double f = low_Hz; f <= kHighestOfRate * rate_Hz; f *= std::pow(10.0, 0.1)) {
        const RecordResponse::Point point = records.at(f);
        if (std::hypot(point.u_magnitude, point.u_front) > kLargestNoise * point.magnitude)
            return limit_Hz;
        limit_Hz = f;
    }
    return kHighestOfRate * rate_Hz;
}

CharacteristicsGap gapOf(const SensorModel &model, bool isStep)
{
    if (!isStep)
        return CharacteristicsGap::FreeDecay;
    if (model.diverges)
        return CharacteristicsGap::Diverges;
    return isLevelKnown(model) ? CharacteristicsGap::None : CharacteristicsGap::LevelUnknown;
}

/// Where the answers end. The refinement fits the records at their own rate, but the poles that it
/// starts from are those that the model's rate can hold.
void setLimits(const std::vector<WindowedResponse> &responses, const ModelInput &input,
    const SensorModel &model, ResponseResult &result)
{
    const double rate_Hz = lowestRate_Hz(responses);
    const bool isStep = isStepTreatment(input.treatment);
    result.window_s = shortestWindow_s(responses);
    result.modelLimit_Hz = 0.5 * input.sampleRate_Hz;
    result.resolution_s = 1.0 / (model.refined ? rate_Hz : input.sampleRate_Hz);
    result.fLow_Hz = 1.0 / result.window_s;
    result.fHigh_Hz = kHighestOfRate * rate_Hz;
    if (!isStep)
        result.fHigh_Hz = std::min(result.fHigh_Hz, result.modelLimit_Hz);
    result.gap = gapOf(model, isStep);
}

/// The larger bound decides why a value is withheld; none where noise alone is larger.
WithheldReason reasonOf(const RecordResponse::Point &point)
{
    if (!std::isfinite(point.magnitude)
        || point.bound() <= std::max(point.u_magnitude, kLargestBound * point.magnitude))
        return WithheldReason::None;
    return point.boundEnd > point.boundAlias ? WithheldReason::End : WithheldReason::Alias;
}

/// Of the bounds, each taken for the half width of a rectangular distribution.
double ofBounds(const RecordResponse::Point &point)
{
    return std::hypot(point.boundEnd, point.boundAlias) / std::sqrt(3.0);
}

void state(const RecordResponse::Point &point, Index k, ResponseResult &result)
{
    result.length_s[k] = point.length_s;
    result.boundEnd[k] = point.boundEnd;
    result.boundAlias[k] = point.boundAlias;
    const WithheldReason reason = reasonOf(point);
    result.withheld[static_cast<std::size_t>(k)] = reason;
    if (reason != WithheldReason::None)
        return;
    result.magnitude[k] = point.magnitude;
    result.u_noiseMagnitude[k] = point.u_magnitude;
    result.u_frontMagnitude[k] = point.u_front;
    result.u_magnitude[k] = std::hypot(point.u_magnitude, ofBounds(point), point.u_front);
    // Only that of the noise rests on a record (Welch-Satterthwaite).
    const double u = result.u_magnitude[k];
    const double noiseShare = u > 0.0 ? point.u_magnitude / u : 0.0;
    result.dof[k] = point.dof / std::pow(noiseShare, 4);
    // The branch nearest the model's unwrapped phase, because points may lie far apart.
    const double reference = result.modelPhase_rad[k];
    result.phase_rad[k] = reference + std::remainder(point.phase_rad - reference, kTwoPi);
    result.u_noisePhase_rad[k] = point.u_phase_rad;
    result.u_phase_rad[k] = std::hypot(point.u_phase_rad, ofBounds(point) / point.magnitude);
}

/// No values above 0.4 of the slowest record's rate: S(f) of samples repeats itself there.
void measure(const RecordResponse &records, double rate_Hz, ResponseResult &result)
{
    const Index count = result.frequency_Hz.size();
    for (auto *values :
        {&result.magnitude, &result.u_magnitude, &result.u_noiseMagnitude, &result.u_frontMagnitude,
            &result.phase_rad, &result.u_phase_rad, &result.u_noisePhase_rad, &result.dof,
            &result.boundEnd, &result.boundAlias, &result.length_s})
        values->setConstant(count, kUnknown);
    result.withheld.assign(static_cast<std::size_t>(count), WithheldReason::AboveRate);
    for (Index k = 0; k < count; ++k)
        if (result.frequency_Hz[k] <= (1.0 + kRoundingOfLimit) * kHighestOfRate * rate_Hz)
            state(records.at(result.frequency_Hz[k]), k, result);
}

/// A magnitude has no sign: an inverted sensor begins at half a turn. A model whose own gain is
/// negative has that half turn already.
double turnOf_rad(const SensorModel &model, double scale)
{
    if (scale >= 0.0)
        return 0.0;
    return model.level() < 0.0 ? -std::numbers::pi : std::numbers::pi;
}

/// The model's drift is known over its input only: it gives way to what the whole record shows of
/// a drift of the sensor's chain, and to nothing for heat, which acts on the sensor's face.
void exchangeDrift(const SensorModel &model, ResponseResult &result)
{
    const auto exchange
        = [&](const Eigen::VectorXd &f_Hz, Eigen::VectorXd &magnitude, Eigen::VectorXd &phase_rad) {
              for (Index k = 0; k < f_Hz.size(); ++k) {
                  const std::complex<double> change
                      = result.drift.keptAt(f_Hz[k]) / modelledDrift(model, f_Hz[k]);
                  magnitude[k] *= std::abs(change);
                  phase_rad[k] += std::arg(change);
              }
          };
    exchange(result.frequency_Hz, result.modelMagnitude, result.modelPhase_rad);
    exchange(
        result.modelCurve.frequency_Hz, result.modelCurve.magnitude, result.modelCurve.phase_rad);
}

void describeModel(
    const SensorModel &model, ResponseTreatment treatment, double scale, ResponseResult &result)
{
    const Index count = result.frequency_Hz.size();
    result.modelMagnitude.resize(count);
    result.modelPhase_rad.resize(count);
    const bool isStep = isStepTreatment(treatment);
    const double top_Hz = isStep
        ? 1.25 * std::max(count ? result.frequency_Hz.maxCoeff() : result.fHigh_Hz, result.fHigh_Hz)
        : result.fHigh_Hz; // nothing measured stands beside the model there
    result.modelCurve = modelCurve(model, treatment, result.fLow_Hz, top_Hz, kCurvePoints);
    const double turn_rad = turnOf_rad(model, scale);
    result.modelCurve.magnitude *= std::abs(scale);
    result.modelCurve.phase_rad.array() += turn_rad;
    UnwrappedPhase phase(model, treatment);
    for (Index k = 0; k < count; ++k) {
        const double f_Hz = result.frequency_Hz[k];
        if (!isStep && !(f_Hz <= (1.0 + kRoundingOfLimit) * result.modelLimit_Hz)) {
            result.modelMagnitude[k] = result.modelPhase_rad[k] = kUnknown;
            continue;
        }
        result.modelMagnitude[k] = std::abs(scale * modelResponse(model, treatment, f_Hz));
        result.modelPhase_rad[k] = phase.at(f_Hz) + turn_rad;
    }
    if (!result.drift.shots.empty())
        exchangeDrift(model, result);
}

/// Compares the two independent answers and reports where they differ beyond their uncertainty.
void compareAnswers(ResponseResult &result)
{
    constexpr double kCoverage = 4.0;
    constexpr double kModelShare = 0.02; // allowed error of the model itself
    for (Index k = 0; k < result.magnitude.size(); ++k) {
        const double difference = std::abs(result.magnitude[k] - result.modelMagnitude[k]);
        const double limit = kCoverage * result.u_noiseMagnitude[k] + result.boundEnd[k]
            + result.boundAlias[k] + kModelShare * result.modelMagnitude[k];
        if (difference > limit) {
            result.findings.push_back({.id = "RSP-001",
                .severity = Severity::Caution,
                .message
                = {DYNCAL_TEXT("core",
                       "At %1 the response taken from the data directly differs by %2 % from the model, more than noise allows: the model misses something there."),
                    {numberWithUnit(result.frequency_Hz[k], "Hz", 3),
                        numberText(100.0 * difference / result.modelMagnitude[k], 2)}},
                .value = difference,
                .limit = limit});
            return;
        }
    }
}

/// Says once for each of the two bounds at which frequencies nothing is stated.
void reportWithheld(
    WithheldReason reason, const char *id, const char *words, ResponseResult &result)
{
    Index count = 0;
    double lowest_Hz = std::numeric_limits<double>::infinity();
    double highest_Hz = 0.0;
    for (std::size_t k = 0; k < result.withheld.size(); ++k) {
        if (result.withheld[k] != reason)
            continue;
        const double f_Hz = result.frequency_Hz[static_cast<Index>(k)];
        lowest_Hz = std::min(lowest_Hz, f_Hz);
        highest_Hz = std::max(highest_Hz, f_Hz);
        ++count;
    }
    if (count == 0)
        return;
    result.findings.push_back({.id = id,
        .severity = Severity::Info,
        .message = {words,
            {std::to_string(count), std::to_string(result.withheld.size()),
                numberWithUnit(lowest_Hz, "Hz", 3), numberWithUnit(highest_Hz, "Hz", 3)}},
        .value = static_cast<double>(count)});
}

void reportWithheld(ResponseResult &result)
{
    reportWithheld(WithheldReason::End, "RSP-003",
        DYNCAL_TEXT("core",
            "The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: what the end of the record cuts off may change it there by more than its noise and 2 %. Use a longer window, or only what the model says there."),
        result);
    reportWithheld(WithheldReason::Alias, "RSP-004",
        DYNCAL_TEXT("core",
            "The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the sampling may change it there by more than its noise and 2 %. Record at a higher rate, or use only what the model says there."),
        result);
}

/// A list is computed as given; below the band the values depend on the plateau by which the
/// records are continued, not on recorded samples.
void reportBelowBand(ResponseResult &result)
{
    if (result.frequency_Hz.size() == 0)
        return;
    const double lowest_Hz = result.frequency_Hz.minCoeff();
    if (lowest_Hz >= result.fLow_Hz * (1.0 - 1e-9))
        return;
    result.findings.push_back({.id = "WIN-005",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The shortest window, %1, resolves steps of %2, but the response is asked for from %3: below %2 it is not measured. Lengthen the window or take these frequencies out of response.frequencies_hz."),
            {numberWithUnit(1.0 / result.fLow_Hz, "s", 4), numberWithUnit(result.fLow_Hz, "Hz", 4),
                numberWithUnit(lowest_Hz, "Hz", 4)}},
        .value = lowest_Hz,
        .limit = result.fLow_Hz});
}

void takeShots(ShotSensitivities &&found, ResponseResult &result)
{
    result.shots = std::move(found.shots);
    result.summary = std::move(found.summary);
    if (!result.shots.empty())
        result.sensitivityUnit = result.shots.back().unit;
    if (result.summary.mean)
        result.sensitivity = result.summary.mean->value;
    result.findings.insert(result.findings.end(), found.findings.begin(), found.findings.end());
}

/// From the model's unit (remapped, the level of the step) to that of the response.
double scaleOf(
    const SensorModel &model, bool isStep, bool isAbsolute, const ResponseResult &response)
{
    if (!isStep || model.level() == 0.0)
        return 1.0;
    return isAbsolute && response.sensitivity ? *response.sensitivity / model.level()
                                              : 1.0 / model.level();
}

} // namespace

double coverageFactorAt(const ResponseResult &response, Index row)
{
    constexpr double kCoverageOfRows = 0.95;
    const double dof = row < response.dof.size() ? response.dof[row] : kUnknown;
    return dof > 0.0 ? coverageFactor(dof, kCoverageOfRows) : kUnknown;
}

ResponseResult computeModelResponse(const std::vector<WindowedResponse> &responses,
    const ModelInput &input, const SensorModel &model, const ShockConditionsSet &shock,
    const ResponseSettings &settings, double from_Hz, double to_Hz)
{
    ResponseResult result;
    result.fLow_Hz = from_Hz;
    result.fHigh_Hz = to_Hz;
    const bool isStep = isStepTreatment(input.treatment);
    const bool isAbsolute = isPerPressure(responses, shock, settings);
    if (isStep) {
        result.drift = findDrift(responses, model, inputSpan_s(input));
        takeShots(describeShots(responses, model, shock), result);
    }
    result.unit = isStep && isAbsolute ? result.sensitivityUnit : "1";
    if (!model.diverges)
        describeModel(model, input.treatment, scaleOf(model, isStep, isAbsolute, result), result);
    return result;
}

Result<ResponseResult> computeResponse(const std::vector<WindowedResponse> &responses,
    const ModelInput &input, const SensorModel &model, const ShockConditionsSet &shock,
    const ResponseSettings &settings)
{
    ResponseResult result;
    const bool isStep = isStepTreatment(input.treatment);
    const double rate_Hz = lowestRate_Hz(responses);
    setLimits(responses, input, model, result);
    result.front = input.front;
    if (isLevelKnown(model))
        result.characteristics = stepCharacteristics(model, input.treatment);

    const bool isAbsolute = isPerPressure(responses, shock, settings);
    if (isStep)
        result.drift = findDrift(responses, model, inputSpan_s(input));
    std::optional<RecordResponse> records;
    if (isStep) {
        takeShots(describeShots(responses, model, shock), result);
        records.emplace(recordResponse(responses, input, model, shock, isAbsolute, result.drift));
        result.fHigh_Hz = upperLimit_Hz(*records, result.fLow_Hz, rate_Hz);
    }
    result.unit = isStep && isAbsolute ? result.sensitivityUnit : "1";
    result.frequency_Hz = frequencyGrid(settings, result.fLow_Hz, result.fHigh_Hz);
    reportBelowBand(result);
    if (!model.diverges)
        describeModel(model, input.treatment, scaleOf(model, isStep, isAbsolute, result), result);
    if (isStep && !model.diverges) {
        measure(*records, rate_Hz, result);
        reportWithheld(result);
        compareAnswers(result);
    }
    return result;
}

} // namespace dyncal
