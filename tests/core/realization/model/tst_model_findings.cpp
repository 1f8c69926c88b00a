// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/hankel_gap.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/model/model_findings.h"
#include "core/realization/model/model_fit.h"
#include "core/realization/model/pole_classes.h"
#include "tests/support/model_inputs.h"
#include "tests/support/second_order_model.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <string>

using namespace dyncal;
using testing::hasFinding;

namespace {

/// A model about which nothing is to be said; each case spoils one thing.
struct Scene
{
    SensorModel model = testing::secondOrderModel(1e5, 0.02);
    ModelInput input;
    HankelDecomposition hankel;
    SpectrumResult spectrum;

    Scene()
    {
        model.fit_percent = 98.0;
        model.fitAttainable_percent = 98.2;
        hankel.singularValues = (Eigen::VectorXd(4) << 10.0, 8.0, 0.9, 0.8).finished();
        hankel.noiseFloor_p95 = 1.0;
        Resonance resonance;
        resonance.frequency_Hz = 1e5 * std::sqrt(1.0 - 0.02 * 0.02);
        spectrum.resonances.push_back(resonance);
    }

    Findings judge() const { return judgeModel(model, input, hankel, spectrum); }
};

HankelDecomposition decomposed(const Eigen::VectorXd &y, ResponseTreatment treatment)
{
    testing::Noise noise(5);
    constexpr double kNoise = 1e-4;
    const Eigen::VectorXd noisy = y + noise.series(y.size(), kNoise);
    return *decomposeHankel(testing::makeInput(treatment, 1e6,
                                {testing::makeSeries(1, noisy, 1e6, noise.series(400, kNoise))}),
        {});
}

/// A slow part that dies out so many times as fast as the pair rings.
void addDrift(Scene &scene, double times, double share)
{
    Pole drift;
    drift.s_rad_s = times * scene.model.poles[0].s_rad_s.real();
    drift.poleClass = PoleClass::Other;
    scene.model.poles.push_back(drift);
    scene.model.slowPoles = {static_cast<Index>(scene.model.poles.size()) - 1};
    scene.model.drift = share;
}

struct Case
{
    const char *id;
    const char *what;
    std::function<void(Scene &)> change;
    bool isSaid;
};

const std::vector<Case> &cases()
{
    static const std::vector<Case> list{
        {"ORD-003", "state below noise", [](Scene &s) { s.model.order = 3; }, true},
        {"ORD-003", "noise not known",
            [](Scene &s) {
                s.model.order = 3;
                s.hankel.noiseFloor_p95 = 0.0;
            },
            false},
        {"MOD-001", "unstable pair",
            [](Scene &s) { s.model.poles[0].poleClass = PoleClass::Unstable; }, true},
        {"MOD-001", "its conjugate alone",
            [](Scene &s) { s.model.poles[1].poleClass = PoleClass::Unstable; }, false},
        {"MOD-002", "Nyquist", [](Scene &s) { s.model.poles[0].poleClass = PoleClass::Nyquist; },
            true},
        {"MOD-003", "step", [](Scene &s) { s.model.poles[0].poleClass = PoleClass::Step; }, true},
        {"MOD-018", "drift as fast as the ringing's square",
            [](Scene &s) { addDrift(s, 2.1, 0.01); }, true},
        {"MOD-018", "a drift of its own", [](Scene &s) { addDrift(s, 0.5, 0.01); }, false},
        {"MOD-018", "a small one", [](Scene &s) { addDrift(s, 2.1, 0.0005); }, false},
        {"MOD-004", "poor fit", [](Scene &s) { s.model.fit_percent = 70.0; }, true},
        {"MOD-004", "poor, noise allows no more",
            [](Scene &s) { s.model.fit_percent = s.model.fitAttainable_percent = 70.0; }, false},
        {"MOD-004", "nothing but noise",
            [](Scene &s) {
                s.model.fit_percent = 1.0;
                s.model.fitAttainable_percent = 9.0;
            },
            false},
        {"MOD-004", "attainable not known",
            [](Scene &s) {
                s.model.fit_percent = 1.0;
                s.model.fitAttainable_percent = kUnknown;
            },
            false},
        {"MOD-005", "zero on a pole", [](Scene &s) { s.model.zeros = {s.model.poles[0].z + 5e-4}; },
            true},
        {"MOD-005", "zero beside", [](Scene &s) { s.model.zeros = {s.model.poles[0].z + 5e-3}; },
            false},
        {"MOD-006", "resonance elsewhere",
            [](Scene &s) { s.spectrum.resonances[0].frequency_Hz = 1.03e5; }, true},
        {"MOD-006", "within two percent",
            [](Scene &s) { s.spectrum.resonances[0].frequency_Hz = 1.015e5; }, false},
        {"MOD-006", "model without ringing", [](Scene &s) { s.model.poles.clear(); }, true},
        {"MOD-006", "no resonance seen", [](Scene &s) { s.spectrum.resonances.clear(); }, false},
        {"MOD-006", "diverging",
            [](Scene &s) {
                s.spectrum.resonances[0].frequency_Hz = 2e5;
                s.model.diverges = true;
            },
            false},
        {"MOD-008", "better than noise allows",
            [](Scene &s) { s.model.fitAttainable_percent = 95.0; }, true},
        {"MOD-008", "two points", [](Scene &s) { s.model.fitAttainable_percent = 96.1; }, false},
        {"MOD-009", "starts with a jump", [](Scene &s) { s.model.amplitudes *= 0.8; }, true},
        {"MOD-009", "small jump", [](Scene &s) { s.model.amplitudes *= 0.95; }, false},
        {"MOD-009", "free decay",
            [](Scene &s) {
                s.model.amplitudes *= 0.8;
                s.input.treatment = ResponseTreatment::Impulse;
            },
            false},
    };
    return list;
}

} // namespace

