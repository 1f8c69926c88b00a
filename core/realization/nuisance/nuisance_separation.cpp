// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/nuisance/nuisance_separation.h"

#include "core/realization/exponentials/pole_mapping.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/input/left_out.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/nuisance/nuisance_search.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/pole_refinement.h"
#include "core/realization/refinement/refinement.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace dyncal {
namespace {

constexpr Index kMostStates = 12;
constexpr int kRounds = 3;
constexpr double kSettled = 1e-4; ///< relative change of the modes' frequencies

/// Continuous poles of one order, where all of them decay.
std::vector<std::complex<double>> sensorPoles(
    const ModelInput &input, const HankelDecomposition &hankel, Index order)
{
    std::vector<std::complex<double>> poles;
    for (const std::complex<double> &z :
        withoutNuisancePoles(input, realizedPoles(hankel, order))) {
        if (!(std::abs(z) < 1.0) || (z.imag() == 0.0 && z.real() <= 0.0))
            return {};
        poles.push_back(continuousPole(z, sampleInterval_s(input)));
    }
    return poles;
}

/// Sensor and modes together, with the suggested order of `rest`, the response without the modes.
/// The remainder of a roughly estimated mode may count as a state of the sensor; then the next
/// lower order that converges is used, because the modes are known better after it.
std::optional<Refinement> jointFit(
    const ModelInput &input, const ModelInput &rest, const JobControl &control)
{
    const auto hankel = decomposeHankel(rest, {}, control);
    if (!hankel)
        return std::nullopt;
    Index order = std::min(kMostStates, suggestOrder(rest, *hankel).order);
    for (; order >= 1 && !control.stopRequested(); --order) {
        const auto poles = sensorPoles(input, *hankel, order);
        if (poles.empty())
            continue;
        if (auto fit = refinePoles(
                refinementRecords(input), poles, isStepTreatment(input.treatment), control))
            return fit;
    }
    return std::nullopt;
}

/// The better of two fits: from the bridged response, and from a run that needs no bridge, because
/// a straight line is a poor bridge across ringing.
std::optional<Refinement> bestFit(const ModelInput &input, const JobControl &control)
{
    const ModelInput rest = sensorOnly(input);
    std::optional<Refinement> best = jointFit(input, rest, control);
    if (input.leftOut.empty())
        return best;
    const ModelInput run = cleanRun(rest);
    if (run.series.empty())
        return best;
    std::optional<Refinement> other = jointFit(input, run, control);
    if (!best || (other && other->residualToNoise < best->residualToNoise))
        return other;
    return best;
}

/// Takes the nuisance terms of the fit into the series; returns the largest relative change of a
/// mode's frequency.
double takeFit(ModelInput &input, const Refinement &fit)
{
    double change = 0.0;
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        ModelSeries &series = input.series[r];
        const std::vector<NuisanceTerm> before = series.nuisance;
        series.nuisance = fit.nuisance[r];
        for (std::size_t i = 0; i < before.size(); ++i) {
            change = std::max(change,
                std::abs(series.nuisance[i].frequency_Hz() / before[i].frequency_Hz() - 1.0));
        }
        series.correction
            = series.leftOut.empty() ? Eigen::VectorXd() : bridge(series, fit.records[r]);
        if (!series.nuisance.empty())
            setNuisance(input, series, series.nuisance);
    }
    return change;
}

} // namespace

void separateNuisance(ModelInput &input, const std::vector<WindowedResponse> &responses,
    const std::vector<NuisanceMode> &modes,
    const std::vector<std::optional<double>> &soundSpeeds_m_s, const JobControl &control)
{
    input.nuisanceModes = modes;
    input.soundSpeeds_m_s = soundSpeeds_m_s;
    if (!modes.empty())
        searchNuisance(input, responses);
    if (!hasNuisance(input) && input.leftOut.empty())
        return;
    for (int round = 0; round < kRounds; ++round) {
        const auto fit = bestFit(input, control);
        if (!fit)
            break;
        const double change = takeFit(input, *fit);
        // A bridge is only as good as the fit before it, so it needs one round more than modes
        // alone.
        if (change < kSettled && (input.leftOut.empty() || round > 0))
            break;
    }
}

} // namespace dyncal
