// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/stated_characteristics.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "ui/plot/curves/component_curves.h"
#include "ui/plot/curves/curve_building.h"
#include "ui/plot/curves/model_curves.h"
#include "ui/plot/curves/realization_curves.h"
#include "ui/plot/curves/signal_curves.h"
#include "ui/report/report_figures.h"

#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

using dyncal::bicCurves;
using dyncal::CalibrationResults;
using dyncal::ChannelRole;
using dyncal::CurveRole;
using dyncal::CurveStyle;
using dyncal::FigureMaker;
using dyncal::figureMakers;
using dyncal::Index;
using dyncal::PlotContent;
using dyncal::PlotCurve;
using dyncal::ReportFigure;
using dyncal::ResponseTreatment;

namespace {

/// Every plot at once.
std::vector<ReportFigure> reportFigures(const CalibrationResults &results)
{
    std::vector<ReportFigure> figures;
    for (const FigureMaker &make : figureMakers(results))
        if (std::optional<ReportFigure> figure = make())
            figures.push_back(std::move(*figure));
    return figures;
}

/// A one-channel set of one shot.
dyncal::CaptureSet captureOf(dyncal::RawSamples samples, std::vector<double> polynomial)
{
    dyncal::Channel channel;
    channel.role = ChannelRole::Dut;
    channel.samples = std::move(samples);
    channel.sampleRate_Hz = 1e6;
    channel.t0_s = -1e-3;
    channel.polynomial = std::move(polynomial);
    dyncal::Shot shot;
    shot.channels.push_back(std::move(channel));
    dyncal::CaptureSet set;
    set.shots.push_back(std::move(shot));
    return set;
}

double largest(const PlotCurve &curve)
{
    return *std::max_element(curve.y.begin(), curve.y.end());
}

double smallest(const PlotCurve &curve)
{
    return *std::min_element(curve.y.begin(), curve.y.end());
}

} // namespace

class TestCurves : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { m_results = dyncal::example::calibration(); }
    void raw_shortRecord_isEverySample();
    void raw_longRecord_keepsSpikeInFewPoints();
    void raw_invertedAndCurvedConversion_keepsExtremes();
    void raw_excludedShot_isLeftOut();
    void raw_unitsThatDiffer_haveAPlotEach();
    void window_times_areRelativeToStart();
    void start_zoom_coversTwentyRiseTimes();
    void spectrum_decibels_andResonanceMark();
    void spectra_manyPoints_shapeHoldsTruePoints();
    void components_barsAndBounds();
    void components_oneShot_explainsItself();
    void autocovariance_oneShot_showsThatAlone();
    void modelInput_samples_lieOnFullRate();
    void singularValues_markAndFloor();
    void singularValues_thesisMode_marksStep();
    void bic_empty_hasNoCurve();
    void simulation_diverging_isClippedAndSaid();
    void simulation_oneSeries_showsTwoCurves();
    void poleZero_classes_haveOwnMarkers();
    void bode_units_andBars();
    void bode_saysWhatIsWithheld();
    void step_ofModel_followsClosedForm();
    void step_hasLinesForItsOvershoot();
    void phase_withAnotherZeroThanTheModels_saysSo();
    void step_ofImpulseModel_isIntegral();
    void figures_ofAllResults_haveUniqueIdsAndTexts();
    void figures_ofPartialResults_areFewer();

private:
    CalibrationResults m_results;
};

void TestCurves::raw_shortRecord_isEverySample()
{
    const dyncal::CaptureSet set
        = captureOf(dyncal::RawSamples(std::vector<std::int16_t>{1, 2, 3}), {0.5, 2.0});
    const PlotContent content = rawCurves(set, ChannelRole::Dut);
    QCOMPARE(content.curves.size(), std::size_t(1));
    QCOMPARE(content.curves[0].y, (std::vector<double>{2.5, 4.5, 6.5}));
    QCOMPARE(content.curves[0].x.front(), -1e-3);
    QVERIFY(rawCurves(set, ChannelRole::Driver).curves.empty());
}

