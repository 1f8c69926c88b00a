// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/history/earlier_calibration.h"

#include <string>
#include <vector>

namespace dyncal {

/// |S(f)| at one frequency.
struct ResponseRow
{
    double frequency_Hz = kUnknown;
    double magnitude = kUnknown;
    double U = kUnknown; ///< NaN: not stated, or not complete
};

/// S(f) of earlier results, to be laid over the present one.
struct EarlierResponse
{
    std::string file;
    std::string serial; ///< of the sensor; empty: not stated
    std::string time; ///< day of the calibration, else the moment of the results
    std::string unit; ///< of the magnitudes
    std::vector<ResponseRow> rows = {}; ///< those with a magnitude
    std::string certificate = {}; ///< number of the one (DCC) that it is read from
    /// Of a certificate: a sentence for everything in it that could not be assigned.
    std::vector<Message> notAssigned = {};
};

/// The rows of these results with the certificate's U (followedValue()). Fails (Usage) where they
/// have none.
Result<EarlierResponse> earlierResponse(const EarlierCalibration &calibration);

/// The same of a results.json, of a folder that holds one, or of a digital calibration certificate
/// (readEarlierDcc()). Fails as readEarlierResults() and earlierCalibration() do.
Result<EarlierResponse> readEarlierResponse(const std::string &path);

/// The rows in another unit of the same quantity ("C/Pa" as "pC/Pa"); false, and nothing is
/// changed, where it is not one.
bool toUnit(EarlierResponse &response, const std::string &unit);

/// How two responses agree at the frequencies that both have.
struct ResponseAgreement
{
    Index compared = 0; ///< rows of the same frequency (kSameRow), both with U
    Index agreeing = 0; ///< |E_n| up to 1
    double largestEn = kUnknown; ///< of the largest absolute value
    double at_Hz = kUnknown; ///< its frequency
};

/// E_n (normalisedError()) of each of `present` against the row of `earlier` at the same frequency,
/// both in one unit. Rows without U are not compared, and nothing is interpolated.
ResponseAgreement agreementOf(
    const std::vector<ResponseRow> &present, const std::vector<ResponseRow> &earlier);

} // namespace dyncal
