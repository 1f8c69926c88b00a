// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/sensor_response.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/base/propagation.h"
#include "core/model_analysis/chain_correction.h"
#include "core/model_analysis/marked_frequencies.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/record_response.h"
#include "core/model_analysis/response_findings.h"
#include "core/model_analysis/response_rows.h"
#include "core/model_analysis/sensor_record.h"
#include "core/model_analysis/shot_levels.h"
#include "core/model_analysis/step_transform.h"
#include "core/model_analysis/table_band.h"
#include "core/model_analysis/transducer_response.h"
#include "core/model_analysis/unwrapped_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

namespace dyncal {
namespace {

constexpr double kLargestNoise = 0.1; ///< of the magnitude: with more, the data are useless
constexpr double kHighestOfRate = 0.4;
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
    return (settings.reference == "computed-step" || settings.isByTransducer())
        && shareOneUnit(responses)
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

/// What S(f) takes of the shots, in physical values.
std::vector<RecordOfShot> recordsOf(const std::vector<WindowedResponse> &responses,
    const SensorModel &model, const DriftResult &drift)
{
    std::vector<RecordOfShot> shots;
    for (const WindowedResponse &response : responses) {
        const SeriesFit *fit = fitOfShot(model, response.shot);
        RecordOfShot shot{&response, sensorRecord(response, model, fit, drift)};
        shot.scale = response.valueScale;
        if (fit)
            shot.onset_s = fit->onset_s;
        if (fit)
            shot.u_onset_s = fit->u_onset_s;
        shots.push_back(std::move(shot));
    }
    return shots;
}

/// Relative to the pressure step or to each record's own.
std::unique_ptr<ResponseSource> byStep(std::vector<RecordOfShot> shots, const ModelInput &input,
    const ShockConditionsSet &shock, bool isAbsolute)
{
    for (RecordOfShot &shot : shots)
        shot.scale = isAbsolute ? shot.scale / *shock.ofShot(shot.response->shot)->step_Pa
                                : 1.0 / levelOfRecord(shot.record);
    return std::make_unique<RecordResponse>(std::move(shots), inputSpan_s(input), input.front);
}

/// What rings in the tube is in both records, and no nuisance of the ratio.
std::unique_ptr<ResponseSource> byTransducer(const std::vector<WindowedResponse> &responses,
    const ModelInput &input, SensorModel model, const DriftResult &drift,
    const ReferenceRecords &reference)
{
    model.nuisance.clear();
    return std::make_unique<TransducerResponse>(
        recordsOf(responses, model, drift), inputSpan_s(input), reference);
}

/// Between two records the onset does not matter.
std::unique_ptr<ResponseSource> withoutChain(std::unique_ptr<ResponseSource> records,
    const ReferenceSensitivity &chain, const ResponseResult &result)
{
    const double u_delay_s
        = result.isByTransducer ? 0.0 : uOnsetBehind(chain, result.fLow_Hz, result.fHigh_Hz);
    return std::make_unique<ChainCorrected>(std::move(records), chain, u_delay_s);
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

/// Upper end of the band: the last third-octave point before the noise takes over, if it does.
void endByNoise(const ResponseSource &records, ResponseResult &result)
{
    double limit_Hz = result.fLow_Hz;
    for (double f = result.fLow_Hz; f <= result.fHigh_Hz; f *= std::pow(10.0, 0.1)) {
        const ResponsePoint point = records.at(f);
        if (std::hypot(point.u_magnitude, point.u_front) > kLargestNoise * point.magnitude) {
            result.fHigh_Hz = limit_Hz;
            result.highEnd = BandEnd::Noise;
            return;
        }
        limit_Hz = f;
    }
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
    if (!isStep && result.modelLimit_Hz < result.fHigh_Hz) {
        result.fHigh_Hz = result.modelLimit_Hz;
        result.highEnd = BandEnd::ModelRate;
    }
    result.gap = gapOf(model, isStep);
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
void exchangeDrift(const SensorModel &model, const DriftResult &drift, const Eigen::VectorXd &f_Hz,
    Eigen::VectorXd &magnitude, Eigen::VectorXd &phase_rad)
{
    if (drift.shots.empty())
        return;
    for (Index k = 0; k < f_Hz.size(); ++k) {
        const std::complex<double> change = drift.keptAt(f_Hz[k]) / modelledDrift(model, f_Hz[k]);
        magnitude[k] *= std::abs(change);
        phase_rad[k] += std::arg(change);
    }
}

/// The model's answer at result.frequency_Hz.
void describeRows(
    const SensorModel &model, ResponseTreatment treatment, double scale, ResponseResult &result)
{
    const Index count = result.frequency_Hz.size();
    result.modelMagnitude.resize(count);
    result.modelPhase_rad.resize(count);
    const double turn_rad = turnOf_rad(model, scale);
    UnwrappedPhase phase(model, treatment);
    for (Index k = 0; k < count; ++k) {
        const double f_Hz = result.frequency_Hz[k];
        if (!isStepTreatment(treatment)
            && !(f_Hz <= (1.0 + kRoundingOfLimit) * result.modelLimit_Hz)) {
            result.modelMagnitude[k] = result.modelPhase_rad[k] = kUnknown;
            continue;
        }
        result.modelMagnitude[k] = std::abs(scale * modelResponse(model, treatment, f_Hz));
        result.modelPhase_rad[k] = phase.at(f_Hz) + turn_rad;
    }
    exchangeDrift(
        model, result.drift, result.frequency_Hz, result.modelMagnitude, result.modelPhase_rad);
}

void describeCurve(
    const SensorModel &model, ResponseTreatment treatment, double scale, ResponseResult &result)
{
    const double top_Hz = isStepTreatment(treatment)
        ? 1.25
            * std::max(
                result.frequency_Hz.size() ? result.frequency_Hz.maxCoeff() : result.fHigh_Hz,
                result.fHigh_Hz)
        : result.fHigh_Hz; // nothing measured stands beside the model there
    ResponseCurve curve = modelCurve(model, treatment, result.fLow_Hz, top_Hz, kCurvePoints);
    curve.magnitude *= std::abs(scale);
    curve.phase_rad.array() += turnOf_rad(model, scale);
    exchangeDrift(model, result.drift, curve.frequency_Hz, curve.magnitude, curve.phase_rad);
    result.modelCurve = std::move(curve);
}

void describeModel(
    const SensorModel &model, ResponseTreatment treatment, double scale, ResponseResult &result)
{
    describeCurve(model, treatment, scale, result);
    describeRows(model, treatment, scale, result);
}

/// The response at the ends of the band, its edges, the resonance and where other calibrations
/// state a value: rows of their own, so that those asked for are what they are without them.
std::shared_ptr<const ResponseResult> measureMarks(const ResponseSource &records,
    const SensorModel &model, ResponseTreatment treatment, double scale, double highest_Hz,
    const ResponseSettings &settings, const ResponseResult &all, const ReferenceSensitivity *chain)
{
    auto marked = std::make_shared<ResponseResult>(all);
    marked->findings.clear();
    marked->modelCurve = {};
    markFrequencies(model, treatment, settings.known, *marked);
    describeRows(model, treatment, scale, *marked);
    if (chain)
        divideModel(*chain, *marked);
    measureRows(records, highest_Hz, *marked);
    return marked;
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
    const ResponseSettings &settings, double from_Hz, double to_Hz,
    const ReferenceSensitivity *chain)
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
    if (chain)
        divideModel(*chain, result);
    return result;
}

Result<ResponseResult> computeResponse(const std::vector<WindowedResponse> &responses,
    const ModelInput &input, const SensorModel &model, const ShockConditionsSet &shock,
    const ResponseSettings &settings, const ReferenceRecords *reference,
    const ReferenceSensitivity *chain)
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
    std::unique_ptr<ResponseSource> records;
    if (isStep) {
        takeShots(describeShots(responses, model, shock), result);
        if (settings.isByTransducer() && reference) {
            records = byTransducer(responses, input, model, result.drift, *reference);
            result.isByTransducer = true;
            endByTable(reference->sensitivity, BandEnd::Reference, result);
        } else {
            records = byStep(recordsOf(responses, model, result.drift), input, shock, isAbsolute);
        }
        if (chain) {
            endByTable(*chain, BandEnd::Chain, result);
            records = withoutChain(std::move(records), *chain, result);
        }
        endByNoise(*records, result);
    }
    result.unit = isStep && isAbsolute ? result.sensitivityUnit : "1";
    result.frequency_Hz = frequencyGrid(settings, result.fLow_Hz, result.fHigh_Hz);
    reportBelowBand(result);
    if (model.diverges)
        return result;
    const double scale = scaleOf(model, isStep, isAbsolute, result);
    describeModel(model, input.treatment, scale, result);
    if (chain)
        divideModel(*chain, result);
    if (isStep) {
        const double highest_Hz = kHighestOfRate * rate_Hz;
        measureRows(*records, highest_Hz, result);
        judgeRows(result);
        result.atMarks = measureMarks(
            *records, model, input.treatment, scale, highest_Hz, settings, result, chain);
    }
    return result;
}

} // namespace dyncal
