// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which quantities of a list are a response, and which results of a certificate are a sensor's.

#include "core/dcc_reading/certified_sensor.h"
#include "tests/support/made_dcc.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <string>

using namespace dyncal;
using testing::dccList;
using testing::dccListOf;
using testing::dccMarked;
using testing::dccOf;
using testing::dccQuantity;
using testing::isNear;

namespace {

const std::string kFrequencies = dccQuantity("1 10 100", "\\hertz");
const std::string kMagnitudes = dccQuantity("2 3 4", "\\volt\\pascal\\tothe{-1}", "0.2");

Result<CertifiedResponse> responseIn(const std::string &quantities)
{
    return readDcc(dccOf(dccList(quantities))).and_then([](const DccContents &contents) {
        return responseOf(contents.tables.at(0), std::nullopt);
    });
}

std::string faultOf(const std::string &quantities)
{
    const auto response = responseIn(quantities);
    return response ? std::string() : english(response.error().message);
}

bool isRefused(const std::string &quantities, const char *word)
{
    return faultOf(quantities).find(word) != std::string::npos;
}

CertifiedSensor sensorIn(const std::string &data)
{
    return certifiedSensor(readDcc(dccOf(data)).value());
}

} // namespace

class TestCertifiedSensor : public QObject
{
    Q_OBJECT

private slots:
    void sensitivities_ofEachInput_areKnownByTheirUnit()
    {
        for (const char *unit : {"\\volt\\pascal\\tothe{-1}", "\\pico\\coulomb\\bar\\tothe{-1}",
                 "\\milli\\volt\\newton\\tothe{-1}", "\\volt\\metre\\tothe{-1}\\second\\tothe{2}",
                 "\\milli\\volt\\volt\\tothe{-1}\\kilo\\pascal\\tothe{-1}", "\\per\\newton"})
            QVERIFY2(
                responseIn(kFrequencies + dccQuantity("2 3 4", unit, "0.2")).has_value(), unit);
        for (const char *unit :
            {"\\volt", "\\pascal", "\\volt\\second", "\\kelvin\\pascal\\tothe{-1}",
                "\\volt\\pascal\\tothe{-2}", "\\volt\\pascal\\tothe{-1}\\newton\\tothe{-1}"})
            QVERIFY2(
                isRefused(kFrequencies + dccQuantity("2 3 4", unit, "0.2"), "no magnitudes"), unit);
    }

    /// refTypes decide before uncertainties; nothing is guessed.
    void severalCandidates_needAMark()
    {
        const std::string nominal = dccQuantity("5 5 5", "\\volt\\pascal\\tothe{-1}");
        QCOMPARE(responseIn(kFrequencies + nominal + kMagnitudes)->magnitude.values[0], 2.0);
        QVERIFY(isRefused(kFrequencies + kMagnitudes + kMagnitudes, "several"));
        QVERIFY(
            isRefused(kFrequencies + kFrequencies + kMagnitudes, "several quantities in hertz"));
        const std::string angles = dccQuantity("1 1 1", "\\radian", "0.1");
        QVERIFY(isRefused(kFrequencies + kMagnitudes + angles + angles, "several angles"));
        QVERIFY(faultOf(kFrequencies + dccMarked(kFrequencies, "vib_frequency") + kMagnitudes
            + dccMarked(kMagnitudes, "basic_measuredValue") + angles
            + dccMarked(angles, "vib_phase"))
                    .empty());
        QCOMPARE(responseIn(kFrequencies + kMagnitudes + dccMarked(nominal, "basic_measuredValue"))
                     ->magnitude.values[0],
            5.0);
    }

    void complexValues_serveWhereThereAreNoRealOnes()
    {
        const std::string complex
            = testing::dccComplex("3 3 3", "4 4 4", "\\volt\\pascal\\tothe{-1}",
                {"1 1 1", "0 0 0", "1 1 1"}, "\\volt\\pascal\\tothe{-1}\\volt\\pascal\\tothe{-1}");
        const auto response = responseIn(kFrequencies + complex);
        QVERIFY(response.has_value());
        QCOMPARE(response->magnitude.values[0], 5.0);
        QVERIFY(isNear(response->phase_rad->values[0], std::atan2(4.0, 3.0), 1e-14));
        QCOMPARE(responseIn(kFrequencies + complex + kMagnitudes)->magnitude.values[0], 2.0);
    }