void TestCurves::raw_longRecord_keepsSpikeInFewPoints()
{
    std::vector<std::int16_t> counts(1000003, 7);
    counts[777777] = 9999;
    counts[1000002] = -300;
    const PlotContent content
        = rawCurves(captureOf(dyncal::RawSamples(std::move(counts)), {0.0, 1.0}), ChannelRole::Dut);
    const PlotCurve &curve = content.curves[0];
    QVERIFY(curve.x.size() <= 2 * static_cast<std::size_t>(dyncal::kRawColumns));
    QCOMPARE(largest(curve), 9999.0);
    QCOMPARE(smallest(curve), -300.0);
    QVERIFY(std::is_sorted(curve.x.begin(), curve.x.end()));
    const auto spike = std::max_element(curve.y.begin(), curve.y.end()) - curve.y.begin();
    QVERIFY(std::abs(curve.x[static_cast<std::size_t>(spike)] - (-1e-3 + 0.777777)) < 2.6e-4);
}

void TestCurves::raw_invertedAndCurvedConversion_keepsExtremes()
{
    std::vector<std::int16_t> counts(20000, 0);
    counts[5] = 10;
    counts[6] = -10;
    const dyncal::CaptureSet inverted
        = captureOf(dyncal::RawSamples(counts), std::vector<double>{0.0, -2.0});
    const PlotCurve line = rawCurves(inverted, ChannelRole::Dut).curves[0];
    QCOMPARE(largest(line), 20.0);
    QCOMPARE(smallest(line), -20.0);
    const dyncal::CaptureSet curved
        = captureOf(dyncal::RawSamples(counts), std::vector<double>{3.0, 0.0, -1.0});
    const PlotCurve parabola = rawCurves(curved, ChannelRole::Dut).curves[0];
    QCOMPARE(largest(parabola), 3.0); // at count 0, neither extreme of the counts
    QCOMPARE(smallest(parabola), -97.0);
}

void TestCurves::raw_excludedShot_isLeftOut()
{
    dyncal::CaptureSet set = m_results.captures->set;
    set.shots[1].included = false;
    const PlotContent content = rawCurves(set, ChannelRole::Dut);
    QCOMPARE(content.curves.size(), std::size_t(2));
    QCOMPARE(content.curves[1].name, QString("Shot 3 (high)"));
    QCOMPARE(content.curves[1].role, CurveRole::ShotHigh);
}

/// 289 kPa are no 289 kV because another shot is in volts.
void TestCurves::raw_unitsThatDiffer_haveAPlotEach()
{
    dyncal::CaptureSet set
        = captureOf(dyncal::RawSamples(std::vector<std::int16_t>{1, 2, 3}), {0.0, 1.0});
    set.shots.push_back(set.shots.front());
    set.shots.push_back(set.shots.front());
    set.shots[0].channels[0].unit = "V";
    set.shots[1].channels[0].unit = "Pa";
    set.shots[2].channels[0].unit = "V";
    QCOMPARE(dyncal::unitsOf(set, ChannelRole::Dut), (std::vector<std::string>{"V", "Pa"}));
    const PlotContent volts = rawCurves(set, ChannelRole::Dut);
    QCOMPARE(volts.yAxis.unit, QString("V"));
    QCOMPARE(volts.curves.size(), std::size_t(2));
    const PlotContent pascals = rawCurves(set, ChannelRole::Dut, {}, "Pa");
    QCOMPARE(pascals.yAxis.unit, QString("Pa"));
    QCOMPARE(pascals.curves.size(), std::size_t(1));
    QVERIFY(pascals.curves[0].name != volts.curves[0].name);
    set.shots[1].included = false;
    QCOMPARE(dyncal::unitsOf(set, ChannelRole::Dut), std::vector<std::string>{"V"});
}

void TestCurves::window_times_areRelativeToStart()
{
    const PlotContent content = windowCurves(*m_results.window);
    const auto &response = m_results.window->responses[0];
    const PlotCurve &curve = content.curves[0];
    QCOMPARE(curve.x.size(), static_cast<std::size_t>(response.lead + response.length));
    QVERIFY(std::abs(curve.x[static_cast<std::size_t>(response.lead)]) < 1e-15);
    QCOMPARE(
        curve.y[static_cast<std::size_t>(response.lead) + 7], response.values[response.lead + 7]);
    QVERIFY(content.yAxis.unit.isEmpty()); // remapped
    dyncal::WindowResult plain = *m_results.window;
    for (auto &one : plain.responses)
        one.valueScale = 1.0;
    QCOMPARE(windowCurves(plain).yAxis.unit, QString("V"));
}

