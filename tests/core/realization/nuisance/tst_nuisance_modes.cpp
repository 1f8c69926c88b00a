// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/nuisance/nuisance_separation.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;
using Speeds = std::vector<std::optional<double>>;

constexpr double kTwoPi = 2.0 * std::numbers::pi;

Complex poleFrom(double frequency_Hz, double zeta)
{
    return kTwoPi * frequency_Hz * Complex(-zeta, std::sqrt(1.0 - zeta * zeta));
}

NuisanceMode modeAt(std::vector<double> frequency_Hz, bool isTube = true, Index shot = 0)
{
    return {std::move(frequency_Hz), shot, isTube, "mode", "test"};
}

/// A window of step response with an oscillation on it; the record is at the model rate.
WindowedResponse windowOf(Index shot, double f0_Hz, double zeta, const NuisanceTerm &term,
    double rate_Hz, Index count, double noise)
{
    testing::Noise source(static_cast<std::uint64_t>(shot) + 7);
    WindowedResponse response;
    response.shot = shot;
    response.sampleRate_Hz = rate_Hz;
    response.length = count;
    response.values
        = testing::sampledStep(f0_Hz, zeta, rate_Hz, count, 0.0) + source.series(count, noise);
    for (Index k = 0; k < count; ++k)
        response.values[k] += term.value(static_cast<double>(k) / rate_Hz);
    response.noise = source.series(2000, noise);
    return response;
}

ModelInput inputOf(const std::vector<WindowedResponse> &responses, Index samples)
{
    std::vector<ModelSeries> series;
    for (const WindowedResponse &response : responses) {
        ModelSeries one = testing::makeSeries(
            response.shot, response.values.head(samples), response.sampleRate_Hz, response.noise);
        series.push_back(std::move(one));
    }
    ModelInput input = testing::makeInput(
        ResponseTreatment::StepDeflated, responses.front().sampleRate_Hz, std::move(series));
    input.combine = CombineMethod::Stacked;
    return input;
}

bool has(const Findings &findings, const char *id)
{
    return std::any_of(
        findings.begin(), findings.end(), [&](const Finding &f) { return f.id == id; });
}

} // namespace

class TestNuisanceModes : public QObject
{
    Q_OBJECT

private slots:
    void expectedFrequencies_tubeModesMoveWithTheGas()
    {
        const Speeds speeds{400.0, std::nullopt, 440.0};
        const auto at = [&](const NuisanceMode &mode, Index shot) {
            return expectedFrequencies_Hz({mode}, shot, speeds).front();
        };
        // One frequency, read in the first shot with known states, or in the shot named.
        QCOMPARE(*at(modeAt({6e3}), 1), 6e3);
        QCOMPARE(*at(modeAt({6e3}), 3), 6.6e3);
        QCOMPARE(*at(modeAt({6.6e3}, true, 3), 1), 6e3);
        QCOMPARE(*at(modeAt({6e3}), 2), 6e3); // nothing known of that shot's gas
        QCOMPARE(*at(modeAt({6e3}, false), 3), 6e3);
        QCOMPARE(*at(modeAt({6e3, 6.1e3, 6.2e3}), 3), 6.2e3);
        QVERIFY(!at(modeAt({6e3, 6.1e3}), 3).has_value());
        QVERIFY(!at(modeAt({}), 1).has_value());
    }

    void peaksOfModes_areNoResonanceOfTheSensor()
    {
        std::vector<WindowedResponse> responses(2);
        responses[0].shot = 1;
        responses[1].shot = 2;
        SpectrumResult spectrum;
        spectrum.resonances = {{6.3e3, 30.0, 8.0, {6e3, 6.6e3}}, {3e4, 20.0, 9.0, {3e4, 3e4}},
            {6.0e3, 10.0, 9.0, {6e3, 6e3}}};
        const SpectrumResult rest
            = withoutNuisancePeaks(spectrum, responses, {modeAt({6e3})}, {400.0, 440.0});
        QCOMPARE(rest.resonances.size(), std::size_t(1));
        QCOMPARE(rest.resonances[0].frequency_Hz, 3e4);
        QCOMPARE(
            withoutNuisancePeaks(spectrum, responses, {}, {}).resonances.size(), std::size_t(3));
    }

