// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of a reference transducer that were cut, changed or made to harm: an answer or a sentence,
// never more.

#include "core/reference/reference_csv.h"
#include "core/reference/reference_dcc.h"
#include "tests/support/made_dcc.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>
#include <string>

using namespace dyncal;

namespace {

const std::string kTable = "frequency_hz,magnitude,u_magnitude,phase_rad,u_phase_rad,dof\n"
                           "100,2e-8,1e-10,-0.01,0.001,\n1000,2.1e-8,2e-10,-0.1,0.002,9\n"
                           "10000,2.2e-8,2e-10,-0.2,0.002,9\n";

std::string certificate()
{
    using namespace testing;
    return dccOf(dccList(dccQuantity("1 10 100", "\\kilo\\hertz")
        + dccQuantity("0.1 0.2 0.3", "\\volt\\mega\\pascal\\tothe{-1}", "0.002")
        + dccQuantity("-1 -2 -3", "\\degree", "0.1")));
}

/// What can be stated of whatever was read: numbers that a certificate may rest on.
void checkSound(const ReferenceSensitivity &sensitivity)
{
    QVERIFY(sensitivity.lowest_Hz() > 0.0 && sensitivity.highest_Hz() >= sensitivity.lowest_Hz());
    for (const double f_Hz : {sensitivity.lowest_Hz(), sensitivity.highest_Hz()}) {
        const ReferencePoint point = sensitivity.at(f_Hz).value();
        QVERIFY(point.magnitude > 0.0 && std::isfinite(point.magnitude));
        QVERIFY(point.u_magnitude >= 0.0 && std::isfinite(point.u_magnitude));
        QVERIFY(point.dof > 0.0);
    }
}

/// One to four bytes changed, removed or doubled.
std::string damaged(std::string text, std::mt19937 &random)
{
    for (auto times = 1 + random() % 4; times > 0 && !text.empty(); --times) {
        const std::size_t at = random() % text.size();
        switch (random() % 3) {
        case 0:
            text[at] = static_cast<char>(random() % 256);
            break;
        case 1:
            text.erase(at, 1 + random() % 8);
            break;
        default:
            text.insert(at, text.substr(at, 1 + random() % 8));
        }
    }
    return text;
}

} // namespace

class TestReferenceHostile : public QObject
{
    Q_OBJECT

private slots:
    void damagedTables_areReadOrRefused()
    {
        std::mt19937 random(1);
        for (int trial = 0; trial < 3000; ++trial) {
            const auto made = readReferenceCsv(damaged(kTable, random));
            if (made)
                checkSound(*made);
            else
                QVERIFY(!english(made.error().message).empty());
        }
    }

    void damagedCertificates_areReadOrRefused()
    {
        std::mt19937 random(2);
        const std::string whole = certificate();
        QVERIFY(readReferenceDcc(whole, "", "V/Pa").has_value());
        for (int trial = 0; trial < 3000; ++trial) {
            const auto made = readReferenceDcc(damaged(whole, random), "", "V/Pa");
            if (made)
                checkSound(made->sensitivity);
            else
                QVERIFY(!english(made.error().message).empty());
        }
    }

    void everyBeginning_isReadOrRefused()
    {
        const std::string whole = certificate();
        for (std::size_t length = 0; length < whole.size(); ++length)
            QVERIFY(!readReferenceDcc(whole.substr(0, length), "", "V/Pa"));
        for (std::size_t length = 0; length < kTable.size(); ++length)
            if (const auto made = readReferenceCsv(kTable.substr(0, length)))
                checkSound(*made);
    }

    /// Entities that grow, and files of the machine: whoever declares them is not read.
    void documentTypes_areRefused()
    {
        const std::string whole = certificate();
        const std::string body = whole.substr(whole.find("<dcc:"));
        for (const std::string declared : {"<!ENTITY a 'aa'><!ENTITY b '&a;&a;'>",
                 "<!ENTITY e SYSTEM 'file:///etc/passwd'>", ""}) {
            const auto made
                = readReferenceDcc("<!DOCTYPE x [" + declared + "]>" + body, "", "V/Pa");
            QVERIFY(!made && english(made.error().message).find("DOCTYPE") != std::string::npos);
        }
    }

    void deepNesting_endsInASentence()
    {
        std::string deep = "<dcc:digitalCalibrationCertificate xmlns:dcc=\"d\">";
        constexpr int kDepth = 500000;
        for (int i = 0; i < kDepth; ++i)
            deep += "<a>";
        for (int i = 0; i < kDepth; ++i)
            deep += "</a>";
        QVERIFY(!readReferenceDcc(deep + "</dcc:digitalCalibrationCertificate>", "", "V/Pa"));
    }

    void longTables_areRead()
    {
        std::string text = "frequency_hz,magnitude,u_magnitude\n";
        for (int i = 1; i <= 20000; ++i)
            text += std::to_string(i) + ",2e-8,1e-10\n";
        QCOMPARE(readReferenceCsv(text)->highest_Hz(), 20000.0);
    }
};

DYNCAL_TEST(TestReferenceHostile)
#include "tst_reference_hostile.moc"
