// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/decomposition/residual_analysis.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

Eigen::VectorXd directAutocovariance(const Eigen::VectorXd &x, Index maxLag)
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero(maxLag + 1);
    for (Index lag = 0; lag <= std::min(maxLag, x.size() - 1); ++lag)
        result[lag]
            = x.head(x.size() - lag).dot(x.tail(x.size() - lag)) / static_cast<double>(x.size());
    return result;
}

} // namespace

class TestResidualAnalysis : public QObject
{
    Q_OBJECT

private slots:
    void autocovariance_anyLength_equalsDirectSum_data();
    void autocovariance_anyLength_equalsDirectSum();
    void autocovariance_limits_areDefined();
    void autocovariance_allLags_isFast();
    void ljungBox_knownValues();
    void ljungBox_whiteNoise_isUniform();
    void residual_whiteNoise_staysWithinItsBound();
    void residual_confidence_setsTheBound();
    void residual_tone_showsItsPeakAndPeriod();
    void residual_correlatedNoise_isNotWhite();
    void residual_mean_countsForTheRmsOnly();
    void residual_zero_isDefined();
    void residual_tooShort_isBlocked();
};

void TestResidualAnalysis::autocovariance_anyLength_equalsDirectSum_data()
{
    QTest::addColumn<int>("length");
    QTest::addColumn<int>("lags");
    for (const int length : {1, 2, 10, 97, 1000}) {
        for (const int lags : {0, 1, 5, 96, 1500})
            QTest::addRow("%d, %d lags", length, lags) << length << lags;
    }
}

void TestResidualAnalysis::autocovariance_anyLength_equalsDirectSum()
{
    QFETCH(int, length);
    QFETCH(int, lags);
    const Eigen::VectorXd x = Gaussian(1).vector(length, 1.0);
    const Eigen::VectorXd fast = autocovariance(x, lags), direct = directAutocovariance(x, lags);
    QCOMPARE(fast.size(), Index(lags + 1));
    QVERIFY((fast - direct).cwiseAbs().maxCoeff() < 1e-14 * (1.0 + direct[0])); // 5e-15 r0 seen
}

void TestResidualAnalysis::autocovariance_limits_areDefined()
{
    QVERIFY(autocovariance(Eigen::VectorXd(), 3) == Eigen::VectorXd::Zero(4));
    QVERIFY(autocovariance(Eigen::VectorXd::Zero(10), 3).isZero(0.0));
}

void TestResidualAnalysis::autocovariance_allLags_isFast()
{
    const Eigen::VectorXd x = Gaussian(2).vector(300'000, 1.0);
    QElapsedTimer timer;
    timer.start();
    const Eigen::VectorXd all = autocovariance(x, x.size() - 1);
    qInfo("3e5 samples, all lags: %.0f ms", static_cast<double>(timer.nsecsElapsed()) * 1e-6);
    for (const Index lag : {0, 1, 77'777, 299'999}) {
        const double direct = x.head(x.size() - lag).dot(x.tail(x.size() - lag)) / 3e5;
        QVERIFY(std::abs(all[lag] - direct) < 1e-13);
    }
}

void TestResidualAnalysis::ljungBox_knownValues()
{
    Eigen::VectorXd r = Eigen::VectorXd::Zero(30);
    r[0] = 1.0;
    QCOMPARE(ljungBox_p(r, 100, 20), 1.0);
    r[1] = 0.2; // Q = 100 * 102 * 0.04/99 = 4.1212, two degrees: e^(-Q/2)
    QVERIFY(std::abs(ljungBox_p(r, 100, 2) / std::exp(-2.0606060606060606) - 1.0) < 1e-12);
    QCOMPARE(ljungBox_p(r, 100, 0), 1.0);
}

void TestResidualAnalysis::ljungBox_whiteNoise_isUniform()
{
    int below = 0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        const Eigen::VectorXd x = Gaussian(seed).vector(1000, 1.0);
        Eigen::VectorXd r = autocovariance((x.array() - x.mean()).matrix(), 20);
        r /= r[0];
        below += ljungBox_p(r, x.size(), 20) < 0.1 ? 1 : 0;
    }
    QVERIFY2(below > 65 && below < 135, qPrintable(QString::number(below))); // 100 +- 3.7 sd
}

