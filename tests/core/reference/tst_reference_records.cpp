// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The reference transducer's record over the DUT's window, and every reason why there is none.

#include "core/reference/reference_records.h"
#include "core/signal/window_cutting.h"
#include "tests/support/near.h"
#include "tests/support/reference_capture.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::isNear;

class TestReferenceRecords : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<CaptureSet> m_set;
    std::vector<WindowedResponse> m_duts;

    Result<ReferenceRecords> records(const ComparisonSettings &settings) const
    {
        return referenceRecords(*m_set, m_duts, settings, {});
    }

    std::string fault(const ComparisonSettings &settings, ErrorKind kind) const
    {
        const auto made = records(settings);
        return made || made.error().kind != kind ? std::string() : english(made.error().message);
    }

private slots:
    void initTestCase()
    {
        m_set = testing::referenceCapture();
        m_duts = cutWindows(*m_set, {}, {}).value().responses;
    }

    void record_isThatOfTheSameTime()
    {
        const ReferenceRecords made = records(testing::referenceComparison()).value();
        QCOMPARE(made.channel, std::string("Reference"));
        QCOMPARE(made.responses.size(), m_duts.size());
        for (const WindowedResponse &dut : m_duts) {
            const WindowedResponse &own = *made.ofShot(dut.shot);
            QVERIFY(std::abs(own.start_s - dut.start_s) <= 0.5 / own.sampleRate_Hz);
            QCOMPARE(own.length, dut.length);
            QVERIFY(isNear(own.window()[own.length - 1], 1.0, 0.02)); // remapped to its own step
            const double ratio = dut.step / own.step;
            QVERIFY(isNear(ratio,
                sensorPreset("optic3").value().sensitivity_V_Pa
                    / testing::referenceTruth().sensitivity,
                0.01));
        }
        QVERIFY(made.ofShot(9) == nullptr);
        QVERIFY(made.sourceSha256.empty());
    }

    void otherRate_isCutByTime()
    {
        auto slower = testing::referenceCapture(1e7);
        for (std::size_t i = 0; i < m_set->shots.size(); ++i)
            slower->shots[i].channels.front()
                = m_set->shots[i].channels.front(); // the DUT at 20 MHz
        const auto made
            = referenceRecords(*slower, m_duts, testing::referenceComparison(), {}).value();
        QCOMPARE(made.responses[0].sampleRate_Hz, 1e7);
        QVERIFY(std::abs(made.responses[0].length - m_duts[0].length / 2) <= 1);
    }

    void channel_isNamed_orHasTheRole()
    {
        ComparisonSettings settings = testing::referenceComparison();
        settings.channel = "Reference";
        QVERIFY(records(settings).has_value());
        settings.channel = m_duts[0].channel; // the DUT is no reference of itself
        QVERIFY(fault(settings, ErrorKind::DataBlocked).find("Shot 1") != std::string::npos);
        settings.channel = "nobody";
        QVERIFY(!fault(settings, ErrorKind::DataBlocked).empty());
    }

    void source_isOne_andTheOneThatWasMeant()
    {
        ComparisonSettings settings = testing::referenceComparison();
        settings.source = "ref.csv";
        QVERIFY(fault(settings, ErrorKind::Usage).find("not both") != std::string::npos);
        settings.model.reset();
        QVERIFY(fault(settings, ErrorKind::FileUnreadable).find("'ref.csv'") != std::string::npos);
        settings.loaded = std::make_shared<const ReferenceSource>(
            ReferenceSource{"ab", "frequency_hz,magnitude,u_magnitude\n1000,2e-8,1e-10\n"});
        QCOMPARE(records(settings)->sourceSha256, std::string("ab"));
        settings.sha256 = "cd";
        QVERIFY(fault(settings, ErrorKind::DataBlocked).find("cd") != std::string::npos);
        settings.sha256.clear();
        settings.source.clear();
        QVERIFY(!fault(settings, ErrorKind::Usage).empty());
    }

    void unit_belongsToTheChannel()
    {
        ComparisonSettings settings = testing::referenceComparison();
        settings.unit = "mV/Pa";
        QVERIFY(fault(settings, ErrorKind::Usage).find("mV/Pa") != std::string::npos);
    }

    void recordThatEndsTooEarly_isRefused()
    {
        auto set = testing::referenceCapture();
        Channel &channel = set->shots[1].channels.back();
        channel.t0_s += 1.0; // recorded a second later
        const auto made = referenceRecords(*set, m_duts, testing::referenceComparison(), {});
        QVERIFY(!made && made.error().kind == ErrorKind::DataBlocked);
        QVERIFY(english(made.error().message).find("Shot 2") != std::string::npos);
    }
};

DYNCAL_TEST(TestReferenceRecords)
#include "tst_reference_records.moc"
