// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/order/order_spread.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kSamePole = 0.1; ///< relative distance of frequencies within which a pole is meant

const OrderPole *nearestPole(const OrderEvidence &evidence, Index order, double frequency_Hz)
{
    const OrderPole *nearest = nullptr;
    for (const OrderPole &pole : evidence.poles) {
        if (pole.order == order && pole.stability != PoleStability::Unstable
            && std::abs(pole.frequency_Hz - frequency_Hz) <= kSamePole * frequency_Hz
            && (!nearest
                || std::abs(pole.frequency_Hz - frequency_Hz)
                    < std::abs(nearest->frequency_Hz - frequency_Hz)))
            nearest = &pole;
    }
    return nearest;
}

/// Mean of one value over the poles; `spread` receives half its range.
double meanOf(const std::vector<const OrderPole *> &poles, double OrderPole::*value, double &spread)
{
    double sum = 0.0;
    double low = poles.front()->*value;
    double high = low;
    for (const OrderPole *pole : poles) {
        sum += pole->*value;
        low = std::min(low, pole->*value);
        high = std::max(high, pole->*value);
    }
    spread = (high - low) / 2.0;
    return sum / static_cast<double>(poles.size());
}

} // namespace

std::optional<OrderSpread> spreadAround(
    const OrderEvidence &evidence, Index order, double frequency_Hz)
{
    const OrderPole *here = nearestPole(evidence, order, frequency_Hz);
    if (!here)
        return std::nullopt;
    std::vector<const OrderPole *> chain{here};
    const auto isStable = [](const OrderPole *p) {
        return p && p->stability == PoleStability::FrequencyAndDamping;
    };
    for (const OrderPole *pole = here; isStable(pole);) {
        pole = nearestPole(evidence, pole->order - 1, pole->frequency_Hz);
        if (pole)
            chain.insert(chain.begin(), pole);
    }
    for (const OrderPole *pole = here;;) {
        pole = nearestPole(evidence, pole->order + 1, pole->frequency_Hz);
        if (!isStable(pole))
            break;
        chain.push_back(pole);
    }
    OrderSpread spread;
    spread.fromOrder = chain.front()->order;
    spread.toOrder = chain.back()->order;
    spread.frequency_Hz = meanOf(chain, &OrderPole::frequency_Hz, spread.frequencySpread_Hz);
    spread.dampingRatio = meanOf(chain, &OrderPole::dampingRatio, spread.dampingSpread);
    return spread;
}

} // namespace dyncal
