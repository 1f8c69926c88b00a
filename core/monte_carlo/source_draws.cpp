// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/source_draws.h"

#include "core/base/input_draws.h"
#include "core/base/portable_math.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dyncal {
namespace {

/// Gamma of shape >= 1 and scale 1.
double drawnGamma(RandomStream &stream, double shape)
{
    const double d = shape - 1.0 / 3.0;
    const double c = 1.0 / std::sqrt(9.0 * d);
    for (;;) {
        const double z = stream.nextNormal();
        const double root = 1.0 + c * z;
        const double v = root * root * root;
        const double p = stream.nextUniform();
        if (root > 0.0 && portableLog(p) < 0.5 * z * z + d - d * v + d * portableLog(v))
            return d * v;
    }
}

} // namespace

Index SourceDraws::add(const UncertainInput &input, Index shot)
{
    UncertainInput source = input;
    if (!input.common && shot > 0)
        source.quantity += " of shot " + std::to_string(shot);
    const auto known = std::ranges::find(m_sources, source.quantity, &UncertainInput::quantity);
    if (known != m_sources.end())
        return known - m_sources.begin();
    m_streams.push_back(streamOf(source.quantity));
    m_sources.push_back(std::move(source));
    m_correlated = std::make_shared<const CorrelatedDraws>(m_sources);
    return size() - 1;
}

Eigen::VectorXd SourceDraws::probabilities(std::uint64_t seed, Index trial) const
{
    Eigen::VectorXd p(size());
    for (Index i = 0; i < size(); ++i)
        p[i] = RandomStream(seed, trial, m_streams[static_cast<std::size_t>(i)]).nextUniform();
    if (m_correlated)
        m_correlated->apply(p);
    return p;
}

double DrawnInput::value(const Eigen::VectorXd &probabilities) const
{
    return drawnValue(input, probabilities[source]);
}

double drawnVariance(RandomStream &stream, double dof)
{
    if (!(dof > 0.0) || std::isinf(dof))
        return 1.0;
    const double shape = 0.5 * dof;
    if (shape >= 1.0)
        return drawnGamma(stream, shape) / shape;
    const double p = stream.nextUniform(); // gamma(a) = gamma(a + 1) p^(1/a)
    return drawnGamma(stream, shape + 1.0) * portableExp(portableLog(p) / shape) / shape;
}

} // namespace dyncal
