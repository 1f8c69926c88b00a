// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/cursor_table.h"

#include "ui/plot/values/axis_prefix.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/text/shown_text.h"

#include <QVBoxLayout>

namespace dyncal {

namespace {

constexpr int kValueDigits = 6;
constexpr QSize kFirstTableSize(460, 240);

QString shown(const std::optional<double> &value, const QString &unit)
{
    return value ? valueWithUnit(*value, unit, kValueDigits) : QStringLiteral("–");
}

QStringList cells(
    const QString &name, const std::array<std::optional<double>, 2> &values, const QString &unit)
{
    const auto difference
        = values[0] && values[1] ? std::optional(*values[1] - *values[0]) : std::nullopt;
    return {
        shownText(name), shown(values[0], unit), shown(values[1], unit), shown(difference, unit)};
}

} // namespace

CursorTable::CursorTable(QWidget *page)
    : QWidget(page, Qt::Tool)
    , m_table(new ValueTable("cursorTable", tr("Values at the cursors"), this))
{
    setObjectName("cursorTableWindow");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_table);
    resize(kFirstTableSize);
}

void CursorTable::follow(PlotWidget *plot)
{
    if (m_plot)
        disconnect(m_plot, nullptr, this, nullptr);
    m_plot = plot;
    connect(plot, &PlotWidget::cursorsChanged, this, &CursorTable::showValues);
    showValues();
    show();
    raise();
}

void CursorTable::showValues()
{
    const CursorValues values = m_plot->cursorValues();
    setWindowTitle(asTitle(m_plot->content().title));
    QVector<QStringList> rows{cells(values.quantity, values.x, values.unit)};
    for (const CursorRow &row : values.rows)
        rows << cells(
            row.curve.isEmpty() ? m_plot->content().yAxis.quantity : row.curve, row.y, row.unit);
    m_table->setValues({tr("Curve"), tr("A (key 1)"), tr("B (key 2)"), tr("B − A")}, rows);
}

} // namespace dyncal
