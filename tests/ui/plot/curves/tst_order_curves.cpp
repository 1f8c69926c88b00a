// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/spectrum_analysis.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/plot/curves/order_curves.h"

#include <QSet>
#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kPeak_Hz = 1e6;
constexpr double kWidth_Hz = 2e4;

/// A line of known height over a flat floor of 1.
PowerSpectrum line(double height, Index bins)
{
    PowerSpectrum spectrum;
    spectrum.frequency_Hz = Eigen::VectorXd::LinSpaced(bins, 0.0, 4e6);
    spectrum.psd
        = 1.0 + height * (-((spectrum.frequency_Hz.array() - kPeak_Hz) / kWidth_Hz).square()).exp();
    return spectrum;
}

OrderPole pole(Index order, double frequency_Hz, PoleStability stability)
{
    OrderPole made;
    made.order = order;
    made.frequency_Hz = frequency_Hz;
    made.stability = stability;
    return made;
}

OrderEvidence evidenceOfFive()
{
    OrderEvidence evidence;
    evidence.poles = {pole(2, 1e6, PoleStability::New), pole(3, 1e6, PoleStability::Frequency),
        pole(4, 1e6, PoleStability::FrequencyAndDamping), pole(4, 2e6, PoleStability::New),
        pole(5, 1.9e6, PoleStability::Unstable)};
    evidence.fit_percent.resize(5);
    evidence.fit_percent << 10.0, 88.0, 88.5, std::nan(""), -40.0;
    return evidence;
}

const PlotCurve *ofRole(const PlotContent &content, CurveRole role)
{
    for (const PlotCurve &curve : content.curves)
        if (curve.role == role)
            return &curve;
    return nullptr;
}

} // namespace

/// The stabilisation strip and the evidence over the order, against constructed truths.
class TestOrderCurves : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void strip_everyPoleIsDrawnOnce_inTheMarkerOfItsClass();
    void strip_viewHoldsAllPoles_andTheOrderOnShow();
    void strip_spectrumBehind_isTheMeanOfTheShots();
    void strip_spectrumOfManyBins_keepsThePeak();
    void strip_spectraOfOtherLengths_areLeftOut();
    void strip_withoutSpectrum_orPoles_isNoCrash();
    void evidence_fitIsOfItsOrder_gapsStayGaps();
    void evidence_bicIsBehind_onItsOwnAxis();
    void evidence_unknownAttainable_drawsNoLevel();
    void swedish_summaryHasTheNumbers();
};

void TestOrderCurves::strip_everyPoleIsDrawnOnce_inTheMarkerOfItsClass()
{
    const OrderEvidence evidence = evidenceOfFive();
    const PlotContent content = stabilisationCurves(evidence, {}, 0);
    std::size_t drawn = 0;
    QSet<int> roles;
    for (const PlotCurve &curve : content.curves) {
        if (curve.onSecondAxis)
            continue;
        roles << static_cast<int>(curve.role);
        drawn += curve.x.size();
    }
    QCOMPARE(drawn, evidence.poles.size());
    QCOMPARE(roles.size(), 4); // classes are told apart by marker, not by colour alone
    const PlotCurve *stable = ofRole(content, CurveRole::StablePole);
    QVERIFY(stable);
    QCOMPARE(stable->x, std::vector<double>{1e6});
    QCOMPARE(stable->y, std::vector<double>{4.0});
    QCOMPARE(ofRole(content, CurveRole::UnstablePole)->x, std::vector<double>{1.9e6});
    QVERIFY(content.levels.empty()); // no order is chosen
}

void TestOrderCurves::strip_viewHoldsAllPoles_andTheOrderOnShow()
{
    const PlotContent content = stabilisationCurves(evidenceOfFive(), {}, 3);
    QVERIFY(*content.xMin < 1e6 && *content.xMax > 2e6);
    QVERIFY(*content.yMin < 2.0 && *content.yMax > 5.0);
    QCOMPARE(content.levels.size(), std::size_t(1));
    QCOMPARE(content.levels[0].y, 3.0);
    QVERIFY(content.levels[0].label.contains('3'));
}

void TestOrderCurves::strip_spectrumBehind_isTheMeanOfTheShots()
{
    SpectrumResult spectrum;
    spectrum.perShot = {line(100.0, 4001), line(300.0, 4001)};
    const PlotContent content = stabilisationCurves(evidenceOfFive(), spectrum, 2);
    const PlotCurve *behind = ofRole(content, CurveRole::Noise);
    QVERIFY(behind && behind->onSecondAxis);
    for (std::size_t i = 0; i < behind->x.size(); ++i) {
        const double d = (behind->x[i] - kPeak_Hz) / kWidth_Hz;
        const double mean = 1.0 + 200.0 * std::exp(-d * d);
        QVERIFY(std::abs(behind->y[i] - 10.0 * std::log10(mean)) < 1e-9);
        QVERIFY(i == 0 || behind->x[i] > behind->x[i - 1]);
    }
    QVERIFY(behind->x.front() >= *content.xMin && behind->x.back() <= *content.xMax);
}

