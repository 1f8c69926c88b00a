// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/kept_results_view.h"

#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace dyncal {

namespace {

constexpr QSize kFirstSize(900, 700);
constexpr int kWidestColumn_chars = 45; // what is longer is in its tool tip

/// A line over all columns.
QTreeWidgetItem *addLine(QTreeWidgetItem *parent, const QString &text)
{
    auto *line = new QTreeWidgetItem(parent, {text});
    line->setFirstColumnSpanned(true);
    line->setToolTip(0, text);
    return line;
}

QStringList wordsOf(const std::vector<Message> &messages)
{
    QStringList words;
    for (const Message &message : messages)
        words << translated(message);
    return words;
}

void addRow(QTreeWidgetItem *parent, const QStringList &cells)
{
    auto *row = new QTreeWidgetItem(parent, cells);
    for (int column = 0; column < cells.size(); ++column)
        row->setToolTip(column, cells[column]);
}

void makeBold(QTreeWidgetItem *item)
{
    for (int column = 0; column < item->columnCount(); ++column) {
        QFont face = item->font(column);
        face.setBold(true);
        item->setFont(column, face);
    }
}

std::size_t columnsOf(const CertificateData &certificate)
{
    std::size_t columns = 2; // label and value
    for (const CertificateSection &section : certificate.sections)
        for (const CertificateTable &table : section.tables)
            columns = std::max(columns, table.columns.size());
    return columns;
}

} // namespace

KeptResultsView::KeptResultsView(const KeptResults &kept, const QString &project, QWidget *parent)
    : QDialog(parent)
    , m_kept(kept)
    , m_tree(new QTreeWidget(this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("keptResults");
    setWindowTitle(tr("Kept results of %1").arg(asTitle(project)));
    auto *what = new QLabel(
        tr("These are the results as they stood when the project was saved (%1). The recordings are missing, so nothing can be computed, changed or exported.")
            .arg(shownText(kept.savedUtc)),
        this);
    what->setWordWrap(true);
    m_tree->setObjectName("keptResultsTree");
    m_tree->setHeaderHidden(true);
    m_tree->setColumnCount(static_cast<int>(columnsOf(kept.certificate)));
    for (const CertificateSection &section : kept.certificate.sections)
        addSection(section);
    m_tree->expandAll();
    fitColumns();
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *column = new QVBoxLayout(this);
    column->addWidget(what);
    column->addWidget(m_tree, 1);
    column->addWidget(buttons);
    resize(kFirstSize);
}

void KeptResultsView::addSection(const CertificateSection &section)
{
    auto *item = new QTreeWidgetItem(m_tree, {translated(section.title)});
    item->setFirstColumnSpanned(true);
    makeBold(item);
    for (const QString &words : wordsOf(section.paragraphs))
        addLine(item, words);
    for (const CertificateField &field : section.fields)
        addRow(item, wordsOf({field.label, field.value}));
    for (const CertificateTable &table : section.tables)
        addTable(item, table);
    for (const QString &words : wordsOf(section.notes))
        addLine(item, words);
}

void KeptResultsView::addTable(QTreeWidgetItem *parent, const CertificateTable &table)
{
    QTreeWidgetItem *item = addLine(parent, translated(table.caption));
    QStringList headings;
    for (const CertificateColumn &column : table.columns)
        headings << translated(column.heading);
    makeBold(new QTreeWidgetItem(item, headings));
    for (const std::vector<Message> &row : table.rows)
        addRow(item, wordsOf(row));
}

/// One long value would push the columns of all tables out of sight.
void KeptResultsView::fitColumns()
{
    const int widest = kWidestColumn_chars * fontMetrics().averageCharWidth();
    for (int column = 0; column < m_tree->columnCount(); ++column) {
        m_tree->resizeColumnToContents(column);
        if (column > 0)
            m_tree->setColumnWidth(column, std::min(m_tree->columnWidth(column), widest));
    }
}

} // namespace dyncal
