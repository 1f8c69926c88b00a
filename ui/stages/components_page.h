// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/stage_page.h"

class QComboBox;

namespace dyncal {

class TubeModeChoice;
class ValueTable;

/// Stage 5: what the shots share (principal components), and what is left of each.
class ComponentsPage : public StagePage
{
    Q_OBJECT

public:
    explicit ComponentsPage(Session &session);

protected:
    void showRecipe() override;
    void showResults() override;

private:
    void buildPlots();
    void buildInspector();
    void showOfShots(); ///< the plots that have a curve for each shot

    PlotWidget *m_explained;
    PlotWidget *m_reconstruction;
    PlotWidget *m_residual;
    PlotWidget *m_autocovariance;
    PlotWidget *m_spectrum;
    ValueTable *m_table;
    QComboBox *m_confidence;
    QLabel *m_first;
    TubeModeChoice *m_tubeModes;
};

} // namespace dyncal
