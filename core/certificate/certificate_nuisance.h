// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"

#include <string>

namespace dyncal {

/// Tables of the modes left out of the model, and of their effect, which is known once the model is
/// assessed; nothing without modes. `gainUnit` is the unit of the responses as analysed: "1" if
/// remapped, empty if not known.
void addNuisance(const SensorModel &model, const ModelAssessment *assessment,
    const std::string &gainUnit, CertificateSection &section);

/// Table of the stretches left out of the fit; nothing without any.
void addLeftOut(const ModelInput &input, CertificateSection &section);

} // namespace dyncal
