// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A reference transducer's digital calibration certificate.

#include "core/reference/reference_dcc.h"
#include "tests/support/made_dcc.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <string>

using namespace dyncal;
using testing::isNear;

namespace {

using testing::dccList;
using testing::dccOf;
using testing::dccQuantity;

const std::string kFrequencies = dccQuantity("1 10 100", "\\kilo\\hertz");
const std::string kMagnitudes
    = dccQuantity("0.1 0.2 0.3", "\\volt\\mega\\pascal\\tothe{-1}", "0.002 0.004 0.006");

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
        const std::string phases = dccQuantity("-1 -2 -4", "\\degree", "0.5", "2.5");
        const auto made
            = readReferenceDcc(dccOf(dccList(kFrequencies + kMagnitudes + phases)), "", "V/Pa");
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
        const auto made = readReferenceDcc(dccOf(dccList(kFrequencies + kMagnitudes)), "a", "V/Pa");
        QVERIFY(std::isnan(made->sensitivity.at(1e3)->phase_rad));
    }

    void list_isNamed_whereThereAreSeveral()
    {
        const std::string two
            = dccOf(dccList(kFrequencies + kMagnitudes) + dccList(kFrequencies + kMagnitudes, "b"));
        QVERIFY(faultOfXml(two).find("2 lists") != std::string::npos);
        QVERIFY(faultOfXml(two, "b").empty());
        QVERIFY(faultOfXml(two, "c").find("'c'") != std::string::npos);
    }

    void lists_areNamed_thoseWithFrequenciesOnly()
    {
        const std::string three = dccOf(dccList(kFrequencies + kMagnitudes)
            + dccList(kMagnitudes, "static") + dccList(kFrequencies, "b"));
        QCOMPARE(listsOverFrequency(three), (std::vector<std::string>{"a", "b"}));
        QVERIFY(listsOverFrequency("frequency_hz,magnitude\n1,1\n").empty());
        QVERIFY(listsOverFrequency("<a><b>").empty());
        QVERIFY(listsOverFrequency("").empty());
    }

    void whatIsMissing_isTold()
    {
        QVERIFY(faultOfXml(dccOf(dccList(kFrequencies))).find("V/Pa") != std::string::npos);
        const std::string noU = dccQuantity("0.1 0.2 0.3", "\\volt\\mega\\pascal\\tothe{-1}");
        QVERIFY(faultOfXml(dccOf(dccList(kFrequencies + noU))).find("V/Pa") != std::string::npos);
        const std::string two = dccQuantity("0.1 0.2", "\\volt\\mega\\pascal\\tothe{-1}", "0.002");
        QVERIFY(!faultOfXml(dccOf(dccList(kFrequencies + two))).empty());
        QVERIFY(faultOfXml(dccOf("")).find("0 lists") != std::string::npos);
    }

    /// Every writer chooses the prefixes of the namespaces for itself.
    void prefixes_doNotMatter()
    {
        std::string plain = dccOf(dccList(kFrequencies + kMagnitudes));
        for (const std::string prefix : {"dcc:", "si:"})
            for (std::size_t at; (at = plain.find(prefix)) != plain.npos;)
                plain.erase(at, prefix.size());
        const auto made = readReferenceDcc(plain, "", "V/Pa");
        QVERIFY(made.has_value());
        QVERIFY(isNear(made->sensitivity.at(1e4)->magnitude, 0.2e-6, 1e-12));
    }

    /// Lists of conditions have no frequencies, and are passed over.
    void otherLists_doNotMatter()
    {
        const std::string temperatures
            = dccList(dccQuantity("294 295", "\\kelvin", "0.2"), "temperatures");
        const std::string pressures
            = dccList(dccQuantity("100 101", "\\kilo\\pascal", "0.2"), "pressures");
        QVERIFY(faultOfXml(dccOf(temperatures + dccList(kFrequencies + kMagnitudes) + pressures))
                    .empty());
    }

    void unitsAndFactors_mayBeListedOneByOne()
    {
        const std::string each = dccQuantity("0.1 0.2 0.3",
            "\\micro\\volt\\per\\pascal \\micro\\volt\\per\\pascal \\micro\\volt\\per\\pascal",
            "0.002 0.004 0.006", "2 2.5 3");
        const auto made = readReferenceDcc(dccOf(dccList(kFrequencies + each)), "", "V/Pa");
        QVERIFY(made.has_value());
        QVERIFY(isNear(made->sensitivity.at(1e4)->u_magnitude, 0.0016e-6, 1e-12));
        QVERIFY(isNear(made->sensitivity.at(1e5)->u_magnitude, 0.002e-6, 1e-12));
    }

    /// Prefixes may differ from value to value, units may not.
    void prefixes_belongToTheirValues()
    {
        const std::string prefixes = dccQuantity("0.1 0.2 300",
            "\\volt\\per\\pascal \\volt\\per\\pascal \\milli\\volt\\per\\pascal", "0.002");
        const auto made = readReferenceDcc(dccOf(dccList(kFrequencies + prefixes)), "", "V/Pa");
        QVERIFY(made.has_value());
        QVERIFY(isNear(made->sensitivity.at(1e5)->magnitude, 0.3, 1e-12));
        QVERIFY(isNear(made->sensitivity.at(1e5)->u_magnitude, 1e-6, 1e-12));
        const std::string mixed
            = dccQuantity("0.1 0.2 0.3", "\\volt\\per\\pascal \\volt\\per\\pascal \\volt", "0.002");
        QVERIFY(
            faultOfXml(dccOf(dccList(kFrequencies + mixed))).find("several") == std::string::npos);
        QVERIFY(
            faultOfXml(dccOf(dccList(kFrequencies + mixed))).find("\\volt") != std::string::npos);
    }

    void rowsThatNoTransducerHas_areRefused()
    {
        const std::string falling = dccQuantity("100 10 1", "\\kilo\\hertz");
        QVERIFY(
            faultOfXml(dccOf(dccList(falling + kMagnitudes))).find("Row 2") != std::string::npos);
        const std::string words = dccQuantity("1 ten 100", "\\kilo\\hertz");
        QVERIFY(!faultOfXml(dccOf(dccList(words + kMagnitudes))).empty());
        const std::string negative = dccQuantity("0.1 -0.2 0.3", "\\volt\\per\\pascal", "0.002");
        QVERIFY(
            faultOfXml(dccOf(dccList(kFrequencies + negative))).find("Row 2") != std::string::npos);
    }

    void magnitudes_comeInTheUnitAskedFor()
    {
        const std::string charge
            = dccQuantity("2 3 4", "\\pico\\coulomb\\kilo\\pascal\\tothe{-1}", "0.02");
        const auto made = readReferenceDcc(dccOf(dccList(kFrequencies + charge)), "", "pC/Pa");
        QVERIFY(made.has_value());
        QVERIFY(isNear(made->sensitivity.at(1e4)->magnitude, 3e-3, 1e-12));
        QVERIFY(isNear(made->sensitivity.at(1e4)->u_magnitude, 1e-5, 1e-12));
        QVERIFY(!readReferenceDcc(dccOf(dccList(kFrequencies + charge)), "", "g/Pa"));
    }

    /// An accelerometer is no reference for pressure.
    void otherInputs_areRefusedByTheirUnit()
    {
        const std::string acceleration
            = dccQuantity("2 3 4", "\\volt\\metre\\tothe{-1}\\second\\tothe{2}", "0.02");
        QVERIFY(
            faultOfXml(dccOf(dccList(kFrequencies + acceleration))).find("no magnitudes in V/Pa")
            != std::string::npos);
    }

    /// S = 3 + 4j and its conjugate, in uV/Pa, with unequal and correlated parts: magnitude and
    /// phase by hand (JCGM 102, 6.2).
    void complexValues_giveMagnitudeAndPhase()
    {
        const auto made = readReferenceDcc(
            dccOf(dccList(dccQuantity("1 2", "\\kilo\\hertz")
                + testing::dccComplex("3 3", "-4 4", "\\micro\\volt\\pascal\\tothe{-1}",
                    {"0.01 0.01", "0.002 0", "0.04 0.04"},
                    "\\micro\\volt\\pascal\\tothe{-1}\\micro\\volt\\pascal\\tothe{-1}"))),
            "", "V/Pa");
        QVERIFY(made.has_value());
        const ReferencePoint one = made->sensitivity.at(1e3).value();
        QVERIFY(isNear(one.magnitude, 5e-6, 1e-12));
        QVERIFY(isNear(one.phase_rad, std::atan2(-4.0, 3.0), 1e-12));
        const double varOfMagnitude = (9 * 0.01 + 2 * 3 * -4 * 0.002 + 16 * 0.04) / 25;
        const double varOfPhase = (16 * 0.01 - 2 * 3 * -4 * 0.002 + 9 * 0.04) / 625;
        QVERIFY(isNear(one.u_magnitude, std::sqrt(varOfMagnitude) * 1e-6, 1e-12));
        QVERIFY(isNear(one.u_phase_rad, std::sqrt(varOfPhase), 1e-12));
        QVERIFY(isNear(made->sensitivity.at(2e3)->phase_rad, std::atan2(4.0, 3.0), 1e-12));
    }

    /// A certificate of this program has its response several times: the one with all digits
    /// counts, with its degrees of freedom.
    void ownCertificate_givesItsResponseInAllDigits()
    {
        using namespace testing;
        const auto response = [](const std::string &values) {
            return kFrequencies
                + dccMarked(
                    dccQuantity(values, "\\volt\\pascal\\tothe{-1}", "0.2"), "dyncal_magnitude")
                + dccMarked(dccQuantity("NaN 4 NaN", "\\one"), "dyncal_degreesOfFreedom");
        };
        const auto made
            = readReferenceDcc(dccOf(dccListOf("dyncal_frequencyResponse", response("2 3 4"))
                                   + dccListOf("dyncal_complexResponse", response("2.1 3.1 4.1"))
                                   + dccListOf("dyncal_complexResponseAtMarks", response("5 6 7"))),
                "", "V/Pa");
        QVERIFY(made.has_value());
        QVERIFY(isNear(made->sensitivity.at(1e4)->magnitude, 3.1, 1e-12));
        QCOMPARE(made->sensitivity.at(1e4)->dof, 4.0);
        QVERIFY(std::isinf(made->sensitivity.at(1e3)->dof));
    }

    /// Rows that the laboratory withheld (NaN of the D-SI) are left out, and no value is taken
    /// without its U.
    void withheldRows_areLeftOut()
    {
        const std::string withheld
            = dccQuantity("0.1 NaN 0.3", "\\volt\\per\\pascal", "0.002 NaN 0.006");
        const auto made = readReferenceDcc(dccOf(dccList(kFrequencies + withheld)), "", "V/Pa");
        QVERIFY(made.has_value());
        QVERIFY(isNear(made->sensitivity.at(1e4)->magnitude, 0.2, 1e-12)); // halfway over log f
        const std::string noU
            = dccQuantity("0.1 0.2 0.3", "\\volt\\per\\pascal", "0.002 NaN 0.006");
        QVERIFY(!readReferenceDcc(dccOf(dccList(kFrequencies + noU)), "", "V/Pa"));
    }

    void otherFiles_areRefused()
    {
        for (const char *text :
            {"", "<a>", "<svg/>", "plain", "<!DOCTYPE x [<!ENTITY e 'e'>]><x>&e;</x>"}) {
            const auto made = readReferenceDcc(text, "", "V/Pa");
            QVERIFY(!made && made.error().kind == ErrorKind::FileUnreadable);
        }
    }

    /// A column that is not understood refuses the reference; nothing is put in its place.
    void columnsThatAreNotUnderstood_refuseIt()
    {
        using testing::dccMarked;
        const std::string unit = "\\volt\\mega\\pascal\\tothe{-1}",
                          angles = dccQuantity("1 1 1", "\\degree", "0.5"),
                          noK = dccQuantity("1 1 1", "\\degree", "0.5", "");
        const auto said = [](const std::string &quantities, const char *what) {
            return faultOfXml(dccOf(dccList(quantities)))
                       .find("not understood and may be the " + std::string(what))
                != std::string::npos;
        };
        QVERIFY(
            said(dccQuantity("1 10 100", "\\hertzz") + kFrequencies + kMagnitudes, "frequencies"));
        QVERIFY(said(kFrequencies + dccQuantity("1,5 2 3", unit) + kMagnitudes, "magnitudes"));
        QVERIFY(said(kFrequencies + kMagnitudes + noK, "phases"));
        QVERIFY(said(kFrequencies + kMagnitudes + noK + angles, "phases"));
        QVERIFY(faultOfXml(dccOf(dccList(dccQuantity("1,5 10 100", "\\kilo\\hertz") + kMagnitudes)))
                    .find("1,5")
            != std::string::npos);
        const std::string two = dccOf(dccList(kFrequencies + kMagnitudes)
            + dccList(kFrequencies + dccQuantity("1,5 2 3", unit, "0.1"), "b"));
        QVERIFY(faultOfXml(two).find("another list (line") != std::string::npos);
        QVERIFY(faultOfXml(two, "a").empty());
    }
};

DYNCAL_TEST(TestReferenceDcc)
#include "tst_reference_dcc.moc"
