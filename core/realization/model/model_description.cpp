// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_description.h"

#include "core/base/constants.h"
#include "core/realization/exponentials/pole_mapping.h"
#include "core/realization/input/left_out.h"
#include "core/realization/model/pole_classes.h"
#include "core/realization/model/series_fit.h"
#include "core/realization/model/step_level.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "core/realization/refinement/series_simulation.h"

#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

/// The series share their poles.
void addTo(ExponentialSum &sum, const ExponentialSum &one, double weight)
{
    if (sum.poles_rad_s.size() == 0)
        sum = {1.0, one.poles_rad_s, Eigen::VectorXcd::Zero(one.amplitudes.size())};
    sum.amplitudes += weight * one.amplitudes;
}

void poolFits(const ModelInput &input, SensorModel &model)
{
    double error = 0.0;
    double noise = 0.0;
    double spread = 0.0;
    bool noiseKnown = true;
    for (std::size_t r = 0; r < model.series.size(); ++r) {
        const SeriesFit &fit = model.series[r];
        const ModelSeries &series = input.series[r];
        const Eigen::VectorXd counted = countedValues(series, series.y);
        error += countedValues(series, fit.error).squaredNorm();
        noise += series.noiseSd * series.noiseSd * static_cast<double>(counted.size());
        spread += spreadSquares(counted);
        noiseKnown = noiseKnown && std::isfinite(fit.fitAttainable_percent);
    }
    model.fit_percent = fitPercent(error, spread);
    model.fitAttainable_percent = noiseKnown ? fitPercent(noise, spread) : kUnknown;
}

Pole makePole(std::complex<double> z, std::complex<double> s, PoleClass poleClass)
{
    Pole pole;
    pole.z = z;
    pole.s_rad_s = s;
    pole.poleClass = poleClass;
    pole.frequency_Hz = std::abs(s) / (2.0 * std::numbers::pi);
    pole.dampingRatio = std::abs(s) > 0.0 ? -s.real() / std::abs(s) : 0.0;
    return pole;
}

/// Sensor states first; in thesis mode the step's own pole joins them in the list.
std::vector<Pole> listPoles(const ModelInput &input, const ModelDraft &draft,
    const std::vector<bool> &standsOut, std::optional<std::complex<double>> stepPole)
{
    const double dt_s = sampleInterval_s(input);
    const auto z = discretePoles(draft.poles_rad_s, dt_s);
    const std::vector<PoleClass> classes
        = classifyPoles(z, ResponseTreatment::StepDeflated, standsOut);
    std::vector<Pole> poles;
    for (std::size_t i = 0; i < z.size(); ++i) {
        poles.push_back(makePole(z[i], draft.poles_rad_s[i], classes[i]));
        if (!standsOut[i])
            poles.back().flags.push_back(kBelowNoiseFlag);
    }
    if (stepPole)
        poles.push_back(makePole(*stepPole, continuousPole(*stepPole, dt_s), PoleClass::Step));
    return poles;
}

void describeAmplitudes(SensorModel &model)
{
    // model.amplitudes follow the sensor's poles, which are listed before the step's.
    for (Index i = 0; i < model.amplitudes.size(); ++i)
        model.poles[static_cast<std::size_t>(i)].amplitude = std::abs(model.amplitudes[i]);
}

} // namespace

void poolShapes(const ModelInput &input, SensorModel &model)
{
    double weights = 0.0;
    double level = 0.0;
    Eigen::VectorXcd shape = Eigen::VectorXcd::Zero(model.series.front().amplitudes.size());
    const bool isStep = isStepTreatment(input.treatment);
    for (std::size_t r = 0; r < model.series.size(); ++r) {
        const SeriesFit &fit = model.series[r];
        const ModelSeries &series = input.series[r];
        // Each shot counts in units of its own plateau: shots of different height have the same
        // shape.
        const double unit = isStep ? fit.level() : 1.0;
        const double relativeNoise = series.noiseSd / unit;
        const double weight = relativeNoise != 0.0 ? 1.0 / (relativeNoise * relativeNoise) : 1.0;
        weights += weight;
        model.plateauGain += weight * fit.plateauGain;
        level += weight * fit.level();
        if (!model.slowPoles.empty())
            addTo(model.sensorStep, fit.sensorStep, weight);
        // Free decays start at arbitrary phases, so magnitudes are pooled, with the phases of the
        // first shot.
        const Eigen::ArrayXcd amplitudes = fit.amplitudes.array();
        if (isStep)
            shape.array() += weight * amplitudes / unit;
        else
            shape.array() += weight * amplitudes.abs()
                * (model.series.front().amplitudes.array().arg() * std::complex<double>(0.0, 1.0))
                      .exp();
    }
    model.plateauGain /= weights;
    if (!model.slowPoles.empty())
        model.stepLevel = level / weights;
    model.amplitudes = shape / weights * (isStep ? model.level() : 1.0);
    model.sensorStep.amplitudes /= weights;
}

void describeModel(const ModelInput &input, const ModelDraft &draft,
    std::optional<std::complex<double>> stepPole, SensorModel &model)
{
    const std::vector<bool> standsOut = standingOut(input, draft);
    model.poles = listPoles(input, draft, standsOut, stepPole);
    for (std::size_t r = 0; r < input.series.size(); ++r)
        model.series.push_back(describeSeries(input, draft, r, standsOut, model.stateSpace));
    describeStepLevel(input, draft, standsOut, model);
    poolFits(input, model);
    poolShapes(input, model);
    describeAmplitudes(model);
}

void addUncertainties(const ModelDraft &draft, std::vector<Pole> &poles)
{
    if (!draft.refinement)
        return;
    const double k = coverageFactor95(draft.noise.dof);
    for (std::size_t i = 0; i < draft.poles_rad_s.size(); ++i) {
        const PoleFigures figures = poleFigures(*draft.refinement, static_cast<Index>(i));
        poles[i].u_frequency_Hz = figures.u_frequency_Hz;
        poles[i].u_dampingRatio = figures.u_dampingRatio;
        poles[i].coverageFactor = k;
    }
}

} // namespace dyncal
