// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which samples a stretch left out takes with it, and what bridges it; whole calibrations with a
// burst in one shot: tests/core/realization/input/tst_left_out.cpp.

#include "core/realization/input/left_out.h"
#include "core/signal/resampler.h"
#include "tests/support/model_inputs.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;
using testing::hasFinding;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding = 1e-12;
constexpr Index kLead = 60;

/// A record of one shot whose value `i` samples behind the start is `truth(i)`, spoilt in
/// [begin, end), and the model input made of it: every `factor`-th sample from `first` on.
struct Scene
{
    WindowedResponse response;
    ModelInput input;

    ModelSeries &series() { return input.series.front(); }
    Result<void> leaveOut(const std::vector<ExcludedStretch> &stretches)
    {
        return dyncal::leaveOut(input, {response}, stretches);
    }
};

template <typename Truth>
Scene sceneOf(double factor, Index count, const Truth &truth, SampleRange spoilt = {},
    double spoiltBy = 0.0, Index shot = 1)
{
    const AntiAliasFilter filter = designAntiAliasFilter(factor, kRate_Hz);
    const Index half = filter.halfLength();
    const Index first = half + 3;
    const auto last = first + static_cast<Index>(std::ceil(factor * static_cast<double>(count)));
    Scene scene;
    WindowedResponse &response = scene.response;
    response.shot = shot;
    response.sampleRate_Hz = kRate_Hz;
    response.lead = kLead + half;
    response.length = last;
    response.values.resize(response.lead + last + half + 2);
    for (Index i = 0; i < response.values.size(); ++i) {
        const Index k = i - response.lead;
        response.values[i] = truth(static_cast<double>(k))
            + (k >= spoilt.begin && k < spoilt.end ? spoiltBy : 0.0);
    }
    ModelSeries series;
    series.shot = shot;
    series.filter = filter;
    series.first_s = static_cast<double>(first) / kRate_Hz;
    series.y = decimate(response.values, filter, response.lead + first, count);
    series.fullRate_Hz = kRate_Hz;
    series.fullRate = response.values.segment(response.lead,
        first + static_cast<Index>(std::floor(factor * static_cast<double>(count - 1))) + 1);
    scene.input = testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz / factor, {series});
    scene.input.combine = CombineMethod::Stacked;
    return scene;
}

double slope(double i)
{
    return 3.0 - 0.01 * i;
}

/// Stretch over samples [begin, end), at least two, its limits between samples.
ExcludedStretch stretchOver(Index begin, Index end, Index shot = 1)
{
    return {shot, (static_cast<double>(begin) + 0.2) / kRate_Hz,
        (static_cast<double>(end) - 1.2) / kRate_Hz, "burst"};
}

} // namespace

class TestLeftOutSamples : public QObject
{
    Q_OBJECT

private slots:
    void stretch_reachesToTheSamplesOutside();
    void stretches_thatTouch_areOneInWhateverOrder();
    void stretch_thatBeginsBeforeTheStartOrEndsBehind_isCut();
    void usedSamples_andStretches_areTheWholeRecord();
    void countedSamples_seeNothingThatIsLeftOut_data();
    void countedSamples_seeNothingThatIsLeftOut();
    void countedValues_areThoseOfTheCountedSamples();
    void straightLine_bridgesAStraightResponse_data();
    void straightLine_bridgesAStraightResponse();
    void stretchToTheEnd_isBridgedByTheLevelBefore();
    void bridge_putsTheModelInPlace();
    void cleanRun_isTheLongestWithoutAnything();
    void cleanRun_ofUnlikeSeries_isAsLongAsTheShortest();
    void cleanRun_tooShort_isEmpty();
    void withoutStretches_nothingChanges();
    void stretchOfAnotherShot_isNotNoted();
    void stretchThatMakesNoSense_isRefused_data();
    void stretchThatMakesNoSense_isRefused();
    void moreThanHalf_isRefusedWithTheNumbers();
    void average_knowsNoStretches();
};

