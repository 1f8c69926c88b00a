// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/stage_page.h"

class QCheckBox;
class QComboBox;

namespace dyncal {

class OptionalEdit;
class QuantityEdit;
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

private:
    void buildInspector();
    void buildReferenceControls();
    void addOptional(OptionalEdit *&edit, const QString &label, const QString &name,
        OptionalEdit *control, std::optional<double> ShockSettings::*member);
    void setDistance(const std::optional<double> &distance_m);
    QVector<QStringList> stateRows() const;
    PlotContent rawSideCurves();
    void showSensitivity();

    PlotWidget *m_side;
    ValueTable *m_states;
    ValueTable *m_sensitivity;
    QLabel *m_reason;
    QCheckBox *m_enabled;
    OptionalEdit *m_step;
    OptionalEdit *m_velocity;
    OptionalEdit *m_p1;
    OptionalEdit *m_T1;
    OptionalEdit *m_T4;
    OptionalEdit *m_humidity;
    QuantityEdit *m_gamma;
    QuantityEdit *m_molarMass;
    QComboBox *m_sideChannel;
    OptionalEdit *m_distance;
    OptionalEdit *m_drivenLength;
    OptionalEdit *m_driverLength;
};

} // namespace dyncal
