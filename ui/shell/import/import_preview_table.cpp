// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/import_preview_table.h"

#include "core/base/number_text.h"
#include "ui/shell/import/fixed_item.h"
#include "ui/text/shown_text.h"

#include <QHeaderView>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kShownColumns = 50; ///< a damaged file may be one line of many thousand cells

bool isNumber(std::string cell, char decimal)
{
    const std::size_t mark = cell.find(decimal);
    if (decimal != '.' && cell.find('.') != std::string::npos)
        return false;
    if (mark != std::string::npos)
        cell[mark] = '.';
    if (cell.starts_with('+'))
        cell.erase(0, 1);
    return cell.empty() || parseNumber(cell).has_value();
}

} // namespace

ImportPreviewTable::ImportPreviewTable(QWidget *parent)
    : QTableWidget(parent)
{
    setObjectName("importPreview");
    setAccessibleName(tr("First rows of the file"));
    setTabKeyNavigation(false);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
}

void ImportPreviewTable::setPreview(const TextPreview &preview)
{
    m_marked = 0;
    const auto columns
        = static_cast<int>(std::min<std::size_t>(preview.columnTitles.size(), kShownColumns));
    setColumnCount(columns);
    QStringList titles;
    for (int c = 0; c < columns; ++c) {
        const auto at = static_cast<std::size_t>(c);
        const QString unit = shownText(preview.units[at]);
        QString title = shownText(preview.columnTitles[at]);
        if (!unit.isEmpty())
            title += QStringLiteral(" [%1]").arg(unit);
        if (preview.timeColumn == Index(c))
            title = tr("%1 (time)").arg(title);
        else if (at < preview.shots.size())
            title = preview.shots[at] > 0 ? tr("%1 (shot %2)").arg(title).arg(preview.shots[at])
                                          : tr("%1 (left out)").arg(title);
        titles << title;
    }
    setHorizontalHeaderLabels(titles);
    setRowCount(static_cast<int>(preview.rows.size()));
    QStringList lines;
    for (int row = 0; row < rowCount(); ++row) {
        lines << QString::number(preview.headerLines + row + 1);
        fillRow(row, preview.rows[static_cast<std::size_t>(row)], preview);
    }
    setVerticalHeaderLabels(lines);
}

void ImportPreviewTable::fillRow(
    int row, const std::vector<std::string> &cells, const TextPreview &preview)
{
    for (int c = 0; c < columnCount(); ++c) {
        const bool there = static_cast<std::size_t>(c) < cells.size();
        const std::string cell = there ? cells[static_cast<std::size_t>(c)] : std::string();
        const bool good = there && isNumber(cell, preview.decimal);
        QTableWidgetItem *item = fixedItem(shownText(cell));
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        if (!good) { // a sign, not colour alone
            ++m_marked;
            item->setText(QStringLiteral("✗ ") + (there ? item->text() : tr("missing")));
            item->setToolTip(tr("No number under these settings"));
            QFont bold = font();
            bold.setBold(true);
            item->setFont(bold);
        } else if (preview.timeColumn == Index(c)) {
            item->setForeground(palette().brush(QPalette::Disabled, QPalette::Text));
        }
        setItem(row, c, item);
    }
}

} // namespace dyncal