void TestCurves::start_zoom_coversTwentyRiseTimes()
{
    const PlotContent content = startCurves(*m_results.window);
    const PlotCurve &curve = content.curves[0];
    QVERIFY(curve.x.front() < 0.0);
    QVERIFY(std::abs(curve.x.back() - 20 * 7.2e-8) < 5e-8);
}

void TestCurves::spectrum_decibels_andResonanceMark()
{
    dyncal::SpectrumResult spectrum = *m_results.spectrum;
    spectrum.perShot[0].psd[3] = 0.0;
    const PlotContent content = spectrumCurves(spectrum, *m_results.window);
    QVERIFY(content.xAxis.logarithmic);
    QVERIFY(std::isnan(content.curves[0].y[3]));
    QCOMPARE(content.curves[1].y[5], 10.0 * std::log10(spectrum.perShot[1].psd[5]));
    QCOMPARE(content.marks.size(), std::size_t(1));
    QCOMPARE(content.marks[0].x, dyncal::example::kF0_Hz);
    QVERIFY(content.marks[0].label.contains("2.330"));
    QVERIFY(content.summary.contains("2.330"));
}

/// A point picked on the shape must be one of the spectrum, and the highest must be among them.
void TestCurves::spectra_manyPoints_shapeHoldsTruePoints()
{
    constexpr Eigen::Index kCount = 50000;
    constexpr Eigen::Index kPeak = 31234;
    dyncal::PowerSpectrum spectrum;
    spectrum.frequency_Hz = Eigen::VectorXd::LinSpaced(kCount, 0.0, 50e6);
    spectrum.psd = Eigen::VectorXd::Ones(kCount);
    spectrum.psd[kPeak] = 100.0;
    const auto curves = dyncal::spectraOfShots(
        {{"Shot 1", dyncal::CurveRole::ShotLow}, {"Shot 2", dyncal::CurveRole::ShotHigh}},
        {&spectrum, &spectrum});
    QCOMPARE(curves.size(), std::size_t(4)); // all values of both, then both shapes on top
    QVERIFY(curves[0].inLegend && !curves[1].inLegend);
    const PlotCurve &shape = curves[2];
    QCOMPARE(shape.name, QString("Shot 1"));
    QVERIFY(shape.x.size() <= 1001);
    const auto top = std::max_element(shape.y.begin(), shape.y.end());
    QCOMPARE(*top, 20.0);
    QCOMPARE(
        shape.x[static_cast<std::size_t>(top - shape.y.begin())], spectrum.frequency_Hz[kPeak]);
    QVERIFY(std::is_sorted(shape.x.begin(), shape.x.end()));
    QVERIFY(shape.x.front() > 0.0); // no place for 0 Hz on a logarithmic axis
}

void TestCurves::components_barsAndBounds()
{
    const PlotContent explained = explainedCurves(*m_results.components);
    QCOMPARE(explained.curves[0].style, CurveStyle::Bars);
    QCOMPARE(explained.curves[0].y, (std::vector<double>{99.886, 99.95, 100.0}));
    QCOMPARE(explained.levels[0].y, 95.0);
    const PlotContent residual = residualCurves(*m_results.components, *m_results.window);
    QCOMPARE(residual.curves[1].y[10],
        m_results.components->responses(10, 1) - m_results.components->reconstructions(10, 1));
    const PlotContent spectrum = residualSpectrumCurves(*m_results.components, *m_results.window);
    QCOMPARE(spectrum.curves.size(), std::size_t(3));
    QCOMPARE(spectrum.marks.size(), std::size_t(1)); // 6.8 kHz in all three shots
    const PlotContent average = averageCurves(*m_results.components, *m_results.window);
    QCOMPARE(average.curves[0].role, CurveRole::Mean);
}

void TestCurves::components_oneShot_explainsItself()
{
    dyncal::ComponentResult components = *m_results.components;
    components.principal.reset();
    const PlotContent content = explainedCurves(components);
    QVERIFY(content.curves.empty());
    QVERIFY(content.summary.contains("One shot"));
}

