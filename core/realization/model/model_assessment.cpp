// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_assessment.h"

namespace dyncal {

const std::vector<Pole> &polesOf(const SensorModel &model, const ModelAssessment *assessment)
{
    return assessment ? assessment->poles : model.poles;
}

const Pole *mainPole(const SensorModel &model, const ModelAssessment *assessment)
{
    return mainPole(polesOf(model, assessment), model.series);
}

} // namespace dyncal
