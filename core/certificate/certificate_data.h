// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/auto_value.h"
#include "core/base/finding.h"
#include "core/base/message.h"
#include "core/capture/capture_set.h"
#include "core/model_analysis/sensor_response.h"
#include "core/realization/hankel_decomposition.h"
#include "core/realization/model_input.h"
#include "core/realization/order_evidence.h"
#include "core/realization/sensor_model.h"
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

/// One line "label: value".
struct CertificateField
{
    std::string id; ///< stable: "laboratory", "natural_frequency"
    Message label;
    Message value;
    bool missing = false; ///< must be there before the certificate can be issued
};

struct CertificateColumn
{
    Message heading;
    bool number = false; ///< set to the right
};

struct CertificateTable
{
    std::string id;
    Message caption;
    std::vector<CertificateColumn> columns;
    std::vector<std::vector<Message>> rows; ///< as many cells as columns
};

struct CertificateFigure
{
    std::string id; ///< "singular-values", "model-data", "model-error", "magnitude", ...
    Message caption;
};

struct CertificateSection
{
    std::string id;
    Message title;
    std::vector<Message> paragraphs; ///< before the fields
    std::vector<CertificateField> fields;
    std::vector<CertificateTable> tables;
    std::vector<Message> notes; ///< after the tables
    std::vector<CertificateFigure> figures;
};

/// A certificate as words and rounded numbers, ready to be set: no layout, no floating point.
struct CertificateData
{
    std::string language;
    std::string createdUtc;
    std::string number; ///< empty = none yet
    Message title;
    bool draft = true; ///< stays so until a certificate can be signed
    std::vector<CertificateSection> sections;

    /// Labels of all fields that are missing, in order.
    std::vector<Message> missingFields() const;
    const CertificateSection *section(const std::string &id) const;
};

CertificateData makeCertificate(const CertificateSources &sources);

} // namespace dyncal
