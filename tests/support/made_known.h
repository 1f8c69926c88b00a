// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/known_value.h"

namespace dyncal::testing {

inline ReportedValue voltsPerPascal(double value, double u)
{
    ReportedValue reported{"magnitude", value, "V/Pa"};
    reported.lines = {directLine("certificate", u)};
    combineLines(reported);
    return reported;
}

/// 2 uV/Pa with u = 4 nV/Pa of another calibration beside 2.02 uV/Pa with 10 nV/Pa here.
inline KnownValue madeKnown(double e_n, double frequency_Hz = 0.0, const char *label = "works")
{
    KnownValue one;
    one.stated = {label, frequency_Hz, 2e-6, 4e-9, "V/Pa", {}, "K 7"};
    one.other = voltsPerPascal(2e-6, 4e-9);
    one.here = voltsPerPascal(2.02e-6, 1e-8);
    one.against = KnownAgainst::Sensitivity;
    one.e_n = e_n;
    return one;
}

/// One that could not be compared, of no certificate.
inline KnownValue madeUncompared()
{
    KnownValue none = madeKnown(kUnknown, 2e6, "far");
    none.against = KnownAgainst::Nothing;
    none.here = {"magnitude", kUnknown, "V/Pa"};
    none.stated.certificate.clear();
    none.missing = {"%1 is above the band, which ends at %2", {"2 MHz", "1 MHz"}};
    return none;
}

} // namespace dyncal::testing
