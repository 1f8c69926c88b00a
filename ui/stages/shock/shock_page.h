// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/stage_page.h"

class QCheckBox;
class QComboBox;
class QTabWidget;

namespace dyncal {

class ArrivalPanel;
class ConditionsPanel;
class ValueTable;

/// Stage 2: the state of the gas, the shock's velocity, the reference pressure step, and with it
/// the sensitivity.
class ShockPage : public StagePage
{
    Q_OBJECT

public:
    explicit ShockPage(Session &session);

protected:
    void showRecipe() override;
    void showResults() override;
    bool showsOld(StageId from) const override;

private:
    void buildPlots();
    ValueTable *addTable(const QString &title, const QString &objectName);
    void buildReferenceControls();
    OptionalEdit *addTyped(const QString &label, const QString &objectName, OptionalEdit *control,
        PerShot ShockSettings::*member);

    /// The shot on show, and its number (0 = none).
    const ShockConditions *shownShot() const;
    Index shownNumber() const;

    void showShots();
    void showDiagram();
    void showTables();
    void showSensitivity();

    PlotWidget *m_diagram;
    PlotWidget *m_side;
    QTabWidget *m_tabs;
    ValueTable *m_states;
    ValueTable *m_measured;
    ValueTable *m_arrivals;
    ValueTable *m_uncertainty;
    ValueTable *m_budget;
    ValueTable *m_peaks;
    ValueTable *m_sensitivity;
    QLabel *m_reason;
    QComboBox *m_shot;
    QCheckBox *m_enabled;
    OptionalEdit *m_step;
    OptionalEdit *m_velocity;
    ArrivalPanel *m_arrivalPanel;
    ConditionsPanel *m_conditions;
};

} // namespace dyncal