    void rows_mustBelongTogether()
    {
        QVERIFY(
            isRefused(kFrequencies + dccQuantity("2 3", "\\volt\\pascal\\tothe{-1}"), "2 values"));
        QVERIFY(isRefused(dccQuantity("0 1 2", "\\hertz") + kMagnitudes, "above 0"));
        QVERIFY(isRefused(dccQuantity("1 NaN 2", "\\hertz") + kMagnitudes, "above 0"));
        QVERIFY(isRefused(
            kFrequencies + dccQuantity("NaN NaN NaN", "\\volt\\pascal\\tothe{-1}"), "NaN only"));
        const auto some
            = responseIn(kFrequencies + dccQuantity("2 NaN 4", "\\volt\\pascal\\tothe{-1}"));
        QCOMPARE(some->frequency_Hz, (std::vector<double>{1, 100}));
        QCOMPARE(some->withoutValue, Index(1));
    }

    /// Where the quantity that is needed was not understood, its sentence is there.
    void reasons_areTold()
    {
        const std::string fault
            = faultOf(kFrequencies + dccQuantity("2 3 4", "\\volt\\knot\\tothe{-1}"));
        QVERIFY(fault.find("no magnitudes") != std::string::npos);
        QVERIFY2(fault.find("\\knot") != std::string::npos, fault.c_str());
    }

    void foreignCertificate_isAssignedByUnitAndName()
    {
        const CertifiedSensor sensor = sensorIn(
            dccQuantity("0.5", "\\volt\\mega\\pascal\\tothe{-1}", "0.1")
            + dccMarked(dccQuantity("50", "\\kilo\\hertz", "2"), "", "Natural frequency")
            + dccMarked(dccQuantity("60", "\\kilo\\hertz", "2"), "", "Upper limit")
            + dccMarked(dccQuantity("2", "\\percent", "1", "2.5"), "", "D\xC3\xA4mpfungsgrad")
            + dccList(kFrequencies + kMagnitudes) + dccList(dccQuantity("1 2", "\\kelvin"), "b"));
        QCOMPARE(sensor.serial, std::string("4711"));
        QVERIFY(isNear(sensor.sensitivity->value, 0.5e-6, 1e-12));
        QVERIFY(isNear(sensor.sensitivity->u, 0.05e-6, 1e-12));
        QCOMPARE(sensor.sensitivity->unit, std::string("V/Pa"));
        QVERIFY(isNear(sensor.naturalFrequency->value, 5e4, 1e-12));
        QVERIFY(isNear(sensor.dampingRatio->u, 0.004, 1e-12));
        QCOMPARE(sensor.response->frequency_Hz.size(), std::size_t(3));
        QCOMPARE(sensor.leftOut.size(), std::size_t(2)); // the limit, the temperatures
    }

    void severalResponses_areNotGuessed()
    {
        const CertifiedSensor sensor = sensorIn(
            dccList(kFrequencies + kMagnitudes) + dccList(kFrequencies + kMagnitudes, "b"));
        QVERIFY(!sensor.response);
        QCOMPARE(sensor.leftOut.size(), std::size_t(2));
        const CertifiedSensor two = sensorIn(kMagnitudes
            + dccQuantity("2", "\\volt\\pascal\\tothe{-1}") + dccQuantity("3", "\\per\\pascal"));
        QVERIFY(!two.sensitivity);
        QCOMPARE(two.leftOut.size(), std::size_t(3));
    }

