// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/model_input.h"

namespace dyncal {

bool roundingCounts(const ModelSeries &series)
{
    constexpr double kShare = 0.1; // of the noise
    return series.roundingSd > kShare * series.noiseSd;
}

bool isThesisMode(const ModelInput &input)
{
    return input.treatment == ResponseTreatment::StepAsImpulse;
}

double sampleInterval_s(const ModelInput &input)
{
    return 1.0 / input.sampleRate_Hz;
}

} // namespace dyncal
