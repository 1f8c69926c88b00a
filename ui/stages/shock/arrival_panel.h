// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_conditions.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/session/session.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/quantity_edit.h"

#include <functional>

class QComboBox;
class QLabel;
class QPushButton;

namespace dyncal {

class InspectorForm;

/// Where and when the shock was seen: the arrival sensors' controls in the inspector of the shock
/// page, and the record of the chosen one with its arrival as a cursor.
class ArrivalPanel : public QObject
{
    Q_OBJECT

public:
    ArrivalPanel(Session &session, InspectorForm &form, PlotWidget &record, QObject *parent);

    /// Number of the shot on show, 0 = none.
    void setShot(Index shot) { m_shot = shot; }
    void showSensors();
    void showRecord();

private:
    void build(InspectorForm *form);

    const ShockConditions *shownShot() const;
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
    void showFields();

    Session &m_session;
    PlotWidget &m_record;
    Index m_shot = 0;
    QComboBox *m_sensor;
    QComboBox *m_channel;
    OptionalEdit *m_distance;
    OptionalEdit *m_distanceUncertainty;
    AutoEdit *m_arrival;
    QLabel *m_arrivalUncertainty;
    QLabel *m_delayUncertainty;
    OptionalEdit *m_delay;
    QPushButton *m_addSensor;
    QPushButton *m_removeSensor;
    QString m_fittedView; ///< shot and channel that the record's view was last fitted to
};

} // namespace dyncal