void TestCurves::autocovariance_oneShot_showsThatAlone()
{
    const PlotContent all = autocovarianceCurves(*m_results.components, *m_results.window);
    QCOMPARE(all.curves.size(), std::size_t(3));
    QCOMPARE(all.levels.size(), std::size_t(2));
    QCOMPARE(all.levels[0].y, -all.levels[1].y);
    const PlotContent one = autocovarianceCurves(*m_results.components, *m_results.window, 2);
    QCOMPARE(one.curves.size(), std::size_t(1));
    QVERIFY(one.title.contains("Shot 2 (medium)"));
}

void TestCurves::modelInput_samples_lieOnFullRate()
{
    const PlotContent content = modelInputCurves(*m_results.input, *m_results.window);
    QCOMPARE(content.curves.size(), std::size_t(6));
    QCOMPARE(content.curves[3].style, CurveStyle::Markers);
    QCOMPARE(content.curves[3].x.front(), m_results.input->offset_s);
    // The resampled values must lie on the full-rate curve, within the noise of both.
    const PlotCurve &full = content.curves[0];
    const PlotCurve &samples = content.curves[3];
    for (std::size_t i = 0; i < samples.x.size(); ++i) {
        const auto at = static_cast<std::size_t>(std::lround(samples.x[i] * 50e6));
        if (at < full.y.size())
            QVERIFY(std::abs(full.y[at] - samples.y[i]) < 12.0 * dyncal::example::kNoise);
    }
}

void TestCurves::singularValues_markAndFloor()
{
    const auto &decomposition = *m_results.decomposition;
    const PlotContent content = singularValueCurves(
        decomposition.hankel, decomposition.suggestion, ResponseTreatment::StepDeflated);
    QVERIFY(content.yAxis.logarithmic);
    QVERIFY(content.xAxis.integers);
    QCOMPARE(content.curves.size(), std::size_t(1));
    QCOMPARE(content.curves[0].x.front(), 1.0);
    QCOMPARE(content.marks[0].x, 2.0);
    QCOMPARE(content.levels[0].y, 55.0);
}

void TestCurves::singularValues_thesisMode_marksStep()
{
    dyncal::HankelDecomposition hankel = m_results.decomposition->hankel;
    hankel.leftVectors = Eigen::MatrixXd::Zero(100, 3);
    hankel.leftVectors(3, 0) = 1.0;
    hankel.leftVectors.col(1).setConstant(-0.1);
    const auto content = singularValueCurves(
        hankel, m_results.decomposition->suggestion, ResponseTreatment::StepAsImpulse);
    QCOMPARE(content.curves.size(), std::size_t(2));
    QCOMPARE(content.curves[1].role, CurveRole::StepPole);
    QCOMPARE(content.curves[1].x, (std::vector<double>{2.0}));
    QCOMPARE(
        content.curves[0].x.size() + 1, static_cast<std::size_t>(hankel.singularValues.size()));
    QVERIFY(!stepValue(hankel, ResponseTreatment::StepDeflated));
    hankel.leftVectors.col(1).head(50).setConstant(0.1); // changes sign: no constant any more
    QVERIFY(!stepValue(hankel, ResponseTreatment::StepAsImpulse));
}

void TestCurves::bic_empty_hasNoCurve()
{
    QVERIFY(bicCurves({}).curves.empty());
    QVERIFY(bicCurves({}).marks.empty());
    const PlotContent content = bicCurves(m_results.decomposition->suggestion);
    QCOMPARE(content.curves[0].x.size(), std::size_t(20));
    QCOMPARE(content.marks[0].x, 2.0);
}

void TestCurves::simulation_diverging_isClippedAndSaid()
{
    dyncal::SensorModel model = *m_results.model;
    model.diverges = true;
    model.series[0].simulated[5] = 1e300;
    model.series[0].simulated[6] = std::numeric_limits<double>::infinity();
    const PlotContent content = simulationCurves(*m_results.input, model, *m_results.window);
    QVERIFY(content.title.contains("diverges"));
    const PlotCurve &data = content.curves[0];
    const PlotCurve &simulated = content.curves[3];
    const double range = largest(data) - smallest(data);
    QVERIFY(std::abs(simulated.y[5] - (largest(data) + 0.5 * range)) < 1e-12);
    QVERIFY(std::isnan(simulated.y[6]));
    // Without divergence nothing is clipped: what the model says is what is drawn.
    const PlotContent honest
        = simulationCurves(*m_results.input, *m_results.model, *m_results.window);
    QVERIFY(!honest.title.contains("diverges"));
    QCOMPARE(honest.curves[3].y[5], m_results.model->series[0].simulated[5]);
}

