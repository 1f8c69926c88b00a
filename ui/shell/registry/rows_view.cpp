// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/rows_view.h"

#include "ui/stages/frame/rows_table.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QVBoxLayout>

namespace dyncal {

RowsView::RowsView(const QString &name, QWidget *parent)
    : QWidget(parent)
    , m_text(new QLineEdit(this))
    , m_count(new QLabel(this))
    , m_view(new QTableView(this))
{
    m_filter.setSourceModel(&m_rows);
    m_filter.setFilterKeyColumn(-1);
    m_filter.setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_text->setObjectName(name + "Text");
    m_text->setClearButtonEnabled(true);
    m_count->setObjectName(name + "Count");
    m_view->setObjectName(name);
    m_view->setModel(&m_filter);
    showAsRows(*m_view);
    m_view->horizontalHeader()->setMaximumSectionSize(
        kWidestColumn_chars * fontMetrics().averageCharWidth());
    auto *line = new QHBoxLayout;
    line->addWidget(m_text, 1);
    line->addWidget(m_count);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(line);
    column->addWidget(m_view, 1);
    connect(m_text, &QLineEdit::textChanged, this, [this](const QString &text) {
        m_filter.setFilterFixedString(text);
        showCount();
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
        &RowsView::selectionChanged);
}

void RowsView::setTitles(const QStringList &titles, const QString &accessibleName)
{
    m_rows.setHorizontalHeaderLabels(titles);
    m_view->setAccessibleName(accessibleName);
    m_text->setAccessibleName(tr("Show only rows that hold this text"));
    m_text->setPlaceholderText(tr("Search"));
    showCount();
}

void RowsView::setRows(const std::vector<QVariantList> &rows)
{
    m_rows.removeRows(0, m_rows.rowCount());
    for (const QVariantList &cells : rows) {
        QList<QStandardItem *> items;
        for (const QVariant &cell : cells) {
            items << new QStandardItem;
            items.last()->setData(cell, Qt::DisplayRole);
            items.last()->setToolTip(cell.toString());
        }
        m_rows.appendRow(items);
    }
    m_view->sortByColumn(0, Qt::DescendingOrder); // the newest first
    m_view->resizeColumnsToContents();
    showCount();
    emit selectionChanged();
}

int RowsView::selected() const
{
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    return rows.isEmpty() ? -1 : m_filter.mapToSource(rows.first()).row();
}

void RowsView::showCount()
{
    m_count->setText(tr("%1 of %2").arg(m_filter.rowCount()).arg(m_rows.rowCount()));
}

} // namespace dyncal
