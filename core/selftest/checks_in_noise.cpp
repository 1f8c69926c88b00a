// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_in_noise.h"

#include "core/base/constants.h"
#include "core/base/portable_random.h"
#include "core/realization/model/model_assessing.h"
#include "core/realization/order/order_scan.h"
#include "core/selftest/known_inputs.h"
#include "core/selftest/second_order_truth.h"

#include <Eigen/LU>

#include <cmath>

namespace dyncal {
namespace {

/// In white noise of 1e-3.
constexpr SecondOrderTruth kNoisy{30e3, 0.05};
constexpr double kNoiseSd = 1e-3;
constexpr double kNoisyFirst = 0.3; ///< samples from the onset to y[0]

ModelInput noisyInput(DataChange &change)
{
    RandomStream random(20, 1, 1);
    Eigen::VectorXd y = kNoisy.sampled(kModelRate_Hz, 600, kNoisyFirst),
                    noise = Eigen::VectorXd::Zero(8000);
    random.addNormal({y.data(), static_cast<std::size_t>(y.size())}, kNoiseSd);
    random.addNormal({noise.data(), static_cast<std::size_t>(noise.size())}, kNoiseSd);
    ModelInput input = inputOf(change(y), ResponseTreatment::StepDeflated);
    ModelSeries &series = input.series.front();
    noise = change(noise);
    series.noise = noise;
    series.noiseSd = series.fullRateNoiseSd
        = std::sqrt(noise.squaredNorm() / static_cast<double>(noise.size()));
    series.fullRateNoise = noiseCovariance(noise, kLargestNoiseModelOrder);
    return input;
}

double fitOfOrderTwo_percent(DataChange &change)
{
    const ModelInput input = noisyInput(change);
    const auto hankel = decomposed(input);
    if (!hankel)
        return kUnknown;
    const auto evidence = gatherOrderEvidence(input, *hankel, suggestOrder(input, *hankel), {});
    return evidence ? evidence->fit_percent[1] : kUnknown;
}

double suggestedOrder(DataChange &change)
{
    const ModelInput input = noisyInput(change);
    const auto hankel = decomposed(input);
    return hankel ? static_cast<double>(suggestOrder(input, *hankel).order) : kUnknown;
}

std::optional<Pole> assessedPole(DataChange &change)
{
    const ModelInput input = noisyInput(change);
    const auto model = modelOf(input);
    if (!model)
        return std::nullopt;
    const auto assessment = assessModel(input, *model, {});
    return assessment ? std::optional(assessment->poles.front()) : std::nullopt;
}

double relativeUncertaintyOfFrequency(DataChange &change)
{
    const auto pole = assessedPole(change);
    return pole ? pole->u_frequency_Hz / pole->frequency_Hz : kUnknown;
}

double uncertaintyOfDamping(DataChange &change)
{
    const auto pole = assessedPole(change);
    return pole ? pole->u_dampingRatio : kUnknown;
}

using FiveParameters = Eigen::Vector<double, 5>;

/// Response by ln f0, zeta, level, onset in samples and share of the ringing: those of a pair of
/// poles whose amplitudes are free.
Eigen::VectorXd noisyModel(const FiveParameters &x)
{
    const SecondOrderTruth sensor{kNoisy.f0_Hz * std::exp(x[0]), kNoisy.zeta + x[1]};
    const Eigen::ArrayXd step = sensor.sampled(kModelRate_Hz, 600, kNoisyFirst + x[3]).array();
    return (1.0 + x[2]) * (1.0 + (1.0 + x[4]) * (step - 1.0)).matrix();
}

/// Standard deviations that no unbiased estimate can be below, in white noise: (J^T J)^-1 sd^2 with
/// J by differences.
FiveParameters cramerRaoBounds()
{
    constexpr double kDifference = 1e-6;
    Eigen::MatrixXd J(600, 5);
    for (Index k = 0; k < 5; ++k) {
        const FiveParameters x = kDifference * FiveParameters::Unit(k);
        J.col(k) = (noisyModel(x) - noisyModel(-x)) / (2.0 * kDifference);
    }
    const Eigen::Matrix<double, 5, 5> information = J.transpose() * J;
    return kNoiseSd * information.inverse().diagonal().cwiseSqrt();
}

/// FIT that noise of that power leaves: 100 (1 - sd sqrt(N)/norm(y - mean)).
double attainableFit_percent()
{
    const Eigen::VectorXd y = noisyModel(FiveParameters::Zero());
    const double spread = (y.array() - y.mean()).matrix().norm();
    return 100.0 * (1.0 - kNoiseSd * std::sqrt(600.0) / spread);
}

} // namespace

std::vector<CheckSpec> checksInNoise()
{
    const FiveParameters bounds = cramerRaoBounds();
    const Message bound{
        DYNCAL_TEXT("core", "Cramer-Rao bound of five parameters in white noise"), {}};
    return {{"evidence", {DYNCAL_TEXT("core", "FIT of order 2, %"), {}},
                {DYNCAL_TEXT("core", "what noise of that power leaves"), {}},
                attainableFit_percent(), 0.02, fitOfOrderTwo_percent},
        {"evidence", {DYNCAL_TEXT("core", "suggested order"), {}},
            {DYNCAL_TEXT("core", "by construction"), {}}, 2.0, 0.1, suggestedOrder},
        {"model_assessment", {DYNCAL_TEXT("core", "u of the natural frequency, relative"), {}},
            bound, bounds[0], 0.05 * bounds[0], relativeUncertaintyOfFrequency},
        {"model_assessment", {DYNCAL_TEXT("core", "u of the damping ratio"), {}}, bound, bounds[1],
            0.05 * bounds[1], uncertaintyOfDamping}};
}

} // namespace dyncal
