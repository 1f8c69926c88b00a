// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/sensor_model.h"

#include "core/realization/homogeneity.h"
#include "core/realization/left_out.h"
#include "core/realization/model_draft.h"
#include "core/realization/model_findings.h"
#include "core/realization/nuisance_modes.h"
#include "core/realization/nuisance_results.h"
#include "core/realization/pole_classes.h"
#include "core/realization/pole_uncertainty.h"
#include "core/realization/realized_poles.h"
#include "core/realization/second_order_beside.h"
#include "core/realization/second_order_fit.h"
#include "core/realization/series_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

void poolFits(const ModelInput &input, SensorModel &model)
{
    double error = 0.0;
    double noise = 0.0;
    double spread = 0.0;
    double weights = 0.0;
    bool noiseKnown = true;
    Eigen::VectorXcd shape = Eigen::VectorXcd::Zero(model.series.front().amplitudes.size());
    const bool isStep = isStepTreatment(input.treatment);
    for (std::size_t r = 0; r < model.series.size(); ++r) {
        const SeriesFit &fit = model.series[r];
        const ModelSeries &series = input.series[r];
        const Eigen::VectorXd counted = countedValues(series, series.y);
        error += countedValues(series, fit.error).squaredNorm();
        noise += series.noiseSd * series.noiseSd * static_cast<double>(counted.size());
        spread += spreadSquares(counted);
        noiseKnown = noiseKnown && std::isfinite(fit.fitAttainable_percent);
        // Each shot's own plateau is its unit: shots of different height share their shape.
        const double unit = isStep ? fit.plateauGain : 1.0;
        const double relativeNoise = series.noiseSd / unit;
        const double weight = relativeNoise != 0.0 ? 1.0 / (relativeNoise * relativeNoise) : 1.0;
        weights += weight;
        model.plateauGain += weight * fit.plateauGain;
        // Free decays start at an arbitrary phase: their sizes are pooled, the first one's phase
        // kept.
        const Eigen::ArrayXcd amplitudes = fit.amplitudes.array();
        if (isStep)
            shape.array() += weight * amplitudes / unit;
        else
            shape.array() += weight * amplitudes.abs()
                * (model.series.front().amplitudes.array().arg() * std::complex<double>(0.0, 1.0))
                      .exp();
    }
    model.plateauGain /= weights;
    model.amplitudes = shape / weights * (isStep ? model.plateauGain : 1.0);
    model.fit_percent = fitPercent(error, spread);
    model.fitAttainable_percent = noiseKnown ? fitPercent(noise, spread) : kUnknown;
}

double listingFit(const StateSpaceModel &stateSpace, const Eigen::VectorXd &y)
{
    // Appendix D compares y(1) with dimpulse's first value, D = 0: one sample late.
    return fitPercent((y - impulseResponse(stateSpace, y.size())).squaredNorm(), spreadSquares(y));
}

bool runsAway(const SensorModel &model, const ModelInput &input)
{
    constexpr double kTooLarge = 10.0;
    for (std::size_t r = 0; r < model.series.size(); ++r) {
        const double data = input.series[r].y.cwiseAbs().maxCoeff();
        const Eigen::VectorXd &simulated = model.series[r].simulated;
        if (!simulated.allFinite() || simulated.cwiseAbs().maxCoeff() > kTooLarge * data)
            return true;
    }
    return std::any_of(model.poles.begin(), model.poles.end(), [&](const Pole &pole) {
        return pole.poleClass == PoleClass::Unstable && isRunaway(pole.z, input.samples);
    });
}

void addUncertainties(const ModelDraft &draft, std::vector<Pole> &poles)
{
    if (!draft.refinement)
        return;
    const double k = coverageFactor95(draft.noise.dof);
    for (std::size_t i = 0; i < poles.size(); ++i) {
        const PoleFigures figures = poleFigures(*draft.refinement, static_cast<Index>(i));
        poles[i].u_frequency_Hz = figures.u_frequency_Hz;
        poles[i].u_dampingRatio = figures.u_dampingRatio;
        poles[i].coverageFactor = k;
    }
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
    const auto z = discretePoles(draft.rates_rad_s, dt_s);
    const std::vector<PoleClass> classes
        = classifyPoles(z, ResponseTreatment::StepDeflated, standsOut);
    std::vector<Pole> poles;
    for (std::size_t i = 0; i < z.size(); ++i) {
        poles.push_back(makePole(z[i], draft.rates_rad_s[i], classes[i]));
        if (!standsOut[i])
            poles.back().flags.push_back("below-noise");
    }
    addUncertainties(draft, poles);
    if (stepPole)
        poles.push_back(makePole(*stepPole, rateOf(*stepPole, dt_s), PoleClass::Step));
    return poles;
}

void describeAmplitudes(SensorModel &model)
{
    // model.amplitudes follow the sensor's poles, which are listed before the step's.
    for (Index i = 0; i < model.amplitudes.size(); ++i)
        model.poles[static_cast<std::size_t>(i)].amplitude = std::abs(model.amplitudes[i]);
}

