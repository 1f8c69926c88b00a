// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/stage_page.h"

namespace dyncal {

class TubeModeChoice;
class ValueTable;

/// Stage 8: how well the model describes the data, and what it says about the sensor.
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
    void buildInspector();
    void showCharacteristics();

    PlotWidget *m_fit;
    PlotWidget *m_error;
    PlotWidget *m_magnitude;
    PlotWidget *m_phase;
    PlotWidget *m_poles;
    ValueTable *m_table;
    QLabel *m_order;
    QLabel *m_score;
    QLabel *m_perShot;
    QLabel *m_listing;
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