    /// The certificate of this program: exact before printed response, k by degrees of freedom.
    void ownCertificate_isAssignedByRefTypes()
    {
        const std::string exact = dccListOf("dyncal_complexResponse",
            dccMarked(kFrequencies, "basic_tableIndex0 dyncal_frequency")
                + dccMarked(dccQuantity("2.5 3.5 4.5", "\\volt\\pascal\\tothe{-1}", "", "", "si:"),
                    "basic_measuredValue dyncal_magnitude")
                + dccMarked(
                    dccQuantity("9 9 9", "\\volt\\pascal\\tothe{-1}", "1"), "dyncal_modelMagnitude")
                + dccMarked(dccQuantity("NaN 4 NaN", "\\one"), "dyncal_degreesOfFreedom"));
        const std::string standard
            = "<si:measurementUncertaintyUnivariateXMLList><si:standardMUXMLList>"
              "<si:valueStandardMUXMLList>0.1 0.2 0.3</si:valueStandardMUXMLList></si:standardMUXMLList>"
              "</si:measurementUncertaintyUnivariateXMLList></si:realListXMLList>";
        std::string withU = exact;
        const std::string close = "</si:realListXMLList>";
        withU.replace(withU.find(close, withU.find("2.5 3.5")), close.size(), standard);
        const CertifiedSensor sensor = sensorIn(
            dccMarked(dccQuantity("5", "\\volt\\pascal\\tothe{-1}", "1"), "dyncal_sensitivity")
            + dccMarked(dccQuantity("6", "\\volt\\pascal\\tothe{-1}", "1"),
                "dyncal_sensitivity dyncal_lowLevel")
            + dccMarked(dccQuantity("7", "\\hertz", "1"), "dyncal_naturalFrequency")
            + dccMarked(dccQuantity("8", "\\hertz", "1"), "dyncal_resonanceFrequency")
            + dccMarked(dccQuantity("0.1", "\\one", "1"), "dyncal_dampingRatio")
            + dccListOf("dyncal_frequencyResponse", kFrequencies + kMagnitudes) + withU
            + dccListOf("dyncal_poles", kFrequencies));
        QCOMPARE(sensor.sensitivity->value, 5.0);
        QCOMPARE(sensor.naturalFrequency->value, 7.0);
        QCOMPARE(sensor.dampingRatio->value, 0.1);
        QCOMPARE(sensor.response->magnitude.values, (std::vector<double>{2.5, 3.5, 4.5}));
        QCOMPARE(sensor.response->magnitude.u[1], 0.2);
        QVERIFY(std::isnan(sensor.response->magnitude.k[0]));
        QVERIFY(isNear(sensor.response->magnitude.k[1], 2.7764451, 1e-7)); // Student, 4, 95 %
        QVERIFY(sensor.leftOut.empty());
    }

    void ownCertificate_namesItsRecordings()
    {
        const std::string first(64, 'b'), second(64, 'a');
        const auto of = [](const std::vector<std::string> &hashes) {
            return sensorIn(
                dccListOf("dyncal_recordings", testing::dccWords("dyncal_sha256", hashes)))
                .recordings;
        };
        QCOMPARE(of({first, second}), (std::vector<std::string>{second, first}));
        QVERIFY(of({first, "not known"}).empty()); // all or none
    }

    void ownCertificate_hasThePrintedResponseElse()
    {
        const CertifiedSensor sensor
            = sensorIn(dccListOf("dyncal_frequencyResponse", kFrequencies + kMagnitudes));
        QCOMPARE(sensor.response->magnitude.values[0], 2.0);
    }

    void serialNumbers_ofSeveralItems_areNotGuessed()
    {
        std::string whole = dccOf("");
        const std::size_t begin = whole.find("<dcc:item>"), end = whole.find("</dcc:items>");
        const std::string item = whole.substr(begin, end - begin);
        whole.insert(end, item);
        const CertifiedSensor sensor = certifiedSensor(readDcc(whole).value());
        QVERIFY(sensor.serial.empty());
        QVERIFY(english(sensor.whyNoSerial).find("4711, 4711") != std::string::npos);
    }

    /// Quantities in the right unit that are about the sensor's value, or of something else.
    void whatIsNoSensitivity_isNotTaken()
    {
        const std::string S = dccQuantity("5", "\\volt\\pascal\\tothe{-1}", "0.1"),
                          f = dccQuantity("3", "\\kilo\\hertz", "0.1"),
                          ratio = dccQuantity("2", "\\percent", "0.1");
        for (const char *type : {"basic_nominalValue", "basic_measurementError"})
            QVERIFY2(!sensorIn(dccMarked(S, type)).sensitivity, type);
        for (const char *name : {"Transverse sensitivity", "Expanded uncertainty", "U (k = 2)",
                 "Hysteresis (deviation)", "relative change per pressure"}) {
            const CertifiedSensor sensor = sensorIn(dccMarked(S, "", name));
            QVERIFY2(!sensor.sensitivity && sensor.leftOut.size() == 1, name);
        }
        for (const char *name :
            {"Deviation of natural frequency", "Uncertainty of the natural frequency (k=2)",
                "highest frequency below a third of the natural frequency"})
            QVERIFY2(!sensorIn(dccMarked(f, "", name)).naturalFrequency, name);
        for (const char *name : {"change of the damping ratio since last calibration",
                 "Uncertainty of the damping ratio"})
            QVERIFY2(!sensorIn(dccMarked(ratio, "", name)).dampingRatio, name);
        QVERIFY(sensorIn(dccMarked(S, "", "Sensitivity at nominal pressure (k = 2)")).sensitivity);
    }

