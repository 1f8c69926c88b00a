// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/stage_page.h"
#include "ui/stages/model/model_tables.h"

class QCheckBox;
class QComboBox;
class QTabWidget;

namespace dyncal {

class TubeModeChoice;
class ValueTable;

/// Stage 8: how well the model describes the data, shot by shot, and what it says about the sensor.
class ModelPage : public StagePage
{
    Q_OBJECT

public:
    explicit ModelPage(Session &session);

protected:
    void showRecipe() override { } ///< nothing is decided here
    void showResults() override;

private:
    void buildPlots();
    QTabWidget *buildTables();
    void buildInspector();
    void showSeries(); ///< the choice of the series itself
    void showTime();
    void showResponse();
    void showTables();
    void showReadouts();
    void showAssessment();
    void showCharacteristics();
    std::optional<std::size_t> series() const; ///< position of the one on show; none: all

    PlotWidget *m_fit;
    PlotWidget *m_error;
    PlotWidget *m_residual;
    PlotWidget *m_magnitude;
    PlotWidget *m_phase;
    PlotWidget *m_poles;
    QTabWidget *m_tabs;
    ValueTable *m_table;
    ValueTable *m_trend;
    ValueTable *m_secondOrder;
    ValueTable *m_nuisance;
    QComboBox *m_series;
    QCheckBox *m_candidates;
    QCheckBox *m_drawSecondOrder;
    QLabel *m_order;
    QLabel *m_score;
    QLabel *m_perShot;
    QLabel *m_listing;
    QLabel *m_uncertainty;
    QLabel *m_shared;
    QLabel *m_second;
    QLabel *m_rise;
    QLabel *m_overshoot;
    QLabel *m_settling;
    QLabel *m_within5;
    QLabel *m_within10;
    QLabel *m_minus3;
    QLabel *m_band;
    TubeModeChoice *m_tubeModes;
};

} // namespace dyncal
