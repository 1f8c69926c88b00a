// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <array>
#include <string>
#include <vector>

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

/// Complex values of a list in rectangular form, their covariance as var Re, cov, var Im; `unit2`
/// is the square of the unit.
inline std::string dccComplex(const std::string &re, const std::string &im, const std::string &unit,
    const std::array<std::string, 3> &covariance, const std::string &unit2)
{
    const auto tag = [](const char *name, const std::string &content) {
        return std::string("<si:") + name + ">" + content + "</si:" + name + ">";
    };
    const auto entry = [&](std::size_t i) {
        return tag(
            "covarianceXMLList", tag("valueXMLList", covariance[i]) + tag("unitXMLList", unit2));
    };
    const std::string matrix = tag("covarianceMatrixXMLList",
        tag("columnXMLList", entry(0) + entry(1)) + tag("columnXMLList", entry(1) + entry(2)));
    const std::string region = tag("measurementUncertaintyBivariateXMLList",
        tag("ellipsoidalRegionMUXMLList",
            matrix + tag("coverageFactorXMLList", "2.45")
                + tag("coverageProbabilityXMLList", "0.95")));
    return "<dcc:quantity>"
        + tag("complexListXMLList",
            tag("valueRealXMLList", re) + tag("valueImagXMLList", im) + tag("unitXMLList", unit)
                + region)
        + "</dcc:quantity>";
}

/// Words in place of numbers, each an entry of its own.
inline std::string dccWords(const std::string &refType, const std::vector<std::string> &entries)
{
    std::string contents;
    for (const std::string &entry : entries)
        contents += "<dcc:content>" + entry + "</dcc:content>";
    return "<dcc:quantity refType=\"" + refType + "\"><dcc:noQuantity>" + contents
        + "</dcc:noQuantity></dcc:quantity>";
}

/// The quantity with a refType and a name.
inline std::string dccMarked(
    std::string quantity, const std::string &refType, const std::string &name = "")
{
    const std::string open = "<dcc:quantity>";
    return quantity.replace(0, open.size(),
        "<dcc:quantity" + (refType.empty() ? "" : " refType=\"" + refType + "\"") + ">"
            + (name.empty() ? "" : "<dcc:name><dcc:content>" + name + "</dcc:content></dcc:name>"));
}

/// A list with a refType and without an id.
inline std::string dccListOf(const std::string &refType, const std::string &quantities)
{
    return "<dcc:list refType=\"" + refType + "\">" + quantities + "</dcc:list>";
}

inline std::string dccList(const std::string &quantities, const std::string &id = "a")
{
    return "<dcc:list id=\"" + id + "\">" + quantities + "</dcc:list>";
}

/// A certificate with the number K-17 of a sensor with the serial number 4711, calibrated
/// 2025-03-04; `data` is what one result holds.
inline std::string dccOf(const std::string &data, const std::string &version = "3.3.0")
{
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<dcc:digitalCalibrationCertificate "
           "xmlns:dcc=\"https://ptb.de/dcc\" xmlns:si=\"https://ptb.de/si\" schemaVersion=\""
        + version
        + "\">\n<dcc:administrativeData>\n<dcc:coreData><dcc:uniqueIdentifier>K-17"
          "</dcc:uniqueIdentifier><dcc:beginPerformanceDate>2025-03-03</dcc:beginPerformanceDate>"
          "<dcc:endPerformanceDate>2025-03-04</dcc:endPerformanceDate></dcc:coreData>\n"
          "<dcc:items><dcc:item><dcc:name><dcc:content lang=\"de\">Aufnehmer</dcc:content>"
          "<dcc:content lang=\"en\">Sensor</dcc:content></dcc:name><dcc:identifications>"
          "<dcc:identification refType=\"basic_serialNumber\"><dcc:issuer>manufacturer</dcc:issuer>"
          "<dcc:value>4711</dcc:value></dcc:identification></dcc:identifications></dcc:item>"
          "</dcc:items>\n<dcc:calibrationLaboratory><dcc:contact><dcc:name><dcc:content>A laboratory"
          "</dcc:content></dcc:name></dcc:contact></dcc:calibrationLaboratory>\n"
          "</dcc:administrativeData>\n<dcc:measurementResults><dcc:measurementResult><dcc:results>"
          "<dcc:result><dcc:data>\n"
        + data
        + "\n</dcc:data></dcc:result></dcc:results></dcc:measurementResult></dcc:measurementResults>"
          "</dcc:digitalCalibrationCertificate>";
}

} // namespace dyncal::testing
