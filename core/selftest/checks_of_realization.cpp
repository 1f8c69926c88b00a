// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_realization.h"

#include "core/base/constants.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/selftest/known_inputs.h"
#include "core/selftest/second_order_truth.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace dyncal {
namespace {

/// The sensor of the published singular values and poles: 400 samples at 1 MHz, y[0] one sample
/// behind the step.
constexpr SecondOrderTruth kPublished{318e3, 0.02};
constexpr Index kModelSamples = 400;

/// A slower one.
constexpr SecondOrderTruth kSlow{30e3, 0.05};
constexpr double kFirst = 0.3; ///< samples from the onset to y[0]

ModelInput publishedInput(ResponseTreatment treatment, DataChange &change)
{
    return inputOf(change(kPublished.sampled(kModelRate_Hz, kModelSamples, 1.0)), treatment);
}

/// Second singular value over the first.
double secondOverFirst(ResponseTreatment treatment, DataChange &change)
{
    const auto hankel = decomposed(publishedInput(treatment, change));
    return hankel ? hankel->singularValues[1] / hankel->singularValues[0] : kUnknown;
}

double singularRatioOfDifferences(DataChange &change)
{
    return secondOverFirst(ResponseTreatment::Differenced, change);
}

double singularRatioOfStep(DataChange &change)
{
    return secondOverFirst(ResponseTreatment::StepAsImpulse, change);
}

/// Beyond the two of the sensor nothing is left but rounding.
double thirdOverFirst(DataChange &change)
{
    const auto hankel = decomposed(publishedInput(ResponseTreatment::StepDeflated, change));
    return hankel ? hankel->singularValues[2] / hankel->singularValues[0] : kUnknown;
}

std::complex<double> firstPole(ResponseTreatment treatment, DataChange &change)
{
    const auto hankel = decomposed(publishedInput(treatment, change));
    return hankel ? realizedPoles(*hankel, 2).front() : std::complex<double>(kUnknown, kUnknown);
}

double realPartOfPole(DataChange &change)
{
    return firstPole(ResponseTreatment::StepDeflated, change).real();
}

double imaginaryPartOfPole(DataChange &change)
{
    return firstPole(ResponseTreatment::StepDeflated, change).imag();
}

double poleOfThesis(DataChange &change)
{
    const auto hankel = decomposed(publishedInput(ResponseTreatment::StepAsImpulse, change));
    if (!hankel)
        return kUnknown;
    const auto poles = realizedPoles(*hankel, 2);
    return std::min(poles[0].real(), poles[1].real());
}

/// Of two periods, which end while the sensor still rings: the last row counts.
double errorOfUndecayedPole(DataChange &change)
{
    const auto hankel = decomposed(
        inputOf(change(kSlow.sampled(kModelRate_Hz, 66, 1.0)), ResponseTreatment::StepDeflated));
    const std::complex<double> truth = std::exp(kSlow.pole_rad_s() / kModelRate_Hz);
    return hankel ? std::abs(realizedPoles(*hankel, 2).front() - truth) : kUnknown;
}

/// The model that the thesis makes of a step, of order 3, gives the step again.
double errorOfThesisModel(DataChange &change)
{
    const ModelInput input = publishedInput(ResponseTreatment::StepAsImpulse, change);
    const auto hankel = decomposed(input);
    if (!hankel)
        return kUnknown;
    const Eigen::VectorXd again
        = impulseResponse(thesisRealization(*hankel, 3, 1.0 / kModelRate_Hz), kModelSamples + 1);
    return (again.tail(kModelSamples) - input.series.front().y).cwiseAbs().maxCoeff();
}

std::optional<SensorModel> modelWithoutNoise(DataChange &change)
{
    return modelOf(inputOf(change(kSlow.sampled(kModelRate_Hz, kModelSamples, kFirst)),
        ResponseTreatment::StepDeflated));
}

double frequencyOfModel_Hz(DataChange &change)
{
    const auto model = modelWithoutNoise(change);
    return model ? model->poles.front().frequency_Hz : kUnknown;
}

double dampingOfModel(DataChange &change)
{
    const auto model = modelWithoutNoise(change);
    return model ? model->poles.front().dampingRatio : kUnknown;
}

double onsetOfModel(DataChange &change)
{
    const auto model = modelWithoutNoise(change);
    return model ? model->series.front().onset_s * kModelRate_Hz : kUnknown;
}

double plateauOfModel(DataChange &change)
{
    const auto model = modelWithoutNoise(change);
    return model ? model->plateauGain : kUnknown;
}

std::vector<CheckSpec> checksOfPublished()
{
    const Message source{
        DYNCAL_TEXT("core", "decomposition by another program, f0 = 318 kHz, zeta = 0.02, 1 MHz"),
        {}};
    const std::complex<double> pole = std::exp(kPublished.pole_rad_s() / kModelRate_Hz);
    const Message closed{DYNCAL_TEXT("core", "exp(s/rate) of the sensor's poles"), {}};
    return {{"decomposition",
                {DYNCAL_TEXT("core", "second singular value over the first, differences"), {}},
                source, 0.954357483697, 1e-11, singularRatioOfDifferences},
        {"decomposition",
            {DYNCAL_TEXT("core", "second singular value over the first, step as impulse"), {}},
            source, 0.0314075405270, 1e-11, singularRatioOfStep},
        {"decomposition",
            {DYNCAL_TEXT("core", "third singular value over the first, step deflated"), {}},
            {DYNCAL_TEXT("core", "a sensor of order 2 has two"), {}}, 0.0, 1e-12, thirdOverFirst},
        {"model", {DYNCAL_TEXT("core", "real part of the pole"), {}}, closed, pole.real(), 1e-10,
            realPartOfPole},
        {"model", {DYNCAL_TEXT("core", "imaginary part of the pole"), {}}, closed, pole.imag(),
            1e-10, imaginaryPartOfPole},
        {"model", {DYNCAL_TEXT("core", "second pole of the thesis's own way, order 2"), {}}, source,
            -0.4361941, 5e-8, poleOfThesis},
        {"model", {DYNCAL_TEXT("core", "pole of a record that ends while it rings, error"), {}},
            closed, 0.0, 1e-10, errorOfUndecayedPole},
        {"model", {DYNCAL_TEXT("core", "step by the thesis's model of order 3, largest error"), {}},
            {DYNCAL_TEXT("core", "by construction"), {}}, 0.0, 1e-9, errorOfThesisModel}};
}

std::vector<CheckSpec> checksOfFit()
{
    const Message closed{DYNCAL_TEXT("core", "second-order step in closed form, zeta = 0.05"), {}};
    return {{"model", {DYNCAL_TEXT("core", "natural frequency, Hz"), {}}, closed, kSlow.f0_Hz, 1e-4,
                frequencyOfModel_Hz},
        {"model", {DYNCAL_TEXT("core", "damping ratio"), {}}, closed, kSlow.zeta, 1e-9,
            dampingOfModel},
        {"model", {DYNCAL_TEXT("core", "onset, in samples from the first"), {}}, closed, -kFirst,
            1e-6, onsetOfModel},
        {"model", {DYNCAL_TEXT("core", "plateau gain"), {}}, closed, 1.0, 1e-9, plateauOfModel}};
}

} // namespace

std::vector<CheckSpec> checksOfRealization()
{
    std::vector<CheckSpec> checks = checksOfPublished();
    for (CheckSpec &check : checksOfFit())
        checks.push_back(std::move(check));
    return checks;
}

} // namespace dyncal
