// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which modes are looked for, over which record, and what taking one off leaves of the model input.

#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/nuisance/nuisance_search.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kRate_Hz = 1e6;
constexpr double kWindow_s = 4e-3;

Complex poleFrom(double frequency_Hz, double zeta)
{
    return kTwoPi * frequency_Hz * Complex(-zeta, std::sqrt(1.0 - zeta * zeta));
}

NuisanceMode modeAt(double frequency_Hz, const char *label = "")
{
    return {{frequency_Hz}, 0, true, label, "test"};
}

/// A plateau with these terms on it, some noise, and samples before the start.
WindowedResponse responseWith(Index shot, const std::vector<NuisanceTerm> &terms)
{
    testing::Noise noise(static_cast<std::uint64_t>(shot));
    WindowedResponse response;
    response.shot = shot;
    response.sampleRate_Hz = kRate_Hz;
    response.lead = 100;
    response.length = static_cast<Index>(kWindow_s * kRate_Hz);
    response.values = noise.series(response.lead + response.length + 50, 1e-5);
    for (Index k = 0; k < response.length + 50; ++k) {
        response.values[response.lead + k] += 1.0;
        for (const NuisanceTerm &term : terms)
            response.values[response.lead + k] += term.value(static_cast<double>(k) / kRate_Hz);
    }
    return response;
}

ModelInput inputOf(
    const std::vector<WindowedResponse> &responses, const std::vector<NuisanceMode> &modes)
{
    std::vector<ModelSeries> series;
    for (const WindowedResponse &response : responses)
        series.push_back(testing::makeSeries(response.shot, response.window().head(400), kRate_Hz));
    ModelInput input
        = testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, std::move(series));
    input.combine = CombineMethod::Stacked;
    input.nuisanceModes = modes;
    return input;
}

const Finding *findingOf(const Findings &findings, const char *id)
{
    const auto found = std::ranges::find(findings, id, &Finding::id);
    return found == findings.end() ? nullptr : &*found;
}

} // namespace

