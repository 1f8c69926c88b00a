// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/signal_settings.h"

namespace dyncal {

const char *responseTreatmentName(ResponseTreatment treatment)
{
    switch (treatment) {
    case ResponseTreatment::StepDeflated:
        return "step-deflated";
    case ResponseTreatment::StepAsImpulse:
        return "step-as-impulse";
    case ResponseTreatment::Differenced:
        return "differenced";
    case ResponseTreatment::Impulse:
        return "impulse";
    }
    return "";
}

Auto<double> WindowSettings::endOfShot_s(Index shot) const
{
    if (ownEnds_s.empty())
        return end_s;
    const auto at = static_cast<std::size_t>(shot - 1);
    return shot >= 1 && at < ownEnds_s.size() ? ownEnds_s[at] : Auto<double>();
}

} // namespace dyncal