void TestCurves::simulation_oneSeries_showsTwoCurves()
{
    const PlotContent content
        = simulationCurves(*m_results.input, *m_results.model, *m_results.window, 1);
    QCOMPARE(content.curves.size(), std::size_t(2));
    QCOMPARE(content.curves[0].role, CurveRole::ShotMedium);
    QCOMPARE(content.curves[1].role, CurveRole::Model);
    QVERIFY(content.curves[1].inLegend);
    QVERIFY(content.summary.contains("98.76"));
    const PlotContent errors = errorCurves(*m_results.input, *m_results.model, *m_results.window);
    QCOMPARE(errors.curves.size(), std::size_t(3));
}

void TestCurves::poleZero_classes_haveOwnMarkers()
{
    dyncal::SensorModel model = *m_results.model;
    for (const auto poleClass : {dyncal::PoleClass::Step, dyncal::PoleClass::Nyquist,
             dyncal::PoleClass::Unstable, dyncal::PoleClass::Other}) {
        dyncal::Pole pole;
        pole.z = {1.3, 0.0};
        pole.poleClass = poleClass;
        model.poles.push_back(pole);
    }
    const PlotContent content = poleZeroCurves(model);
    std::set<CurveRole> roles;
    for (const PlotCurve &curve : content.curves)
        QVERIFY(roles.insert(curve.role).second);
    QCOMPARE(roles.size(), std::size_t(6)); // five classes and the zeros
    QVERIFY(content.equalAspect && content.unitCircle);
    QVERIFY(*content.xMax > 1.3 && *content.xMax < 2.0); // the zero at 3.7 does not stretch it
    QVERIFY(content.summary.contains("further out"));
}

void TestCurves::bode_units_andBars()
{
    const PlotContent magnitude = bodeMagnitudeCurves(*m_results.response);
    QVERIFY(magnitude.xAxis.logarithmic && magnitude.yAxis.logarithmic);
    QCOMPARE(magnitude.yAxis.unit, QString("V/Pa"));
    QCOMPARE(magnitude.curves.size(), std::size_t(3));
    const PlotCurve &bars = magnitude.curves[1];
    QVERIFY(std::abs(bars.y[1] - bars.y[0] - 4.0 * m_results.response->u_magnitude[0]) < 1e-15);
    QVERIFY(std::isnan(bars.y[2])); // bars are not joined
    const PlotContent phase = bodePhaseCurves(*m_results.response);
    const PlotCurve &dots = phase.curves[2];
    QVERIFY(std::abs(dots.y[3] - m_results.response->phase_rad[3] * 180.0 / M_PI) < 1e-12);
    dyncal::ResponseResult relative = *m_results.response;
    relative.unit = "1";
    relative.u_magnitude.resize(0);
    QVERIFY(bodeMagnitudeCurves(relative).yAxis.unit.isEmpty());
    QCOMPARE(bodeMagnitudeCurves(relative).curves.size(), std::size_t(2));
}

void TestCurves::bode_saysWhatIsWithheld()
{
    dyncal::ResponseResult response = *m_results.response;
    QVERIFY(!bodeMagnitudeCurves(response).summary.contains("withheld"));
    response.withheld.assign(
        static_cast<std::size_t>(response.frequency_Hz.size()), dyncal::WithheldReason::None);
    QVERIFY(!bodePhaseCurves(response).summary.contains("withheld"));
    response.withheld[0] = dyncal::WithheldReason::Alias;
    response.withheld[1] = dyncal::WithheldReason::End;
    response.magnitude.head(2).setConstant(std::nan(""));
    const QString words
        = QString("withheld: 2 of %1").arg(static_cast<int>(response.withheld.size()));
    QVERIFY(bodeMagnitudeCurves(response).summary.contains(words));
    QVERIFY(bodePhaseCurves(response).summary.contains(words));
}

