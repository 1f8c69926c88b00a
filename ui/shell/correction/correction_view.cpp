// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/correction/correction_view.h"

#include "ui/plot/curves/pressure_curves.h"
#include "ui/plot/curves/signal_curves.h"
#include "ui/stages/frame/layout_scale.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/frame/wrapped_controls.h"
#include "ui/text/finding_group.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QListWidget>
#include <QSplitter>
#include <QVBoxLayout>

namespace dyncal {

namespace {

constexpr int kUDigits = 2;
constexpr int kFactorDigits = 3;
constexpr int kTableHeight = 90;
constexpr int kFindingsHeight = 70;

/// Read here and now, for views down to single samples.
std::shared_ptr<const ChannelEnvelope> envelopeOf(const Channel &channel)
{
    auto envelope = ChannelEnvelope::build(channel);
    return envelope ? std::make_shared<const ChannelEnvelope>(std::move(*envelope)) : nullptr;
}

Index samplesOf(const CaptureSet &captures)
{
    Index samples = 0;
    for (const Shot &shot : captures.shots)
        if (const Channel *channel = shot.channelWithRole(ChannelRole::Dut))
            samples += channel->samples.size();
    return samples;
}

/// "V" of "Pa/V"
QString recordedUnit(const CorrectionFilter &filter)
{
    return shownText(filter.unit).section(QLatin1Char('/'), 1);
}

QStringList rowOf(const ShotPressure &shot, const CorrectionFilter &filter)
{
    const CorrectedPressure &pressure = shot.record.pressure;
    const QString Pa = QStringLiteral("Pa");
    Index at = 0;
    pressure.pressure_Pa.cwiseAbs().maxCoeff(&at);
    const double largest_Pa = pressure.pressure_Pa[at];
    const double U_Pa = pressure.k[at] * pressure.u_Pa[at];
    const ShownResult largest = shownResult(largest_Pa, U_Pa, Pa);
    return {QString::number(shot.shot), shownText(shot.channel), largest.value, largest.u,
        shownNumber(pressure.k[at], kFactorDigits),
        shownQuantity(
            pressure.time_s + static_cast<double>(at) / pressure.rate_Hz, QStringLiteral("s")),
        shownQuantity(pressure.u_noise_Pa, Pa, kUDigits),
        shownQuantity(pressure.bound_Pa.maxCoeff(), Pa, kUDigits),
        shownQuantity(shot.record.level, recordedUnit(filter))};
}

QString filterSentence(const CorrectionFilter &filter)
{
    const QString Hz = QStringLiteral("Hz");
    return CorrectionView::tr(
        "Filter: the pressure from 0 to %1, nothing of it beyond %2; delay %3 (%4 samples of %5), which the times are without; gain %6 at 0 Hz; noise is amplified up to %7 times.")
        .arg(shownQuantity(filter.lowPass.band_Hz, Hz), shownQuantity(filter.lowPass.edge_Hz, Hz),
            shownQuantity(filter.delay_s(), QStringLiteral("s")),
            QString::number(filter.delaySamples), QString::number(filter.taps.size()),
            shownQuantity(filter.gain(), shownText(filter.unit)),
            shownNumber(filter.noiseAmplification(), kFactorDigits));
}

} // namespace

CorrectionView::CorrectionView(SharedCursors &cursors, QWidget *parent)
    : QWidget(parent)
    , m_tools(new PlotTools(this))
    , m_recorded(addPlot("correctionRecordedPlot", tr("Recorded signal"), cursors))
    , m_pressure(addPlot("correctionPressurePlot", tr("Pressure behind the recording"), cursors))
    , m_fillRecorded(new PlotFilling(m_recorded))
    , m_fillPressure(new PlotFilling(m_pressure))
    , m_filter(new FormLabel({}, this))
    , m_shots(new ValueTable("correctionShots", tr("Corrected shots"), this))
    , m_findings(new QListWidget(this))
{
    auto *plots = new QSplitter(Qt::Vertical, this);
    plots->setChildrenCollapsible(false);
    plots->addWidget(m_recorded);
    plots->addWidget(m_pressure);
    m_filter->setObjectName("correctionFilter");
    m_filter->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_shots->setFixedHeight(kTableHeight);
    m_findings->setObjectName("correctionFindings");
    m_findings->setAccessibleName(tr("Findings of recordings and calibration"));
    m_findings->setWordWrap(true);
    m_findings->setFixedHeight(kFindingsHeight);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(scale::kSmall);
    column->addWidget(plots, 1);
    for (QWidget *widget : {static_cast<QWidget *>(m_filter), static_cast<QWidget *>(m_shots),
             static_cast<QWidget *>(m_findings)}) {
        column->addWidget(widget);
        widget->hide();
    }
}

PlotWidget *CorrectionView::addPlot(
    const QString &objectName, const QString &name, SharedCursors &cursors)
{
    auto *plot = new PlotWidget(this);
    plot->setObjectName(objectName);
    plot->setAccessibleName(name);
    PlotContent nothing;
    nothing.title = name;
    plot->setContent(nothing);
    m_tools->attach(plot);
    PlotTools::share(plot, &cursors);
    return plot;
}

void CorrectionView::showReport(const CorrectionReport &report)
{
    showPlots(report);
    m_filter->setVisible(report.outcome != nullptr);
    m_shots->setVisible(report.outcome != nullptr);
    if (report.outcome) {
        m_filter->setText(filterSentence(report.outcome->filter));
        showShots(*report.outcome);
    }
    showFindings(report);
}

void CorrectionView::showPlots(const CorrectionReport &report)
{
    m_fillRecorded->show(
        {{report.captures}, samplesOf(*report.captures), [captures = report.captures] {
             return rawCurves(*captures, ChannelRole::Dut, &envelopeOf);
         }});
    PlotContent nothing;
    nothing.title = m_pressure->accessibleName();
    if (!report.outcome)
        m_fillPressure->showAtOnce(nothing);
    else
        m_fillPressure->show({{report.outcome}, pointsOf(*report.outcome),
            [outcome = report.outcome, captures = report.captures] {
                return pressureCurves(*outcome, *captures);
            }});
}

void CorrectionView::showShots(const CorrectionOutcome &outcome)
{
    QVector<QStringList> rows;
    for (const ShotPressure &shot : outcome.shots)
        rows << rowOf(shot, outcome.filter);
    m_shots->setValues(
        {tr("Shot"), tr("Channel"), tr("Largest pressure"), tr("U (95 %)"), tr("k"), tr("At"),
            tr("u by noise"), tr("Bound beyond the band"), tr("Level without pressure")},
        rows);
}

void CorrectionView::showFindings(const CorrectionReport &report)
{
    m_findings->clear();
    QStringList cautions;
    if (report.outcome)
        for (const std::string &id : report.outcome->calibration.says.cautions)
            cautions << shownText(id);
    if (!cautions.isEmpty())
        m_findings->addItem(
            tr("▲ The calibration has cautions, which hold for the correction too: %1.")
                .arg(cautions.join(QStringLiteral(", "))));
    for (const FindingGroup &group : grouped(report.findings))
        m_findings->addItem(groupLine(group));
    m_findings->setVisible(m_findings->count() > 0);
}

void CorrectionView::setNotice(const QString &sentence)
{
    for (PlotWidget *plot : {m_recorded, m_pressure})
        plot->setNotice(sentence, !sentence.isEmpty());
    m_shots->setEnabled(sentence.isEmpty());
    m_filter->setEnabled(sentence.isEmpty());
}

} // namespace dyncal