void TestOrderCurves::strip_spectrumOfManyBins_keepsThePeak()
{
    SpectrumResult spectrum;
    spectrum.perShot = {line(1.0, 400'001)};
    spectrum.perShot[0].psd[150'000] = 1e6; // one bin, at 1.5 MHz: between all bands' edges
    const PlotContent content = stabilisationCurves(evidenceOfFive(), spectrum, 2);
    const PlotCurve *behind = ofRole(content, CurveRole::Noise);
    QVERIFY(behind->x.size() < 1000); // drawn at every move
    const auto highest = std::ranges::max_element(behind->y);
    QCOMPARE(*highest, 60.0);
    QVERIFY(
        std::abs(behind->x[static_cast<std::size_t>(highest - behind->y.begin())] - 1.5e6) < 1e-3);
}

void TestOrderCurves::strip_spectraOfOtherLengths_areLeftOut()
{
    SpectrumResult both;
    both.perShot = {line(100.0, 4001), line(1e9, 2001)}; // the second from a shorter window
    SpectrumResult first;
    first.perShot = {both.perShot[0]};
    const PlotContent a = stabilisationCurves(evidenceOfFive(), both, 2);
    const PlotContent b = stabilisationCurves(evidenceOfFive(), first, 2);
    QCOMPARE(ofRole(a, CurveRole::Noise)->y, ofRole(b, CurveRole::Noise)->y);
}

void TestOrderCurves::strip_withoutSpectrum_orPoles_isNoCrash()
{
    const PlotContent noPoles = stabilisationCurves({}, {}, 2);
    QVERIFY(noPoles.curves.empty());
    QVERIFY(!noPoles.summary.isEmpty());
    const PlotContent noSpectrum = stabilisationCurves(evidenceOfFive(), {}, 2);
    QVERIFY(ofRole(noSpectrum, CurveRole::Noise)->x.empty());
    SpectrumResult dead; // a channel that recorded nothing has no power anywhere
    dead.perShot = {line(0.0, 101)};
    dead.perShot[0].psd.setZero();
    QVERIFY(ofRole(stabilisationCurves(evidenceOfFive(), dead, 2), CurveRole::Noise)->x.empty());
}

void TestOrderCurves::evidence_fitIsOfItsOrder_gapsStayGaps()
{
    const OrderEvidence evidence = evidenceOfFive();
    const PlotContent content = evidenceCurves(&evidence, {}, 89.5, 2);
    const PlotCurve *fit = ofRole(content, CurveRole::Measured);
    QVERIFY(fit);
    QCOMPARE(fit->x, (std::vector<double>{1, 2, 3, 4, 5}));
    QCOMPARE(fit->y[1], 88.0);
    QVERIFY(std::isnan(fit->y[3])); // order 4 diverges: no point, and no zero either
    QCOMPARE(*content.yMin, 0.0); // -40 % does not squeeze the rest
    QVERIFY(*content.yMax > 100.0);
    QCOMPARE(content.marks.size(), std::size_t(1));
    QCOMPARE(content.marks[0].x, 2.0);
    QVERIFY(!ofRole(content, CurveRole::Error)); // no shot was left out
}

void TestOrderCurves::evidence_bicIsBehind_onItsOwnAxis()
{
    OrderSuggestion suggestion;
    suggestion.bic = Eigen::VectorXd::LinSpaced(20, -1e6, 1e6);
    const PlotContent content = evidenceCurves(nullptr, suggestion, 89.5, 2);
    QVERIFY(content.yAxis2);
    QCOMPARE(content.curves.size(), std::size_t(1));
    QVERIFY(content.curves[0].onSecondAxis);
    QCOMPARE(content.curves[0].x.front(), 1.0);
    QCOMPARE(content.curves[0].y.back(), 1e6);
    OrderEvidence evidence = evidenceOfFive();
    evidence.crossShot_percent = Eigen::VectorXd::Constant(5, 12.0);
    QCOMPARE(evidenceCurves(&evidence, suggestion, 89.5, 2).curves.size(), std::size_t(3));
}

void TestOrderCurves::evidence_unknownAttainable_drawsNoLevel()
{
    const OrderEvidence evidence = evidenceOfFive();
    QVERIFY(evidenceCurves(&evidence, {}, std::nan(""), 0).levels.empty());
    QVERIFY(evidenceCurves(&evidence, {}, std::nan(""), 0).marks.empty());
    const PlotContent known = evidenceCurves(&evidence, {}, 89.5, 0);
    QCOMPARE(known.levels.at(0).y, 89.5);
    QVERIFY(known.levels.at(0).label.contains("89.5"));
}

void TestOrderCurves::swedish_summaryHasTheNumbers()
{
    const test::InSwedish swedish;
    const PlotContent content = stabilisationCurves(evidenceOfFive(), {}, 2);
    QVERIFY2(!content.summary.contains("Poles of orders"), qPrintable(content.summary));
    for (const char *number : {"1", "5"})
        QVERIFY(content.summary.contains(number));
    QVERIFY(!content.summary.contains('%')); // every place is filled
    const OrderEvidence evidence = evidenceOfFive();
    QVERIFY(evidenceCurves(&evidence, {}, 89.5, 2).levels.at(0).label.contains("89,5"));
}

DYNCAL_TEST(TestOrderCurves)
#include "tst_order_curves.moc"
