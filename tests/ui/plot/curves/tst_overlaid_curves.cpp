// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/decomposition/component_result.h"
#include "core/decomposition/residual_analysis.h"
#include "tests/support/test_program.h"
#include "ui/plot/curves/candidate_curves.h"
#include "ui/plot/curves/component_curves.h"
#include "ui/plot/curves/model_residual_curves.h"

#include <QSet>
#include <QtTest>

#include <cmath>
#include <random>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 10e6;
constexpr Index kSamples = 2000;

/// Two shots whose inputs begin 3 and 5 us after the start.
ModelInput input()
{
    ModelInput made;
    made.sampleRate_Hz = kRate_Hz;
    made.samples = kSamples;
    for (const double first_s : {3e-6, 5e-6}) {
        ModelSeries series;
        series.shot = made.series.empty() ? 1 : 2;
        series.first_s = first_s;
        series.y = Eigen::VectorXd::Ones(kSamples);
        made.series.push_back(series);
    }
    return made;
}

/// A model of an order, whose error at each sample the test says.
std::shared_ptr<SensorModel> model(Index order, const std::function<double(Index)> &error)
{
    auto made = std::make_shared<SensorModel>();
    made->order = order;
    for (const Index shot : {Index(1), Index(2)}) {
        SeriesFit fit;
        fit.shot = shot;
        fit.plateauGain = 1.0;
        fit.error.resize(kSamples);
        for (Index k = 0; k < kSamples; ++k)
            fit.error[k] = static_cast<double>(shot) * error(k);
        fit.simulated = Eigen::VectorXd::Ones(kSamples) - fit.error;
        made->series.push_back(fit);
    }
    return made;
}

double alternating(Index k)
{
    return k % 2 == 0 ? 0.1 : -0.1;
}

std::shared_ptr<ResponseResult> response()
{
    auto made = std::make_shared<ResponseResult>();
    made->modelCurve.frequency_Hz = Eigen::VectorXd::LinSpaced(5, 1e3, 5e6);
    made->modelCurve.magnitude = Eigen::VectorXd::LinSpaced(5, 1.0, 0.1);
    made->modelCurve.phase_rad = Eigen::VectorXd::LinSpaced(5, 0.0, -M_PI);
    return made;
}

} // namespace

/// Models laid over the chosen one, and what they leave, against constructed truths.
class TestOverlaidCurves : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void simulation_isOfTheSeriesAsked_atItsOwnTimes();
    void diverging_orMissing_isLeftOut();
    void phase_isInDegrees_withoutResponseNothing();
    void poles_farOutside_areNotDrawn();
    void roles_areDistinct_andGoRound();
    void residual_ofAnAlternatingError_alternates();
    void residual_ofWhiteNoise_staysInItsBand();
    void residual_oneSeries_showsThatAlone();
    void secondOrder_withoutPlateau_isNotDrawn();
    void secondOrder_atItsResonance_isItsQuality();
    void average_andReconstruction_haveTheirTimes();
    void peaks_sharedByShots_areMarkedOnce();
};

void TestOverlaidCurves::simulation_isOfTheSeriesAsked_atItsOwnTimes()
{
    const std::vector<OverlaidModel> pinned{{CurveRole::Candidate2, model(4, alternating), {}}};
    PlotContent content;
    overlayErrors(content, input(), pinned, 1);
    QCOMPARE(content.curves.size(), std::size_t(1));
    const PlotCurve &curve = content.curves[0];
    QCOMPARE(curve.role, CurveRole::Candidate2);
    QVERIFY(curve.name.contains('4'));
    QCOMPARE(curve.x.front(), 5e-6); // of the second shot
    QVERIFY(std::abs(curve.x[1] - curve.x[0] - 1.0 / kRate_Hz) < 1e-15);
    QCOMPARE(curve.y[1], -0.2);
    overlaySimulations(content, input(), pinned); // none asked for: the first
    QCOMPARE(content.curves[1].x.front(), 3e-6);
    QCOMPARE(content.curves[1].y[1], 1.1);
}

