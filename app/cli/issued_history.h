// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/sensor_history.h"
#include "registry/certificates/certificate_record.h"

#include <string>

namespace dyncal {

/// What the certificates in `folder` state of the sensor of `results` (results.json, which are
/// the last point), as far as they are in force: withdrawn, replaced and amended ones, runs without
/// a number and other sensors take no part. `registry` as for lookUpStates(). Files are named from
/// `folder`: nothing tells where it lies. Fails (Usage) where the results.json of one cannot be
/// read, as the history would lack it unseen, and where the sensor has no serial number.
Result<SensorHistory> issuedHistory(const std::string &folder, const std::string &registry,
    const CertificateRecord &record, const std::string &results);

} // namespace dyncal
