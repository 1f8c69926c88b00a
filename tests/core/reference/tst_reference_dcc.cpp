// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A reference transducer's digital calibration certificate.

#include "core/reference/reference_dcc.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <string>

using namespace dyncal;
using testing::isNear;

namespace {

std::string quantity(const char *values, const char *unit, const char *U = "", const char *k = "2")
{
    std::string text = std::string("<dcc:quantity><si:realListXMLList><si:valueXMLList>") + values
        + "</si:valueXMLList><si:unitXMLList>" + unit + "</si:unitXMLList>";
    if (*U != '\0')
        text += std::string("<si:measurementUncertaintyUnivariateXMLList><si:expandedMUXMLList>"
                            "<si:valueExpandedMUXMLList>")
            + U + "</si:valueExpandedMUXMLList><si:coverageFactorXMLList>" + k
            + "</si:coverageFactorXMLList></si:expandedMUXMLList>"
              "</si:measurementUncertaintyUnivariateXMLList>";
    return text + "</si:realListXMLList></dcc:quantity>";
}

const std::string kFrequencies = quantity("1 10 100", "\\kilo\\hertz");
const std::string kMagnitudes
    = quantity("0.1 0.2 0.3", "\\volt\\mega\\pascal\\tothe{-1}", "0.002 0.004 0.006");

std::string certificate(const std::string &lists)
{
    return "<?xml version=\"1.0\"?><dcc:digitalCalibrationCertificate xmlns:dcc=\"d\" "
           "xmlns:si=\"s\"><dcc:coreData><dcc:uniqueIdentifier>K-17</dcc:uniqueIdentifier>"
           "</dcc:coreData>"
        + lists + "</dcc:digitalCalibrationCertificate>";
}

std::string list(const std::string &quantities, const std::string &id = "a")
{
    return "<dcc:list id=\"" + id + "\">" + quantities + "</dcc:list>";
}

std::string faultOfXml(const std::string &xml, const std::string &id = "")
{
    const auto made = readReferenceDcc(xml, id, "V/Pa");
    return made ? std::string() : english(made.error().message);
}

} // namespace

class TestReferenceDcc : public QObject
{
    Q_OBJECT

private slots:
    void sensitivity_isRead_inSiUnits_withUOverK()
    {
        const std::string phases = quantity("-1 -2 -4", "\\degree", "0.5", "2.5");
        const auto made
            = readReferenceDcc(certificate(list(kFrequencies + kMagnitudes + phases)), "", "V/Pa");
        QVERIFY(made.has_value());
        QCOMPARE(made->certificate, std::string("K-17"));
        const ReferencePoint point = made->sensitivity.at(1e4).value();
        QVERIFY(isNear(point.magnitude, 0.2e-6, 1e-12));
        QVERIFY(isNear(point.u_magnitude, 0.002e-6, 1e-12));
        QVERIFY(isNear(point.phase_rad, -2.0 * std::numbers::pi / 180.0, 1e-12));
        QVERIFY(isNear(point.u_phase_rad, 0.2 * std::numbers::pi / 180.0, 1e-12)); // one U for all
        QVERIFY(isNear(made->sensitivity.highest_Hz(), 1e5));
    }

    void phase_mayBeMissing()
    {
        const auto made
            = readReferenceDcc(certificate(list(kFrequencies + kMagnitudes)), "a", "V/Pa");
        QVERIFY(std::isnan(made->sensitivity.at(1e3)->phase_rad));
    }

    void list_isNamed_whereThereAreSeveral()
    {
        const std::string two
            = certificate(list(kFrequencies + kMagnitudes) + list(kFrequencies + kMagnitudes, "b"));
        QVERIFY(faultOfXml(two).find("2 lists") != std::string::npos);
        QVERIFY(faultOfXml(two, "b").empty());
        QVERIFY(faultOfXml(two, "c").find("'c'") != std::string::npos);
    }

    void whatIsMissing_isTold()
    {
        QVERIFY(faultOfXml(certificate(list(kFrequencies))).find("V/Pa") != std::string::npos);
        const std::string noU = quantity("0.1 0.2 0.3", "\\volt\\mega\\pascal\\tothe{-1}");
        QVERIFY(
            faultOfXml(certificate(list(kFrequencies + noU))).find("V/Pa") != std::string::npos);
        const std::string two = quantity("0.1 0.2", "\\volt\\mega\\pascal\\tothe{-1}", "0.002");
        QVERIFY(!faultOfXml(certificate(list(kFrequencies + two))).empty());
        QVERIFY(faultOfXml(certificate("")).find("0 lists") != std::string::npos);
    }

    void otherFiles_areRefused()
    {
        for (const char *text :
            {"", "<a>", "<svg/>", "plain", "<!DOCTYPE x [<!ENTITY e 'e'>]><x>&e;</x>"}) {
            const auto made = readReferenceDcc(text, "", "V/Pa");
            QVERIFY(!made && made.error().kind == ErrorKind::FileUnreadable);
        }
    }
};

DYNCAL_TEST(TestReferenceDcc)
#include "tst_reference_dcc.moc"