    void amplitudesOfStep_undoWhatTheModeAdded()
    {
        // Forward by the formula of the pressure step (1 + sum Re(a e^(r t))), partial fractions.
        const Complex s = poleFrom(3e4, 0.05);
        Eigen::VectorXcd poles(3);
        poles << s, std::conj(s), Complex(-5e4, 0.0);
        Eigen::VectorXcd truth(3);
        truth << Complex(-0.6, 0.2), Complex(-0.6, -0.2), Complex(0.2, 0.0);
        const double c0 = 1.0;
        const std::vector<std::pair<Complex, Complex>> modes{
            {poleFrom(6.8e3, 0.01), std::polar(0.04, 0.7)},
            {poleFrom(9.1e3, 0.03), std::polar(0.03, 0.4)}};
        Eigen::VectorXcd recorded = truth;
        std::vector<NuisanceTerm> terms;
        for (Index i = 0; i < 3; ++i) {
            Complex input = 1.0;
            for (const auto &[r, a] : modes)
                input += 0.5 * poles[i] * (a / (poles[i] - r))
                    + 0.5 * poles[i] * std::conj(a) / (poles[i] - std::conj(r));
            recorded[i] *= input;
        }
        for (const auto &[r, a] : modes) {
            Complex gain = c0;
            for (Index i = 0; i < 3; ++i)
                gain += truth[i] * r / (r - poles[i]);
            terms.push_back({0, true, r, a * gain});
        }
        const Eigen::VectorXcd found = amplitudesOfStep(poles, recorded, c0, terms);
        QVERIFY((found - truth).norm() < 1e-12);
        QVERIFY((recorded - truth).norm() > 0.02);
        // What was there before the step changes nothing.
        for (NuisanceTerm &term : terms)
            term.startsWithStep = false;
        QCOMPARE((amplitudesOfStep(poles, recorded, c0, terms) - recorded).norm(), 0.0);
    }

    void termsAt_moveTimeZero()
    {
        const NuisanceTerm term{0, true, poleFrom(5e3, 0.02), Complex(0.1, -0.2)};
        const NuisanceTerm moved = termsAt({term}, 3e-5).front();
        QVERIFY(std::abs(moved.value(1e-5) - term.value(4e-5)) < 1e-15);
        QVERIFY(std::abs(term.frequency_Hz() - 5e3) < 1e-9);
        QVERIFY(std::abs(term.dampingRatio() - 0.02) < 1e-12);
    }

    void separation_findsEachShotsOwnTerm()
    {
        const std::vector<NuisanceTerm> truth{{0, false, poleFrom(6.1e3, 0.01), {0.02, 0.01}},
            {0, false, poleFrom(6.8e3, 0.02), {-0.03, 0.0}}};
        std::vector<WindowedResponse> responses;
        for (Index shot = 1; shot <= 2; ++shot)
            responses.push_back(windowOf(
                shot, 3e4, 0.05, truth[static_cast<std::size_t>(shot - 1)], 1e6, 1600, 1e-5));
        ModelInput input = inputOf(responses, 900);
        separateNuisance(input, responses, {modeAt({6.0e3, 6.9e3}, false)}, {});
        QVERIFY(hasNuisance(input));
        for (std::size_t r = 0; r < 2; ++r) {
            const NuisanceTerm &found = input.series[r].nuisance.front();
            QVERIFY2(std::abs(found.frequency_Hz() / truth[r].frequency_Hz() - 1.0) < 1e-4,
                qPrintable(QString::number(found.frequency_Hz(), 'g', 8)));
            QVERIFY(std::abs(found.amplitude - truth[r].amplitude) < 1e-4);
        }
        // What is left is the sensor's alone.
        const ModelInput rest = sensorOnly(input);
        const Eigen::VectorXd sensor = testing::sampledStep(3e4, 0.05, 1e6, 900, 0.0);
        QVERIFY((rest.series[0].y - sensor).cwiseAbs().maxCoeff() < 2e-4);
        QVERIFY((input.series[0].y - sensor).cwiseAbs().maxCoeff() > 0.01);
        // A pole there is the mode's, one elsewhere is the sensor's.
        const Complex mode = std::exp(poleFrom(6.3e3, 0.01) / 1e6);
        const Complex pole = std::exp(poleFrom(3e4, 0.05) / 1e6);
        QCOMPARE(
            withoutNuisancePoles(input, {mode, std::conj(mode), pole, std::conj(pole), 0.9}).size(),
            std::size_t(3));
    }

