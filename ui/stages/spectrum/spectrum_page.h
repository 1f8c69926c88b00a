// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/stage_page.h"

class QComboBox;
class QPushButton;

namespace dyncal {

class NuisanceList;
class OptionalEdit;
class QuantityEdit;
class TubeModeChoice;
class ValueTable;

/// Stage 4: power spectra of the shots and the resonances they share.
class SpectrumPage : public StagePage
{
    Q_OBJECT

public:
    explicit SpectrumPage(Session &session);

protected:
    void showRecipe() override;
    void showResults() override;

private:
    void buildInspector();
    void buildNuisance();
    void setSource(int choice);
    void setBand(bool begin, const std::optional<double> &frequency_Hz);
    void giveResonance(double frequency_Hz);
    void showPlot();

    PlotWidget *m_plot;
    ValueTable *m_table;
    QComboBox *m_source;
    QuantityEdit *m_frequency;
    OptionalEdit *m_bandBegin;
    OptionalEdit *m_bandEnd;
    QComboBox *m_taper;
    QComboBox *m_method;
    QComboBox *m_detrend;
    NuisanceList *m_nuisance;
    TubeModeChoice *m_tubeModes;
};

} // namespace dyncal
