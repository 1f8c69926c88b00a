// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A certificate (DCC) as an earlier calibration: beside results in a history, and over S(f).

#include "core/history/dcc_calibration.h"
#include "core/history/earlier_response.h"
#include "core/history/history_files.h"
#include "tests/core/history/made_history.h"
#include "tests/support/made_dcc.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Sensor 4711, 2025-03-04: 5.2 V/MPa without frequency, and a response in mV/kPa.
std::string certificate()
{
    return dccOf(dccQuantity("5.2", "\\volt\\mega\\pascal\\tothe{-1}", "0.15", "3")
        + dccList(dccQuantity("1000 10000", "\\hertz")
            + dccQuantity("5 5.1", "\\milli\\volt\\kilo\\pascal\\tothe{-1}", "0.1 0.2")
            + dccQuantity("-1 -10", "\\degree", "0.5", "2.5"))
        + dccQuantity("1", "\\furlong"));
}

EarlierCalibration calibration(const std::string &bytes = certificate())
{
    return earlierCalibrationOfDcc("a.xml", bytes).value();
}

std::string replaced(std::string text, const std::string &what, const std::string &with)
{
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

} // namespace

class TestDccCalibration : public QObject
{
    Q_OBJECT

private slots:
    void certificate_isACalibration()
    {
        const EarlierCalibration one = calibration();
        QCOMPARE(
            one.file + ' ' + one.serial + ' ' + one.time, std::string("a.xml 4711 2025-03-04"));
        QVERIFY(one.isDayOfCalibration && one.blocked.empty() && one.recordings.empty());
        QCOMPARE(one.dcc.number + ' ' + one.dcc.version, std::string("K-17 3.3.0"));
        QCOMPARE(one.notAssigned.size(), std::size_t(1));
    }

    void values_areThoseOfTheCertificate()
    {
        const nlohmann::json results = calibration().results;
        const FollowedValue sensitivity = followedValue(results, {FollowedKind::Sensitivity});
        QVERIFY(isNear(sensitivity.value, 5.2e-6, 1e-12));
        QVERIFY(isNear(sensitivity.u, 0.05e-6, 1e-12));
        QCOMPARE(sensitivity.k, 3.0); // Student's, as stated
        QCOMPARE(sensitivity.unit, std::string("V/Pa"));
        const FollowedValue row = followedValue(results, {FollowedKind::Magnitude, 1e4, 1e4});
        QVERIFY(isNear(row.value, 5.1e-6, 1e-12));
        QVERIFY(isNear(row.U(), 0.2e-6, 1e-12));
        const FollowedValue phase = followedValue(results, {FollowedKind::Phase, 1e4, 1e4});
        QVERIFY(isNear(phase.value, -10 * std::numbers::pi / 180, 1e-12));
        QVERIFY(!followedValue(results, {FollowedKind::NaturalFrequency}).missing.empty());
    }

    void response_isLaidOver()
    {
        EarlierResponse response = earlierResponse(calibration()).value();
        QCOMPARE(response.unit + ' ' + response.certificate, std::string("V/Pa K-17"));
        QCOMPARE(response.rows.size(), std::size_t(2));
        QVERIFY(isNear(response.rows[0].U, 0.1e-6, 1e-12));
        QVERIFY(toUnit(response, "mV/Pa"));
        QVERIFY(isNear(response.rows[0].magnitude, 5e-3, 1e-12));
        QVERIFY(isNear(response.rows[0].U, 0.1e-3, 1e-12));
        QVERIFY(!toUnit(response, "C/Pa") && !toUnit(response, "g/Pa"));
        QCOMPARE(response.unit, std::string("mV/Pa"));
    }

    /// Without a response the sentence has the reasons of the certificate.
    void noResponse_isRefusedWithTheReasons()
    {
        const auto none = earlierResponse(calibration(dccOf(dccQuantity("1", "\\furlong"))));
        QVERIFY(english(none.error().message).find("\\furlong") != std::string::npos);
    }