void TestOverlaidCurves::diverging_orMissing_isLeftOut()
{
    const auto wild = model(40, alternating);
    wild->diverges = true;
    const auto sound = model(2, alternating);
    PlotContent content;
    overlaySimulations(content, input(), {{CurveRole::Candidate1, wild, {}}});
    overlaySimulations(content, input(), {{CurveRole::Candidate1, sound, {}}}, 2); // no third shot
    QVERIFY(content.curves.empty());
    sound->series.resize(1);
    overlayErrors(content, input(), {{CurveRole::Candidate1, sound, {}}}, 1);
    QVERIFY(content.curves.empty());
}

void TestOverlaidCurves::phase_isInDegrees_withoutResponseNothing()
{
    const std::vector<OverlaidModel> pinned{{CurveRole::Candidate1, model(2, alternating), {}},
        {CurveRole::Candidate2, model(3, alternating), response()}};
    PlotContent content;
    overlayPhases(content, pinned);
    QCOMPARE(content.curves.size(), std::size_t(1));
    QVERIFY(std::abs(content.curves[0].y.back() + 180.0) < 1e-9);
    overlayMagnitudes(content, pinned);
    QCOMPARE(content.curves[1].y.back(), 0.1);
    QCOMPARE(content.curves[1].role, CurveRole::Candidate2);
}

void TestOverlaidCurves::poles_farOutside_areNotDrawn()
{
    const auto made = model(3, alternating);
    for (const std::complex<double> z : {std::complex<double>(0.5, 0.5),
             std::complex<double>(0.5, -0.5), std::complex<double>(40.0, 0.0)}) {
        Pole pole;
        pole.z = z;
        made->poles.push_back(pole);
    }
    PlotContent content;
    overlayPoles(content, {{CurveRole::Candidate3, made, {}}});
    QCOMPARE(content.curves.at(0).x, (std::vector<double>{0.5, 0.5}));
    QCOMPARE(content.curves.at(0).y, (std::vector<double>{0.5, -0.5}));
    made->poles.erase(made->poles.begin(), made->poles.begin() + 2);
    PlotContent empty;
    overlayPoles(empty, {{CurveRole::Candidate3, made, {}}});
    QVERIFY(empty.curves.empty()); // no name in the legend without a marker
}

void TestOverlaidCurves::roles_areDistinct_andGoRound()
{
    QSet<int> roles;
    for (std::size_t k = 0; k < kMostOverlaid; ++k)
        roles << static_cast<int>(candidateRole(k));
    QCOMPARE(roles.size(), static_cast<qsizetype>(kMostOverlaid));
    QCOMPARE(candidateRole(kMostOverlaid), candidateRole(0));
}

void TestOverlaidCurves::residual_ofAnAlternatingError_alternates()
{
    ComponentSettings settings;
    settings.residualLags = 10;
    const PlotContent content
        = modelResidualCurves(input(), *model(2, alternating), {}, settings, 0);
    QCOMPARE(content.curves.size(), std::size_t(1));
    const std::vector<double> &r = content.curves[0].y;
    QCOMPARE(r.size(), std::size_t(11));
    for (std::size_t lag = 0; lag < r.size(); ++lag) {
        // Biased estimate: (N - lag)/N, with the sign of the alternation.
        const double expected = (lag % 2 == 0 ? 1.0 : -1.0)
            * (1.0 - static_cast<double>(lag) / static_cast<double>(kSamples));
        QVERIFY2(std::abs(r[lag] - expected) < 1e-9, qPrintable(QString::number(r[lag])));
    }
}

void TestOverlaidCurves::residual_ofWhiteNoise_staysInItsBand()
{
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0.0, 0.01);
    ComponentSettings settings;
    settings.residualLags = 200;
    settings.residualConfidence = 0.99;
    const PlotContent content = modelResidualCurves(
        input(), *model(2, [&](Index) { return normal(random); }), {}, settings, {});
    QCOMPARE(content.levels.size(), std::size_t(2));
    const double bound = content.levels[0].y;
    QVERIFY(std::abs(bound - 2.5758 / std::sqrt(static_cast<double>(kSamples))) < 1e-5);
    QCOMPARE(content.levels[1].y, -bound);
    for (const PlotCurve &curve : content.curves) {
        const auto outside = std::count_if(
            curve.y.begin() + 1, curve.y.end(), [bound](double r) { return std::abs(r) > bound; });
        QVERIFY2(outside <= 8, qPrintable(QString::number(outside))); // 2 of 200 are expected
    }
    QVERIFY(*content.yMax < 0.5); // lag 0 is cut off, else the band could not be seen
}