    void modesThatCannotBeSeparated_stayInAndAreSaid()
    {
        const NuisanceTerm none;
        const std::vector<WindowedResponse> responses{
            windowOf(1, 3e4, 0.05, none, 1e6, 1600, 1e-3)};
        ModelInput input = inputOf(responses, 900);
        // 1.6 ms: 229 Hz has 0.4 periods; 6.8 kHz is not there; 0.45 MHz is above 0.4 of the rate.
        separateNuisance(input, responses, {modeAt({229.0}), modeAt({6.8e3}), modeAt({4.5e5})}, {});
        QVERIFY(!hasNuisance(input));
        for (const char *id : {"NUI-001", "NUI-002", "NUI-003"})
            QVERIFY2(has(input.findings, id), id);
        QCOMPARE((sensorOnly(input).series[0].y - input.series[0].y).norm(), 0.0);
    }

    void modesThatCannotBeFollowed_areSaid_data()
    {
        QTest::addColumn<std::vector<double>>("frequency_Hz");
        QTest::addColumn<bool>("isTube");
        QTest::addColumn<int>("shot");
        QTest::addColumn<int>("said");
        using List = std::vector<double>;
        QTest::newRow("first shot") << List{6.8e3} << true << 1 << 0;
        QTest::newRow("shot left open") << List{6.8e3} << true << 0 << 0;
        QTest::newRow("no such shot") << List{6.8e3} << true << 9 << 1;
        QTest::newRow("shot without a shock") << List{6.8e3} << true << 2 << 1;
        QTest::newRow("moves with nothing") << List{6.8e3} << false << 9 << 0;
        QTest::newRow("one for each") << List{6.1e3, 6.4e3, 6.8e3} << true << 0 << 0;
        QTest::newRow("one too few") << List{6.1e3, 6.4e3} << true << 0 << 1;
    }
    void modesThatCannotBeFollowed_areSaid()
    {
        QFETCH(std::vector<double>, frequency_Hz);
        QFETCH(bool, isTube);
        QFETCH(int, shot);
        QFETCH(int, said);
        const NuisanceTerm none;
        std::vector<WindowedResponse> responses;
        for (const Index number : {1, 2, 3})
            responses.push_back(windowOf(number, 3e4, 0.05, none, 1e6, 1600, 1e-3));
        ModelInput input = inputOf(responses, 900);
        separateNuisance(
            input, responses, {modeAt(frequency_Hz, isTube, shot)}, {400.0, std::nullopt, 444.0});
        QCOMPARE(std::ranges::count(input.findings, "NUI-005", &Finding::id), std::ptrdiff_t(said));
    }

    void average_hasNoModesOfItsOwn()
    {
        const NuisanceTerm none;
        const std::vector<WindowedResponse> responses{
            windowOf(1, 3e4, 0.05, none, 1e6, 1600, 1e-3)};
        ModelInput input = inputOf(responses, 900);
        input.combine = CombineMethod::PcaAverage;
        separateNuisance(input, responses, {modeAt({6.8e3})}, {});
        QVERIFY(has(input.findings, "NUI-004"));
        QVERIFY(!hasNuisance(input));
    }

    void noModes_changeNothing()
    {
        const NuisanceTerm none;
        const std::vector<WindowedResponse> responses{
            windowOf(1, 3e4, 0.05, none, 1e6, 1600, 1e-3)};
        ModelInput input = inputOf(responses, 900);
        separateNuisance(input, responses, {}, {});
        QVERIFY(input.findings.empty());
        QCOMPARE(input.series[0].fullRate.size(), Index(900));
    }
};

DYNCAL_TEST(TestNuisanceModes)
#include "tst_nuisance_modes.moc"