    /// E_n of 5.2 and 5.0 V/MPa with U = 0.15 and 0.10, by hand.
    void history_comparesCertificatesAndResults()
    {
        SensorCalibrations sensor = calibrationsOfSensor(
            {calibration(), madeCalibration({.day = "2026-03-01", .serial = "4711"}, "b.json")}, "")
                                        .value();
        QCOMPARE(filesOf(sensor.points), std::string("a.xml b.json"));
        QCOMPARE(sensor.leftOut.size(), std::size_t(1));
        QCOMPARE(leftOutName(sensor.leftOut[0].why), "not_understood");
        QVERIFY(sensor.leftOut[0].reason.find("\\furlong") != std::string::npos);
        const SensorHistory history = sensorHistory(std::move(sensor), {1e4});
        const auto series = std::ranges::find(history.series, FollowedKind::Sensitivity,
            [](const HistorySeries &one) { return one.quantity.kind; });
        QVERIFY(isNear(series->entries[1].En, -0.2 / std::hypot(0.15, 0.10), 1e-9));
        const auto rows = std::ranges::find(history.series, FollowedKind::Magnitude,
            [](const HistorySeries &one) { return one.quantity.kind; });
        QVERIFY(std::isfinite(rows->entries[1].En));
        const auto root = nlohmann::json::parse(historyJson(history));
        QCOMPARE(root["points"][0]["dcc"]["number"].get<std::string>(), std::string("K-17"));
        QVERIFY(root["points"][1]["dcc"].is_null());
        QVERIFY(root["points"][1].contains("dcc_reason"));
    }

    /// What differs in its prefix only comes in the unit of the newest.
    void prefixes_areConverted()
    {
        EarlierCalibration charge = madeCalibration({.day = "2026-03-01", .serial = "4711"});
        charge.results["sensitivity"]["unit"] = "pC/Pa";
        charge.results["sensitivity"]["value"] = 5.0;
        charge.results["sensitivity"]["u"] = 0.05;
        const std::string picocoulomb
            = dccOf(dccQuantity("5.2", "\\nano\\coulomb\\kilo\\pascal\\tothe{-1}", "0.15", "3"));
        const SensorHistory history = sensorHistory(
            calibrationsOfSensor({calibration(picocoulomb), charge}, "").value(), {});
        QCOMPARE(history.series[2].unit, std::string("pC/Pa"));
        QVERIFY(isNear(history.series[2].entries[0].stated.value, 5.2, 1e-12));
        QVERIFY(std::isfinite(history.series[2].entries[1].En));
    }

    /// The certificate of a calibration beside its results is the same calibration.
    void ownCertificate_isTheSameJobAsItsResults()
    {
        EarlierCalibration own = calibration(dccOf(
            dccListOf("dyncal_recordings", dccWords("dyncal_sha256", {std::string(64, 'a')}))));
        QCOMPARE(own.recordings, std::vector<std::string>{std::string(64, 'a')});
        EarlierCalibration results
            = madeCalibration({.day = "2025-03-04", .serial = "4711"}, "r.json");
        results.recordings = own.recordings;
        const SensorCalibrations sensor = calibrationsOfSensor({own, results}, "").value();
        QCOMPARE(filesOf(sensor.points), std::string("r.json"));
        QCOMPARE(leftOutName(sensor.leftOut.at(0).why), "same_recordings");
    }

    void withoutSerial_isLeftOut_withTheReason()
    {
        const EarlierCalibration none
            = calibration(replaced(certificate(), "<dcc:value>4711</dcc:value>", ""));
        const SensorCalibrations sensor
            = calibrationsOfSensor({none, madeCalibration({.day = "2026-03-01"})}, "").value();
        QVERIFY(sensor.leftOut.at(0).reason.find("serial number of its item") != std::string::npos);
    }

    void withoutDay_isRefused()
    {
        const std::string none
            = replaced(replaced(certificate(), "2025-03-04", "2025-13-04"), "2025-03-03", "soon");
        const auto read = earlierCalibrationOfDcc("a.xml", none);
        QVERIFY(english(read.error().message).find("endPerformanceDate") != std::string::npos);
        const auto begun
            = earlierCalibrationOfDcc("a.xml", replaced(certificate(), "2025-03-04", "2025-13-04"));
        QCOMPARE(begun->time, std::string("2025-03-03"));
    }

    void files_areKnownByTheirBeginning()
    {
        const ScratchFolder scratch;
        const std::string xml = put(scratch, "a.json", "\xEF\xBB\xBF \n" + certificate());
        QVERIFY(isXmlFile(xml));
        QVERIFY(readEarlierResponse(xml).has_value());
        QVERIFY(!isXmlFile(put(scratch, "b.xml", " {\"a\": \"<\"}")));
        QVERIFY(!isXmlFile(scratch.file("none.xml")) && !isXmlFile(scratch.file("")));
        QVERIFY(readEarlierDcc(scratch.file("none.xml")).error().kind == ErrorKind::FileUnreadable);
    }
};

DYNCAL_TEST(TestDccCalibration)
#include "tst_dcc_calibration.moc"