void TestOverlaidCurves::residual_oneSeries_showsThatAlone()
{
    const auto made = model(2, alternating);
    QCOMPARE(modelResidualCurves(input(), *made, {}, {}, {}).curves.size(), std::size_t(2));
    QCOMPARE(modelResidualCurves(input(), *made, {}, {}, 1).curves.size(), std::size_t(1));
    made->diverges = true;
    QVERIFY(modelResidualCurves(input(), *made, {}, {}, {}).curves.empty());
}

void TestOverlaidCurves::secondOrder_withoutPlateau_isNotDrawn()
{
    const auto made = model(2, alternating);
    PlotContent content;
    const SecondOrderModel fit;
    addSecondOrder(content, *made, fit, *response()); // the model has no plateau to refer to
    made->plateauGain = 1.0;
    addSecondOrder(content, *made, fit, *response()); // nor any shot of the second-order sensor
    QVERIFY(content.curves.empty());
}

void TestOverlaidCurves::secondOrder_atItsResonance_isItsQuality()
{
    const auto made = model(2, alternating);
    made->plateauGain = 1.0;
    SecondOrderModel fit;
    fit.f0_Hz = 5e6;
    fit.zeta = 0.025;
    fit.shots.resize(2);
    for (SecondOrderShot &shot : fit.shots)
        shot.plateauGain = 1.0;
    PlotContent content;
    addSecondOrder(content, *made, fit, *response());
    QVERIFY(std::abs(content.curves.at(0).y.back() - 1.0 / (2.0 * 0.025)) < 1e-9); // at f0
    QVERIFY(std::abs(content.curves.at(0).y.front() - 1.0) < 1e-6); // far below
}

void TestOverlaidCurves::average_andReconstruction_haveTheirTimes()
{
    ComponentResult components;
    components.sampleRate_Hz = kRate_Hz;
    components.shots = {1, 3};
    components.responses = Eigen::MatrixXd::Constant(50, 2, 2.0);
    components.reconstructions = Eigen::MatrixXd::Constant(50, 2, 1.5);
    components.average = Eigen::VectorXd::Constant(50, 1.5);
    const PlotContent left = residualCurves(components, {});
    QCOMPARE(left.curves.size(), std::size_t(2));
    QVERIFY(left.curves[1].name.contains('3')); // the number of the shot, not of the column
    QCOMPARE(left.curves[1].y.at(7), 0.5);
    const PlotContent mean = averageCurves(components, {});
    QVERIFY(std::abs(mean.curves.at(0).x.back() - 49.0 / kRate_Hz) < 1e-15);
    components.reconstructions.resize(0, 0); // not there: no difference to something else
    for (const PlotCurve &curve : residualCurves(components, {}).curves)
        QVERIFY(curve.y.empty());
}

void TestOverlaidCurves::peaks_sharedByShots_areMarkedOnce()
{
    ComponentResult components;
    components.shots = {1, 2, 3};
    for (const double peak_Hz : {6.80e3, 6.85e3, 9.1e3}) {
        ResidualAnalysis residual;
        residual.spectrum.frequency_Hz = Eigen::VectorXd::LinSpaced(100, 1e2, 1e6);
        residual.spectrum.psd = Eigen::VectorXd::Ones(100);
        residual.peaks_Hz = {peak_Hz, 1e5};
        components.residuals.push_back(residual);
    }
    const PlotContent content = residualSpectrumCurves(components, {});
    QCOMPARE(content.marks.size(), std::size_t(2)); // 6.80 and 6.85 kHz would hide each other
    QCOMPARE(content.marks[0].x, 6.80e3);
    QCOMPARE(content.marks[1].x, 9.1e3);
}

DYNCAL_TEST(TestOverlaidCurves)
#include "tst_overlaid_curves.moc"
