// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The steps between poles and model: z to s and back, amplitudes brought to time 0 and freed of
// the filter, what stands out of the noise, and when nothing is refined.

#include "core/realization/exponentials/pole_mapping.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/model_draft.h"
#include "core/realization/refinement/series_simulation.h"
#include "core/signal/resampler.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kRounding = 1e-12;

/// c0 + 2 Re(c e^(s t)) sampled at the record's rate, reduced by `factor`, beginning at sample
/// `first` of the record: a series whose truth is known at time 0.
struct Decay
{
    double constant = 1.5;
    Complex s{-4e4, 3e5};
    Complex c{0.7, -0.4};

    double value(double t_s) const { return constant + 2.0 * (c * std::exp(s * t_s)).real(); }

    ModelInput input(double factor, Index first) const
    {
        const AntiAliasFilter filter = designAntiAliasFilter(factor, kRate_Hz * factor);
        const Index count = 150;
        const auto size = static_cast<Index>(factor * 160.0) + first + filter.halfLength() + 2;
        Eigen::VectorXd record(size);
        for (Index i = 0; i < size; ++i)
            record[i] = value(static_cast<double>(i) / (kRate_Hz * factor));
        ModelSeries series;
        series.shot = 1;
        series.filter = filter;
        series.y = decimate(record, filter, first, count);
        series.first_s = static_cast<double>(first) / (kRate_Hz * factor);
        series.fullRate = record;
        series.fullRate_Hz = kRate_Hz * factor;
        return testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, {series});
    }
    std::vector<Complex> poles() const
    {
        const Complex z = std::exp(s / kRate_Hz);
        return {z, std::conj(z)};
    }
};

} // namespace

class TestModelDraft : public QObject
{
    Q_OBJECT

private slots:
    void rates_andPoles_areEachOthersInverse()
    {
        const std::vector<Complex> poles{{0.9, 0.3}, {0.9, -0.3}, {0.5, 0.0}, {-0.7, 0.0},
            {1.01, 0.0}, {-0.2, 0.97}, {-0.2, -0.97}};
        for (const double dt_s : {1.0, 1e-9, 3e7}) {
            std::vector<Complex> continuous;
            for (const Complex &z : poles)
                continuous.push_back(continuousPole(z, dt_s));
            const std::vector<Complex> again = discretePoles(continuous, dt_s);
            for (std::size_t i = 0; i < poles.size(); ++i) {
                QVERIFY(std::abs(again[i] - poles[i]) < kRounding);
                // Real stays exactly real, also on the negative axis.
                QCOMPARE(again[i].imag() == 0.0, poles[i].imag() == 0.0);
            }
            QCOMPARE(continuousPole(std::conj(poles[0]), dt_s),
                std::conj(continuousPole(poles[0], dt_s)));
        }
        QVERIFY(std::isfinite(std::abs(continuousPole(0.0, 1e-6)))); // a pure delay
        QVERIFY(std::abs(discretePoles({continuousPole(0.0, 1e-6)}, 1e-6)[0]) < 1e-200);
    }

    void amplitudes_areThoseAtTimeZero_whateverTheFilterAndTheBegin_data()
    {
        QTest::addColumn<double>("factor");
        QTest::addColumn<int>("begin"); ///< samples behind half of the filter
        QTest::newRow("as recorded") << 1.0 << 0;
        QTest::newRow("as recorded, later") << 1.0 << 17;
        QTest::newRow("reduced") << 5.0 << 0;
        QTest::newRow("reduced, later") << 10.0 << 7;
    }
    void amplitudes_areThoseAtTimeZero_whateverTheFilterAndTheBegin()
    {
        QFETCH(double, factor);
        QFETCH(int, begin);
        const Decay truth;
        const Index half = designAntiAliasFilter(factor, kRate_Hz * factor).halfLength();
        const ModelInput input = truth.input(factor, half + begin);
        const ModelDraft draft = linearDraft(input, truth.poles());
        const ExponentialSum &sum = draft.series.at(0);
        QVERIFY(std::abs(sum.constant - truth.constant) < 1e-9);
        QVERIFY(std::abs(sum.amplitudes[0] - truth.c) < 1e-9);
        QCOMPARE(sum.amplitudes[1], std::conj(sum.amplitudes[0]));
        QVERIFY(std::abs(sum.poles_rad_s[0] - truth.s) < 1e-6);
        // Simulated through the same filter it is the series again.
        const Eigen::VectorXd again = simulate(input.series[0], sum, {}, 1.0 / kRate_Hz);
        QVERIFY((again - input.series[0].y).cwiseAbs().maxCoeff() < 1e-10);
        for (const double t_s : {0.0, 2e-6, 31e-6})
            QVERIFY(std::abs(sum.value(t_s) - truth.value(t_s)) < 1e-9);
    }

    void nuisanceTerms_areSimulatedThroughTheFilterToo()
    {
        const Decay truth;
        const Index half = designAntiAliasFilter(10.0, kRate_Hz * 10.0).halfLength();
        ModelInput input = truth.input(10.0, half);
        const ModelSeries &series = input.series[0];
        // A term written as a mode and the same as part of the sum: one record.
        ExponentialSum constant{truth.constant, {}, {}};
        const NuisanceTerm term{0, true, truth.s, 2.0 * truth.c};
        const Eigen::VectorXd asTerm = simulate(series, constant, {term}, 1.0 / kRate_Hz);
        QVERIFY((asTerm - series.y).cwiseAbs().maxCoeff() < 1e-10);
    }

