// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/signal_settings.h"

#include <array>

namespace dyncal {
namespace {

constexpr std::array kTreatments{ResponseTreatment::StepDeflated, ResponseTreatment::StepAsImpulse,
    ResponseTreatment::Differenced, ResponseTreatment::Impulse};

} // namespace

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

std::optional<ResponseTreatment> responseTreatmentFromName(std::string_view name)
{
    for (const ResponseTreatment treatment : kTreatments) {
        if (name == responseTreatmentName(treatment))
            return treatment;
    }
    return std::nullopt;
}

} // namespace dyncal
