// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/nuisance_results.h"

#include "core/realization/input/left_out.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "core/realization/refinement/refinement.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

NuisanceOfShot ofShot(
    const ModelDraft &draft, const SeriesFit &fit, std::size_t series, std::size_t term)
{
    NuisanceOfShot result;
    result.shot = fit.shot;
    result.term = draft.nuisance[series][term];
    const NuisanceTerm atOnset = termsAt({result.term}, fit.onset_s).front();
    result.phase_rad = std::arg(atOnset.amplitude);
    result.relativeAmplitude = std::abs(atOnset.amplitude);
    if (fit.level() != 0.0)
        result.relativeAmplitude /= std::abs(fit.level());
    if (draft.refinement) {
        const Eigen::Matrix4d covariance = nuisanceCovariance(
            *draft.refinement, static_cast<Index>(series), static_cast<Index>(term));
        const PoleFigures figures
            = pairFigures(result.term.pole_rad_s, covariance.topLeftCorner<2, 2>());
        result.u_frequency_Hz = figures.u_frequency_Hz;
        result.u_dampingRatio = figures.u_dampingRatio;
    }
    return result;
}

double residualRms(const ModelInput &input, const std::vector<SeriesFit> &fits)
{
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t r = 0; r < fits.size(); ++r) {
        const Eigen::VectorXd counted = countedValues(input.series[r], fits[r].error);
        squares += counted.squaredNorm();
        count += static_cast<double>(counted.size());
    }
    return std::sqrt(squares / count);
}

} // namespace

std::vector<NuisanceResult> nuisanceResults(
    const ModelInput &input, const ModelDraft &draft, const std::vector<SeriesFit> &fits)
{
    std::vector<NuisanceResult> results;
    for (std::size_t m = 0; m < input.nuisanceModes.size(); ++m) {
        NuisanceResult result{input.nuisanceModes[m], {}};
        for (std::size_t r = 0; r < draft.nuisance.size(); ++r) {
            for (std::size_t i = 0; i < draft.nuisance[r].size(); ++i) {
                if (draft.nuisance[r][i].mode == m)
                    result.perShot.push_back(ofShot(draft, fits[r], r, i));
            }
        }
        results.push_back(std::move(result));
    }
    return results;
}

ModelInput withModesLeftIn(const ModelInput &input)
{
    ModelInput plain = input;
    plain.nuisanceModes.clear();
    for (ModelSeries &series : plain.series) {
        // The records end with the last sample of the series, as without modes.
        const double last_s
            = series.first_s + static_cast<double>(series.y.size() - 1) * sampleInterval_s(input);
        const auto count = static_cast<Index>(std::floor(last_s * series.fullRate_Hz + 1e-6)) + 1;
        series.fullRate.conservativeResize(std::min(series.fullRate.size(), count));
        series.nuisance.clear();
        series.correction = {};
    }
    return plain;
}

NuisanceEffect::Side effectSide(
    const ModelInput &input, const SensorModel &model, const std::vector<Pole> &poles)
{
    NuisanceEffect::Side side;
    side.residualRms = residualRms(input, model.series);
    side.fit_percent = model.fit_percent;
    side.plateauGain = model.plateauGain;
    if (const Pole *pole = mainPole(poles, model.series)) {
        side.f0_Hz = pole->frequency_Hz;
        side.u_f0_Hz = pole->u_frequency_Hz;
        side.zeta = pole->dampingRatio;
        side.u_zeta = pole->u_dampingRatio;
    }
    return side;
}

} // namespace dyncal
