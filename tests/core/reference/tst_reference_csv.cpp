// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of a reference transducer as text.

#include "core/reference/reference_csv.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <string>

using namespace dyncal;

namespace {

std::string faultOfText(const std::string &text)
{
    const auto made = readReferenceCsv(text);
    return made ? std::string() : english(made.error().message);
}

} // namespace

class TestReferenceCsv : public QObject
{
    Q_OBJECT

private slots:
    void table_isRead()
    {
        const auto made
            = readReferenceCsv("\xEF\xBB\xBF# of 2026\r\n"
                               "frequency_hz, magnitude,u_magnitude,phase_rad,u_phase_rad,dof\r\n"
                               "100,2e-8,1e-10,-0.01,0.001,\r\n\r\n"
                               "1000,2.1e-8,2e-10,-0.1,0.002,9\r\n");
        QVERIFY(made.has_value());
        QCOMPARE(made->at(1000.0)->magnitude, 2.1e-8);
        QCOMPARE(made->at(1000.0)->dof, 9.0);
        QVERIFY(std::isinf(made->at(100.0)->dof));
        QCOMPARE(made->at(100.0)->u_phase_rad, 0.001);
    }

    void columns_mayStandInAnyOrder_withoutPhase()
    {
        const auto made = readReferenceCsv("u_magnitude,frequency_hz,magnitude\n1e-10,100,2e-8");
        QVERIFY(made.has_value());
        QCOMPARE(made->lowest().u_magnitude, 1e-10);
        QVERIFY(std::isnan(made->lowest().phase_rad));
    }

    /// The values behind a decimal comma would be read as those of the next columns.
    void decimalCommas_areRefused()
    {
        const std::string head = "frequency_hz,magnitude,u_magnitude,dof\n";
        for (const char *line : {"100,5,2e-8,1e-10,9", "100,5,2e-8,1e-10,", "100,2,1e-8,1e-10,9"}) {
            const std::string fault = faultOfText(head + "50,1e-8,1e-10,9\n" + line + "\n");
            QVERIFY2(
                fault.starts_with("Line 3 of the table has 5 values for 4 columns"), fault.c_str());
            QVERIFY(fault.find("decimal comma") != std::string::npos);
        }
        QVERIFY(faultOfText(head + "100,5,2e-8\n").starts_with("Line 2 of the table has 3 values"));
        QVERIFY(faultOfText("frequency_hz;magnitude;u_magnitude\n1,5;2e-8;1e-10\n")
                    .find("has semicolons")
            != std::string::npos);
        QVERIFY(faultOfText(head + "1,5;2e-8;1e-10;9\n").starts_with("Line 2 of the table has 2"));
    }

    void columnNamedTwice_isRefused()
    {
        const std::string fault
            = faultOfText("frequency_hz,magnitude,u_magnitude,magnitude\n100,2e-8,1e-10,3e-8\n");
        QVERIFY2(fault.starts_with("The table names the column 'magnitude' twice"), fault.c_str());
    }

    void whatIsWrong_isNamedWithItsLine()
    {
        QVERIFY(faultOfText("").find("'frequency_hz'") != std::string::npos);
        QVERIFY(
            faultOfText("frequency_hz,magnitude\n1,2").find("'u_magnitude'") != std::string::npos);
        QVERIFY(faultOfText("frequency_hz,gain\n1,2").find("'gain'") != std::string::npos);
        const std::string head = "frequency_hz,magnitude,u_magnitude\n";
        QVERIFY(faultOfText(head).find("no rows") != std::string::npos);
        QVERIFY(
            faultOfText(head + "100,2e-8,1e-10\n200,2e-8\n").find("Line 3") != std::string::npos);
        QVERIFY(faultOfText(head + "100,2;1,1e-10\n").find("'2;1'") != std::string::npos);
        QVERIFY(faultOfText(head + "200,2e-8,0\n100,2e-8,0\n").find("Row 2") != std::string::npos);
        QVERIFY(faultOfText(std::string("\0\0", 2)).find("column") != std::string::npos);
    }
};

DYNCAL_TEST(TestReferenceCsv)
#include "tst_reference_csv.moc"
