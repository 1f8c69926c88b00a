// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/stage_page.h"

class QSplitter;

namespace dyncal {

class KnownPanel;
class Prompts;
class ReferencePanel;
class ValueTable;

/// Stage 11: what S(f) is related to besides the pressure step. A reference transducer beside the
/// sensor, S(f) against it and against the step; values of other calibrations beside S(f); and the
/// chain's response, divided out of S(f).
class ComparisonPage : public StagePage
{
    Q_OBJECT

public:
    ComparisonPage(Session &session, Prompts &prompts);

protected:
    void showRecipe() override { } // every control follows the recipe by itself
    void showResults() override;

private:
    void buildContent();
    QLabel *addSentence(const char *objectName);
    void buildInspector(Prompts &prompts);
    void showTables(const ComparisonResult *comparison);
    void showPlots(const ComparisonResult *comparison);

    QLabel *m_verdict;
    QLabel *m_advice;
    PlotWidget *m_magnitude;
    PlotWidget *m_deviation;
    PlotWidget *m_error;
    ValueTable *m_table;
    ValueTable *m_knownTable;
    QSplitter *m_all; ///< plots and tables
    KnownPanel *m_known;
};

} // namespace dyncal