    void neighboursOfUnreadOnes_areNotTaken()
    {
        const std::string unit = "\\volt\\pascal\\tothe{-1}", S = dccQuantity("5", unit),
                          bad = dccQuantity("5,0", unit);
        QVERIFY(!sensorIn(S + bad).sensitivity);
        QVERIFY(!sensorIn(S + dccMarked(dccQuantity("-9", "\\decibel"), "", "Sensitivity"))
                     .sensitivity);
        QVERIFY(sensorIn(S + dccQuantity("1", "\\furlong")).sensitivity);
        QVERIFY(sensorIn(dccMarked(S, "basic_measuredValue") + bad).sensitivity);
        QVERIFY(
            !sensorIn(dccMarked(S, "basic_measuredValue") + dccMarked(bad, "basic_measuredValue"))
                 .sensitivity);
        const auto natural = [](const std::string &value) {
            return dccMarked(dccQuantity(value, "\\kilo\\hertz"), "", "Natural frequency");
        };
        QVERIFY(sensorIn(natural("300")).naturalFrequency);
        QVERIFY(!sensorIn(natural("300") + natural("300,5")).naturalFrequency);
        // a list that is not understood may be the meant one
        const CertifiedSensor sensor = sensorIn(dccList(kFrequencies + kMagnitudes)
            + dccList(kFrequencies + dccQuantity("2,5 3 4", unit), "b"));
        QVERIFY(!sensor.response);
        QCOMPARE(sensor.leftOut.size(), std::size_t(2));
    }

    void phasesThatAreNotUnderstood_areToldOnce()
    {
        const CertifiedSensor sensor
            = sensorIn(dccList(kFrequencies + kMagnitudes + dccQuantity("1,5 2 3", "\\degree")));
        QVERIFY(sensor.response && !sensor.response->phase_rad);
        QCOMPARE(sensor.leftOut.size(), std::size_t(1));
        QVERIFY(english(sensor.leftOut[0]).find("1,5") != std::string::npos);
    }

    void rowsThatNoSensorHas_areRefused()
    {
        const auto faultIn = [](const std::string &quantities) {
            const CertifiedSensor sensor = sensorIn(dccList(quantities));
            return sensor.response || sensor.leftOut.empty() ? std::string()
                                                             : english(sensor.leftOut[0]);
        };
        const std::string unit = "\\volt\\pascal\\tothe{-1}";
        QVERIFY(faultIn(dccQuantity("100 1000 100", "\\hertz") + kMagnitudes)
                    .find("100 Hz more than once")
            != std::string::npos);
        QVERIFY(!faultIn(dccQuantity("0.1 100 1000", "\\kilo\\hertz \\hertz \\hertz") + kMagnitudes)
                     .empty());
        for (const char *low : {"2 -3 4", "2 0 4"})
            QVERIFY2(faultIn(kFrequencies + dccQuantity(low, unit)).find("at 10 Hz")
                    != std::string::npos,
                low);
        QVERIFY(faultIn(dccQuantity("100 10 1", "\\hertz") + kMagnitudes).empty()); // in any order
    }

    /// Elements that look like those of the D-SI and are of another namespace.
    void foreignElements_areNotRead()
    {
        std::string evil = dccOf(dccList(kFrequencies + kMagnitudes));
        const std::string open = "<si:realListXMLList>";
        const std::size_t at = evil.rfind(open);
        evil.insert(at + open.size() - 1, " xmlns:si=\"http://evil/\"");
        const CertifiedSensor sensor = certifiedSensor(readDcc(evil).value());
        QVERIFY(!sensor.response);
        QVERIFY(
            english(sensor.leftOut[0]).find("{http://evil/}realListXMLList") != std::string::npos);
        const auto list
            = readDcc(dccOf(dccList(kFrequencies + "<x:quantity xmlns:x='evil'/>"))).value();
        QVERIFY(english(list.tables[0].notUnderstood.at(0)).find("{evil}quantity")
            != std::string::npos);
        const auto single = readDcc(dccOf("<x:quantity xmlns:x='evil'/>")).value();
        QCOMPARE(single.notUnderstood.size(), std::size_t(1));
    }
};

DYNCAL_TEST(TestCertifiedSensor)
#include "tst_certified_sensor.moc"
