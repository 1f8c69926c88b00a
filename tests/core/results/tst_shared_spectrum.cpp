// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/shared_spectrum.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

class TestSharedSpectrum : public QObject
{
    Q_OBJECT

private:
    /// Bins 0, df, 2 df ...; psd 1 except one peak.
    static PowerSpectrum spectrum(Index bins, double df, Index peak, double height)
    {
        PowerSpectrum s;
        s.frequency_Hz = Eigen::VectorXd::LinSpaced(bins, 0.0, df * static_cast<double>(bins - 1));
        s.psd = Eigen::VectorXd::Ones(bins);
        s.psd[peak] = height;
        return s;
    }

private slots:
    void fewBins_areKeptAsTheyAre()
    {
        const SharedSpectrum shared
            = sharedSpectrum({spectrum(101, 10.0, 20, 5.0), spectrum(101, 10.0, 30, 7.0)}, 4096);
        QCOMPARE(shared.frequency_Hz.size(), Index(100)); // without 0 Hz
        QCOMPARE(shared.frequency_Hz[0], 10.0);
        QCOMPARE(shared.psd[0][19], 5.0);
        QCOMPARE(shared.psd[1][29], 7.0);
        QCOMPARE(shared.psd[1][19], 1.0);
    }

    void manyBins_areThinnedWithoutLosingThePeak()
    {
        const Index peak = 61234;
        const SharedSpectrum shared = sharedSpectrum({spectrum(100000, 610.0, peak, 1e6)}, 4096);
        QVERIFY(shared.frequency_Hz.size() <= 4096);
        QVERIFY(shared.frequency_Hz.size() > 2000);
        Index at = 0;
        QCOMPARE(shared.psd[0].maxCoeff(&at), 1e6);
        QCOMPARE(shared.frequency_Hz[at], 610.0 * static_cast<double>(peak)); // to the bin
        for (Index i = 1; i < shared.frequency_Hz.size(); ++i)
            QVERIFY(shared.frequency_Hz[i] > shared.frequency_Hz[i - 1]);
    }

    void lowerRate_leavesGapsAboveItsNyquist()
    {
        const SharedSpectrum shared
            = sharedSpectrum({spectrum(101, 10.0, 20, 5.0), spectrum(51, 10.0, 20, 5.0)}, 4096);
        QCOMPARE(shared.frequency_Hz.size(), Index(100));
        QVERIFY(std::isfinite(shared.psd[1][49]));
        QVERIFY(std::isnan(shared.psd[1][50]));
        QVERIFY(shared.psd[0].allFinite());
    }

    void otherLength_keepsBothGrids()
    {
        const SharedSpectrum shared
            = sharedSpectrum({spectrum(11, 10.0, 2, 5.0), spectrum(11, 15.0, 2, 5.0)}, 4096);
        // 10..100 and 15..150, with 30, 60 and 90 in both.
        QCOMPARE(shared.frequency_Hz.size(), Index(17));
        QCOMPARE(shared.frequency_Hz[1], 15.0);
        QVERIFY(std::isnan(shared.psd[0][1]));
        QCOMPARE(shared.psd[1][1], 1.0);
    }

    void nothing_givesNothing()
    {
        QCOMPARE(sharedSpectrum({}, 4096).frequency_Hz.size(), Index(0));
    }
};

DYNCAL_TEST(TestSharedSpectrum)
#include "tst_shared_spectrum.moc"
