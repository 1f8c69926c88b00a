// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/batch/batch_watch.h"

#include <QAbstractTableModel>

namespace dyncal {

/// A batch as a table, one row for each sensor in the order of the plan.
class BatchModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Sensor, State, Frequency, Damping, Sensitivity, Worst, Reason, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// Rows of the same sensors are changed in place, so that selection and place stay.
    void setMoment(const BatchMoment &moment);
    const BatchMoment &moment() const { return m_moment; }
    const SensorNow &sensor(int row) const { return m_moment.sensors[std::size_t(row)]; }
    void showWords(); ///< in the language of the moment

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString textOf(const SensorNow &sensor, int column) const;

    BatchMoment m_moment;
};

} // namespace dyncal
