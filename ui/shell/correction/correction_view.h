// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/shared_cursors.h"
#include "ui/shell/correction/correction_task.h"
#include "ui/stages/frame/plot_filling.h"
#include "ui/stages/frame/plot_tools.h"

#include <QWidget>

class QLabel;
class QListWidget;

namespace dyncal {

class ValueTable;

/// What a correction gave: the recorded signals above the pressure with its band, what the filter
/// is, a row for each shot, and all that is to be known of recordings and calibration.
class CorrectionView : public QWidget
{
    Q_OBJECT

public:
    explicit CorrectionView(SharedCursors &cursors, QWidget *parent = nullptr);

    void showReport(const CorrectionReport &report);
    /// Why what is on show is out of date; empty where it is not.
    void setNotice(const QString &sentence);

private:
    PlotWidget *addPlot(const QString &objectName, const QString &name, SharedCursors &cursors);
    void showPlots(const CorrectionReport &report);
    void showShots(const CorrectionOutcome &outcome);
    void showFindings(const CorrectionReport &report);

    PlotTools *m_tools;
    PlotWidget *m_recorded;
    PlotWidget *m_pressure;
    PlotFilling *m_fillRecorded;
    PlotFilling *m_fillPressure;
    QLabel *m_filter;
    ValueTable *m_shots;
    QListWidget *m_findings;
};

} // namespace dyncal