void TestCurves::step_ofModel_followsClosedForm()
{
    const PlotContent content = stepCurves(*m_results.model, ResponseTreatment::StepDeflated);
    const PlotCurve &curve = content.curves[0];
    QVERIFY(std::abs(curve.y.front()) < 1e-12);
    for (std::size_t i = 0; i < curve.x.size(); i += 37)
        QVERIFY(std::abs(curve.y[i] - dyncal::example::stepResponse(curve.x[i])) < 1e-12);
    QVERIFY(std::abs(curve.y.back() - 1.0) < 0.01);
}

/// Words without numbers: these stand with their U among the key results.
void TestCurves::step_hasLinesForItsOvershoot()
{
    const auto &response = m_results.response;
    const auto stated = dyncal::statedCharacteristics(*response).overshoot_percent.value;
    QVERIFY(stated);
    const PlotContent content
        = stepCurves(*m_results.model, ResponseTreatment::StepDeflated, response.get());
    QCOMPARE(content.levels.size(), std::size_t(2));
    QVERIFY(std::abs(content.levels[0].y - 1.0) < 1e-6);
    const auto &y = content.curves[0].y;
    QVERIFY(std::abs(content.levels[1].y - *std::ranges::max_element(y)) < 0.01);
    for (const auto &level : content.levels)
        QVERIFY(!level.label.isEmpty() && !level.label.contains(QRegularExpression("\\d")));
    dyncal::ResponseResult none = *response;
    none.characteristics = {};
    QVERIFY(stepCurves(*m_results.model, ResponseTreatment::StepDeflated, &none).levels.empty());
}

void TestCurves::phase_withAnotherZeroThanTheModels_saysSo()
{
    dyncal::ResponseResult response = *m_results.response;
    QCOMPARE(bodePhaseCurves(response).curves[0].name, QString("Model"));
    response.isByTransducer = true;
    QCOMPARE(bodePhaseCurves(response).curves[0].name, QString("Model, from its own onset"));
}

void TestCurves::step_ofImpulseModel_isIntegral()
{
    // Impulse response c e^(st) + conj: its integral is Re(2 c (e^(st) - 1)/s).
    dyncal::SensorModel model = *m_results.model;
    model.plateauGain = 0.0;
    const std::complex<double> s = dyncal::example::pole_rad_s();
    const std::complex<double> c(0.0, -1e7);
    model.amplitudes = Eigen::Vector2cd(c, std::conj(c));
    const PlotCurve curve = stepCurves(model, ResponseTreatment::Impulse).curves[0];
    for (std::size_t i = 0; i < curve.x.size(); i += 37) {
        const double expected = 2.0 * (c * (std::exp(s * curve.x[i]) - 1.0) / s).real();
        QVERIFY(std::abs(curve.y[i] - expected) < 1e-12);
    }
}

void TestCurves::figures_ofAllResults_haveUniqueIdsAndTexts()
{
    const auto figures = reportFigures(m_results);
    std::set<std::string> ids;
    for (const auto &figure : figures) {
        QVERIFY2(ids.insert(figure.id).second, figure.id.c_str());
        QVERIFY2(!figure.content.title.isEmpty(), figure.id.c_str());
        QVERIFY2(!figure.content.summary.isEmpty(), figure.id.c_str());
        QVERIFY2(!figure.content.xAxis.quantity.isEmpty(), figure.id.c_str());
        for (const PlotCurve &curve : figure.content.curves)
            QVERIFY2(curve.x.size() == curve.y.size() && !curve.x.empty(), figure.id.c_str());
    }
    for (const char *id : {"singular-values", "model-data", "model-error", "magnitude", "phase",
             "spectrum", "pole-zero"})
        QVERIFY2(findFigure(figures, id), id);
}

void TestCurves::figures_ofPartialResults_areFewer()
{
    QVERIFY(reportFigures({}).empty());
    CalibrationResults partial;
    partial.captures = m_results.captures;
    QCOMPARE(reportFigures(partial).size(), std::size_t(1));
    partial.window = m_results.window;
    QCOMPARE(reportFigures(partial).size(), std::size_t(3));
}

DYNCAL_TEST(TestCurves)
#include "tst_curves.moc"
