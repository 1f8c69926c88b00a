// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/auto_value.h"
#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/capture/capture_set.h"
#include "core/model_analysis/sensor_response.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/order/order_evidence.h"
#include "core/shock/shock_conditions.h"
#include "core/signal/response_window.h"

#include <map>
#include <string>
#include <vector>

namespace dyncal {

/// A caution the operator has seen, with the reason given.
struct CertificateAcknowledgement
{
    std::string finding;
    Index shot = 0; ///< 0 = all shots
    std::string reason;
};

/// Everything a certificate is written from. Null = that stage has no result; the certificate then
/// says "not determined" and why.
struct CertificateSources
{
    const CaptureSet *captures = nullptr;
    const WindowResult *window = nullptr;
    const ShockConditionsSet *shock = nullptr;
    const ModelInput *input = nullptr;
    const OrderSuggestion *suggestion = nullptr;
    const OrderEvidence *evidence = nullptr;
    const SensorModel *model = nullptr;
    const ModelAssessment *assessment = nullptr; ///< of the model
    const ResponseResult *response = nullptr;
    Auto<Index> order; ///< as asked for
    std::string orderReason; ///< typed: why this order was adopted
    double coverage = 0.95; ///< probability for which the step's U is stated
    Findings findings;
    std::vector<CertificateAcknowledgement> acknowledgements;
    std::map<std::string, std::string> fields; ///< typed: keys in docs/certificate.md
    std::string language = "en";
    std::string createdUtc; ///< ISO 8601 with Z
    std::string softwareVersion;
    std::string softwareBuild;
};

} // namespace dyncal