class TestModelFindings : public QObject
{
    Q_OBJECT

private slots:
    void soundModel_isNotSpokenOf() { QVERIFY(Scene().judge().empty()); }

    void finding_isRaisedWhereItsConditionHolds_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < cases().size(); ++i)
            QTest::addRow("%s %s", cases()[i].id, cases()[i].what) << int(i);
    }
    void finding_isRaisedWhereItsConditionHolds()
    {
        QFETCH(int, index);
        const Case &c = cases()[static_cast<std::size_t>(index)];
        Scene scene;
        c.change(scene);
        const Findings findings = scene.judge();
        QCOMPARE(hasFinding(findings, c.id), c.isSaid);
        for (const Finding &finding : findings) {
            const std::string text = english(finding.message);
            QVERIFY2(text.find("%1") == std::string::npos, text.c_str());
            QVERIFY2(text.find(" nan") == std::string::npos, text.c_str());
        }
    }

    void splitPair_isSaidByThePoles_data()
    {
        QTest::addColumn<ResponseTreatment>("treatment");
        QTest::addColumn<double>("zeta");
        QTest::addColumn<int>("order");
        QTest::addColumn<bool>("isSplit");
        const auto deflated = ResponseTreatment::StepDeflated;
        const auto thesis = ResponseTreatment::StepAsImpulse;
        QTest::addRow("rings long") << deflated << 0.003 << 1 << true;
        QTest::addRow("decays within the matrix") << deflated << 0.05 << 1 << true;
        QTest::addRow("hardly rings") << deflated << 0.5 << 1 << true;
        QTest::addRow("whole pair") << deflated << 0.05 << 2 << false;
        QTest::addRow("pair and noise") << deflated << 0.05 << 3 << false;
        QTest::addRow("thesis: step") << thesis << 0.05 << 1 << false;
        QTest::addRow("thesis: step and half a pair") << thesis << 0.05 << 2 << true;
        QTest::addRow("thesis: step and pair") << thesis << 0.05 << 3 << false;
    }
    void splitPair_isSaidByThePoles()
    {
        QFETCH(ResponseTreatment, treatment);
        QFETCH(double, zeta);
        QFETCH(int, order);
        QFETCH(bool, isSplit);
        Scene scene;
        scene.hankel = decomposed(testing::sampledStep(30e3, zeta, 1e6, 400), treatment);
        scene.model.order = order;
        QCOMPARE(splitsPair(scene.hankel, order), isSplit);
        const Findings findings = scene.judge();
        QCOMPARE(hasFinding(findings, "ORD-001"), isSplit);
        if (!isSplit)
            return;
        const auto split = std::ranges::find(findings, "ORD-001", &Finding::id);
        QVERIFY(split->correction.has_value());
        QCOMPARE(split->correction->key, std::string("realization.order"));
        QCOMPARE(split->correction->value, std::to_string(order + 1));
        QCOMPARE(english(split->correction->label), "Use order " + std::to_string(order + 1));
    }

    void splitPair_realPolesAndNoise_areNone()
    {
        // Two real poles: the second singular value is well above the noise, and no pair.
        Eigen::VectorXd y(400);
        for (Index k = 0; k < y.size(); ++k)
            y[k] = 1.0 - 2.0 * std::pow(0.9, k) + std::pow(0.8, k);
        const HankelDecomposition real = decomposed(y, ResponseTreatment::StepDeflated);
        QVERIFY(real.singularValues[1] > real.noiseFloor_p95);
        for (Index order = 0; order <= largestOrder(real); ++order)
            QVERIFY2(!splitsPair(real, order), qPrintable(QString::number(order)));
    }

    void splitPair_twoPairs_areSplitAtOddOrders()
    {
        const Eigen::VectorXd y = testing::sampledStep(30e3, 0.05, 1e6, 400)
            + 0.3 * testing::sampledStep(110e3, 0.02, 1e6, 400);
        const HankelDecomposition two = decomposed(y, ResponseTreatment::StepDeflated);
        for (Index order = 1; order <= 5; ++order)
            QCOMPARE(splitsPair(two, order), order == 1 || order == 3);
    }

    void noiseStates_offerTheHighestOrderAboveTheNoise()
    {
        Scene scene;
        scene.model.order = 3;
        const Findings findings = scene.judge();
        const auto found = std::ranges::find(findings, "ORD-003", &Finding::id);
        QCOMPARE(found->correction->value, std::string("2"));
        scene.hankel.noiseFloor_p95 = 20.0;
        const Findings nothing = scene.judge();
        const auto none = std::ranges::find(nothing, "ORD-003", &Finding::id);
        QVERIFY(!none->correction);
        QVERIFY(
            english(none->message).find("nothing that could be identified") != std::string::npos);
    }

    void manyUnstablePoles_areOneFinding()
    {
        Scene scene;
        for (int i = 0; i < 6; ++i) {
            Pole pole;
            pole.z = {1.0 + 0.01 * (i + 1), 0.1};
            pole.frequency_Hz = 1000.0 * (i + 1);
            pole.poleClass = PoleClass::Unstable;
            scene.model.poles.push_back(pole);
        }
        const Findings findings = scene.judge();
        QCOMPARE(std::ranges::count(findings, "MOD-001", &Finding::id), std::ptrdiff_t(1));
        const auto found = std::ranges::find(findings, "MOD-001", &Finding::id);
        QCOMPARE(*found->value, std::abs(scene.model.poles.back().z));
        const std::string text = english(found->message);
        QVERIFY2(text.find("1 kHz, 2 kHz, 3 kHz, 4 kHz, \xE2\x80\xA6") != std::string::npos,
            text.c_str());
    }

    void stepTreatedAsDecay_isSaid_andCorrected()
    {
        ModelInput input = testing::makeInput(ResponseTreatment::Impulse, 1e6,
            {testing::makeSeries(1, testing::sampledStep(30e3, 0.05, 1e6, 400), 1e6)});
        const auto step = fitModel(input, *decomposeHankel(input, {}), 3, {}, {});
        const auto found = std::ranges::find(step->findings, "MOD-013", &Finding::id);
        QVERIFY(found != step->findings.end());
        QCOMPARE(found->correction->key, std::string("input.treatment"));
        QCOMPARE(found->correction->value, std::string("\"step-deflated\""));

        input.series.front().y.array() = 1.0 - input.series.front().y.array(); // a free decay
        input.series.front().fullRate = input.series.front().y;
        const auto decay = fitModel(input, *decomposeHankel(input, {}), 2, {}, {});
        QVERIFY(!hasFinding(decay->findings, "MOD-013"));
        input.treatment = ResponseTreatment::StepDeflated;
        const auto deflated = fitModel(input, *decomposeHankel(input, {}), 2, {}, {});
        QVERIFY(!hasFinding(deflated->findings, "MOD-013"));
    }

    void mainPole_isWhatMostShotsHave()
    {
        SensorModel model = testing::secondOrderModel(1e5, 0.02);
        Pole loose = model.poles.front(); // rings longer and stronger, but in one shot only
        loose.s_rad_s = {-1.0, 1e4};
        loose.amplitude = 2.0;
        model.poles.push_back(loose);
        QCOMPARE(mainPole(model.poles, model.series),
            &model.poles[2]); // of one series there is nothing else to say
        for (const double amplitude : {2.0, 1e-5, 1e-6}) {
            SeriesFit fit;
            fit.plateauGain = 0.5;
            fit.amplitudes.resize(3);
            fit.amplitudes << 0.25, 0.25, amplitude;
            model.series.push_back(fit);
        }
        QCOMPARE(mainPole(model.poles, model.series), &model.poles[0]);
        model.series[2].amplitudes[2] = 2.0;
        QCOMPARE(mainPole(model.poles, model.series), &model.poles[2]);
        model.series.pop_back(); // of two shots both must have it
        QCOMPARE(mainPole(model.poles, model.series), &model.poles[0]);
    }

    void missingFastPart_polesInTheNoise_sayNothing()
    {
        Scene scene;
        scene.model.amplitudes.conservativeResize(3);
        scene.model.amplitudes[2] = 5.0; // of a pole that decays before the first sample
        Pole fast = scene.model.poles.front();
        fast.z = 1e-5;
        fast.flags = {kBelowNoiseFlag};
        scene.model.poles.push_back(fast);
        QVERIFY(!hasFinding(scene.judge(), "MOD-009"));
        scene.model.poles.back().flags.clear();
        QVERIFY(hasFinding(scene.judge(), "MOD-009"));
    }

    void cancelledPoles_areNamedOncePerPair()
    {
        Scene scene;
        scene.model.zeros = {scene.model.poles[0].z + 5e-4, scene.model.poles[1].z + 5e-4};
        const Findings findings = scene.judge();
        const auto found = std::find_if(findings.begin(), findings.end(),
            [](const Finding &finding) { return finding.id == "MOD-005"; });
        QCOMPARE(*found->value, 1.0);
        QVERIFY(english(found->message).find("100 kHz") != std::string::npos);
    }

    void flags_sayWhatEachPoleIs()
    {
        Scene scene;
        scene.model.zeros = {scene.model.poles[0].z + 5e-4};
        Pole real;
        real.z = {0.99999, 0.0};
        real.frequency_Hz = 5.0;
        real.u_frequency_Hz = 6.0;
        real.poleClass = PoleClass::Sensor;
        real.flags = {"below-noise"};
        scene.model.poles.push_back(real);
        real.u_frequency_Hz = 4.0; // known well enough to differ from 0
        real.flags.clear();
        scene.model.poles.push_back(real);
        for (const PoleClass kind : {PoleClass::Step, PoleClass::Nyquist, PoleClass::Unstable}) {
            real.poleClass = kind;
            scene.model.poles.push_back(real);
        }
        flagPoles(scene.model.zeros, scene.model.poles);
        const std::vector<std::vector<std::string>> expected{{"near-cancelled"}, {},
            {"below-noise", "integrator"}, {}, {"step"}, {"nyquist"}, {"unstable"}};
        for (std::size_t i = 0; i < expected.size(); ++i)
            QVERIFY2(scene.model.poles[i].flags == expected[i], qPrintable(QString::number(i)));
    }

    void runaways_areThosePolesThatGrowTenfold()
    {
        const double slow = std::pow(9.9, 0.01);
        const double fast = std::pow(10.1, 0.01);
        std::vector<std::complex<double>> poles{
            {0.5, 0.0}, {slow, 0.0}, {fast, 0.0}, {0.0, fast}, {0.0, -fast}};
        QVERIFY(dropRunaways(poles, 100));
        QCOMPARE(poles.size(), std::size_t(2));
        QVERIFY(!dropRunaways(poles, 100));
    }

    void onlyAnUnstableModel_blocks()
    {
        for (const Case &c : cases()) {
            Scene scene;
            c.change(scene);
            const bool blocks = worstSeverity(scene.judge()) == Severity::Block;
            QCOMPARE(blocks, c.isSaid && std::string(c.id) == "MOD-001");
        }
    }

    void poles_areClassedByWhereTheyLie()
    {
        const double nyquist = 0.96 * std::numbers::pi;
        const double below = 0.94 * std::numbers::pi;
        const std::vector<std::complex<double>> z{{0.9, 0.1}, {1.0 + 2e-6, 0.0}, {1.0 + 5e-7, 0.0},
            {-0.6, 0.0}, {-0.4, 0.0}, std::polar(0.9, nyquist), std::polar(0.9, below),
            std::polar(1.1, nyquist)};
        const std::vector<PoleClass> expected{PoleClass::Sensor, PoleClass::Unstable,
            PoleClass::Sensor, PoleClass::Nyquist, PoleClass::Sensor, PoleClass::Nyquist,
            PoleClass::Sensor, PoleClass::Unstable};
        const auto classes
            = classifyPoles(z, ResponseTreatment::StepDeflated, std::vector<bool>(z.size(), true));
        QVERIFY(classes == expected);
        const auto faint
            = classifyPoles(z, ResponseTreatment::StepDeflated, std::vector<bool>(z.size(), false));
        QVERIFY(faint[0] == PoleClass::Other && faint[1] == PoleClass::Unstable);
    }

    void stepPole_isTheRealOneNearestOne_inThesisModeOnly()
    {
        const std::vector<std::complex<double>> z{
            {1.0 - 9e-4, 0.0}, {1.0 + 1e-5, 0.0}, {1.0, 1e-5}, {1.0, -1e-5}, {0.99, 0.0}};
        const std::vector<bool> all(z.size(), true);
        const auto thesis = classifyPoles(z, ResponseTreatment::StepAsImpulse, all);
        QVERIFY(thesis[1] == PoleClass::Step);
        QCOMPARE(std::count(thesis.begin(), thesis.end(), PoleClass::Step), std::ptrdiff_t(1));
        const auto deflated = classifyPoles(z, ResponseTreatment::StepDeflated, all);
        QCOMPARE(std::count(deflated.begin(), deflated.end(), PoleClass::Step), std::ptrdiff_t(0));
        const auto far = classifyPoles({{0.99, 0.0}}, ResponseTreatment::StepAsImpulse, {true});
        QVERIFY(far[0] == PoleClass::Sensor);
    }

    void classNames_areThoseOfTheResultFile()
    {
        QCOMPARE(poleClassName(PoleClass::Sensor), "sensor");
        QCOMPARE(poleClassName(PoleClass::Step), "step");
        QCOMPARE(poleClassName(PoleClass::Nyquist), "nyquist");
        QCOMPARE(poleClassName(PoleClass::Unstable), "unstable");
        QCOMPARE(poleClassName(PoleClass::Other), "other");
    }

    void sortPoles_isByFrequency_upperHalfFirst()
    {
        std::vector<Pole> poles(4);
        poles[0].frequency_Hz = 3.0;
        poles[1].frequency_Hz = 2.0;
        poles[1].z = {0.5, -0.1};
        poles[2].frequency_Hz = 2.0;
        poles[2].z = {0.5, 0.1};
        poles[3].frequency_Hz = 1.0;
        sortPoles(poles);
        QCOMPARE(poles[0].frequency_Hz, 1.0);
        QCOMPARE(poles[1].z.imag(), 0.1);
        QCOMPARE(poles[2].z.imag(), -0.1);
        QCOMPARE(poles[3].frequency_Hz, 3.0);
    }
};

DYNCAL_TEST(TestModelFindings)
#include "tst_model_findings.moc"
