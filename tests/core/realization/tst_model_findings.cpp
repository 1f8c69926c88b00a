// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model_findings.h"
#include "core/realization/pole_classes.h"
#include "tests/support/second_order_model.h"
#include "tests/support/signals.h"

#include <QTest>

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
        {"ORD-001", "pair split", [](Scene &s) { s.hankel.singularValues << 20, 8, 7.9, 0.8; },
            true},
        {"ORD-001", "ratio just above", [](Scene &s) { s.hankel.singularValues << 20, 8, 7.6, 1; },
            false},
        {"ORD-001", "pair below noise",
            [](Scene &s) {
                s.hankel.singularValues << 20, 8, 7.9, 0.8;
                s.hankel.noiseFloor_p95 = 7.95;
            },
            false},
        {"ORD-001", "last order", [](Scene &s) { s.model.order = 4; }, false},
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

    void splitPair_offersTheNextOrder()
    {
        Scene scene;
        scene.hankel.singularValues << 20, 8, 7.9, 0.8;
        const Findings findings = scene.judge();
        const auto split = std::find_if(findings.begin(), findings.end(),
            [](const Finding &finding) { return finding.id == "ORD-001"; });
        QVERIFY(split->mend.has_value());
        QCOMPARE(split->mend->key, std::string("realization.order"));
        QCOMPARE(split->mend->value, std::string("3"));
        QCOMPARE(english(split->mend->label), std::string("Use order 3"));
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
        flagPoles(scene.model);
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

QTEST_APPLESS_MAIN(TestModelFindings)
#include "tst_model_findings.moc"
