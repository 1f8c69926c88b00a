// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certificates as laboratories write them, one for each version of the schema: a pressure sensor
// (3.3), a force transducer (3.2), an accelerometer (3.1) and a charge amplifier's chain (3.0).
// What was put into each is what is read.

#include "core/dcc_reading/certified_sensor.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <numbers>
#include <string>

using namespace dyncal;
using testing::isNear;

namespace {

/// The frame that all have in common: `prefix` of the schema's namespace, the item's
/// identification, what the result holds.
std::string certificate(const std::string &version, const std::string &prefix,
    const std::string &identification, const std::string &data)
{
    std::string text
        = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
          "<?xml-stylesheet type=\"text/xsl\" href=\"dcc.xsl\"?>\n"
          "<!-- written by hand -->\n"
          "<P:digitalCalibrationCertificate xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"\n"
          "    xmlns:P=\"https://ptb.de/dcc\" xmlns:si=\"https://ptb.de/si\" schemaVersion=\"VERSION\"\n"
          "    xsi:schemaLocation=\"https://ptb.de/dcc https://ptb.de/dcc/vVERSION/dcc.xsd\">\n"
          "  <P:administrativeData>\n"
          "    <P:dccSoftware><P:software><P:name><P:content>Editor</P:content></P:name>\n"
          "      <P:release>1.0</P:release></P:software></P:dccSoftware>\n"
          "    <P:coreData>\n"
          "      <P:countryCodeISO3166_1>DE</P:countryCodeISO3166_1>\n"
          "      <P:uniqueIdentifier>5012</P:uniqueIdentifier>\n"
          "      <P:beginPerformanceDate>2021-02-01</P:beginPerformanceDate>\n"
          "      <P:endPerformanceDate>2021-02-03</P:endPerformanceDate>\n"
          "      <P:performanceLocation>laboratory</P:performanceLocation>\n"
          "    </P:coreData>\n"
          "    <P:items><P:item><P:name><P:content lang=\"de\">Aufnehmer</P:content></P:name>\n"
          "      <P:model>M-1</P:model>\n"
          "      <P:identifications>IDENTIFICATION</P:identifications></P:item></P:items>\n"
          "    <P:calibrationLaboratory><P:contact><P:name><P:content>Labor</P:content></P:name></P:contact>\n"
          "    </P:calibrationLaboratory>\n"
          "  </P:administrativeData>\n"
          "  <P:measurementResults><P:measurementResult>\n"
          "    <P:name><P:content lang=\"de\">Messergebnisse</P:content></P:name>\n"
          "    <P:influenceConditions><P:influenceCondition><P:name><P:content>T</P:content></P:name><P:data>\n"
          "      <P:quantity><si:real><si:value>23</si:value><si:unit>\\degreecelsius</si:unit></si:real>\n"
          "      </P:quantity></P:data></P:influenceCondition></P:influenceConditions>\n"
          "    <P:results><P:result><P:name><P:content lang=\"de\">Ergebnis</P:content></P:name>\n"
          "      <P:data>DATA</P:data></P:result></P:results>\n"
          "  </P:measurementResult></P:measurementResults>\n"
          "</P:digitalCalibrationCertificate>\n";
    const auto replace = [&text](const std::string &what, const std::string &with) {
        for (std::size_t at = text.find(what); at != text.npos;
             at = text.find(what, at + with.size()))
            text.replace(at, what.size(), with);
    };
    replace("IDENTIFICATION", identification);
    replace("DATA", data);
    replace("VERSION", version);
    replace("xmlns:P", prefix.empty() ? "xmlns" : "xmlns:" + prefix);
    replace("P:", prefix.empty() ? "" : prefix + ":");
    return text;
}

CertifiedSensor sensorOf(const std::string &text)
{
    const Result<DccContents> contents = readDcc(text);
    return contents ? certifiedSensor(*contents) : CertifiedSensor{};
}

} // namespace

