// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/order/order_scan.h"
#include "tests/support/model_inputs.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <chrono>
#include <cstdio>
#include <functional>
#include <thread>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kRate_Hz = 10e6;
constexpr double kResonance_Hz = 318e3;
constexpr double kDamping = 0.02;
constexpr double kNoise = 0.01;
constexpr Index kLong = 100'000;
constexpr Index kDense = 700; ///< 349 rows: decomposed as a whole
/// The target is 0.2 s; a loaded machine gets three times as much before the test fails.
constexpr double kTarget_s = 0.2;
constexpr double kLimit_s = 0.6;

/// Three shots whose pre-trigger records are long enough for the noise floor by draws.
ModelInput threeShots(Index samples)
{
    const Eigen::VectorXd y = sampledStep(kResonance_Hz, kDamping, kRate_Hz, samples);
    Noise noise(7);
    std::vector<ModelSeries> series;
    for (Index shot = 1; shot <= 3; ++shot)
        series.push_back(makeSeries(
            shot, y + noise.series(samples, kNoise), kRate_Hz, noise.series(4 * samples, kNoise)));
    return makeInput(ResponseTreatment::StepDeflated, kRate_Hz, std::move(series));
}

using Clock = std::chrono::steady_clock;
using Work = std::function<void(const JobControl &)>;

double seconds(Clock::time_point from, Clock::time_point to)
{
    return std::chrono::duration<double>(to - from).count();
}

/// From the request to stop, `after_s` into the work, to the end of it; empty if it ended before.
std::optional<double> timeToStop_s(const Work &work, double after_s)
{
    std::stop_source source;
    std::atomic<bool> ended = false;
    Clock::time_point end;
    std::jthread thread([&] {
        work({source.get_token(), {}});
        end = Clock::now();
        ended = true;
    });
    const auto begin = Clock::now();
    while (!ended && seconds(begin, Clock::now()) < after_s)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (ended)
        return std::nullopt;
    const auto asked = Clock::now();
    source.request_stop();
    thread.join();
    return std::max(0.0, seconds(asked, end));
}

/// The longest time to stop at moments spread over the work; prints it.
double longestToStop_s(const char *what, const Work &work)
{
    const double growth = trials::count(5, 2);
    double longest_s = 0.0;
    int moments = 0;
    for (double after_s = 0.02;; after_s *= growth, ++moments) {
        const auto time_s = timeToStop_s(work, after_s);
        if (!time_s)
            break;
        longest_s = std::max(longest_s, *time_s);
    }
    std::printf("cancel: %s: %.0f ms at most, of %d moments (target %.0f ms)\n", what,
        1e3 * longest_s, moments, 1e3 * kTarget_s);
    std::fflush(stdout);
    return longest_s;
}

RealizationSettings settingsOf(Index largest)
{
    RealizationSettings settings;
    settings.maxOrder = largest;
    return settings;
}

} // namespace

/// How long work goes on once it is asked to stop.
class TestCancel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void decomposition_stopsAtOnce_data();
    void decomposition_stopsAtOnce();
    void suggestion_stopsAtOnce();
    void evidence_stopsAtOnce();
    void model_stopsAtOnce_data();
    void model_stopsAtOnce();

private:
    ModelInput m_input;
    HankelDecomposition m_hankel;
    OrderSuggestion m_suggestion;
};

void TestCancel::initTestCase()
{
    m_input = threeShots(kLong);
    auto hankel = decomposeHankel(m_input, settingsOf(40));
    QVERIFY(hankel);
    m_hankel = std::move(*hankel);
    m_suggestion = suggestOrder(m_input, m_hankel);
}

void TestCancel::decomposition_stopsAtOnce_data()
{
    QTest::addColumn<Index>("samples");
    QTest::addColumn<Index>("largest");
    QTest::newRow("dense, N = 700") << kDense << Index(120);
    QTest::newRow("N = 4000, k = 120") << Index(4000) << Index(120);
    QTest::newRow("N = 100 000, k = 120") << kLong << Index(120);
}

void TestCancel::decomposition_stopsAtOnce()
{
    QFETCH(Index, samples);
    QFETCH(Index, largest);
    const ModelInput input = samples == kLong ? m_input : threeShots(samples);
    const Work work
        = [&](const JobControl &control) { decomposeHankel(input, settingsOf(largest), control); };
    const std::string what = std::string("decomposition, ") + QTest::currentDataTag();
    QVERIFY(longestToStop_s(what.c_str(), work) < kLimit_s);
}

void TestCancel::suggestion_stopsAtOnce()
{
    const Work work = [&](const JobControl &control) { suggestOrder(m_input, m_hankel, control); };
    QVERIFY(longestToStop_s("suggestion, N = 100 000", work) < kLimit_s);
}

void TestCancel::evidence_stopsAtOnce()
{
    const Work work = [&](const JobControl &control) {
        gatherOrderEvidence(m_input, m_hankel, m_suggestion, {}, control);
    };
    QVERIFY(longestToStop_s("evidence, N = 100 000", work) < kLimit_s);
}

void TestCancel::model_stopsAtOnce_data()
{
    QTest::addColumn<Index>("order");
    QTest::newRow("order 2") << Index(2);
    QTest::newRow("order 12") << Index(12);
    QTest::newRow("order 40") << Index(40);
}

void TestCancel::model_stopsAtOnce()
{
    QFETCH(Index, order);
    const Work work = [&](const JobControl &control) {
        testing::realizeModel(m_input, m_hankel, order, {}, control);
    };
    const std::string what = std::string("model, N = 100 000, ") + QTest::currentDataTag();
    QVERIFY(longestToStop_s(what.c_str(), work) < kLimit_s);
}

DYNCAL_TEST(TestCancel)
#include "tst_cancel.moc"
