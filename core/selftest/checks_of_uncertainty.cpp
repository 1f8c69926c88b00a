// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_uncertainty.h"

#include "core/base/constants.h"
#include "core/base/distributions.h"
#include "core/base/propagation.h"
#include "core/shock/shock_uncertainty.h"
#include "core/signal/dft_covariance.h"
#include "core/uncertainty/reported_value.h"

#include <cmath>

namespace dyncal {
namespace {

/// Contributions 3 with 4 degrees of freedom, and 4.
ReportedValue threeAndFour(DataChange &change, double least = 0.0)
{
    ReportedValue value;
    value.of = "sensitivity";
    value.value = 1.0;
    value.lines
        = {directLine("first", change(3.0), change(4.0)), directLine("second", change(4.0))};
    value.leastExpanded = change(least);
    combineLines(value);
    return value;
}

double rootOfSquares(DataChange &change)
{
    return threeAndFour(change).u.value_or(kUnknown);
}

double effectiveDegrees(DataChange &change)
{
    return threeAndFour(change).dof;
}

double studentFactor(DataChange &change)
{
    return coverageFactor(change(10.0), 0.95);
}

double factorOfReport(DataChange &change)
{
    ReportedValue value;
    value.value = 1.0;
    value.lines = {directLine("only", change(2.0), change(10.0))};
    combineLines(value);
    return value.expanded().value_or(kUnknown);
}

double expandedAtLeast(DataChange &change)
{
    return threeAndFour(change, 20.0).expanded().value_or(kUnknown);
}

/// Two sources that err together, r = 1/2, beside one alone: 3 with 6 degrees of freedom, 4, and 2
/// with 5.
CombinedUncertainty correlatedSum(DataChange &change)
{
    UncertaintyLine first = directLine("first", change(3.0), change(6.0)),
                    second = directLine("second", change(4.0));
    const double r = change(0.5);
    first.correlated = {{"second", r}};
    second.correlated = {{"first", r}};
    return combined({first, second, directLine("third", change(2.0), change(5.0))});
}

double correlatedUncertainty(DataChange &change)
{
    return correlatedSum(change).u;
}

/// Those that err together count as one, with the fewest degrees of freedom among them.
double correlatedDegrees(DataChange &change)
{
    return correlatedSum(change).dof;
}

/// a b at a = 3, b = 4 with u 0.03 and 0.08.
double productsUncertainty(DataChange &change)
{
    const std::vector<UncertainInput> inputs{
        {"a", change(3.0), change(0.03)}, {"b", change(4.0), change(0.08)}};
    const auto gum = propagateGum(inputs, [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
        return Eigen::VectorXd::Constant(1, x[0] * x[1]);
    });
    return gum ? gum->u[0] : kUnknown;
}

/// The thesis's shot with its velocity typed.
std::optional<double> stepUncertainty_Pa(DataChange &change)
{
    StepMeasurement m;
    m.state = {change(101100.0), change(294.15), 0.0, 0.0};
    m.velocity.velocity_m_s = change(512.8);
    UncertaintyRequest request;
    request.evaluate = true;
    for (const auto &[quantity, u] :
        {std::pair("velocity_m_s", 0.5128), std::pair("t1_k", 0.3), std::pair("p1_pa", 30.0),
            std::pair("gamma", 5e-4), std::pair("molar_mass_kg_mol", 1e-5)})
        request.stated.push_back({quantity, change(u), Distribution::Normal, std::nullopt});
    const auto budget = evaluateStep(m, request);
    return budget ? budget->u(StepResult::Step) : std::nullopt;
}

double stepUncertainty_relative(DataChange &change)
{
    return stepUncertainty_Pa(change).value_or(kUnknown) / 434498.068;
}

/// Of a shot of 500 m/s between a sensor 0.8 m before the wall and the wall, of which nothing but
/// the sensor's distance (0.8 mm) and time (1 us) is uncertain.
double velocityUncertainty_relative(DataChange &change)
{
    StepMeasurement m;
    m.state = {change(101100.0), change(294.15), 0.0, 0.0};
    Sighting side, wall;
    side.channel = "side";
    side.distance_m = change(0.8);
    side.u_distance_m = change(8e-4);
    side.u_time_s = change(1e-6);
    wall.channel = "DUT";
    wall.time_s = change(1.6e-3);
    wall.u_time_s = change(1e-12);
    wall.isDut = true;
    m.velocity.sightings = {side, wall};
    const auto fit = fitVelocity(m.velocity.sightings, Attenuation::None);
    if (!fit)
        return kUnknown;
    m.velocity.fit = *fit;
    m.velocity.velocity_m_s = fit->velocity_m_s;
    UncertaintyRequest request;
    request.evaluate = true;
    const auto budget = evaluateStep(m, request);
    return budget ? budget->u(StepResult::Velocity).value_or(kUnknown) / fit->velocity_m_s
                  : kUnknown;
}

/// The published sensitivities times those u: d ln step = 4.65354 d ln W and so on.
double knownStepUncertainty_relative()
{
    double sum = 0.0;
    for (const double part : {4.65354 * 1e-3, 2.32677 * 0.3 / 294.15, 30.0 / 101100.0,
             2.07628 * 5e-4 / 1.402, 2.32677 * 1e-5 / 0.028966})
        sum += part * part;
    return std::sqrt(sum);
}

UncertainComplex spectrumOfEight(DataChange &change)
{
    Eigen::VectorXd y(8), variance(8);
    y << 0.0, 1.0, 2.0, 1.0, 0.5, 0.25, 0.1, 0.05;
    for (Index k = 0; k < 8; ++k)
        variance[k] = std::pow(0.01 * static_cast<double>(k + 1), 2.0);
    return dftWithCovariance(change(y), change(variance), 8.0, Eigen::VectorXd::Constant(1, 1.0))
        .front();
}

double realPartOfSpectrum(DataChange &change)
{
    return spectrumOfEight(change).value.real();
}

double covarianceOfParts(DataChange &change)
{
    return spectrumOfEight(change).covariance(0, 1);
}

double varianceOfMagnitude(DataChange &change)
{
    return toPolar(spectrumOfEight(change)).covariance(0, 0);
}

std::vector<CheckSpec> checksOfSums()
{
    const Message gum{DYNCAL_TEXT("core", "JCGM 100, by hand"), {}};
    const Message student{DYNCAL_TEXT("core", "table of Student's t, 10 degrees of freedom"), {}};
    return {{"uncertainty", {DYNCAL_TEXT("core", "u of contributions 3 and 4"), {}}, gum, 5.0,
                1e-13, rootOfSquares},
        {"uncertainty",
            {DYNCAL_TEXT("core", "effective degrees of freedom (Welch-Satterthwaite)"), {}}, gum,
            4.0 * std::pow(5.0 / 3.0, 4.0), 1e-11, effectiveDegrees},
        {"uncertainty", {DYNCAL_TEXT("core", "coverage factor k for 95 %"), {}}, student,
            2.2281388520, 1e-9, studentFactor},
        {"uncertainty", {DYNCAL_TEXT("core", "U of u = 2 with 10 degrees of freedom"), {}}, student,
            2.0 * 2.2281388520, 1e-9, factorOfReport},
        {"uncertainty", {DYNCAL_TEXT("core", "U where the laboratory states no less than 20"), {}},
            {DYNCAL_TEXT("core", "ILAC-P14, 5.4"), {}}, 20.0, 1e-12, expandedAtLeast},
        {"uncertainty", {DYNCAL_TEXT("core", "u of contributions with r = 0.5"), {}}, gum,
            std::sqrt(41.0), 1e-13, correlatedUncertainty},
        {"uncertainty", {DYNCAL_TEXT("core", "effective degrees of freedom with r = 0.5"), {}}, gum,
            41.0 * 41.0 / (37.0 * 37.0 / 6.0 + 16.0 / 5.0), 1e-11, correlatedDegrees},
        {"uncertainty", {DYNCAL_TEXT("core", "u of a product"), {}}, gum, std::hypot(0.12, 0.24),
            1e-10, productsUncertainty},
        {"uncertainty", {DYNCAL_TEXT("core", "relative u of the thesis's step"), {}},
            {DYNCAL_TEXT("core", "published sensitivities, six digits"), {}},
            knownStepUncertainty_relative(), 2e-8, stepUncertainty_relative},
        {"uncertainty", {DYNCAL_TEXT("core", "relative u of a velocity over 0.8 m"), {}},
            {DYNCAL_TEXT("core", "u of the distance over the distance, of the time over the time"),
                {}},
            std::hypot(1e-3, 1.0 / 1600.0), 1e-8, velocityUncertainty_relative}};
}

std::vector<CheckSpec> checksOfSpectra()
{
    const Message source{DYNCAL_TEXT("core", "PyDynamic 2.5.1, GUM_DFT and DFT2AmpPhase"), {}};
    return {{"uncertainty", {DYNCAL_TEXT("core", "real part of a spectral line"), {}}, source,
                -0.6414213562, 1e-10, realPartOfSpectrum},
        {"uncertainty", {DYNCAL_TEXT("core", "covariance of its real and imaginary part"), {}},
            source, 0.002, 1e-12, covarianceOfParts},
        {"uncertainty", {DYNCAL_TEXT("core", "variance of its magnitude"), {}}, source,
            0.012461969086, 1e-12, varianceOfMagnitude}};
}

} // namespace

std::vector<CheckSpec> checksOfUncertainty()
{
    std::vector<CheckSpec> checks = checksOfSums();
    for (CheckSpec &check : checksOfSpectra())
        checks.push_back(std::move(check));
    return checks;
}

} // namespace dyncal
