// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/series_fit.h"

#include "core/base/constants.h"
#include "core/realization/exponentials/front.h"
#include "core/realization/exponentials/onset.h"
#include "core/realization/input/left_out.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/refinement/refinement.h"
#include "core/realization/refinement/series_simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

/// The sensor's part of the sum, for the search for the onset.
ExponentialSum sensorPart(const ExponentialSum &sum, const std::vector<bool> &isSensor)
{
    ExponentialSum part;
    part.constant = sum.constant;
    const Index kept = std::count(isSensor.begin(), isSensor.end(), true);
    part.poles_rad_s.resize(kept);
    part.amplitudes.resize(kept);
    Index at = 0;
    for (std::size_t i = 0; i < isSensor.size(); ++i) {
        if (isSensor[i]) {
            part.poles_rad_s[at] = sum.poles_rad_s[static_cast<Index>(i)];
            part.amplitudes[at++] = sum.amplitudes[static_cast<Index>(i)];
        }
    }
    return part;
}

/// The sensor's response with the tube's modes that the step excites: it vanishes at the onset.
ExponentialSum drivenPart(const ExponentialSum &sum, const std::vector<bool> &isSensor,
    const std::vector<NuisanceTerm> &terms)
{
    ExponentialSum part = sensorPart(sum, isSensor);
    for (const NuisanceTerm &term : terms) {
        if (!term.startsWithStep)
            continue;
        const Index n = part.poles_rad_s.size();
        part.poles_rad_s.conservativeResize(n + 2);
        part.amplitudes.conservativeResize(n + 2);
        part.poles_rad_s.tail(2) << term.pole_rad_s, std::conj(term.pole_rad_s);
        part.amplitudes.tail(2) << 0.5 * term.amplitude, 0.5 * std::conj(term.amplitude);
    }
    return part;
}

/// Search range for the onset: six tenths of the period (or time constant) of the fastest part.
double onsetSearch_s(const ExponentialSum &part)
{
    const double fastest = part.poles_rad_s.cwiseAbs().maxCoeff();
    return 0.6 * 2.0 * std::numbers::pi / fastest;
}

/// The middle of the front, where the response to a sharp step would begin.
std::optional<double> beginOf(const ModelInput &input, const ModelDraft &draft, std::size_t series,
    const std::vector<bool> &isSensor, const ExponentialSum &sum, double search_s)
{
    const ExponentialSum sharp = asIfSharp(sum, input.front.duration_s);
    return findOnset_s(drivenPart(sharp, isSensor, draft.nuisance[series]), search_s);
}

FittedOnset locateOnset(const ModelInput &input, const ModelDraft &draft, std::size_t series,
    const std::vector<bool> &isSensor)
{
    const ExponentialSum part = sensorPart(draft.series[series], isSensor);
    if (part.poles_rad_s.size() == 0)
        return {0.0, kUnknown};
    const double search_s = onsetSearch_s(part);
    const auto begin = [&](const ExponentialSum &sum) {
        return beginOf(input, draft, series, isSensor, sum, search_s);
    };
    const auto found = begin(draft.series[series]);
    if (!found)
        return {0.0, kUnknown};
    FittedOnset onset{*found, kUnknown};
    if (!draft.refinement)
        return onset;

    const Index record = static_cast<Index>(series);
    const Eigen::MatrixXd covariance = recordCovariance(*draft.refinement, record);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(covariance.rows());
    for (Index i = 0; i < gradient.size(); ++i) {
        const double step = 0.1 * std::sqrt(std::max(0.0, covariance(i, i)));
        if (!(step > 0.0))
            continue;
        const auto above = begin(perturbed(*draft.refinement, record, i, step));
        const auto below = begin(perturbed(*draft.refinement, record, i, -step));
        if (!above || !below)
            return onset;
        gradient[i] = (*above - *below) / (2.0 * step);
    }
    onset.u_s = std::sqrt(std::max(0.0, gradient.dot(covariance * gradient)));
    return onset;
}

} // namespace

SeriesFit describeSeries(const ModelInput &input, const ModelDraft &draft, std::size_t r,
    const std::vector<bool> &isSensor, const StateSpaceModel &stateSpace)
{
    const ModelSeries &series = input.series[r];
    const ExponentialSum &sum = draft.series[r];
    SeriesFit fit;
    fit.shot = series.shot;
    fit.plateauGain = sum.constant;
    fit.recorded = sum;
    for (const LeftOut &part : series.leftOut)
        if (!part.isFront)
            fit.leftOut.push_back(part.samples);
    if (draft.refinement && draft.refinement->withConstant) {
        // The uncertainty of the subtracted baseline adds to that of the plateau.
        fit.u_plateauGain
            = std::hypot(std::sqrt(constantVariance(*draft.refinement, static_cast<Index>(r))),
                series.u_baseline);
    }
    if (isStepTreatment(input.treatment)) {
        const FittedOnset onset
            = draft.onsets.empty() ? locateOnset(input, draft, r, isSensor) : draft.onsets[r];
        fit.onset_s = onset.time_s;
        fit.u_onset_s = draft.onsetsOfSecondPole_s.empty()
            ? onset.u_s
            : std::hypot(onset.u_s, draft.onsetsOfSecondPole_s[r] - onset.time_s);
    }
    fit.amplitudes = amplitudesAt(input, draft, r, sum, fit.onset_s);
    fit.simulated = isThesisMode(input)
        ? Eigen::VectorXd(impulseResponse(stateSpace, series.y.size() + 1).tail(series.y.size()))
        : simulate(series, sum, draft.nuisance[r], sampleInterval_s(input));
    fit.error = series.y - fit.simulated;
    const Eigen::VectorXd counted = countedValues(series, series.y);
    fit.fit_percent
        = fitPercent(countedValues(series, fit.error).squaredNorm(), spreadSquares(counted));
    // Without a quiet stretch the noise is unknown; a record without noise has noise 0.
    fit.fitAttainable_percent = series.noise.size() > 0
        ? fitPercent(series.noiseSd * series.noiseSd * static_cast<double>(counted.size()),
            spreadSquares(counted))
        : kUnknown;
    return fit;
}

std::optional<double> onsetOf(const ModelInput &input, const ModelDraft &draft, std::size_t r,
    const std::vector<bool> &isSensor, const ExponentialSum &sum)
{
    const ExponentialSum part = sensorPart(sum, isSensor);
    if (part.poles_rad_s.size() == 0)
        return std::nullopt;
    return beginOf(input, draft, r, isSensor, sum, onsetSearch_s(part));
}

Eigen::VectorXcd amplitudesAt(const ModelInput &input, const ModelDraft &draft, std::size_t r,
    const ExponentialSum &sum, double onset_s)
{
    const Eigen::VectorXcd amplitudes = asIfSharp(sum, input.front.duration_s).amplitudes.array()
        * (sum.poles_rad_s.array() * onset_s).exp();
    return isStepTreatment(input.treatment) ? amplitudesOfStep(
               sum.poles_rad_s, amplitudes, sum.constant, termsAt(draft.nuisance[r], onset_s))
                                            : amplitudes;
}

} // namespace dyncal
