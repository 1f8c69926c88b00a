// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/stage_page.h"

class QComboBox;

namespace dyncal {

class AutoEdit;

/// Stage 6: rate, length and treatment of what the identification gets.
class ModelInputPage : public StagePage
{
    Q_OBJECT

public:
    explicit ModelInputPage(Session &session);

protected:
    void showRecipe() override;
    void showResults() override;

private:
    void buildInspector();
    void showSamplesPerPeriod();

    PlotWidget *m_plot;
    QComboBox *m_treatment;
    QComboBox *m_combine;
    AutoEdit *m_rate;
    QLabel *m_perPeriod;
    AutoEdit *m_samples;
    AutoEdit *m_offset;
    QLabel *m_length;
    QLabel *m_lost;
};

} // namespace dyncal