void TestResidualAnalysis::residual_whiteNoise_staysWithinItsBound()
{
    double outside = 0.0;
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const auto result = analyseResidual(Gaussian(seed).vector(5000, 0.3), 1e6, {}, {});
        QVERIFY(result.has_value());
        QVERIFY(std::abs(result->rms / 0.3 - 1.0) < 0.05);
        QCOMPARE(result->autocovariance.size(), Index(501));
        QCOMPARE(result->autocovariance[0], 1.0);
        outside += result->outsideFraction / 50.0;
    }
    QVERIFY2(std::abs(outside - 0.01) < 0.003, qPrintable(QString::number(outside)));
}

void TestResidualAnalysis::residual_confidence_setsTheBound()
{
    ComponentSettings settings;
    settings.residualConfidence = 0.95;
    settings.residualLags = 1000;
    const auto result = analyseResidual(Gaussian(1).vector(400, 1.0), 1.0, settings, {});
    QVERIFY(std::abs(result->confidenceBound - 1.959963984540054 / 20.0) < 1e-14);
    QCOMPARE(result->autocovariance.size(), Index(400)); // no more lags than there are
}

void TestResidualAnalysis::residual_tone_showsItsPeakAndPeriod()
{
    constexpr double kRate_Hz = 1e6, kTone_Hz = 6.8e3;
    const Eigen::VectorXd x
        = Gaussian(3).vector(20'000, 0.1) + Eigen::VectorXd::NullaryExpr(20'000, [&](Index i) {
              return 0.1
                  * std::sin(2.0 * std::numbers::pi * kTone_Hz * static_cast<double>(i) / kRate_Hz);
          });
    SpectrumSettings spectrum; // the operator's own resonance must not hide the peak
    spectrum.searchResonance = false;
    spectrum.resonances_Hz = {318e3};
    spectrum.resonanceBand_Hz = Interval{200e3, 400e3};
    const auto result = analyseResidual(x, kRate_Hz, {}, spectrum);
    QCOMPARE(result->peaks_Hz.size(), std::size_t(1));
    QVERIFY(std::abs(result->peaks_Hz[0] / kTone_Hz - 1.0) < 2e-3);
    QVERIFY(result->autocovariance[147] > 0.2 && result->autocovariance[74] < -0.2);
    QVERIFY(result->outsideFraction > 0.8);
    QVERIFY(result->whiteness_p < 1e-10);
}

void TestResidualAnalysis::residual_correlatedNoise_isNotWhite()
{
    Eigen::VectorXd x = Gaussian(4).vector(5000, 1.0);
    for (Index i = 1; i < x.size(); ++i)
        x[i] += 0.2 * x[i - 1];
    const auto result = analyseResidual(x, 1.0, {}, {});
    QVERIFY(result->whiteness_p < 1e-6);
    QVERIFY(std::abs(result->autocovariance[1] - 0.2) < 0.05);
}

void TestResidualAnalysis::residual_mean_countsForTheRmsOnly()
{
    const Eigen::VectorXd x = Gaussian(5).vector(2000, 1.0).array() + 10.0;
    const auto result = analyseResidual(x, 1.0, {}, {});
    QVERIFY(result->rms > 9.9);
    QVERIFY(result->autocovariance.tail(500).cwiseAbs().maxCoeff() < 0.1);
}

void TestResidualAnalysis::residual_zero_isDefined()
{
    const auto result = analyseResidual(Eigen::VectorXd::Zero(100), 1.0, {}, {});
    QVERIFY(result.has_value());
    QCOMPARE(result->rms, 0.0);
    QCOMPARE(result->whiteness_p, 1.0);
    QCOMPARE(result->outsideFraction, 0.0);
    QVERIFY(result->autocovariance.allFinite() && result->spectrum.psd.allFinite());
}

void TestResidualAnalysis::residual_tooShort_isBlocked()
{
    const auto result = analyseResidual(Eigen::VectorXd::Ones(7), 1.0, {}, {});
    QVERIFY(!result);
    QCOMPARE(result.error().kind, ErrorKind::DataBlocked);
}

DYNCAL_TEST(TestResidualAnalysis)
#include "tst_residual_analysis.moc"
