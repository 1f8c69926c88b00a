// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace dyncal::testing {

/// A quantity of a list in a digital calibration certificate; U and k empty: without uncertainty.
inline std::string dccQuantity(const std::string &values, const std::string &unit,
    const std::string &U = "", const std::string &k = "2", const std::string &si = "si:")
{
    const auto tag = [&](const char *name, const std::string &content) {
        return "<" + si + name + ">" + content + "</" + si + name + ">";
    };
    std::string list = tag("valueXMLList", values) + tag("unitXMLList", unit);
    if (!U.empty())
        list += tag("measurementUncertaintyUnivariateXMLList",
            tag("expandedMUXMLList",
                tag("valueExpandedMUXMLList", U) + tag("coverageFactorXMLList", k)));
    return "<dcc:quantity>" + tag("realListXMLList", list) + "</dcc:quantity>";
}

inline std::string dccList(const std::string &quantities, const std::string &id = "a")
{
    return "<dcc:list id=\"" + id + "\">" + quantities + "</dcc:list>";
}

/// A certificate with the number K-17.
inline std::string dccOf(const std::string &lists)
{
    return "<?xml version=\"1.0\"?><dcc:digitalCalibrationCertificate xmlns:dcc=\"d\" "
           "xmlns:si=\"s\"><dcc:coreData><dcc:uniqueIdentifier>K-17</dcc:uniqueIdentifier>"
           "</dcc:coreData>"
        + lists + "</dcc:digitalCalibrationCertificate>";
}

} // namespace dyncal::testing
