// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/svd.h"
#include "core/decomposition/component_analysis.h"
#include "core/decomposition/component_result.h"
#include "core/decomposition/component_settings.h"
#include "core/decomposition/principal_components.h"
#include "core/decomposition/residual_analysis.h"
#include "core/signal/resampler.h"
#include "core/signal/response_window.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <Eigen/QR>
#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <stop_token>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Orthonormal columns, the same on every machine.
Eigen::MatrixXd orthonormal(Index rows, Index columns, std::uint64_t seed)
{
    Gaussian noise(seed);
    const Eigen::MatrixXd random
        = Eigen::MatrixXd::NullaryExpr(rows, columns, [&](Index, Index) { return noise(); });
    return Eigen::HouseholderQR<Eigen::MatrixXd>(random).householderQ()
        * Eigen::MatrixXd::Identity(rows, columns);
}

/// Window of a remapped step with rest before it.
WindowedResponse response(Index shot, double noise, double rate_Hz = 10e6,
    SecondOrder sensor = {100e3, 0.05}, double scale = 1.0, double duration_s = 1e-3,
    double late_samples = 0.0)
{
    StepRecord record;
    record.sensor = sensor;
    record.rate_Hz = rate_Hz;
    record.arrival_s = 1e-4 + late_samples / rate_Hz;
    record.duration_s = duration_s;
    record.step = scale;
    record.noiseSd = noise;
    record.seed = static_cast<std::uint64_t>(shot);
    WindowedResponse result;
    result.shot = shot;
    result.sampleRate_Hz = rate_Hz;
    result.values = record.values();
    result.lead = static_cast<Index>(std::llround(1e-4 * rate_Hz));
    result.length = result.values.size() - result.lead;
    return result;
}

const Finding *findingOf(const ComponentResult &result, const std::string &id)
{
    for (const Finding &finding : result.findings) {
        if (finding.id == id)
            return &finding;
    }
    return nullptr;
}

} // namespace

class TestPrincipalComponents : public QObject
{
    Q_OBJECT

private slots:
    void components_constructedMatrix_areRecovered_data();
    void components_constructedMatrix_areRecovered();
    void components_tinyOnes_survive();
    void components_centred_subtractTheMean();
    void components_signs_followTheConvention();
    void components_zeroMatrix_isDefined();
    void components_wideMatrix_isDefined();
    void reconstruct_all_isTheData();
    void reconstruct_some_isTheBestOfItsRank();
    void analyse_identicalShots_isOneComponent();
    void analyse_noisyShots_averagesThem();
    void analyse_differentRates_areReduced();
    void analyse_recordWithoutLead_isReduced();
    void analyse_ratesWithoutRatio_areReducedToo();
    void analyse_windowShorterThanFilter_isBlocked();
    void analyse_lengths_areCutToTheShortest();
    void analyse_oneShot_skipsTheComponents();
    void analyse_keptComponents_areLimited();
    void analyse_unlawfulSettings_areUsage();
    void finding_poorFirstComponent();
    void finding_resonanceLeft();
    void finding_resonanceLeft_byStartsBetweenSamples_isANote();
    void finding_resonanceLeft_byMoreThanStarts_staysACaution();
    void finding_oneShotDominates();
    void analyse_stop_isCancelled();
    void components_longShots_areFast();
};

void TestPrincipalComponents::components_constructedMatrix_areRecovered_data()
{
    QTest::addColumn<int>("rows");
    QTest::addColumn<int>("shots");
    for (const int shots : {1, 2, 3, 10}) {
        QTest::addRow("10 x %d", shots) << 10 << shots;
        QTest::addRow("5000 x %d", shots) << 5000 << shots;
    }
}