    void rates_areSortedWithPairsTogether()
    {
        const std::vector<Complex> poles{std::polar(0.9, 2.0), std::polar(0.9, -2.0), {0.5, 0.0},
            std::polar(0.99, 0.1), std::polar(0.99, -0.1), {0.999, 0.0}};
        ModelInput input = Decay{}.input(1.0, 0);
        const ModelDraft draft = linearDraft(input, poles);
        QCOMPARE(draft.poles_rad_s.size(), poles.size());
        for (std::size_t i = 1; i < poles.size(); ++i)
            QVERIFY(std::abs(draft.poles_rad_s[i])
                >= std::abs(draft.poles_rad_s[i - 1]) * (1.0 - kRounding));
        for (const std::size_t upper : {1U, 4U}) {
            QVERIFY(draft.poles_rad_s[upper].imag() > 0.0);
            QCOMPARE(draft.poles_rad_s[upper + 1], std::conj(draft.poles_rad_s[upper]));
        }
        QVERIFY(draft.realizedPoles_rad_s == draft.poles_rad_s);
        QCOMPARE(draft.series.at(0).amplitudes.size(), Index(6));
    }

    void energyOverNoise_isTheSumWrittenOut()
    {
        const Index half = designAntiAliasFilter(5.0, kRate_Hz * 5.0).halfLength();
        for (const Complex s : {Complex(-4e4, 3e5), Complex(-1e3, 0.0), Complex(0.0, 2e5),
                 Complex(2e3, 1e5), Complex(-1e-9, 1e5)}) {
            Decay decay;
            decay.s = s;
            ModelInput input = decay.input(5.0, half);
            ModelSeries &series = input.series[0];
            series.noiseSd = 0.03;
            ExponentialSum sum{0.0, Eigen::VectorXcd(1), Eigen::VectorXcd(1)};
            sum.poles_rad_s << s;
            sum.amplitudes << decay.c;
            double energy = 0.0;
            for (Index k = 0; k < series.y.size(); ++k) {
                const double t_s = series.first_s + static_cast<double>(k) / kRate_Hz;
                energy += 2.0 * std::norm(decay.c * series.filter.gain(s) * std::exp(s * t_s));
            }
            const double found = energyOverNoise(series, sum, 0, 1.0 / kRate_Hz);
            QVERIFY2(std::abs(found / (energy / 9e-4) - 1.0) < 1e-6,
                qPrintable(QString::number(found / (energy / 9e-4))));
        }
    }

    void standsOut_whereOneOfTheShotsShowsIt_inAnyUnit()
    {
        testing::Noise noise(2);
        const Decay decay;
        ModelInput input = decay.input(1.0, 0);
        input.series.push_back(input.series[0]);
        input.series[0].noiseSd = 100.0; // buried here
        input.series[1].noiseSd = 0.01;
        // A third pole that nothing shows.
        std::vector<Complex> poles = decay.poles();
        poles.emplace_back(0.2);
        const ModelDraft draft = linearDraft(input, poles);
        std::vector<bool> expected;
        for (const Complex &s : draft.poles_rad_s)
            expected.push_back(s.imag() != 0.0);
        QVERIFY(standingOut(input, draft) == expected);
        input.series.pop_back();
        QVERIFY(standingOut(input, draft) == std::vector<bool>(3, false));
        // Without any noise what is left of rounding must not stand out.
        input.series[0].noiseSd = 0.0;
        for (const double unit : {1.0, 1e-9, 1e9}) {
            ModelInput scaled = input;
            scaled.series[0].y *= unit;
            scaled.series[0].fullRate *= unit;
            QVERIFY(standingOut(scaled, linearDraft(scaled, poles)) == expected);
        }
    }

    void refinement_leavesAloneWhatItCannotRefine()
    {
        const Decay decay;
        const auto refined = [&](const ModelInput &input, const std::vector<Complex> &poles) {
            ModelDraft draft = linearDraft(input, poles);
            const ModelDraft before = draft;
            refineDraft(input, draft, {});
            if (!draft.refinement && draft.poles_rad_s != before.poles_rad_s)
                qFatal("changed without a refinement");
            return draft.refinement.has_value();
        };
        const ModelInput input = decay.input(1.0, 0);
        QVERIFY(refined(input, decay.poles()));
        QVERIFY(!refined(input, {}));
        std::vector<Complex> poles = decay.poles();
        poles.emplace_back(
            1.05); // does not decay; 1.001 would be nearly a ramp, whose sign is open
        QVERIFY(!refined(input, poles));
        poles.back() = -0.5; // has no continuous partner
        QVERIFY(!refined(input, poles));
        std::vector<Complex> many;
        for (int i = 0; i < 7; ++i) {
            many.push_back(std::polar(0.95, 0.2 + 0.3 * i));
            many.push_back(std::conj(many.back()));
        }
        QVERIFY(!refined(input, many)); // fourteen: beyond order 12
        ModelInput thesis = input;
        thesis.treatment = ResponseTreatment::StepAsImpulse;
        QVERIFY(!refined(thesis, decay.poles()));
    }

    void fitPercent_isEquation41()
    {
        QCOMPARE(fitPercent(0.0, 4.0), 100.0);
        QCOMPARE(fitPercent(1.0, 4.0), 50.0);
        QCOMPARE(fitPercent(16.0, 4.0), -100.0);
        QCOMPARE(fitPercent(1.0, 0.0), 0.0); // a constant has no spread to explain
        Eigen::VectorXd y(4);
        y << 1.0, 3.0, 5.0, 7.0;
        QCOMPARE(spreadSquares(y), 20.0);
        QVERIFY(std::abs(spreadSquares((y.array() + 1e6).matrix()) - 20.0) < 1e-6);
    }
};

DYNCAL_TEST(TestModelDraft)
#include "tst_model_draft.moc"
