// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_conditions.h"
#include "ui/session/session.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/quantity_edit.h"

class QCheckBox;

namespace dyncal {

class GasEdit;
class InspectorForm;

/// A number of the recipe's section "shock" that may be left out, in an inspector.
OptionalEdit *addShockNumber(Session &session, InspectorForm &form, const QString &label,
    const QString &objectName, OptionalEdit *control, std::optional<double> ShockSettings::*member);

/// The controls of the gases before the shot and of the tube, in the inspector of the shock page.
class ConditionsPanel : public QObject
{
    Q_OBJECT

public:
    ConditionsPanel(Session &session, InspectorForm &form, QObject *parent);

    /// Shows the recipe; `recording` has what was recorded, `shot` the gases as used (null = none).
    void show(const Shot *recording, const ShockConditions *shot);

private:
    void buildGasControls();
    void buildTubeControls();
    void addAttenuation();
    /// A time of the recipe's section "shock" of which 0 means "none".
    OptionalEdit *addTime(const QString &label, const QString &objectName, const ShownUnit &unit,
        const QString &change, double ShockSettings::*member);

    Session &m_session;
    InspectorForm &m_form;
    OptionalEdit *m_p1;
    OptionalEdit *m_T1;
    OptionalEdit *m_T4;
    GasEdit *m_driven;
    GasEdit *m_driver;
    QCheckBox *m_variable;
    OptionalEdit *m_humidity;
    OptionalEdit *m_dioxide;
    OptionalEdit *m_drivenLength;
    OptionalEdit *m_driverLength;
    OptionalEdit *m_diameter;
    OptionalEdit *m_front;
    OptionalEdit *m_u_front;
    OptionalEdit *m_guard;
    OptionalEdit *m_leastAttenuation = nullptr;
    OptionalEdit *m_largestAttenuation = nullptr;
};

} // namespace dyncal
