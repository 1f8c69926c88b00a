// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/order/cross_shot.h"

#include "core/base/constants.h"
#include "core/realization/exponentials/shared_fit.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/model/pole_classes.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/series_simulation.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr Index kHighestOrderCompared = 20;

/// Squared error of one shot by order; empty if the others cannot be decomposed.
Eigen::VectorXd errorsLeftOut(const ModelInput &input, std::size_t shot,
    const RealizationSettings &settings, const JobControl &control)
{
    ModelInput others = input;
    others.series.erase(others.series.begin() + static_cast<std::ptrdiff_t>(shot));
    for (ModelSeries &series : others.series)
        series.noise.resize(0); // this decomposition needs no noise floor
    const auto hankel = decomposeHankel(others, settings, control);
    if (!hankel)
        return {};
    const Eigen::VectorXd &y = input.series[shot].y;
    Eigen::VectorXd errors(std::min(kHighestOrderCompared, largestOrder(*hankel)));
    for (Index n = 1; n <= errors.size() && !control.stopRequested(); ++n) {
        std::vector<std::complex<double>> poles = realizedPoles(*hankel, n);
        errors[n - 1] = dropRunaways(poles, y.size())
            ? kUnknown
            : (y - fitSharedPoles(y, poles, isStepTreatment(input.treatment)).front().fitted)
                  .squaredNorm();
    }
    return errors;
}

} // namespace

CrossShot leaveOneShotOut(
    const ModelInput &input, const RealizationSettings &settings, const JobControl &control)
{
    if (isThesisMode(input) || input.series.size() < 2)
        return {};
    RealizationSettings few = settings;
    few.maxOrder = std::min(settings.maxOrder, kHighestOrderCompared);
    std::vector<Eigen::VectorXd> errors;
    Index orders = kHighestOrderCompared;
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        errors.push_back(errorsLeftOut(input, r, few, control));
        orders = std::min(orders, errors.back().size());
    }
    if (orders == 0 || control.stopRequested())
        return {};
    CrossShot result{Eigen::VectorXd::Zero(orders),
        Eigen::MatrixXd(orders, static_cast<Index>(input.series.size()))};
    double spread = 0.0;
    for (std::size_t r = 0; r < errors.size(); ++r) {
        const double own = spreadSquares(input.series[r].y);
        spread += own;
        for (Index n = 0; n < orders; ++n) {
            result.error_percent[n] += errors[r][n];
            result.fit_percent(n, static_cast<Index>(r)) = fitPercent(errors[r][n], own);
        }
    }
    result.error_percent = 100.0 * (result.error_percent / spread).cwiseSqrt();
    return result;
}

} // namespace dyncal
