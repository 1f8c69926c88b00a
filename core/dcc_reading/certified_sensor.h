// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc_reading/dcc_response.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// One value with u and k as StatedValues has them.
struct CertifiedValue
{
    std::string name; ///< as the certificate calls it
    Index line = 0;
    std::string unit; ///< without prefix, "V/Pa"
    double value = 0.0;
    double u = 0.0; ///< NaN: none is stated
    double k = 0.0; ///< NaN: not stated
};

/// What a certificate says of the sensor that it is of, as far as it can be assigned.
struct CertifiedSensor
{
    std::string serial; ///< empty: not known
    Message whyNoSerial = {}; ///< where it is empty
    std::optional<CertifiedResponse> response = {};
    std::optional<CertifiedValue> sensitivity = {}; ///< that holds for no single frequency
    std::optional<CertifiedValue> naturalFrequency = {}; ///< in Hz
    std::optional<CertifiedValue> dampingRatio = {};
    std::vector<std::string> recordings = {}; ///< SHA-256, sorted: of this program's certificates
    std::vector<Message> leftOut = {}; ///< a sentence for everything else among the results
};

/// Results of this program's own certificates are assigned by their refTypes (own_certificate.h),
/// and what else is in them is not named in leftOut; those of others by unit and name: a response
/// is the only list that responseOf() reads and that has each frequency once and magnitudes above
/// 0, where no other might be one (mightBeResponse()); a sensitivity the only single quantity in
/// such a unit (of several the only basic_measuredValue), natural frequency and damping ratio the
/// only ones in hertz and without unit that are called so in English or German (isCalled()). What
/// is about a value (isAboutAValue()) is none of them, and beside one that is not understood and
/// may be it no other is taken. The serial number is that of the only item that has one.
CertifiedSensor certifiedSensor(const DccContents &contents);

} // namespace dyncal