void TestPrincipalComponents::components_constructedMatrix_areRecovered()
{
    QFETCH(int, rows);
    QFETCH(int, shots);
    Eigen::VectorXd s(shots);
    for (Index i = 0; i < shots; ++i)
        s[i] = std::pow(0.3, static_cast<double>(i)) * 7.0;
    const Eigen::MatrixXd U = orthonormal(rows, shots, 1), V = orthonormal(shots, shots, 2);
    const Eigen::MatrixXd X = U * s.asDiagonal() * V.transpose();
    const PrincipalComponents pc = computePrincipalComponents(X, false);
    QVERIFY((pc.singularValues - s).cwiseAbs().maxCoeff() < 1e-13 * s[0]);
    QCOMPARE(pc.components.rows(), Index(rows));
    QCOMPARE(pc.components.cols(), Index(shots));
    QCOMPARE(pc.mean.size(), Index(0));
    const Eigen::MatrixXd gram = pc.components.transpose() * pc.components;
    QVERIFY((gram - Eigen::MatrixXd::Identity(shots, shots)).norm() < 1e-13 * shots);
    QVERIFY((pc.components * pc.scores - X).norm() < 1e-13 * X.norm());
    QVERIFY((pc.scores.rowwise().norm() - s).norm() < 1e-13 * s[0]);
    double sum = 0.0;
    for (Index i = 0; i < shots; ++i) {
        sum += s[i] * s[i];
        const double expected = 100.0 * sum / s.squaredNorm();
        QVERIFY(std::abs(pc.explainedCumulative_percent[i] - expected) < 1e-11);
    }
    QVERIFY((pc.singularValues - thinSvd(X).singularValues).norm() < 1e-13 * s[0]);
}

void TestPrincipalComponents::components_tinyOnes_survive()
{
    // The Gram matrix loses everything below 1e-8 of the first.
    Eigen::Vector3d s(1.0, 1e-6, 1e-11);
    const Eigen::MatrixXd U = orthonormal(2000, 3, 3), V = orthonormal(3, 3, 4);
    const PrincipalComponents pc
        = computePrincipalComponents(U * s.asDiagonal() * V.transpose(), false);
    QVERIFY(std::abs(pc.singularValues[1] / 1e-6 - 1.0) < 1e-8);
    QVERIFY(std::abs(pc.singularValues[2] / 1e-11 - 1.0) < 1e-3);
    QVERIFY(std::abs(std::abs(pc.components.col(2).dot(U.col(2))) - 1.0) < 1e-3);
}

void TestPrincipalComponents::components_centred_subtractTheMean()
{
    Gaussian noise(5);
    const Eigen::MatrixXd X = Eigen::MatrixXd::NullaryExpr(
        100, 4, [&](Index i, Index) { return noise() + 0.1 * static_cast<double>(i); });
    const PrincipalComponents pc = computePrincipalComponents(X, true);
    QVERIFY((pc.mean - X.rowwise().mean()).norm() < 1e-14 * pc.mean.norm());
    QVERIFY(pc.singularValues[3] < 1e-13 * pc.singularValues[0]); // one dimension is the mean
    QVERIFY((reconstruct(pc, 4) - X).norm() < 1e-13 * X.norm());
    QVERIFY((pc.scores.rowwise().sum()).norm() < 1e-12 * pc.singularValues[0]);
}

void TestPrincipalComponents::components_signs_followTheConvention()
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Gaussian noise(seed);
        const Eigen::VectorXd shape = noise.vector(50, 1.0);
        Eigen::MatrixXd X(50, 3);
        for (Index i = 0; i < 3; ++i)
            X.col(i) = shape + noise.vector(50, 0.1);
        const PrincipalComponents pc = computePrincipalComponents(X, false);
        QVERIFY(pc.scores.row(0).mean() > 0.0);
        QVERIFY(pc.components.col(0).dot(shape) > 0.0);
        for (Index i = 1; i < 3; ++i) {
            Index largest = 0;
            pc.scores.row(i).cwiseAbs().maxCoeff(&largest);
            QVERIFY(pc.scores(i, largest) > 0.0);
        }
    }
}

