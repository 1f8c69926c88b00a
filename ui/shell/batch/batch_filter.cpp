// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/batch/batch_filter.h"

#include "ui/shell/batch/batch_model.h"
#include "ui/shell/batch/batch_words.h"
#include "ui/text/shown_text.h"

#include <algorithm>
#include <limits>

namespace dyncal {

namespace {

/// Sensors without the result come last.
double valueOf(const SensorNow &sensor, const char *quantity)
{
    const auto &results = sensor.standing.record.results;
    const auto found = std::ranges::find(results, quantity, &StatedResult::quantity);
    return found == results.end() ? std::numeric_limits<double>::infinity() : found->value;
}

} // namespace

BatchFilter::BatchFilter(BatchModel &model, QObject *parent)
    : QSortFilterProxyModel(parent)
    , m_model(model)
{
    setSourceModel(&model);
    setDynamicSortFilter(true);
}

void BatchFilter::setText(const QString &text)
{
    m_text = text.trimmed();
    invalidateFilter();
}

void BatchFilter::setState(std::optional<ShownState> state)
{
    m_state = state;
    invalidateFilter();
}

bool BatchFilter::filterAcceptsRow(int row, const QModelIndex &) const
{
    const SensorNow &sensor = m_model.sensor(row);
    if (m_state && shownState(sensor) != *m_state)
        return false;
    const auto holds
        = [this](const QString &text) { return text.contains(m_text, Qt::CaseInsensitive); };
    const SensorOutcome &record = sensor.standing.record;
    return m_text.isEmpty() || holds(shownText(sensor.standing.id)) || holds(reasonText(record))
        || std::ranges::any_of(
            record.findings, [&](const FindingMark &mark) { return holds(shownText(mark.id)); });
}

bool BatchFilter::lessThan(const QModelIndex &left, const QModelIndex &right) const
{
    const SensorNow &a = m_model.sensor(left.row());
    const SensorNow &b = m_model.sensor(right.row());
    switch (left.column()) {
    case BatchModel::Sensor:
        return left.row() < right.row();
    case BatchModel::Frequency:
        return valueOf(a, "f0_hz") < valueOf(b, "f0_hz");
    case BatchModel::Damping:
        return valueOf(a, "damping_ratio") < valueOf(b, "damping_ratio");
    case BatchModel::Sensitivity:
        return valueOf(a, "sensitivity") < valueOf(b, "sensitivity");
    case BatchModel::Reason:
        return reasonText(a.standing.record) < reasonText(b.standing.record);
    default:
        return isWorse(a, b);
    }
}

} // namespace dyncal
