// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether a delayed copy of the step is found where there is one, and nowhere else.

#include "core/realization/input/echo_search.h"
#include "tests/support/echo_records.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

using namespace dyncal;
using testing::echoRecord;
using testing::EchoRecord;
using testing::traitsOf;

namespace {

/// Size of what looks like an echo, over its u.
double clarity(const EchoRecord &made)
{
    const auto echo = findEcho(echoRecord(made), traitsOf(made.f0_Hz, made.zeta));
    return echo ? std::abs(echo->relative) / echo->u_relative : 0.0;
}

} // namespace

class TestEchoSearch : public QObject
{
    Q_OBJECT

private slots:
    void echoes_areFound_data()
    {
        QTest::addColumn<double>("f0_Hz");
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("relative");
        QTest::addColumn<double>("delay_s");
        QTest::newRow("3 % after 0.1 ms") << 318e3 << 0.02 << 0.03 << 100e-6;
        QTest::newRow("-3 % after 0.1 ms") << 318e3 << 0.02 << -0.03 << 100e-6;
        QTest::newRow("1 % while it rings") << 318e3 << 0.02 << 0.01 << 50e-6;
        QTest::newRow("6 %, low damping") << 318e3 << 0.01 << 0.06 << 83.37e-6;
        QTest::newRow("2 %, zeta 0.7") << 400e3 << 0.7 << 0.02 << 120e-6;
        QTest::newRow("2 %, no resonance") << 318e3 << 1.5 << 0.02 << 120e-6;
    }
    /// Delay and size of 20 records each, 1 % noise: found every time, and with errors that match
    /// the stated uncertainties.
    void echoes_areFound()
    {
        QFETCH(double, f0_Hz);
        QFETCH(double, zeta);
        QFETCH(double, relative);
        QFETCH(double, delay_s);
        constexpr int kRuns = 20;
        double size = 0.0, delay = 0.0;
        for (int seed = 1; seed <= kRuns; ++seed) {
            EchoRecord made{f0_Hz, zeta, relative, delay_s};
            made.seed = static_cast<std::uint64_t>(seed);
            const auto echo = findEcho(echoRecord(made), traitsOf(f0_Hz, zeta));
            QVERIFY(echo.has_value());
            QCOMPARE(echo->shot, Index(1));
            size += std::pow((echo->relative - relative) / echo->u_relative, 2) / kRuns;
            delay += std::pow((echo->delay_s - delay_s) / echo->u_delay_s, 2) / kRuns;
        }
        qInfo("mean square of error over u: size %.2f, delay %.2f", size, delay);
        QVERIFY(size > 0.3 && size < 2.2); // 20 values: 0.41 to 1.9 in 99 %
        QVERIFY(delay < 2.2);
    }

    /// 40 ms are 76 000 points; looked at are 32 000, 17 ms.
    void aLongRecord_isSearchedAsFarAsAnEchoMatters()
    {
        EchoRecord made{318e3, 0.02, 0.03, 15e-3};
        made.samples = 400000;
        const SensorTraits traits = traitsOf(made.f0_Hz, made.zeta);
        const auto echo = findEcho(echoRecord(made), traits);
        QVERIFY(echo && std::abs(echo->delay_s - 15e-3) < 1e-6);
        made.delay_s = 25e-3;
        // One of 4000 looks may find something by chance, which other shots would not confirm.
        const auto late = findEcho(echoRecord(made), traits);
        QVERIFY(!late || std::abs(late->delay_s - made.delay_s) > 1e-3);
    }

    void withoutAnEcho_nothingIsFound_data()
    {
        QTest::addColumn<double>("f0_Hz");
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("drift");
        QTest::newRow("rings") << 318e3 << 0.02 << 0.0;
        QTest::newRow("zeta 0.7") << 400e3 << 0.7 << 0.0;
        QTest::newRow("does not ring") << 318e3 << 1.5 << 0.0;
        QTest::newRow("a drift of 5 % in 0.1 ms") << 318e3 << 0.02 << 0.05;
    }
    /// A candidate of noise is found in most records, but none that stands alone: 8 of its u.
    void withoutAnEcho_nothingIsFound()
    {
        QFETCH(double, f0_Hz);
        QFETCH(double, zeta);
        QFETCH(double, drift);
        const int runs = trials::count(60, 1000);
        double most = 0.0;
        for (int seed = 1; seed <= runs; ++seed) {
            EchoRecord made{f0_Hz, zeta};
            made.drift = drift;
            made.seed = static_cast<std::uint64_t>(seed);
            most = std::max(most, clarity(made));
        }
        qInfo("at most %.1f u in %d records", most, runs);
        QVERIFY(most < 7.0);
    }

    /// A second resonance that nobody listed is no echo, nor is a plateau that slopes.
    void otherShapes_areNoEcho()
    {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            EchoRecord made{318e3, 0.02};
            made.seed = seed;
            made.slope_per_s = 20.0; // 0.6 % over the record
            QVERIFY(clarity(made) < 7.0);
            made.slope_per_s = 0.0;
            made.secondMode = 0.02;
            QVERIFY(clarity(made) < 7.0);
        }
    }

    void scaleOfTheRecord_doesNotMatter()
    {
        const SensorTraits traits = traitsOf(318e3, 0.02);
        WindowedResponse response = echoRecord({318e3, 0.02, 0.03, 100e-6});
        const auto before = findEcho(response, traits);
        response.values *= -1e-3;
        response.noise *= -1e-3;
        const auto after = findEcho(response, traits);
        QVERIFY(before && after);
        QVERIFY(std::abs(after->relative / before->relative - 1.0) < 1e-9);
        QCOMPARE(after->delay_s, before->delay_s);
    }

    void nothingToGoBy_findsNothing()
    {
        const SensorTraits traits = traitsOf(318e3, 0.02);
        WindowedResponse response = echoRecord({318e3, 0.02, 0.03, 100e-6});
        QVERIFY(!findEcho(response, {})); // neither resonance nor rise time
        response.noise.resize(0); // no record before the step
        QVERIFY(!findEcho(response, traits));
        response = echoRecord({318e3, 0.02, 0.03, 100e-6});
        response.length = 100; // shorter than what must be on both sides
        QVERIFY(!findEcho(response, traits));
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!findEcho(echoRecord({318e3, 0.02, 0.03, 100e-6}), traits, {stop.get_token(), {}}));
    }
};

DYNCAL_TEST(TestEchoSearch)
#include "tst_echo_search.moc"