class TestNuisanceSearch : public QObject
{
    Q_OBJECT

private slots:
    void correction_isWhatTheFilterLetsThrough_data()
    {
        QTest::addColumn<double>("frequency_Hz");
        QTest::addColumn<double>("zeta");
        QTest::newRow("slow") << 5e3 << 0.01;
        QTest::newRow("near the model's Nyquist frequency") << 9e4 << 0.01;
        QTest::newRow("well damped") << 2e4 << 0.3;
    }
    void correction_isWhatTheFilterLetsThrough()
    {
        // The term's own record through the filter, tap by tap.
        QFETCH(double, frequency_Hz);
        QFETCH(double, zeta);
        constexpr int kFactor = 4;
        const NuisanceTerm term{0, true, poleFrom(frequency_Hz, zeta), std::polar(0.2, 1.1)};
        ModelSeries series = testing::makeSeries(1, Eigen::VectorXd::Zero(60), kRate_Hz / kFactor);
        series.filter = designAntiAliasFilter(kFactor, kRate_Hz);
        const Index first = series.filter.halfLength() + 7;
        series.first_s = static_cast<double>(first) / kRate_Hz;
        for (Index k = 0; k < series.y.size(); ++k) {
            for (Index j = 0; j < series.filter.taps.size(); ++j) {
                const Index at = first + kFactor * k + j - series.filter.halfLength();
                series.y[k]
                    += series.filter.taps[j] * term.value(static_cast<double>(at) / kRate_Hz);
            }
        }
        const ModelInput input
            = testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz / kFactor, {series});
        setNuisance(input, series, {term});
        QVERIFY(series.y.norm() > 1e-3);
        QVERIFY2((series.y + series.correction).cwiseAbs().maxCoeff() < 1e-12,
            qPrintable(QString::number((series.y + series.correction).cwiseAbs().maxCoeff())));
    }

    void correction_isAddedToTheBridge()
    {
        ModelSeries series = testing::makeSeries(1, Eigen::VectorXd::Ones(50), kRate_Hz);
        const ModelInput input
            = testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, {series});
        const NuisanceTerm term{0, true, poleFrom(3e4, 0.02), {0.1, 0.0}};
        setNuisance(input, series, {term});
        const Eigen::VectorXd alone = series.correction;
        series.correction = Eigen::VectorXd::LinSpaced(50, 0.0, 3.0);
        setNuisance(input, series, {term, term});
        const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(50, 0.0, 3.0) + 2.0 * alone;
        QVERIFY((series.correction - expected).cwiseAbs().maxCoeff() < 1e-14);
        QCOMPARE(series.nuisance.size(), std::size_t(2));
    }

    void limits_areTwoPeriodsAndTwoFifthsOfTheRate_data()
    {
        QTest::addColumn<double>("frequency_Hz");
        QTest::addColumn<QString>("said");
        QTest::newRow("no oscillation") << 0.0 << "NUI-001";
        QTest::newRow("too slow") << 1.999 / kWindow_s << "NUI-001";
        QTest::newRow("just slow enough") << 2.0 / kWindow_s << "NUI-003";
        QTest::newRow("just fast enough") << 0.4 * kRate_Hz << "NUI-003";
        QTest::newRow("too fast") << 0.4001 * kRate_Hz << "NUI-002";
    }
    void limits_areTwoPeriodsAndTwoFifthsOfTheRate()
    {
        // None is there: what may be looked for is said not to be found, and nothing else is.
        QFETCH(double, frequency_Hz);
        QFETCH(QString, said);
        const std::vector<WindowedResponse> responses{responseWith(3, {})};
        ModelInput input = inputOf(responses, {modeAt(frequency_Hz, "gong")});
        searchNuisance(input, responses);
        QCOMPARE(input.findings.size(), std::size_t(1));
        const Finding &finding = input.findings.front();
        QCOMPARE(QString::fromStdString(finding.id), said);
        QCOMPARE(finding.shot, Index(3));
        QVERIFY(english(finding.message).find("gong") != std::string::npos);
        QVERIFY(!hasNuisance(input));
        if (said == "NUI-001")
            QVERIFY(*finding.value < *finding.limit);
        if (said == "NUI-002")
            QVERIFY(*finding.value > *finding.limit);
    }

    void record_isLengthenedToSixPeriods_data()
    {
        QTest::addColumn<double>("slowest_Hz");
        QTest::addColumn<int>("samples");
        QTest::newRow("shorter than the input") << 2e4 << 400;
        QTest::newRow("six periods") << 2e3 << 3000;
        QTest::newRow("at most the window") << 1e3 << 4000;
    }
    void record_isLengthenedToSixPeriods()
    {
        QFETCH(double, slowest_Hz);
        QFETCH(int, samples);
        const std::vector<WindowedResponse> responses{
            responseWith(1, {{0, true, poleFrom(slowest_Hz, 0.01), {0.02, 0.0}}})};
        ModelInput input = inputOf(responses, {modeAt(3e4), modeAt(slowest_Hz)});
        searchNuisance(input, responses);
        const Eigen::VectorXd &record = input.series[0].fullRate;
        QCOMPARE(record.size(), Index(samples));
        QVERIFY(record == responses[0].window().head(samples)); // from the start on, unchanged
        QCOMPARE(input.series[0].y.size(), Index(400));
    }

    void modes_keepTheirPlaceInTheList()
    {
        // The first is in neither shot, the second in one of them only.
        const NuisanceTerm term{0, true, poleFrom(6.1e3, 0.01), {0.03, 0.01}};
        const std::vector<WindowedResponse> responses{responseWith(2, {}), responseWith(5, {term})};
        ModelInput input = inputOf(responses, {modeAt(9.5e3, "high"), modeAt(6e3, "low")});
        searchNuisance(input, responses);
        QVERIFY(input.series[0].nuisance.empty());
        QCOMPARE(input.series[1].nuisance.size(), std::size_t(1));
        QCOMPARE(input.series[1].nuisance[0].mode, std::size_t(1));
        std::vector<std::pair<Index, bool>> absent;
        for (const Finding &finding : input.findings) {
            QCOMPARE(finding.id, std::string("NUI-003"));
            absent.emplace_back(
                finding.shot, english(finding.message).find("high") != std::string::npos);
        }
        QCOMPARE(absent, (std::vector<std::pair<Index, bool>>{{2, true}, {2, false}, {5, true}}));
    }

    void shotWithoutAResponse_isLeftAsItIs()
    {
        const std::vector<WindowedResponse> responses{responseWith(1, {})};
        ModelInput input = inputOf(responses, {modeAt(6e3)});
        input.series[0].shot = 2;
        searchNuisance(input, responses);
        QVERIFY(input.findings.empty());
        QVERIFY(!hasNuisance(input));
        for (const ModelSeries &series : input.series)
            QCOMPARE(series.correction.size(), Index(0));
        QCOMPARE(findingOf(input.findings, "NUI-003"), nullptr);
    }

    void unnamedMode_isNamedByItsFrequency()
    {
        const std::vector<WindowedResponse> responses{responseWith(1, {})};
        ModelInput input = inputOf(responses, {modeAt(6.125e3)});
        searchNuisance(input, responses);
        const Finding *finding = findingOf(input.findings, "NUI-003");
        QVERIFY(finding != nullptr);
        QVERIFY2(english(finding->message).find("6.125 kHz") != std::string::npos,
            english(finding->message).c_str());
    }
};

DYNCAL_TEST(TestNuisanceSearch)
#include "tst_nuisance_search.moc"