void TestPrincipalComponents::components_zeroMatrix_isDefined()
{
    const PrincipalComponents pc = computePrincipalComponents(Eigen::MatrixXd::Zero(20, 3), false);
    QVERIFY(pc.singularValues.isZero(0.0));
    QVERIFY(pc.explainedCumulative_percent.isZero(0.0)); // not NaN
    QVERIFY(pc.components.allFinite() && pc.scores.allFinite());
}

void TestPrincipalComponents::components_wideMatrix_isDefined()
{
    const Eigen::MatrixXd X = orthonormal(5, 3, 1).transpose(); // 3 samples of 5 shots
    const PrincipalComponents pc = computePrincipalComponents(X, false);
    QCOMPARE(pc.singularValues.size(), Index(3));
    QVERIFY((pc.components * pc.scores - X).norm() < 1e-14);
}

void TestPrincipalComponents::reconstruct_all_isTheData()
{
    Gaussian noise(8);
    const Eigen::MatrixXd X
        = Eigen::MatrixXd::NullaryExpr(300, 5, [&](Index, Index) { return noise(); });
    QVERIFY((reconstruct(computePrincipalComponents(X, false), 5) - X).norm() < 1e-12);
}

/// Eckart-Young: the error of rank k is the norm of the singular values left out.
void TestPrincipalComponents::reconstruct_some_isTheBestOfItsRank()
{
    Gaussian noise(9);
    const Eigen::MatrixXd X
        = Eigen::MatrixXd::NullaryExpr(300, 5, [&](Index, Index) { return noise(); });
    const PrincipalComponents pc = computePrincipalComponents(X, false);
    for (Index kept = 1; kept < 5; ++kept) {
        const double error = (X - reconstruct(pc, kept)).norm();
        QVERIFY(std::abs(error / pc.singularValues.tail(5 - kept).norm() - 1.0) < 1e-12);
    }
}

void TestPrincipalComponents::analyse_identicalShots_isOneComponent()
{
    const auto result = analyseComponents(
        {response(1, 0.0), response(2, 0.0, 10e6, {100e3, 0.05}, 2.0), response(7, 0.0)}, {}, {});
    QVERIFY(result.has_value());
    QCOMPARE(result->shots, (std::vector<Index>{1, 2, 7}));
    QCOMPARE(result->sampleRate_Hz, 10e6);
    QVERIFY(std::abs(result->principal->explainedCumulative_percent[0] - 100.0) < 1e-10);
    QVERIFY(
        (result->reconstructions - result->responses).norm() < 1e-12 * result->responses.norm());
    QVERIFY((result->average - result->responses.col(0) * 4.0 / 3.0).norm()
        < 1e-12 * result->average.norm());
    QVERIFY(result->findings.empty()); // rounding is not a residual
    QCOMPARE(result->residuals.size(), std::size_t(3));
    for (const ResidualAnalysis &residual : result->residuals)
        QVERIFY(residual.rms < 1e-12 && residual.autocovariance.allFinite());
}

void TestPrincipalComponents::analyse_noisyShots_averagesThem()
{
    constexpr double kNoise = 0.02;
    std::vector<WindowedResponse> shots;
    for (Index i = 1; i <= 4; ++i)
        shots.push_back(response(i, kNoise));
    const auto result = analyseComponents(shots, {}, {});
    const Eigen::VectorXd clean = response(9, 0.0).window();
    const double error
        = (result->average - clean).norm() / std::sqrt(static_cast<double>(clean.size()));
    QVERIFY(std::abs(error / (kNoise / 2.0) - 1.0) < 0.05); // noise falls by sqrt(4)
    QVERIFY(result->principal->explainedCumulative_percent[0] > 99.9);
    for (const ResidualAnalysis &residual : result->residuals) {
        // what one component takes from white noise of four shots: a quarter of the energy
        QVERIFY(std::abs(residual.rms / (kNoise * std::sqrt(0.75)) - 1.0) < 0.03);
        QVERIFY(residual.whiteness_p > 1e-4);
        QVERIFY(residual.outsideFraction < 0.05);
        QVERIFY(residual.peaks_Hz.empty());
    }
    QVERIFY(result->findings.empty());
}

