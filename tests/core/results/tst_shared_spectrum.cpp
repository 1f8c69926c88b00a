// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/shared_spectrum.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

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

    /// Each shot's values are among its bins, its largest is kept, and at each frequency one shot
    /// has exactly that bin.
    static void verifyKept(const std::vector<PowerSpectrum> &spectra, const SharedSpectrum &shared)
    {
        QCOMPARE(shared.psd.size(), spectra.size());
        std::vector<int> owners(static_cast<std::size_t>(shared.frequency_Hz.size()), 0);
        for (std::size_t shot = 0; shot < spectra.size(); ++shot) {
            const PowerSpectrum &whole = spectra[shot];
            const auto finite = shared.psd[shot].array().isFinite();
            QCOMPARE(finite.select(shared.psd[shot].array(), 0.0).maxCoeff(),
                whole.psd.tail(whole.psd.size() - 1).maxCoeff());
            for (Index i = 0; i < shared.psd[shot].size(); ++i) {
                if (!std::isfinite(shared.psd[shot][i]))
                    continue;
                const auto bin = std::find(whole.psd.begin(), whole.psd.end(), shared.psd[shot][i]);
                QVERIFY(bin != whole.psd.end());
                const double f_Hz = whole.frequency_Hz[bin - whole.psd.begin()];
                owners[static_cast<std::size_t>(i)] += f_Hz == shared.frequency_Hz[i] ? 1 : 0;
            }
        }
        for (Index i = 0; i < shared.frequency_Hz.size(); ++i) {
            QVERIFY(owners[static_cast<std::size_t>(i)] > 0);
            QVERIFY(i == 0 || shared.frequency_Hz[i] > shared.frequency_Hz[i - 1]);
        }
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

    /// Whatever the spectra: no value is invented, none moves, no peak is lost, order is no matter.
    void anySpectra_keepTheirBins()
    {
        std::mt19937_64 random(5);
        std::exponential_distribution<double> power(1.0);
        for (const Index count : {3, 17, 64, 4096}) {
            std::vector<PowerSpectrum> spectra;
            for (const auto &[bins, df] : {std::pair(90, 10.0), {301, 7.0}, {40, 33.0}}) {
                spectra.push_back(spectrum(bins, df, 1, 1.0));
                for (double &value : spectra.back().psd)
                    value = power(random);
            }
            const SharedSpectrum shared = sharedSpectrum(spectra, count);
            QVERIFY(shared.frequency_Hz.size() <= count && shared.frequency_Hz.size() > 0);
            verifyKept(spectra, shared);
            std::swap(spectra[0], spectra[2]);
            const SharedSpectrum turned = sharedSpectrum(spectra, count);
            QCOMPARE(turned.frequency_Hz, shared.frequency_Hz);
            verifyKept(spectra, turned);
        }
    }

    /// A bin that is no number is none; its neighbours stay.
    void binsThatAreNoNumber_areLeftOut()
    {
        PowerSpectrum broken = spectrum(21, 10.0, 5, 9.0);
        broken.psd[7] = std::numeric_limits<double>::quiet_NaN();
        broken.psd[8] = std::numeric_limits<double>::infinity();
        const SharedSpectrum shared = sharedSpectrum({broken}, 4096);
        QCOMPARE(shared.frequency_Hz.size(), Index(18));
        QVERIFY(shared.psd[0].allFinite() && shared.frequency_Hz.allFinite());
        QCOMPARE(shared.psd[0].maxCoeff(), 9.0);
    }

    void nothing_givesNothing()
    {
        QCOMPARE(sharedSpectrum({}, 4096).frequency_Hz.size(), Index(0));
    }
};

DYNCAL_TEST(TestSharedSpectrum)
#include "tst_shared_spectrum.moc"
