// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/front_effect.h"

#include "core/realization/exponentials/front.h"
#include "core/uncertainty/model_shape.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

FrontRange frontRange(const FrontDuration &front)
{
    if (isFrontStated(front))
        return {"front_duration_s", std::max(0.0, front.duration_s - front.u_s),
            front.duration_s + front.u_s, 2.0};
    return {"front_unknown", 0.0, kUnstatedFront_s, std::sqrt(5.0)};
}

SensorModel withFront(const SensorModel &model, double from_s, double to_s)
{
    return withAmplitudes(model, [=](std::complex<double> s_rad_s) {
        return frontFactor(from_s, s_rad_s) / frontFactor(to_s, s_rad_s);
    });
}

FrontVariation frontVariation(const SensorModel &model, const FrontDuration &front)
{
    const FrontRange range = frontRange(front);
    return {range, withFront(model, front.duration_s, range.shorter_s),
        withFront(model, front.duration_s, range.longer_s)};
}

} // namespace dyncal
