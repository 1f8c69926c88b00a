// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <map>
#include <optional>
#include <string>

namespace dyncal {

/// What has become of a number.
enum class CertificateState {
    Reserved, ///< for a job whose files are not all there yet
    Issued,
    Amended, ///< issued as the amendment of another one
    Replaced, ///< by an amendment
    Withdrawn,
    Void ///< never issued
};

const char *certificateStateName(CertificateState state); ///< "reserved", ...
std::optional<CertificateState> certificateState(const std::string &name);

/// Whether a certificate of this state is what the laboratory stands by.
bool isInForce(CertificateState state);

/// A number of the registry and all that is known of it.
struct CertificateRecord
{
    Index number = 0; ///< from 1
    CertificateState state = CertificateState::Reserved;
    std::string job = {}; ///< SHA-256 of the recordings: what is calibrated
    std::string jobSha256 = {}; ///< of all that the certificate is made of
    std::string reservedUtc = {}; ///< ISO 8601 with Z; also the time that the certificate states
    std::string issuedUtc = {}; ///< of the last step; empty before
    std::string by = {}; ///< who issues it
    std::string reviewedBy = {}; ///< empty: nobody
    std::string sensor = {}; ///< manufacturer, model, serial number
    std::string customer = {};
    Index amends = 0; ///< number of the certificate that it replaces; 0: none
    Index replacedBy = 0; ///< 0: none
    std::string reason = {}; ///< of the amendment, the withdrawal or why it is void
    std::string head = {}; ///< of the audit trail before issuing; stands on the certificate
    std::map<std::string, std::string> files = {}; ///< SHA-256 by name, once issued

    bool operator==(const CertificateRecord &) const = default;
};

/// "certificate 17": the object of its entries in the audit trail.
std::string certificateObject(Index number);

/// As JSON on one line, keys sorted: what a row and the audit trail hold.
std::string recordJson(const CertificateRecord &record);

/// Reads it back; empty where it is no record.
std::optional<CertificateRecord> parseRecord(const std::string &json);

} // namespace dyncal