void TestPrincipalComponents::analyse_differentRates_areReduced()
{
    const std::vector<WindowedResponse> shots{response(1, 0.0, 50e6, {20e3, 0.3}),
        response(2, 0.0, 10e6, {20e3, 0.3}), response(3, 0.0, 20e6, {20e3, 0.3})};
    const auto result = analyseComponents(shots, {}, {});
    QVERIFY(result.has_value());
    QCOMPARE(result->sampleRate_Hz, 10e6);
    QVERIFY(!findingOf(*result, "CAP-004")); // the captures' check has said so already
    // far below the new Nyquist frequency only the onset's kink is not passed as it is
    const Index settled = 12;
    for (const Index shot : {0, 2}) {
        const Eigen::VectorXd difference = result->responses.col(shot) - result->responses.col(1);
        QVERIFY(difference.tail(difference.size() - settled).cwiseAbs().maxCoeff() < 2e-5);
        QVERIFY(difference.cwiseAbs().maxCoeff() < 1e-3);
    }
    QVERIFY(result->responses.rows() >= 9000 - 6);
}

void TestPrincipalComponents::analyse_recordWithoutLead_isReduced()
{
    WindowedResponse bare = response(1, 0.0, 50e6, {20e3, 0.3});
    bare.values = Eigen::VectorXd(bare.values.tail(bare.length));
    bare.lead = 0;
    const auto result = analyseComponents({bare, response(2, 0.0, 10e6, {20e3, 0.3})}, {}, {});
    QVERIFY(result.has_value());
    const Eigen::VectorXd difference = result->responses.col(0) - result->responses.col(1);
    QVERIFY(difference.cwiseAbs().maxCoeff() < 1e-3); // rest before the start is the truth here
}

void TestPrincipalComponents::analyse_ratesWithoutRatio_areReducedToo()
{
    const auto result = analyseComponents(
        {response(1, 0.0, 50e6, {20e3, 0.3}), response(2, 0.0, 20e6, {20e3, 0.3})}, {}, {});
    QVERIFY(result.has_value());
    QCOMPARE(result->sampleRate_Hz, 20e6);
    const Eigen::VectorXd difference = result->responses.col(0) - result->responses.col(1);
    QVERIFY(difference.cwiseAbs().maxCoeff() < 1e-3); // the filter's ripple between the inputs
}

void TestPrincipalComponents::analyse_windowShorterThanFilter_isBlocked()
{
    for (const Index length : {1, 100, 400, 600}) {
        WindowedResponse tiny = response(1, 0.0, 10e6);
        tiny.length = length;
        tiny.values = Eigen::VectorXd(tiny.values.head(tiny.lead + length)); // no margin behind
        const auto result = analyseComponents({tiny, response(2, 0.0, 1e5)}, {}, {});
        QVERIFY(!result);
        QCOMPARE(result.error().kind, ErrorKind::DataBlocked);
        QCOMPARE(result.error().shot, Index(1));
    }
}

void TestPrincipalComponents::analyse_lengths_areCutToTheShortest()
{
    WindowedResponse shorter = response(2, 0.01);
    shorter.length = 777;
    const auto result = analyseComponents({response(1, 0.01), shorter}, {}, {});
    QCOMPARE(result->responses.rows(), Index(777));
    QVERIFY(result->responses.col(1) == Eigen::VectorXd(shorter.window()));
    QCOMPARE(result->average.size(), Index(777));
    QCOMPARE(result->residuals[0].autocovariance.size(), Index(501));
}

