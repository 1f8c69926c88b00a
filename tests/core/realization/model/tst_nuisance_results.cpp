// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/nuisance_results.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kRounding = 1e-12;

/// a e^(-t/tau) cos(2 pi f t + phase), t from the detected start.
NuisanceTerm termOf(std::size_t mode, double f_Hz, double tau_s, double a, double phase_rad)
{
    return {mode, true, {-1.0 / tau_s, 2.0 * M_PI * f_Hz}, std::polar(a, phase_rad)};
}

SeriesFit fitOf(Index shot, double plateau, double onset_s)
{
    SeriesFit fit;
    fit.shot = shot;
    fit.plateauGain = plateau;
    fit.onset_s = onset_s;
    return fit;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= kRounding * std::max(1.0, std::abs(b));
}

} // namespace

class TestNuisanceResults : public QObject
{
    Q_OBJECT

private slots:
    void term_isToldAtTheOnsetRelativeToThePlateau()
    {
        ModelInput input;
        input.nuisanceModes.resize(1);
        ModelDraft draft;
        draft.nuisance = {{termOf(0, 10e3, 1e-3, 0.2, 0.5)}};
        // A quarter of a period behind the start, and with a plateau of -4.
        const double onset_s = 0.25 / 10e3;
        const auto results = nuisanceResults(input, draft, {fitOf(7, -4.0, onset_s)});
        const NuisanceOfShot &found = results.at(0).perShot.at(0);
        QCOMPARE(found.shot, Index(7));
        QVERIFY(isNear(found.relativeAmplitude, 0.2 / 4.0 * std::exp(-onset_s / 1e-3)));
        QVERIFY(isNear(found.phase_rad, 0.5 + M_PI / 2.0));
        QCOMPARE(found.term.amplitude, draft.nuisance[0][0].amplitude); // as fitted
        QVERIFY(std::isnan(found.u_frequency_Hz) && std::isnan(found.u_dampingRatio));
    }

    void withoutPlateau_amplitudeIsThatOfTheRecord()
    {
        ModelInput input;
        input.nuisanceModes.resize(1);
        ModelDraft draft;
        draft.nuisance = {{termOf(0, 10e3, 1e-3, 0.2, -1.0)}};
        const auto results = nuisanceResults(input, draft, {fitOf(1, 0.0, 0.0)});
        QVERIFY(isNear(results[0].perShot[0].relativeAmplitude, 0.2));
        QVERIFY(isNear(results[0].perShot[0].phase_rad, -1.0));
    }

    void modes_keepTheRecipesOrderAndTheShotsThatShowThem()
    {
        ModelInput input;
        for (const char *label : {"first", "nowhere", "third"}) {
            NuisanceMode mode;
            mode.label = label;
            input.nuisanceModes.push_back(mode);
        }
        ModelDraft draft;
        draft.nuisance = {{termOf(2, 30e3, 1e-3, 0.3, 0.0), termOf(0, 10e3, 1e-3, 0.1, 0.0)}, {},
            {termOf(0, 11e3, 1e-3, 0.4, 0.0)}};
        const auto results = nuisanceResults(
            input, draft, {fitOf(1, 1.0, 0.0), fitOf(2, 1.0, 0.0), fitOf(5, 2.0, 0.0)});
        QCOMPARE(results.size(), std::size_t(3));
        QCOMPARE(results[1].mode.label, std::string("nowhere"));
        QVERIFY(results[1].perShot.empty());
        QCOMPARE(results[2].perShot.size(), std::size_t(1));
        QVERIFY(isNear(results[2].perShot[0].relativeAmplitude, 0.3));
        QCOMPARE(results[0].perShot.size(), std::size_t(2));
        QCOMPARE(results[0].perShot[1].shot, Index(5));
        QVERIFY(isNear(results[0].perShot[1].relativeAmplitude, 0.2));
    }

