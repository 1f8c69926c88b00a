// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_fit.h"

#include "core/realization/hankel/realized_poles.h"
#include "core/realization/model/model_description.h"
#include "core/realization/model/model_findings.h"
#include "core/realization/model/nuisance_results.h"
#include "core/realization/model/pole_classes.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/model_draft.h"
#include "core/realization/refinement/noise_basis.h"
#include "core/realization/refinement/series_simulation.h"
#include "core/realization/second_order/second_order_choice.h"
#include "core/signal/spectrum_analysis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

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

/// Removes the step's pole (thesis mode) from the list and returns it.
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

/// Lets the second-order sensor take the draft's place, if it is better.
std::optional<SecondOrderModel> competeSecondOrder(
    const ModelInput &input, ModelDraft &draft, Index order, const JobControl &control)
{
    const auto rivals = secondOrderRivals(input, draft, control);
    const SecondOrderRival *better = leader(rivals, order);
    if (!better) {
        allowForSecondPole(rivals, draft);
        return std::nullopt;
    }
    takeSecondOrder(better->fit, draft);
    SecondOrderModel sensor = better->fit.sensor;
    sensor.describes = true;
    sensor.isModel = true;
    return sensor;
}

} // namespace

Result<SensorModel> fitModel(const ModelInput &input, const HankelDecomposition &decomposition,
    Index order, const RealizationSettings &settings, const SpectrumResult &spectrum,
    const JobControl &control)
{
    const Index largest = largestOrder(decomposition);
    if (order < 1 || order > largest) {
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "Model order %1 is not possible: the Hankel matrix of %2 rows serves orders 1 to %3; choose one of them, or a longer model input."),
                {std::to_string(order), std::to_string(decomposition.rows),
                    std::to_string(largest)}});
    }
    if (isThesisMode(input) != (decomposition.shiftedCore.size() > 0)) {
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The Hankel matrix was decomposed for another treatment of the response than the model's; compute the decomposition again."),
                {}});
    }
    std::vector<std::complex<double>> poles = realizedPoles(decomposition, order);
    const auto stepPole = takeStepPole(input, poles);
    poles = withoutNuisancePoles(input, poles);
    ModelDraft draft = linearDraft(input, poles);
    std::optional<SecondOrderModel> secondOrder;
    if (settings.refine) {
        refineDraft(input, draft, control);
        if (order <= kLargestRefined)
            secondOrder = competeSecondOrder(input, draft, order, control);
    }
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});

    SensorModel model;
    model.order = order;
    model.refined = draft.refinement.has_value();
    if (isThesisMode(input))
        model.stateSpace = thesisRealization(decomposition, order, sampleInterval_s(input));
    describeModel(input, draft, stepPole, model);
    model.secondOrder = std::move(secondOrder);
    if (model.refined)
        model.uncertaintyMethod = noiseName(draft.noise);
    if (isThesisMode(input))
        model.fitListing_percent = listingFit(model.stateSpace, input.series.front().y);
    else
        model.stateSpace = describeStateSpace(input, model);
    model.zeros = transmissionZeros(model.stateSpace);
    flagPoles(model.zeros, model.poles);
    model.diverges = runsAway(model, input);
    model.nuisance = nuisanceResults(input, draft, model.series);
    model.findings = judgeModel(model, input, decomposition, spectrum);
    model.draft = std::move(draft);
    return model;
}

} // namespace dyncal