void TestPrincipalComponents::analyse_oneShot_skipsTheComponents()
{
    const auto result = analyseComponents({response(3, 0.01)}, {}, {});
    QVERIFY(result.has_value());
    QVERIFY(!result->principal);
    QVERIFY(result->residuals.empty());
    QVERIFY(result->average == Eigen::VectorXd(response(3, 0.01).window()));
    QVERIFY(result->reconstructions == result->responses);
    QVERIFY(result->findings.empty()); // CAP-017 comes from the captures' check
}

void TestPrincipalComponents::analyse_keptComponents_areLimited()
{
    ComponentSettings settings;
    settings.components = 2;
    const std::vector<WindowedResponse> shots{response(1, 0.1), response(2, 0.1), response(3, 0.1)};
    const auto two = analyseComponents(shots, settings, {});
    QCOMPARE(two->kept, Index(2));
    settings.components = 50;
    const auto all = analyseComponents(shots, settings, {});
    QCOMPARE(all->kept, Index(3));
    QVERIFY(two->residuals[0].rms > 0.01 && all->residuals[0].rms < 1e-12);
}

void TestPrincipalComponents::analyse_unlawfulSettings_areUsage()
{
    const std::vector<WindowedResponse> shots{response(1, 0.1), response(2, 0.1)};
    QCOMPARE(analyseComponents({}, {}, {}).error().kind, ErrorKind::Usage);
    ComponentSettings settings;
    settings.components = 0;
    QCOMPARE(analyseComponents(shots, settings, {}).error().kind, ErrorKind::Usage);
    settings = {};
    settings.residualLags = 0;
    QCOMPARE(analyseComponents(shots, settings, {}).error().kind, ErrorKind::Usage);
    settings = {};
    settings.residualConfidence = 1.0;
    QCOMPARE(analyseComponents(shots, settings, {}).error().kind, ErrorKind::Usage);
}

void TestPrincipalComponents::finding_poorFirstComponent()
{
    std::vector<WindowedResponse> shots{response(1, 0.0), response(2, 0.0), response(3, 0.0)};
    shots[1].values += Gaussian(3).vector(shots[1].values.size(), 1.0);
    const auto result = analyseComponents(shots, {}, {});
    const Finding *finding = findingOf(*result, "PCA-001");
    QVERIFY(finding);
    QCOMPARE(finding->severity, Severity::Caution);
    QCOMPARE(finding->shot, Index(2));
    QCOMPARE(*finding->value, result->principal->explainedCumulative_percent[0]);
    QCOMPARE(*finding->limit, 95.0);
    ComponentSettings centred; // deviations from the mean: no single one has to dominate
    centred.centre = true;
    QVERIFY(!findingOf(*analyseComponents(shots, centred, {}), "PCA-001"));
}

void TestPrincipalComponents::finding_resonanceLeft()
{
    // the same resonance with another damping in one shot
    const auto result = analyseComponents(
        {response(1, 0.001), response(2, 0.001), response(3, 0.001, 10e6, {100e3, 0.03})}, {}, {});
    QVERIFY(findingOf(*result, "PCA-003"));
    QVERIFY(*findingOf(*result, "PCA-003")->value > *findingOf(*result, "PCA-003")->limit);
    QCOMPARE(findingOf(*result, "PCA-003")->severity, Severity::Caution);
    QVERIFY(findingOf(*result, "PCA-002"));
    QCOMPARE(findingOf(*result, "PCA-002")->severity, Severity::Info);
    QVERIFY(!result->residuals[2].peaks_Hz.empty());
    QVERIFY(result->residuals[2].whiteness_p < 1e-6);
}

