// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/coloured_noise.h"

#include "core/base/constants.h"
#include "core/base/portable_math.h"

#include <cmath>

namespace dyncal {

NoiseSource::NoiseSource(const NoiseKind &kind, Index count, RandomStream random)
    : m_random(random)
{
    constexpr double kCornerRatio = 4.0;
    if (kind.colour == NoiseColour::Autoregressive)
        addProcess(kind.phi);
    if (kind.colour == NoiseColour::Flicker) {
        const double lowest = 0.5 / static_cast<double>(count);
        for (double corner = 0.5; corner >= lowest; corner /= kCornerRatio)
            addProcess(portableExp(-kTwoPi * corner));
    }
    if (!m_processes.empty())
        m_weight = 1.0 / std::sqrt(static_cast<double>(m_processes.size()));
}

void NoiseSource::addProcess(double phi)
{
    m_processes.push_back({phi, std::sqrt((1.0 - phi) * (1.0 + phi)), m_random.nextNormal()});
}

void NoiseSource::addTo(std::span<double> values, double deviation)
{
    if (m_processes.empty()) {
        m_random.addNormal(values, deviation);
        return;
    }
    for (double &value : values) {
        double sum = 0.0;
        for (Process &process : m_processes) {
            sum += process.state;
            process.state
                = process.phi * process.state + process.innovation * m_random.nextNormal();
        }
        value += deviation * m_weight * sum;
    }
}

} // namespace dyncal
