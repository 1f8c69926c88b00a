// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/hankel_gap.h"
#include "core/realization/model/model_fit.h"
#include "core/realization/order/order_evidence.h"
#include "core/realization/order/order_findings.h"
#include "core/realization/order/order_scan.h"
#include "core/realization/order/order_spread.h"
#include "core/realization/refinement/series_simulation.h"
#include "tests/support/test_program.h"

#include "core/realization/exponentials/shared_fit.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/order/cross_shot.h"
#include "core/realization/order/order_words.h"
#include "tests/support/model_inputs.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <ctime>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kF0_Hz = 30e3;
constexpr double kZeta = 0.05;
/// Normal equations square the condition of the basis; the residual is a minimum, so that their
/// error enters it squared.
constexpr double kSameFit = 1e-6;
constexpr double kSameFitted = 1e-9; ///< of the data, low orders

ModelInput shots(const std::vector<double> &f0_Hz, Index samples, double noise, std::uint64_t seed)
{
    testing::Noise source(seed);
    std::vector<ModelSeries> series;
    for (std::size_t i = 0; i < f0_Hz.size(); ++i) {
        const double first = 0.25 * static_cast<double>(i + 1);
        const Eigen::VectorXd y = testing::sampledStep(f0_Hz[i], kZeta, kRate_Hz, samples, first)
            + source.series(samples, noise);
        series.push_back(testing::makeSeries(
            static_cast<Index>(i) + 1, y, kRate_Hz, source.series(6000, noise)));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, std::move(series));
}

ModelInput threeShots(Index samples, double noise, std::uint64_t seed = 1)
{
    return shots({kF0_Hz, kF0_Hz, kF0_Hz}, samples, noise, seed);
}

struct Gathered
{
    HankelDecomposition hankel;
    OrderSuggestion suggestion;
    OrderEvidence evidence;
};

Gathered gather(const ModelInput &input, const RealizationSettings &settings = {})
{
    Gathered result;
    result.hankel = decomposeHankel(input, settings).value();
    result.suggestion = suggestOrder(input, result.hankel);
    result.evidence
        = gatherOrderEvidence(input, result.hankel, result.suggestion, settings).value();
    return result;
}

double relative(double a, double b)
{
    return std::abs(a - b) / std::abs(b);
}

const OrderPole *poleNear(const OrderEvidence &evidence, Index order, double frequency_Hz)
{
    for (const OrderPole &pole : evidence.poles) {
        if (pole.order == order && relative(pole.frequency_Hz, frequency_Hz) < 0.01)
            return &pole;
    }
    return nullptr;
}

/// An evidence with one pole per order from `first` on, written down.
OrderEvidence chain(Index first, const std::vector<std::pair<double, double>> &poles)
{
    OrderEvidence evidence;
    Index order = first;
    for (const auto &[frequency_Hz, damping] : poles) {
        OrderPole pole;
        pole.order = order;
        pole.frequency_Hz = frequency_Hz;
        pole.dampingRatio = damping;
        pole.stability = order == first ? PoleStability::New : PoleStability::FrequencyAndDamping;
        evidence.poles.push_back(pole);
        ++order;
    }
    return evidence;
}

std::string allWords(const std::vector<Message> &words)
{
    std::string text;
    for (const Message &word : words)
        text += english(word) + "\n";
    return text;
}