void TestPrincipalComponents::finding_resonanceLeft_byStartsBetweenSamples_isANote()
{
    // 25 samples a period, shots apart by 0.9 of one: 0.23 rad of the ringing, more than 10 %.
    constexpr double kRate_Hz = 2.5e6;
    const auto late = [&](Index shot, double samples) {
        return response(shot, 0.001, kRate_Hz, {100e3, 0.05}, 1.0, 1e-3, samples);
    };
    const auto result = analyseComponents({late(1, 0.0), late(2, 0.45), late(3, 0.9)}, {}, {});
    int notes = 0;
    for (const Finding &finding : result->findings) {
        if (finding.id != "PCA-003")
            continue;
        QCOMPARE(finding.severity, Severity::Info);
        notes += *finding.value > *finding.limit ? 1 : 0;
        if (finding.shot == 3) // the others' mean start is 0.45 before
            QVERIFY(finding.message.arguments.size() == 5
                && std::abs(std::stod(finding.message.arguments[3]) - 0.45) < 0.05);
    }
    QVERIFY2(notes > 0, "the case must be one that was a caution before");
}

void TestPrincipalComponents::finding_resonanceLeft_byMoreThanStarts_staysACaution()
{
    constexpr double kRate_Hz = 2.5e6;
    const auto caution = [](const ComponentResult &result) {
        return std::any_of(result.findings.begin(), result.findings.end(),
            [](const Finding &f) { return f.id == "PCA-003" && f.severity == Severity::Caution; });
    };
    const auto shot = [&](Index number, SecondOrder sensor, double samples) {
        return response(number, 0.001, kRate_Hz, sensor, 1.0, 1e-3, samples);
    };
    // Starts between samples and a resonance that is another: both shifted, one not the same.
    QVERIFY(caution(*analyseComponents(
        {shot(1, {100e3, 0.05}, 0.0), shot(2, {100e3, 0.05}, 0.45), shot(3, {100e3, 0.03}, 0.9)},
        {}, {})));
    // The same shape three samples late: that start was not found.
    QVERIFY(caution(*analyseComponents(
        {shot(1, {100e3, 0.05}, 0.0), shot(2, {100e3, 0.05}, 0.0), shot(3, {100e3, 0.05}, 3.0)}, {},
        {})));
}

void TestPrincipalComponents::finding_oneShotDominates()
{
    const auto result
        = analyseComponents({response(1, 0.001), response(2, 0.001), response(3, 0.05)}, {}, {});
    const Finding *finding = findingOf(*result, "PCA-004");
    QVERIFY(finding);
    QCOMPARE(finding->shot, Index(3));
    QVERIFY(std::abs(*finding->value - 66.7) < 1.0); // two thirds of three: all it can be
    QCOMPARE(*finding->limit, 60.0);
    // noise in inverse proportion to the step, as remapped shots of three levels have it
    QVERIFY(!findingOf(
        *analyseComponents({response(1, 0.03), response(2, 0.0167), response(3, 0.011)}, {}, {}),
        "PCA-004"));
    QVERIFY(
        !findingOf(*analyseComponents({response(1, 0.001), response(2, 0.05)}, {}, {}), "PCA-004"));
}

void TestPrincipalComponents::analyse_stop_isCancelled()
{
    std::stop_source source;
    source.request_stop();
    const auto result
        = analyseComponents({response(1, 0.1), response(2, 0.1)}, {}, {}, {source.get_token(), {}});
    QVERIFY(!result);
    QCOMPARE(result.error().kind, ErrorKind::Cancelled);
}

void TestPrincipalComponents::components_longShots_areFast()
{
    Gaussian noise(1);
    Eigen::MatrixXd X(1'000'000, 3);
    for (Index i = 0; i < 3; ++i)
        X.col(i) = noise.vector(X.rows(), 1.0);
    QElapsedTimer timer;
    timer.start();
    const PrincipalComponents pc = computePrincipalComponents(X, false);
    const auto fast_ms = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    timer.restart();
    const ThinSvd direct = thinSvd(X);
    const auto direct_ms = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    qInfo("1e6 x 3: %.0f ms, thin SVD %.0f ms", fast_ms, direct_ms);
    QVERIFY((pc.singularValues / direct.singularValues[0]
                - direct.singularValues / direct.singularValues[0])
                .norm()
        < 1e-12);
}

DYNCAL_TEST(TestPrincipalComponents)
#include "tst_principal_components.moc"