void TestLeftOutSamples::stretch_reachesToTheSamplesOutside()
{
    Scene scene = sceneOf(1.0, 100, slope);
    QVERIFY(scene.leaveOut({{1, 20.5e-6, 30.5e-6, "burst"}}).has_value());
    QCOMPARE(scene.series().leftOut.size(), std::size_t(1));
    const LeftOut &part = scene.series().leftOut[0];
    QCOMPARE(part.samples, (SampleRange{20, 32})); // 20 .. 31 hold 20.5 to 30.5
    for (Index i = 0; i < part.samples.size(); ++i)
        QCOMPARE(part.recorded[i], slope(static_cast<double>(20 + i)));
    QVERIFY(hasFinding(scene.input.findings, "WIN-007"));
    const std::string text = english(scene.input.findings[0].message);
    QVERIFY2(text.find("burst") != std::string::npos, text.c_str());
    QVERIFY2(text.find("20.5 ") != std::string::npos, text.c_str());
    QCOMPARE(scene.input.leftOut.size(), std::size_t(1));
}

void TestLeftOutSamples::stretches_thatTouch_areOneInWhateverOrder()
{
    const ExcludedStretch a = stretchOver(10, 20), b = stretchOver(20, 30), c = stretchOver(25, 28),
                          d = stretchOver(40, 45);
    for (const auto &order : {std::vector{a, b, c, d}, {d, c, b, a}, {b, d, a, c}, {a, c, d, b}}) {
        Scene scene = sceneOf(1.0, 100, slope);
        QVERIFY(scene.leaveOut(order).has_value());
        const auto &parts = scene.series().leftOut;
        QCOMPARE(parts.size(), std::size_t(2));
        QCOMPARE(parts[0].samples, (SampleRange{10, 30}));
        QCOMPARE(parts[1].samples, (SampleRange{40, 45}));
        QCOMPARE(parts[0].recorded.size(), Index(20));
        QCOMPARE(scene.input.leftOut.size(), std::size_t(4)); // each with its own reason
    }
}

void TestLeftOutSamples::stretch_thatBeginsBeforeTheStartOrEndsBehind_isCut()
{
    for (const double before_s : {-1e-6, -1e-3, -1e30}) {
        Scene scene = sceneOf(1.0, 100, slope);
        QVERIFY(scene.leaveOut({{1, before_s, 9.5e-6, "x"}}).has_value());
        QCOMPARE(scene.series().leftOut[0].samples, (SampleRange{0, 11}));
    }
    for (const double behind_s : {100e-6, 1.0, 1e30}) {
        Scene scene = sceneOf(1.0, 100, slope);
        QVERIFY(scene.leaveOut({{1, 90.5e-6, behind_s, "x"}}).has_value());
        const SampleRange samples = scene.series().leftOut[0].samples;
        QCOMPARE(samples.begin, Index(90));
        QVERIFY(samples.end >= scene.series().fullRate.size() - 3);
        QVERIFY(samples.end <= scene.response.values.size() - scene.response.lead);
    }
}

