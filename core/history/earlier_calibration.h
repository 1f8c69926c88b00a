// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/recheck/earlier_run.h"
#include "core/results/method_versions.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A digital calibration certificate that a calibration is read from.
struct CertificateSource
{
    std::string number = {}; ///< as its laboratory writes it
    std::string laboratory = {};
    std::string version = {}; ///< of the schema; empty: it is read from a results.json
};

/// One calibration of a sensor, as its results.json, or its certificate (DCC), has it.
struct EarlierCalibration
{
    std::string file; ///< the results.json, or the certificate
    Index number = 0; ///< of its certificate; 0: none that is known of
    std::string serial; ///< of the sensor; empty: not stated
    std::string time = {}; ///< day of the calibration, else the moment of the results (UTC)
    double day = 0.0; ///< since 1970
    bool isDayOfCalibration = false;
    std::string createdUtc; ///< of the results
    std::optional<MethodVersions> methods; ///< empty: from before they were recorded
    std::string jobSha256 = {}; ///< of what its certificate is made of; empty: not known
    std::string blocked; ///< why nothing could be issued; empty: it could
    /// Why the laboratory does not stand by its certificate any more; empty: it does, or there is
    /// none, or no registry was asked.
    std::string notInForce = {};
    std::vector<std::string> recordings; ///< SHA-256 of each, sorted; empty: not stated
    nlohmann::json results;
    std::vector<Message> remarks;
    CertificateSource dcc = {};
    std::string whyNoSerial = {}; ///< of a certificate without a serial number
    /// Of a certificate: a sentence for everything in it that could not be assigned.
    std::vector<Message> notAssigned = {};
};

/// What a results.json says of the calibration: serial number and day are the fields of its
/// certificate (`certificate.fields.sensor_serial`, `date_performed`). Fails (Usage) where neither
/// that day nor `created_utc` says when it was.
Result<EarlierCalibration> earlierCalibration(EarlierResults read, Index number = 0);

/// Every results.json that the paths stand for: a file itself, a folder all that it holds at any
/// depth (runFoldersBelow()); each once. Fails as runFoldersBelow().
Result<std::vector<std::string>> resultsFilesOf(const std::vector<std::string> &paths);

} // namespace dyncal
