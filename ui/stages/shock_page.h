// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/quantity_edit.h"
#include "ui/stages/shock_tables.h"
#include "ui/stages/stage_page.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QTabWidget;

namespace dyncal {

class GasEdit;
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
    void buildPlots();
    ValueTable *addTable(const QString &title, const QString &objectName);
    void buildReferenceControls();
    void buildArrivalControls();
    void buildGasControls();
    void buildTubeControls();
    void addOptional(OptionalEdit *&edit, const QString &label, const QString &name,
        OptionalEdit *control, std::optional<double> ShockSettings::*member);

    /// The shot on show, and its number (0 = none).
    const ShockConditions *shownShot() const;
    Index shownNumber() const;
    /// The sensors as the recipe has them, else as the recording describes them.
    std::vector<ArrivalSensor> sensors() const;
    std::size_t shownSensor() const;
    /// The channel on show: an arrival sensor's, or the DUT's behind the last of them.
    const Channel *shownChannel() const;

    void editSensor(const QString &label, const std::function<void(ArrivalSensor &)> &edit,
        const QString &mergeKey = {});
    void setDistance(const std::optional<double> &distance_m);
    void addSensor();
    void removeSensor();
    void setArrival(const std::optional<double> &arrival_s, const QString &mergeKey = {});
    void moveArrival(double time_s, bool finished);

    void showShots();
    void showSensors();
    void showSensorFields();
    void showArrival();
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
    QComboBox *m_sensor;
    QComboBox *m_sideChannel;
    OptionalEdit *m_distance;
    OptionalEdit *m_distanceUncertainty;
    AutoEdit *m_arrival;
    QLabel *m_arrivalUncertainty;
    OptionalEdit *m_delay;
    QPushButton *m_addSensor;
    QPushButton *m_removeSensor;
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
    OptionalEdit *m_guard;
    QString m_fittedView; ///< shot and channel that the record's view was last fitted to
    bool m_dragging = false;
};

} // namespace dyncal
