// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/earlier_calibration.h"

#include <string>

namespace dyncal {

/// Whether the file begins as XML does; a results.json never does.
bool isXmlFile(const std::string &path);

/// A digital calibration certificate (readDcc(), certifiedSensor()) as an earlier calibration: its
/// `results` have what a history follows, under the keys of results.json (`response`,
/// `sensitivity`, `characteristics`), in SI units without prefix; the day is the last one of the
/// calibration. What of it could not be assigned is in `notAssigned`. Fails as readDcc(), and
/// (Usage) where the certificate states no day.
Result<EarlierCalibration> earlierCalibrationOfDcc(
    const std::string &file, const std::string &bytes);

/// The same of the file at `path`. Fails (FileUnreadable) where it cannot be read.
Result<EarlierCalibration> readEarlierDcc(const std::string &path);

} // namespace dyncal
