// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_division.h"

#include "core/base/constants.h"
#include "core/model_analysis/chain_correction.h"
#include "core/reference/reference_sensitivity.h"

#include <cmath>
#include <memory>
#include <optional>

namespace dyncal {
namespace {

class KnownPoint : public ResponseSource
{
public:
    explicit KnownPoint(const ResponsePoint &point)
        : m_point(point)
    {
    }
    ResponsePoint at(double) const override { return m_point; }

private:
    ResponsePoint m_point;
};

/// H = 0.5 e^(-0.5 j) at 1 MHz, u 2 % of it.
ResponsePoint behindChain(DataChange &change)
{
    const double last_Hz = change(1e6);
    const auto chain = ReferenceSensitivity::fromTable(
        {{change(100.0), change(1.0), change(0.002), 0.0, change(0.004)},
            {last_Hz, change(0.5), change(0.01), change(-0.5), change(0.004)}});
    const ResponsePoint point{.magnitude = change(2.0),
        .phase_rad = change(0.5),
        .u_magnitude = change(0.02),
        .u_phase_rad = change(0.01)};
    return chain ? ChainCorrected(std::make_unique<KnownPoint>(point), *chain).at(last_Hz)
                 : ResponsePoint{};
}

double magnitudeWithoutChain(DataChange &change)
{
    return behindChain(change).magnitude;
}

double phaseWithoutChain_rad(DataChange &change)
{
    return behindChain(change).phase_rad;
}

double uncertaintyOfChain(DataChange &change)
{
    return behindChain(change).u_chain;
}

/// Between two rows, at the geometric mean of their frequencies.
double referenceBetweenRows(DataChange &change)
{
    const auto table = ReferenceSensitivity::fromTable(
        {{change(1e3), change(3.0), change(0.01)}, {change(1e5), change(4.0), change(0.02)}});
    const auto point = table ? table->at(change(1e4)) : std::nullopt;
    return point ? point->magnitude : kUnknown;
}

std::optional<ReferencePoint> referenceAtResonance(DataChange &change)
{
    const auto model = ReferenceSensitivity::fromModel(
        {change(3.0), change(0.03), change(1e5), 0.0, change(0.25), 0.0});
    return model ? model->at(change(1e5)) : std::nullopt;
}

double referenceMagnitude(DataChange &change)
{
    const auto point = referenceAtResonance(change);
    return point ? point->magnitude : kUnknown;
}

double referenceUncertainty(DataChange &change)
{
    const auto point = referenceAtResonance(change);
    return point ? point->u_magnitude : kUnknown;
}

} // namespace

std::vector<CheckSpec> checksOfDivision()
{
    const Message division{DYNCAL_TEXT("core", "division by hand"), {}};
    return {{"response", {DYNCAL_TEXT("core", "magnitude without the chain"), {}}, division, 4.0,
                1e-13, magnitudeWithoutChain},
        {"response", {DYNCAL_TEXT("core", "phase without the chain, rad"), {}}, division, 1.0,
            1e-13, phaseWithoutChain_rad},
        {"response", {DYNCAL_TEXT("core", "u of the chain in the magnitude"), {}}, division, 0.08,
            1e-13, uncertaintyOfChain},
        {"reference_transducer",
            {DYNCAL_TEXT("core", "sensitivity between two rows of a table"), {}},
            {DYNCAL_TEXT("core", "straight line over log f"), {}}, 3.5, 1e-13,
            referenceBetweenRows},
        {"reference_transducer", {DYNCAL_TEXT("core", "sensitivity by a model, at its f0"), {}},
            division, 6.0, 1e-13, referenceMagnitude},
        {"reference_transducer", {DYNCAL_TEXT("core", "u of that sensitivity"), {}}, division, 0.06,
            1e-9, referenceUncertainty}};
}

} // namespace dyncal