    void uncertainties_areThoseOfTheTermsOwnPlaceInTheFit()
    {
        // Every variance is different, so that a wrong place is a wrong number.
        const NuisanceTerm a = termOf(0, 10e3, 1e-3, 0.2, 0.0), b = termOf(1, 25e3, 2e-3, 0.1, 0.0);
        Refinement fit;
        fit.poleParameters = 2;
        fit.withConstant = true;
        fit.nuisance = {{a, b}, {b}};
        fit.offsets = {2, 2 + 3 + 8}; // two amplitudes and c0, four of each term
        const Index size = 2 + 3 + 8 + 3 + 4;
        fit.covariance = Eigen::VectorXd::LinSpaced(size, 1.0, static_cast<double>(size))
                             .asDiagonal()
                             .toDenseMatrix();
        ModelInput input;
        input.nuisanceModes.resize(2);
        ModelDraft draft;
        draft.nuisance = fit.nuisance;
        draft.refinement = fit;
        const auto results
            = nuisanceResults(input, draft, {fitOf(1, 1.0, 0.0), fitOf(2, 1.0, 0.0)});
        const auto check = [](const NuisanceOfShot &found, double varRe, double varIm) {
            const std::complex<double> s = found.term.pole_rad_s;
            const double w = std::abs(s);
            const double u
                = std::hypot(s.real() / w * std::sqrt(varRe), s.imag() / w * std::sqrt(varIm));
            QVERIFY(isNear(found.u_frequency_Hz, u / (2.0 * M_PI)));
            const double turn
                = std::hypot(s.imag() / w * std::sqrt(varRe), s.real() / w * std::sqrt(varIm)) / w;
            QVERIFY(std::abs(found.u_dampingRatio / (s.imag() / w * turn) - 1.0) < kRounding);
        };
        check(results[0].perShot[0], 6.0, 7.0); // parameters 5 and 6 from 0
        check(results[1].perShot[0], 10.0, 11.0);
        check(results[1].perShot[1], 17.0, 18.0);
    }

    void modesLeftIn_recordsEndWithTheSeriesAgain()
    {
        ModelSeries series
            = testing::makeSeries(1, testing::sampledStep(30e3, 0.1, kRate_Hz, 500), kRate_Hz);
        series.y = Eigen::VectorXd::Ones(50); // every fourth sample from the 7th on
        series.first_s = 7.0 / kRate_Hz;
        series.nuisance = {termOf(0, 10e3, 1e-3, 0.1, 0.0)};
        series.correction = Eigen::VectorXd::Ones(50);
        ModelInput input
            = testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz / 4.0, {series});
        input.nuisanceModes.resize(1);
        const ModelInput plain = withModesLeftIn(input);
        QCOMPARE(plain.series[0].fullRate.size(), Index(7 + 49 * 4 + 1));
        QCOMPARE(plain.series[0].fullRate, series.fullRate.head(204).eval());
        QVERIFY(plain.nuisanceModes.empty() && plain.series[0].nuisance.empty());
        QCOMPARE(plain.series[0].correction.size(), Index(0));
        QCOMPARE(plain.series[0].y, series.y);
        input.series[0].fullRate.conservativeResize(100); // never longer than it was
        QCOMPARE(withModesLeftIn(input).series[0].fullRate.size(), Index(100));
    }

    void side_isTheMainPoleAndTheResidualOfWhatCounts()
    {
        ModelSeries series = testing::makeSeries(1, Eigen::VectorXd::Zero(40), kRate_Hz);
        ModelSeries other = testing::makeSeries(2, Eigen::VectorXd::Zero(40), kRate_Hz);
        other.leftOut = {{{10, 20}, Eigen::VectorXd::Zero(10)}};
        const ModelInput input
            = testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, {series, other});
        SensorModel model;
        model.series = {fitOf(1, 1.0, 0.0), fitOf(2, 1.0, 0.0)};
        model.series[0].error = Eigen::VectorXd::Constant(40, 3.0);
        model.series[1].error = Eigen::VectorXd::Constant(40, -4.0);
        model.series[1].error.segment(10, 10).setConstant(1e9); // left out
        model.fit_percent = 87.0;
        model.plateauGain = 1.5;
        NuisanceEffect::Side side = effectSide(input, model, {});
        QVERIFY(isNear(side.residualRms, std::sqrt((40.0 * 9.0 + 30.0 * 16.0) / 70.0)));
        QCOMPARE(side.fit_percent, 87.0);
        QCOMPARE(side.plateauGain, 1.5);
        QVERIFY(std::isnan(side.f0_Hz) && std::isnan(side.u_zeta)); // nothing oscillates

        Pole pole;
        pole.poleClass = PoleClass::Sensor;
        pole.s_rad_s = {-1e3, 1e5};
        pole.amplitude = 1.0;
        pole.frequency_Hz = 16e3;
        pole.u_frequency_Hz = 2.0;
        pole.dampingRatio = 0.01;
        pole.u_dampingRatio = 1e-4;
        side = effectSide(input, model, {pole});
        QCOMPARE(side.f0_Hz, 16e3);
        QCOMPARE(side.u_f0_Hz, 2.0);
        QCOMPARE(side.zeta, 0.01);
        QCOMPARE(side.u_zeta, 1e-4);
    }
};

DYNCAL_TEST(TestNuisanceResults)
#include "tst_nuisance_results.moc"
