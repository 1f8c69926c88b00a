// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/batch/batch_model.h"

#include "ui/shell/batch/batch_words.h"
#include "ui/text/shown_text.h"

#include <algorithm>

namespace dyncal {

namespace {

bool areOfSameSensors(const BatchMoment &a, const BatchMoment &b)
{
    return std::ranges::equal(
        a.sensors, b.sensors, {},
        [](const SensorNow &sensor) -> const std::string & { return sensor.standing.id; },
        [](const SensorNow &sensor) -> const std::string & { return sensor.standing.id; });
}

} // namespace

void BatchModel::setMoment(const BatchMoment &moment)
{
    if (!areOfSameSensors(m_moment, moment)) {
        beginResetModel();
        m_moment = moment;
        endResetModel();
        return;
    }
    m_moment.plan = moment.plan;
    for (std::size_t i = 0; i < moment.sensors.size(); ++i) {
        if (m_moment.sensors[i] == moment.sensors[i])
            continue;
        m_moment.sensors[i] = moment.sensors[i];
        const int row = static_cast<int>(i);
        emit dataChanged(index(row, 0), index(row, kColumns - 1));
    }
}

void BatchModel::showWords()
{
    emit headerDataChanged(Qt::Horizontal, 0, kColumns - 1);
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int BatchModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_moment.sensors.size());
}

int BatchModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(kColumns);
}

QString BatchModel::textOf(const SensorNow &sensor, int column) const
{
    const SensorOutcome &record = sensor.standing.record;
    switch (column) {
    case Sensor:
        return shownText(sensor.standing.id);
    case State:
        return stateText(shownState(sensor));
    case Frequency:
        return keyResultText(record, "f0_hz");
    case Damping:
        return keyResultText(record, "damping_ratio");
    case Sensitivity:
        return keyResultText(record, "sensitivity");
    case Worst:
        return worstFindingText(record);
    default:
        return reasonText(record);
    }
}

QVariant BatchModel::data(const QModelIndex &index, int role) const
{
    const bool isNumber = index.column() >= Frequency && index.column() <= Sensitivity;
    switch (role) {
    case Qt::DisplayRole:
        return textOf(sensor(index.row()), index.column());
    case Qt::ToolTipRole:
        return recordText(sensor(index.row()));
    case Qt::TextAlignmentRole:
        return int((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    default:
        return {};
    }
}

QVariant BatchModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    const QString titles[kColumns]{tr("Sensor"), tr("State"), tr("f₀ ± U"), tr("ζ ± U"),
        tr("Sensitivity ± U"), tr("Worst finding"), tr("Reason")};
    return titles[section];
}

} // namespace dyncal
