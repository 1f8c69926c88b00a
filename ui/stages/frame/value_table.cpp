// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/value_table.h"

#include "ui/text/shown_text.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>

namespace dyncal {

namespace {

/// Numbers stand at the right, names and words at the left.
Qt::Alignment alignment(int column, const QString &text)
{
    const bool isWord = column == 0 || (!text.isEmpty() && text.front().isLetter());
    return (isWord ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
}

} // namespace

ValueTable::ValueTable(const QString &objectName, const QString &accessibleName, QWidget *parent)
    : QTableWidget(parent)
{
    setObjectName(objectName);
    setAccessibleName(accessibleName);
    setEditTriggers(NoEditTriggers);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setHighlightSections(false);
}

void ValueTable::setValues(const QStringList &headers, const QVector<QStringList> &rows)
{
    setColumnCount(static_cast<int>(headers.size()));
    setHorizontalHeaderLabels(headers);
    setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < rowCount(); ++row) {
        for (int column = 0; column < columnCount(); ++column) {
            const QString text = rows[row].value(column);
            if (!item(row, column))
                setItem(row, column, new QTableWidgetItem);
            item(row, column)->setText(text);
            item(row, column)->setTextAlignment(alignment(column, text));
        }
    }
    fitColumns();
}

void ValueTable::fitColumns()
{
    int widest = 0;
    for (int column = 0; column < columnCount(); ++column)
        widest = std::max(
            {widest, sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column)});
    horizontalHeader()->setSectionResizeMode(widest * columnCount() < viewport()->width()
            ? QHeaderView::Stretch
            : QHeaderView::ResizeToContents);
}

void ValueTable::resizeEvent(QResizeEvent *event)
{
    QTableWidget::resizeEvent(event);
    fitColumns();
}

QString ValueTable::selectedText() const
{
    const bool all = selectedItems().isEmpty();
    QStringList lines;
    for (int row = 0; row < rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < columnCount(); ++column)
            if (item(row, column) && (all || item(row, column)->isSelected()))
                cells << pasted(item(row, column)->text());
        if (!cells.isEmpty())
            lines << cells.join('\t');
    }
    return lines.join('\n');
}

void ValueTable::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy))
        QApplication::clipboard()->setText(selectedText());
    else
        QTableWidget::keyPressEvent(event);
}

} // namespace dyncal
