// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/normalised_step.h"

#include <cstddef>

namespace dyncal {

ExponentialSum normalisedStep(const SensorModel &model)
{
    if (!model.slowPoles.empty())
        return model.sensorStep;
    ExponentialSum sum{1.0, Eigen::VectorXcd(model.amplitudes.size()), model.amplitudes};
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i)
        sum.poles_rad_s[i] = model.poles[static_cast<std::size_t>(i)].s_rad_s;
    sum.amplitudes /= model.plateauGain;
    return sum;
}

} // namespace dyncal