class TestDccDialects : public QObject
{
    Q_OBJECT

private slots:
    /// Version 3.3: expandedMU, complex values, refTypes of the schema's good practice.
    void pressureSensor_ofVersion33()
    {
        const std::string data
            = "\n"
              "<P:list refType=\"basic_tableIndex0\">\n"
              "  <P:quantity refType=\"vib_frequency basic_tableIndex0\"><P:name><P:content lang=\"en\">Frequency</P:content></P:name>\n"
              "    <si:realListXMLList><si:valueXMLList>0.5 5 50</si:valueXMLList>\n"
              "      <si:unitXMLList>\\kilo\\hertz</si:unitXMLList></si:realListXMLList></P:quantity>\n"
              "  <P:quantity refType=\"basic_measuredValue\"><P:name><P:content lang=\"en\">S</P:content></P:name>\n"
              "    <si:complexListXMLList><si:valueMagnitudeXMLList>1.5 1.6 1.8</si:valueMagnitudeXMLList>\n"
              "      <si:valuePhaseXMLList>-0.1 -1.0 -9.0</si:valuePhaseXMLList>\n"
              "      <si:unitXMLList>\\volt\\mega\\pascal\\tothe{-1}</si:unitXMLList>\n"
              "      <si:unitPhaseXMLList>\\degree</si:unitPhaseXMLList></si:complexListXMLList></P:quantity>\n"
              "</P:list>\n"
              "<P:quantity><P:name><P:content lang=\"en\">Static sensitivity</P:content></P:name>\n"
              "  <si:real><si:value>1.49</si:value><si:unit>\\milli\\volt\\kilo\\pascal\\tothe{-1}</si:unit>\n"
              "    <si:measurementUncertaintyUnivariate><si:expandedMU><si:valueExpandedMU>0.02</si:valueExpandedMU>\n"
              "      <si:coverageFactor>2</si:coverageFactor><si:coverageProbability>0.95</si:coverageProbability>\n"
              "    </si:expandedMU></si:measurementUncertaintyUnivariate></si:real></P:quantity>";
        const CertifiedSensor sensor = sensorOf(certificate("3.3.0", "dcc",
            "<P:identification refType=\"basic_serialNumber\"><P:issuer>manufacturer</P:issuer><P:value>A-7</P:value></P:identification>",
            data));
        QCOMPARE(sensor.serial, std::string("A-7"));
        QCOMPARE(sensor.response->frequency_Hz, (std::vector<double>{500, 5000, 50000}));
        QVERIFY(isNear(sensor.response->magnitude.values[2], 1.8e-6, 1e-12));
        QVERIFY(isNear(sensor.response->phase_rad->values[2], -std::numbers::pi / 20, 1e-12));
        QVERIFY(sensor.response->magnitude.u.empty());
        QVERIFY(isNear(sensor.sensitivity->value, 1.49e-6, 1e-12));
        QVERIFY(isNear(sensor.sensitivity->u, 1e-8, 1e-12));
        QVERIFY(sensor.leftOut.empty());
    }

    /// Version 3.2: hybrids, deprecated uncertainties, German names, no prefix of the namespace.
    void forceTransducer_ofVersion32()
    {
        const std::string data
            = "\n"
              "<P:list><P:quantity><P:name><P:content lang=\"de\">Frequenz</P:content></P:name>\n"
              "    <si:realListXMLList><si:valueXMLList>10 20\n"
              "      40</si:valueXMLList><si:unitXMLList>\\hertz</si:unitXMLList></si:realListXMLList></P:quantity>\n"
              "  <P:quantity><P:name><P:content lang=\"de\">Empfindlichkeit</P:content></P:name>\n"
              "    <si:hybrid><si:realListXMLList><si:valueXMLList>2 2 2</si:valueXMLList>\n"
              "        <si:unitXMLList>\\volt\\kilogramforce\\tothe{-1}</si:unitXMLList></si:realListXMLList>\n"
              "      <si:realListXMLList><si:valueXMLList>20.1 20.2 20.4</si:valueXMLList>\n"
              "        <si:unitXMLList>\\milli\\volt\\newton\\tothe{-1}</si:unitXMLList>\n"
              "        <si:expandedUncXMLList><si:uncertaintyXMLList>0.4</si:uncertaintyXMLList>\n"
              "          <si:coverageFactorXMLList>2</si:coverageFactorXMLList>\n"
              "          <si:coverageProbabilityXMLList>0.95</si:coverageProbabilityXMLList></si:expandedUncXMLList>\n"
              "      </si:realListXMLList></si:hybrid></P:quantity></P:list>\n"
              "<P:quantity><P:name><P:content lang=\"de\">Eigenfrequenz</P:content></P:name>\n"
              "  <si:real><si:value>21.5</si:value><si:unit>\\kilo\\hertz</si:unit></si:real></P:quantity>";
        const CertifiedSensor sensor = sensorOf(certificate("3.2.1", "",
            "<P:identification><P:issuer>manufacturer</P:issuer><P:value>31</P:value><P:name><P:content lang=\"de\">Serien-Nr.</P:content></P:name></P:identification>"
            "<P:identification><P:issuer>manufacturer</P:issuer><P:value>B</P:value><P:name><P:content>Typ</P:content></P:name></P:identification>",
            data));
        QCOMPARE(sensor.serial, std::string("31"));
        QCOMPARE(sensor.response->magnitude.unit.symbol(), std::string("V/N"));
        QVERIFY(isNear(sensor.response->magnitude.values[1], 20.2e-3, 1e-12));
        QVERIFY(isNear(sensor.response->magnitude.u[1], 0.2e-3, 1e-12));
        QVERIFY(isNear(sensor.naturalFrequency->value, 21500.0, 1e-12));
        QVERIFY(std::isnan(sensor.naturalFrequency->u));
    }

