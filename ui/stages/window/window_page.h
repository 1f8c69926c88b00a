// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/stage_page.h"

class QCheckBox;
class QComboBox;

namespace dyncal {

class AutoEdit;
class IntervalEdit;
class StretchMarking;
class ValueTable;

/// Stage 3: where the response starts and ends, and the bands that give its two levels.
class WindowPage : public StagePage
{
    Q_OBJECT

public:
    explicit WindowPage(Session &session);

protected:
    void showRecipe() override;
    void showResults() override;

private:
    void buildPlots();
    void buildInspector();
    void buildStartControls();
    void connectHandles();
    void moveBand(const QString &id, Interval band, bool finished);
    void moveLine(const QString &id, double time_s, bool finished);
    void shiftStarts(double by_s);
    void setStart(const Auto<double> &start_s);
    void buildEndControls();
    void chooseEnds(bool own);
    Index chosenShot() const;
    void showHandles();
    void showGuard(const WindowedResponse &response);
    void showLength();
    void showTable();
    const WindowedResponse *firstResponse() const;
    const WindowedResponse *responseOfChosenShot() const;

    PlotWidget *m_plot;
    PlotWidget *m_detail;
    ValueTable *m_table;
    StretchMarking *m_stretches;

    QComboBox *m_startShot;
    AutoEdit *m_start;
    QCheckBox *m_subtract;
    IntervalEdit *m_baseline;
    QComboBox *m_endFor; ///< all shots, or each by itself
    AutoEdit *m_end;
    QLabel *m_common; ///< whose end it is
    QCheckBox *m_plateau;
    IntervalEdit *m_settle;
    QCheckBox *m_remap;
    QLabel *m_length;
    QLabel *m_resolution;
};

} // namespace dyncal