bool holds(const std::string &text, const char *part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class TestOrderEvidence : public QObject
{
    Q_OBJECT

private slots:
    void sharedFit_equalsTheFitOfEachRecord()
    {
        testing::Noise source(3);
        const std::vector<std::complex<double>> poles{
            {0.9, 0.0}, {0.5, 0.6}, {0.5, -0.6}, {-0.7, 0.0}, {0.99, 0.1}, {0.99, -0.1}};
        Eigen::MatrixXd records(300, 2);
        records.col(0) = source.series(300, 1.0);
        records.col(1) = source.series(300, 2.0).array() + 5.0;
        for (const bool withConstant : {true, false}) {
            const auto fits = fitSharedPoles(records, poles, withConstant);
            for (Index r = 0; r < 2; ++r) {
                const AmplitudeFit expected = fitAmplitudes(records.col(r), poles, withConstant);
                const AmplitudeFit &found = fits[static_cast<std::size_t>(r)];
                QVERIFY((found.fitted - expected.fitted).cwiseAbs().maxCoeff() < kSameFitted);
                QVERIFY(
                    (found.amplitudes - expected.amplitudes).cwiseAbs().maxCoeff() < kSameFitted);
                QVERIFY(std::abs(found.constant - expected.constant) < kSameFitted);
            }
        }
    }

    void sharedFit_equalPoles_stayFinite()
    {
        const std::vector<std::complex<double>> poles{{0.9, 0.0}, {0.9, 0.0}, {0.0, 0.0}};
        const Eigen::VectorXd y = testing::sampledStep(kF0_Hz, kZeta, kRate_Hz, 100);
        const auto fits = fitSharedPoles(y, poles, true);
        QVERIFY(fits.front().fitted.allFinite() && fits.front().amplitudes.allFinite());
    }

    void sharedFit_ofNothing_isZero()
    {
        const auto fits = fitSharedPoles(Eigen::MatrixXd::Ones(50, 2), {}, false);
        QCOMPARE(fits.size(), std::size_t(2));
        QVERIFY(fits[1].fitted == Eigen::VectorXd::Zero(50));
        QCOMPARE(fits[1].amplitudes.size(), Index(0));
    }

    void fit_equalsThatOfTheModelNotRefined()
    {
        const ModelInput input = threeShots(400, 0.01);
        const Gathered g = gather(input);
        QCOMPARE(g.evidence.fit_percent.size(), Index(60));
        RealizationSettings settings;
        settings.refine = false;
        for (const Index n : {Index(1), Index(2), Index(3), Index(7), Index(20), Index(45)}) {
            const auto model = fitModel(input, g.hankel, n, settings, {});
            QCOMPARE(model->diverges, std::isnan(g.evidence.fit_percent[n - 1]));
            if (!model->diverges)
                QVERIFY2(std::abs(model->fit_percent - g.evidence.fit_percent[n - 1]) < kSameFit,
                    qPrintable(QString::number(n)));
        }
        const auto model = fitModel(input, g.hankel, 2, settings, {});
        QCOMPARE(g.evidence.fitAttainable_percent, model->fitAttainable_percent);
    }

    void poles_areThoseOfTheModel()
    {
        const ModelInput input = threeShots(400, 0.01);
        const Gathered g = gather(input);
        RealizationSettings settings;
        settings.refine = false;
        for (const Index n : {Index(1), Index(2), Index(11)}) {
            const auto model = fitModel(input, g.hankel, n, settings, {});
            std::vector<double> expected;
            for (const Pole &pole : model->poles) {
                if (pole.z.imag() > 0.0)
                    expected.push_back(pole.frequency_Hz);
            }
            std::sort(expected.begin(), expected.end());
            std::vector<double> found;
            for (const OrderPole &pole : g.evidence.poles) {
                if (pole.order == n)
                    found.push_back(pole.frequency_Hz);
            }
            QCOMPARE(found.size(), expected.size());
            for (std::size_t i = 0; i < found.size(); ++i)
                QVERIFY(relative(found[i], expected[i]) < 1e-12);
        }
    }

    void truePole_isStableFromItsOrderOn_andStandsOut()
    {
        const Gathered g = gather(threeShots(400, 0.01));
        QCOMPARE(g.suggestion.order, Index(2));
        const OrderPole *first = poleNear(g.evidence, 2, kF0_Hz);
        QVERIFY(first && first->standsOut);
        QVERIFY(first->stability == PoleStability::New); // order 1 cannot oscillate
        for (Index n = 3; n <= 20; ++n) {
            const OrderPole *pole = poleNear(g.evidence, n, kF0_Hz);
            QVERIFY2(pole && pole->standsOut, qPrintable(QString::number(n)));
            QVERIFY(pole->stability == PoleStability::FrequencyAndDamping);
        }
        QVERIFY(g.evidence.spread.has_value());
        QCOMPARE(g.evidence.spread->fromOrder, Index(2));
        QVERIFY(g.evidence.spread->toOrder >= 20);
        QVERIFY(relative(g.evidence.spread->frequency_Hz, kF0_Hz) < 1e-3);
        QVERIFY(relative(g.evidence.spread->dampingRatio, kZeta) < 0.02);
    }

    void tolerances_decideWhatIsStable()
    {
        RealizationSettings narrow;
        narrow.stableFrequency = 1e-9;
        narrow.stableDamping = 1e-9;
        const Gathered none = gather(threeShots(400, 0.01), narrow);
        QVERIFY(std::none_of(
            none.evidence.poles.begin(), none.evidence.poles.end(), [](const OrderPole &pole) {
                return pole.stability == PoleStability::FrequencyAndDamping;
            }));
        QCOMPARE(none.evidence.spread->fromOrder, none.evidence.spread->toOrder);
        QCOMPARE(none.evidence.spread->frequencySpread_Hz, 0.0);

        RealizationSettings frequencyOnly;
        frequencyOnly.stableDamping = 1e-9;
        const Gathered some = gather(threeShots(400, 0.01), frequencyOnly);
        QVERIFY(poleNear(some.evidence, 3, kF0_Hz)->stability == PoleStability::Frequency);
    }

    void spread_isMeanAndHalfRangeOfTheChain()
    {
        const OrderEvidence evidence
            = chain(2, {{100.0, 0.10}, {101.0, 0.12}, {100.5, 0.11}, {99.5, 0.10}});
        const auto spread = spreadAround(evidence, 4, 100.0);
        QVERIFY(spread.has_value());
        QCOMPARE(spread->fromOrder, Index(2));
        QCOMPARE(spread->toOrder, Index(5));
        QCOMPARE(spread->frequency_Hz, 100.25);
        QCOMPARE(spread->frequencySpread_Hz, 0.75);
        QCOMPARE(spread->dampingRatio, 0.1075);
        QVERIFY(std::abs(spread->dampingSpread - 0.01) < 1e-15);
    }

    void spread_endsWhereThePoleIsNotStable()
    {
        OrderEvidence evidence = chain(2, {{100.0, 0.1}, {101.0, 0.1}, {103.0, 0.1}, {103.5, 0.1}});
        evidence.poles[2].stability = PoleStability::New; // order 4
        QCOMPARE(spreadAround(evidence, 3, 101.0)->toOrder, Index(3));
        QCOMPARE(spreadAround(evidence, 5, 103.5)->fromOrder, Index(4));
        evidence.poles[1].stability = PoleStability::Unstable;
        QCOMPARE(spreadAround(evidence, 2, 100.0)->toOrder, Index(2));
        QVERIFY(!spreadAround(evidence, 2, 150.0).has_value());
        QVERIFY(!spreadAround(evidence, 9, 100.0).has_value());
    }

    void growingPole_isUnstableAndTheFitIsNone()
    {
        Eigen::VectorXd y(200);
        for (Index k = 0; k < y.size(); ++k) {
            const double t = static_cast<double>(k);
            y[k] = std::exp(0.05 * t) * std::cos(0.7 * t);
        }
        const ModelInput input = testing::makeInput(
            ResponseTreatment::Impulse, kRate_Hz, {testing::makeSeries(1, y, kRate_Hz)});
        const Gathered g = gather(input);
        const OrderPole *pole = poleNear(g.evidence, 2, 0.7017835 * kRate_Hz / (2.0 * M_PI));
        QVERIFY(pole && pole->stability == PoleStability::Unstable);
        QVERIFY(!pole->standsOut);
        QCOMPARE(g.evidence.unstable[1], Index(2));
        QVERIFY(std::isnan(g.evidence.fit_percent[1]));
        QVERIFY(!g.evidence.spread.has_value());
        QVERIFY(!holds(allWords(g.evidence.words), "nan"));
        // Impulse: no constant. One shot: nobody to leave out, no noise: nothing attainable.
        QCOMPARE(g.evidence.crossShot_percent.size(), Index(0));
        QVERIFY(std::isnan(g.evidence.fitAttainable_percent));
    }

    void crossShot_isTheFitByPolesOfTheOthers()
    {
        const ModelInput input = threeShots(400, 0.01);
        const CrossShot cross = leaveOneShotOut(input, {});
        QCOMPARE(cross.error_percent.size(), Index(20));
        QCOMPARE(cross.fit_percent.cols(), Index(3));
        const Index n = 4;
        double errors = 0.0;
        double spread = 0.0;
        for (std::size_t out = 0; out < 3; ++out) {
            ModelInput others = input;
            others.series.erase(others.series.begin() + static_cast<std::ptrdiff_t>(out));
            const auto poles = realizedPoles(decomposeHankel(others, {}).value(), n);
            const Eigen::VectorXd &y = input.series[out].y;
            const double error = (y - fitAmplitudes(y, poles, true).fitted).squaredNorm();
            errors += error;
            spread += spreadSquares(y);
            QVERIFY(std::abs(cross.fit_percent(n - 1, static_cast<Index>(out))
                        - fitPercent(error, spreadSquares(y)))
                < kSameFit);
        }
        QVERIFY(
            std::abs(cross.error_percent[n - 1] - 100.0 * std::sqrt(errors / spread)) < kSameFit);
    }

    void crossShot_neverLiesBelowTheOwnError()
    {
        const Gathered g = gather(threeShots(400, 0.02, 5));
        // 100 - FIT of the stack is the same ratio with poles that saw the shot.
        for (Index n = 2; n <= 10; ++n)
            QVERIFY(
                g.evidence.crossShot_percent[n - 1] > 100.0 - g.evidence.fit_percent[n - 1] - 0.2);
    }

    void oneShotOrThesisMode_leaveNobodyOut()
    {
        ModelInput one = threeShots(400, 0.01);
        one.series.resize(1);
        QCOMPARE(leaveOneShotOut(one, {}).error_percent.size(), Index(0));
        one.treatment = ResponseTreatment::StepAsImpulse;
        const Gathered g = gather(one);
        QCOMPARE(g.evidence.crossShot_percent.size(), Index(0));
        const auto model = fitModel(one, g.hankel, 3, {}, {});
        QVERIFY(std::abs(model->fit_percent - g.evidence.fit_percent[2]) < kSameFit);
        QVERIFY(poleNear(g.evidence, 3, kF0_Hz)->standsOut);
    }

    void shotsThatDiffer_areSaid()
    {
        const ModelInput input = shots({30e3, 30e3, 33e3}, 400, 0.001, 2);
        const Gathered g = gather(input);
        const auto model = fitModel(input, g.hankel, 4, {}, {});
        const Findings findings = judgeOtherShots(*model, g.evidence);
        QVERIFY(!findings.empty());
        for (const Finding &finding : findings) {
            QCOMPARE(finding.id, std::string("MOD-007"));
            QVERIFY(finding.severity == Severity::Caution);
            QVERIFY(finding.shot >= 1 && finding.shot <= 3);
            QVERIFY(*finding.value > *finding.limit);
        }
        QVERIFY(std::any_of(findings.begin(), findings.end(),
            [](const Finding &finding) { return finding.shot == 3; }));
    }

    void shotsThatAgree_areNot()
    {
        const ModelInput input = threeShots(400, 0.01);
        const Gathered g = gather(input);
        for (const Index n : {Index(1), Index(2), Index(8), Index(40)})
            QVERIFY(
                judgeOtherShots(fitModel(input, g.hankel, n, {}, {}).value(), g.evidence).empty());
    }

    void noClearGap_isSaid()
    {
        HankelDecomposition hankel;
        hankel.singularValues = (Eigen::VectorXd(5) << 10.0, 5.0, 2.0, 1.0, 0.5).finished();
        hankel.noiseFloor_p95 = 0.1;
        QCOMPARE(judgeGap(hankel).at(0).id, std::string("ORD-002"));
        QVERIFY(judgeGap(hankel).at(0).severity == Severity::Info);
        hankel.singularValues[2] = 1.6; // 5.0 / 1.6 = 3.1
        QVERIFY(judgeGap(hankel).empty());
        hankel.noiseFloor_p95 = 6.0; // that gap lies in the noise
        QCOMPARE(judgeGap(hankel).size(), std::size_t(1));
        QVERIFY(gather(threeShots(400, 0.01)).evidence.findings.empty());
    }

    void words_sayWhyAndHoldNoNonsense()
    {
        const Gathered g = gather(threeShots(400, 0.01));
        const std::string words = allWords(g.evidence.words);
        qInfo("%s", words.c_str());
        for (const char *part : {"Order 2 has the smallest BIC", "Singular value 2 is",
                 "splits no oscillating pair", "The pole at ", " kHz \xC2\xB1 ", "from order 2 to",
                 "Poles of the other shots", "Order 2 is the lowest whose FIT"})
            QVERIFY2(holds(words, part), part);
        for (const char *part : {"nan", "inf", "%1", "%2"})
            QVERIFY2(!holds(words, part), part);
    }

    void lowestSufficientOrder_needsFitAndNoSpuriousPole()
    {
        OrderEvidence evidence;
        evidence.fit_percent = (Eigen::VectorXd(4) << 20.0, 89.0, kUnknown, 89.2).finished();
        evidence.unstable = {0, 0, 1, 0};
        evidence.nyquist = {0, 0, 0, 0};
        evidence.fitAttainable_percent = 89.5;
        QCOMPARE(*lowestSufficientOrder(evidence), Index(2));
        evidence.nyquist[1] = 1;
        QCOMPARE(*lowestSufficientOrder(evidence), Index(4));
        evidence.fitAttainable_percent = 95.0;
        QVERIFY(!lowestSufficientOrder(evidence).has_value());
        evidence.fitAttainable_percent = 9.0; // at the noise limit
        QVERIFY(!lowestSufficientOrder(evidence).has_value());
        evidence.fitAttainable_percent = kUnknown;
        QVERIFY(!lowestSufficientOrder(evidence).has_value());
    }

    void request_stops()
    {
        std::stop_source source;
        source.request_stop();
        const ModelInput input = threeShots(200, 0.01);
        const auto hankel = decomposeHankel(input, {});
        const auto evidence = gatherOrderEvidence(
            input, *hankel, suggestOrder(input, *hankel), {}, {source.get_token(), {}});
        QVERIFY(!evidence.has_value());
        QVERIFY(evidence.error().kind == ErrorKind::Cancelled);
    }

    void duration_ofUsualInputs()
    {
        for (const Index samples : {Index(400), Index(1000), Index(4000)}) {
            const ModelInput input = threeShots(samples, 0.01);
            const auto hankel = decomposeHankel(input, {});
            const auto suggestion = suggestOrder(input, *hankel);
            QElapsedTimer timer;
            timer.start();
            const std::clock_t before = std::clock();
            QVERIFY(gatherOrderEvidence(input, *hankel, suggestion, {}).has_value());
            qInfo("%td samples, three shots: %.0f ms, %.0f ms of processor time", samples,
                static_cast<double>(timer.nsecsElapsed()) * 1e-6,
                1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
            const std::clock_t crossBefore = std::clock();
            QVERIFY(leaveOneShotOut(input, {}).error_percent.size() > 0);
            qInfo("of which leaving shots out %.0f ms",
                1e3 * static_cast<double>(std::clock() - crossBefore) / CLOCKS_PER_SEC);
        }
    }
};

DYNCAL_TEST(TestOrderEvidence)
#include "tst_order_evidence.moc"