    /// Version 3.1: charge per acceleration, phase beside it, coverage intervals.
    void accelerometer_ofVersion31()
    {
        const std::string interval
            = "<si:coverageIntervalXMLList><si:standardUncXMLList>0.001 0.002</si:standardUncXMLList>"
              "<si:intervalMinXMLList>0 0</si:intervalMinXMLList><si:intervalMaxXMLList>1 1</si:intervalMaxXMLList>"
              "<si:coverageProbabilityXMLList>0.95</si:coverageProbabilityXMLList></si:coverageIntervalXMLList>";
        const std::string data
            = "\n"
              "<P:list><P:quantity refType=\"vib_frequency\"><si:realListXMLList><si:valueXMLList>6.3 80</si:valueXMLList>\n"
              "      <si:unitXMLList>\\hertz</si:unitXMLList></si:realListXMLList></P:quantity>\n"
              "  <P:quantity refType=\"vib_acceleration\"><si:realListXMLList><si:valueXMLList>98.5 98.5</si:valueXMLList>\n"
              "      <si:unitXMLList>\\metre\\second\\tothe{-2}</si:unitXMLList></si:realListXMLList></P:quantity>\n"
              "  <P:quantity refType=\"vib_magnitude\"><si:realListXMLList><si:valueXMLList>0.128 0.129</si:valueXMLList>\n"
              "      <si:unitXMLList>\\pico\\coulomb\\second\\tothe{2}\\metre\\tothe{-1}</si:unitXMLList>INTERVAL</si:realListXMLList></P:quantity>\n"
              "  <P:quantity refType=\"vib_phase\"><si:realListXMLList><si:valueXMLList>0.2 0.1</si:valueXMLList>\n"
              "      <si:unitXMLList>\\degree</si:unitXMLList></si:realListXMLList></P:quantity></P:list>";
        std::string filled = data;
        filled.replace(filled.find("INTERVAL"), 8, interval);
        const CertifiedSensor sensor = sensorOf(certificate("3.1.2", "c",
            "<P:identification><P:issuer>manufacturer</P:issuer><P:value>8305</P:value></P:identification>",
            filled));
        QCOMPARE(sensor.serial, std::string("8305"));
        QVERIFY(sensor.response->magnitude.unit.isSensitivity());
        QVERIFY(isNear(sensor.response->magnitude.values[0], 0.128e-12, 1e-12));
        QVERIFY(isNear(sensor.response->magnitude.u[1], 0.002e-12, 1e-12));
        QVERIFY(std::isnan(sensor.response->magnitude.k[1])); // stated without one
        QVERIFY(isNear(sensor.response->phase_rad->values[0], 0.2 * std::numbers::pi / 180, 1e-12));
    }

    /// Version 3.0: one value after the other in lists of their own, nothing over frequency.
    void amplifier_ofVersion30_hasNoResponse()
    {
        const std::string data
            = "\n"
              "<P:list><P:quantity><P:name><P:content lang=\"en\">Gain</P:content></P:name>\n"
              "  <si:real><si:value>10.001</si:value><si:unit>\\volt\\pico\\coulomb\\tothe{-1}</si:unit>\n"
              "    <si:expandedUnc><si:uncertainty>0.03</si:uncertainty><si:coverageFactor>2</si:coverageFactor>\n"
              "      <si:coverageProbability>0.95</si:coverageProbability></si:expandedUnc></si:real></P:quantity></P:list>";
        const CertifiedSensor sensor = sensorOf(certificate("3.0.0", "dcc",
            "<P:identification><P:issuer>calibrationLaboratory</P:issuer><P:value>77</P:value></P:identification>",
            data));
        QVERIFY(sensor.serial.empty() && !english(sensor.whyNoSerial).empty());
        QVERIFY(!sensor.response && !sensor.sensitivity);
        QCOMPARE(sensor.leftOut.size(), std::size_t(1));
        QVERIFY(english(sensor.leftOut[0]).find("no frequencies") != std::string::npos);
    }
};

DYNCAL_TEST(TestDccDialects)
#include "tst_dcc_dialects.moc"