void TestLeftOutSamples::usedSamples_andStretches_areTheWholeRecord()
{
    QVERIFY(usedSamples(sceneOf(1.0, 100, slope).series()).empty()); // empty = all
    for (const auto &stretches : {std::vector{stretchOver(0, 10)}, {stretchOver(50, 60)},
             {stretchOver(0, 5), stretchOver(30, 33), stretchOver(90, 104)}}) {
        Scene scene = sceneOf(1.0, 100, slope);
        QVERIFY(scene.leaveOut(stretches).has_value());
        std::vector<int> seen(static_cast<std::size_t>(scene.series().fullRate.size()), 0);
        for (const SampleRange &range : usedSamples(scene.series())) {
            QVERIFY(range.size() > 0);
            for (Index i = range.begin; i < range.end; ++i)
                ++seen[static_cast<std::size_t>(i)];
        }
        for (const LeftOut &part : scene.series().leftOut) {
            for (Index i = part.samples.begin;
                 i < std::min<Index>(part.samples.end, std::ssize(seen)); ++i)
                ++seen[static_cast<std::size_t>(i)];
        }
        QVERIFY(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
    }
}

void TestLeftOutSamples::countedSamples_seeNothingThatIsLeftOut_data()
{
    QTest::addColumn<double>("factor");
    for (const double factor : {1.0, 2.0, 4.0, 2.5, 3.3, 1.7})
        QTest::addRow("every %g samples", factor) << factor;
}

void TestLeftOutSamples::countedSamples_seeNothingThatIsLeftOut()
{
    // What was recorded there is made NaN: whatever the filter lets see of it is NaN too.
    QFETCH(double, factor);
    const auto samples = [&](double at) { return static_cast<Index>(std::lround(at * factor)); };
    for (Index shift = 0; shift < 8; ++shift) {
        const SampleRange spoilt{samples(80) + shift, samples(80) + shift + 6};
        Scene scene = sceneOf(factor, 160, slope, spoilt, kNaN);
        QVERIFY(scene.leaveOut({stretchOver(spoilt.begin, spoilt.end)}).has_value());
        QCOMPARE(scene.series().leftOut[0].samples, spoilt);
        std::vector<bool> counted(160, false);
        for (const SampleRange &range : countedSamples(scene.series())) {
            for (Index k = range.begin; k < range.end; ++k)
                counted[static_cast<std::size_t>(k)] = true;
        }
        for (Index k = 0; k < 160; ++k)
            QVERIFY2(counted[static_cast<std::size_t>(k)] == std::isfinite(scene.series().y[k]),
                qPrintable(QString("sample %1, stretch at %2").arg(k).arg(spoilt.begin)));
    }
}

void TestLeftOutSamples::countedValues_areThoseOfTheCountedSamples()
{
    Scene scene = sceneOf(1.0, 100, slope);
    const Eigen::VectorXd numbers = Eigen::VectorXd::LinSpaced(100, 0.0, 99.0);
    QCOMPARE(countedValues(scene.series(), numbers), numbers);
    // y[k] is sample 3 + k of the record.
    QVERIFY(scene.leaveOut({stretchOver(13, 23), stretchOver(50, 52)}).has_value());
    const Eigen::VectorXd kept = countedValues(scene.series(), numbers);
    QCOMPARE(kept.size(), Index(88));
    QCOMPARE(kept[9], 9.0);
    QCOMPARE(kept[10], 20.0);
    QCOMPARE(kept[36], 46.0);
    QCOMPARE(kept[37], 49.0);
    QCOMPARE(kept[87], 99.0);
}

void TestLeftOutSamples::straightLine_bridgesAStraightResponse_data()
{
    countedSamples_seeNothingThatIsLeftOut_data();
}

void TestLeftOutSamples::straightLine_bridgesAStraightResponse()
{
    QFETCH(double, factor);
    const Scene clean = sceneOf(factor, 100, slope);
    const auto begin = static_cast<Index>(40 * factor);
    for (const SampleRange &spoilt :
        {SampleRange{begin, begin + 7}, SampleRange{begin, begin + 2}}) {
        Scene scene = sceneOf(factor, 100, slope, spoilt, 5.0);
        QVERIFY(scene.leaveOut({stretchOver(spoilt.begin, spoilt.end)}).has_value());
        const Eigen::VectorXd bridged = scene.series().y + scene.series().correction;
        QVERIFY((bridged - clean.input.series[0].y).cwiseAbs().maxCoeff() < kRounding);
    }
}

void TestLeftOutSamples::stretchToTheEnd_isBridgedByTheLevelBefore()
{
    const auto level = [](double) { return 2.0; };
    for (const double factor : {1.0, 4.0}) {
        const Scene clean = sceneOf(factor, 100, level);
        const Index size = clean.response.length;
        const SampleRange spoilt{size - 20, size + 100};
        Scene scene = sceneOf(factor, 100, level, spoilt, 5.0);
        QVERIFY(scene
                    .leaveOut({{1, (static_cast<double>(spoilt.begin) + 0.5) / kRate_Hz,
                        static_cast<double>(size) / kRate_Hz, "x"}})
                    .has_value());
        const Eigen::VectorXd bridged = scene.series().y + scene.series().correction;
        // Only what the stretch covers can be bridged: the filter may look beyond the window.
        const Index seen = scene.series().filter.halfLength();
        const Index covered
            = 100 - static_cast<Index>(std::ceil(static_cast<double>(seen) / factor));
        QVERIFY((bridged.head(covered).array() - 2.0).abs().maxCoeff() < kRounding);
    }
}

void TestLeftOutSamples::bridge_putsTheModelInPlace()
{
    ExponentialSum sensor{1.0, Eigen::VectorXcd(2), Eigen::VectorXcd(2)};
    sensor.poles_rad_s << std::complex<double>(-2e3, 9e4), std::complex<double>(-2e3, -9e4);
    sensor.amplitudes << std::complex<double>(-0.5, 0.1), std::complex<double>(-0.5, -0.1);
    const NuisanceTerm tube{0, true, {-500.0, 2e4}, {0.05, 0.02}};
    const auto truth
        = [&](double i) { return sensor.value(i / kRate_Hz) + tube.value(i / kRate_Hz); };
    for (const double factor : {1.0, 4.0, 2.5}) {
        const Scene clean = sceneOf(factor, 120, truth);
        const auto begin = static_cast<Index>(50 * factor);
        Scene scene = sceneOf(factor, 120, truth, {begin, begin + 9}, -3.0);
        scene.series().nuisance = {tube};
        QVERIFY(scene.leaveOut({stretchOver(begin, begin + 9)}).has_value());
        const Eigen::VectorXd bridged = scene.series().y + bridge(scene.series(), sensor);
        QVERIFY((bridged - clean.input.series[0].y).cwiseAbs().maxCoeff() < kRounding);
    }
}

void TestLeftOutSamples::cleanRun_isTheLongestWithoutAnything()
{
    Scene scene = sceneOf(1.0, 100, slope);
    QVERIFY(scene.leaveOut({stretchOver(33, 38), stretchOver(93, 96)}).has_value());
    const ModelInput run = cleanRun(scene.input);
    QCOMPARE(run.samples, Index(55)); // samples 38 .. 92 of the record, y[35] .. y[89]
    QCOMPARE(run.series[0].y, scene.series().y.segment(35, 55).eval());
    QVERIFY(std::abs(run.series[0].first_s - 38e-6) < 1e-15);
}

void TestLeftOutSamples::cleanRun_ofUnlikeSeries_isAsLongAsTheShortest()
{
    Scene scene = sceneOf(1.0, 100, slope);
    const Scene other = sceneOf(1.0, 100, slope, {}, 0.0, 2);
    scene.input.series.push_back(other.input.series[0]);
    QVERIFY(leaveOut(scene.input, {scene.response, other.response},
        {stretchOver(43, 53, 1), stretchOver(63, 73, 2)})
                .has_value());
    const ModelInput run = cleanRun(scene.input);
    QCOMPARE(run.samples, Index(50)); // shot 1: y[50] on; shot 2: y[0] to y[59]
    QCOMPARE(run.series[0].y, scene.input.series[0].y.segment(50, 50).eval());
    QCOMPARE(run.series[1].y, scene.input.series[1].y.head(50).eval());
    QCOMPARE(run.series[1].first_s, scene.input.series[1].first_s);
}

void TestLeftOutSamples::cleanRun_tooShort_isEmpty()
{
    Scene scene = sceneOf(1.0, 100, slope);
    std::vector<ExcludedStretch> stretches; // 20 samples free at a time: fewer than 24
    for (Index begin = 23; begin < 100; begin += 22)
        stretches.push_back(stretchOver(begin, begin + 2));
    QVERIFY(scene.leaveOut(stretches).has_value());
    QVERIFY(cleanRun(scene.input).series.empty());
}

void TestLeftOutSamples::withoutStretches_nothingChanges()
{
    Scene scene = sceneOf(4.0, 50, slope);
    QVERIFY(scene.leaveOut({}).has_value());
    QVERIFY(scene.series().leftOut.empty());
    QCOMPARE(scene.series().correction.size(), Index(0));
    QCOMPARE(countedSamples(scene.series()), (std::vector<SampleRange>{{0, 50}}));
    QCOMPARE(cleanRun(scene.input).series[0].y, scene.series().y);
    QVERIFY(scene.input.findings.empty());
}

void TestLeftOutSamples::stretchOfAnotherShot_isNotNoted()
{
    Scene scene = sceneOf(1.0, 50, slope);
    QVERIFY(scene.leaveOut({stretchOver(10, 20, 7)}).has_value());
    QVERIFY(scene.series().leftOut.empty() && scene.input.leftOut.empty());
    QVERIFY(scene.input.findings.empty());
}

void TestLeftOutSamples::stretchThatMakesNoSense_isRefused_data()
{
    QTest::addColumn<double>("from_s");
    QTest::addColumn<double>("to_s");
    QTest::newRow("ends before it begins") << 20e-6 << 10e-6;
    QTest::newRow("empty") << 20e-6 << 20e-6;
    QTest::newRow("before the window") << -2e-3 << -1e-3;
    QTest::newRow("behind the window") << 1.0 << 2.0;
    QTest::newRow("no begin") << kNaN << 20e-6;
    QTest::newRow("no end") << 20e-6 << kNaN;
}

void TestLeftOutSamples::stretchThatMakesNoSense_isRefused()
{
    QFETCH(double, from_s);
    QFETCH(double, to_s);
    Scene scene = sceneOf(1.0, 50, slope);
    const auto done = scene.leaveOut({{1, from_s, to_s, "x"}});
    QVERIFY(!done);
    QVERIFY(done.error().kind == ErrorKind::Usage);
    QCOMPARE(done.error().shot, Index(1));
    const std::string text = english(done.error().message);
    QVERIFY2(text.find("window.exclude_stretches") != std::string::npos, text.c_str());
    QVERIFY2(
        text.find("53 \xC2\xB5s") != std::string::npos || text.find("53 us") != std::string::npos,
        text.c_str()); // how far the window reaches
}

void TestLeftOutSamples::moreThanHalf_isRefusedWithTheNumbers()
{
    Scene half = sceneOf(1.0, 100, slope);
    QVERIFY(half.leaveOut({stretchOver(3, 53)}).has_value()); // y[0] .. y[49]
    Scene more = sceneOf(1.0, 100, slope);
    const auto done = more.leaveOut({stretchOver(3, 54)});
    QVERIFY(!done);
    QCOMPARE(done.error().findingId, std::string("WIN-008"));
    QVERIFY(done.error().kind == ErrorKind::DataBlocked);
    const std::string text = english(done.error().message);
    QVERIFY2(text.find("only 49 of the 100 samples") != std::string::npos, text.c_str());
    // The filter makes less of it worthless: 6 x 4 samples on either side.
    Scene filtered = sceneOf(4.0, 20, slope);
    QVERIFY(!filtered.leaveOut({stretchOver(60, 62)}).has_value());
}

void TestLeftOutSamples::average_knowsNoStretches()
{
    Scene scene = sceneOf(1.0, 50, slope);
    scene.input.combine = CombineMethod::PcaAverage;
    QVERIFY(scene.leaveOut({stretchOver(10, 20)}).has_value());
    QVERIFY(scene.series().leftOut.empty());
    QVERIFY(hasFinding(scene.input.findings, "WIN-009"));
    QVERIFY(!hasFinding(scene.input.findings, "WIN-007"));
}

DYNCAL_TEST(TestLeftOutSamples)
#include "tst_left_out_samples.moc"