/// Poles, series and what is pooled over them.
void describe(const ModelInput &input, const ModelDraft &draft,
    std::optional<std::complex<double>> stepPole, SensorModel &model)
{
    const std::vector<bool> standsOut = standingOut(input, draft);
    model.poles = listPoles(input, draft, standsOut, stepPole);
    for (std::size_t r = 0; r < input.series.size(); ++r)
        model.series.push_back(describeSeries(input, draft, r, standsOut, model.stateSpace));
    poolFits(input, model);
    describeAmplitudes(model);
}

/// The same poles refined with the nuisance modes left in the response, beside the model.
std::optional<NuisanceEffect> effectOfNuisance(const ModelInput &input,
    const std::vector<std::complex<double>> &realised_rad_s, const SensorModel &model,
    const JobControl &control)
{
    const ModelInput plain = withModesLeftIn(input);
    ModelDraft draft = linearDraft(plain, discretePoles(realised_rad_s, sampleInterval_s(plain)));
    refineDraft(plain, draft, control);
    if (!draft.refinement)
        return std::nullopt;
    SensorModel before;
    describe(plain, draft, std::nullopt, before);
    return NuisanceEffect{effectSide(input, before), effectSide(input, model)};
}

/// ZOH-equivalent G(z) = c0 + sum c_i (z - 1)/(z - p_i); of a free decay F(z) = sum c_i/(z - p_i).
StateSpaceModel describeStateSpace(const ModelInput &input, const SensorModel &model)
{
    std::vector<std::complex<double>> z;
    for (Index i = 0; i < model.amplitudes.size(); ++i)
        z.push_back(model.poles[static_cast<std::size_t>(i)].z);
    Eigen::VectorXcd residues = model.amplitudes;
    double feedthrough = 0.0;
    if (isStepTreatment(input.treatment)) {
        for (Index i = 0; i < residues.size(); ++i)
            residues[i] *= z[static_cast<std::size_t>(i)] - 1.0;
        feedthrough = model.plateauGain + model.amplitudes.sum().real();
    }
    return modalStateSpace(z, residues, feedthrough, sampleInterval_s(input));
}

void addFindings(const Findings &findings, SensorModel &model)
{
    model.findings.insert(model.findings.end(), findings.begin(), findings.end());
}

/// The pole of the step (thesis mode) is taken out of the list and handed back.
std::optional<std::complex<double>> takeStepPole(
    const ModelInput &input, std::vector<std::complex<double>> &poles)
{
    const std::vector<PoleClass> classes
        = classifyPoles(poles, input.treatment, std::vector<bool>(poles.size(), true));
    const auto step = std::find(classes.begin(), classes.end(), PoleClass::Step);
    if (step == classes.end())
        return std::nullopt;
    const auto at = poles.begin() + (step - classes.begin());
    const std::complex<double> pole = *at;
    poles.erase(at);
    return pole;
}

} // namespace

const Pole *mainPole(const SensorModel &model)
{
    const auto energy = [](const Pole &pole) {
        return pole.amplitude * pole.amplitude / std::abs(pole.s_rad_s.real());
    };
    const Pole *main = nullptr;
    for (const Pole &pole : model.poles) {
        if (pole.poleClass == PoleClass::Sensor && pole.s_rad_s.imag() > 0.0
            && (!main || energy(pole) > energy(*main)))
            main = &pole;
    }
    return main;
}

Result<SensorModel> realizeModel(const ModelInput &input, const HankelDecomposition &decomposition,
    Index order, const RealizationSettings &settings, const SpectrumResult &spectrum,
    const JobControl &control)
{
    const Index largest = largestOrder(decomposition);
    if (order < 1 || order > largest) {
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "Model order %1 is not possible: the Hankel matrix of %2 rows serves orders 1 "
                    "to %3; choose one of them, or a longer model input."),
                {std::to_string(order), std::to_string(decomposition.rows),
                    std::to_string(largest)}});
    }
    const double dt_s = sampleInterval_s(input);
    std::vector<std::complex<double>> poles = realizedPoles(decomposition, order);
    const auto stepPole = takeStepPole(input, poles);
    poles = withoutNuisancePoles(input, poles);
    ModelDraft draft = linearDraft(input, poles);
    const std::vector<std::complex<double>> realised = draft.rates_rad_s;
    if (settings.refine)
        refineDraft(input, draft, control);
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});

    SensorModel model;
    model.order = order;
    model.refined = draft.refinement.has_value();
    if (isThesisMode(input))
        model.stateSpace = thesisRealization(decomposition, order, dt_s);
    describe(input, draft, stepPole, model);
    if (model.refined)
        model.uncertaintyMethod = noiseName(draft.noise);
    compareShots(input, draft, model, control);
    if (isThesisMode(input))
        model.fitListing_percent = listingFit(model.stateSpace, input.series.front().y);
    else
        model.stateSpace = describeStateSpace(input, model);
    model.zeros = transmissionZeros(model.stateSpace);
    flagPoles(model);
    model.diverges = runsAway(model, input);
    model.nuisance = nuisanceResults(input, draft, model.series);
    if (model.refined && hasNuisance(input))
        model.nuisanceEffect = effectOfNuisance(input, realised, model, control);
    if (settings.refine)
        fitSecondOrderBeside(input, draft, model, control);
    model.findings = judgeModel(model, input, decomposition, spectrum);
    addFindings(judgeShots(model), model);
    if (model.secondOrder)
        addFindings(judgeSecondOrder(*model.secondOrder, model.fit_percent), model);
    return model;
}

} // namespace dyncal
