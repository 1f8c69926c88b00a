// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/trail_tab.h"

#include "ui/shell/registry/registry_caller.h"
#include "ui/shell/registry/registry_rows.h"
#include "ui/shell/registry/rows_view.h"
#include "ui/text/shown_text.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace dyncal {

namespace {

constexpr int kHeightOfEntry_lines = 9;

/// A row of the registry, a field on each line.
QString linesOf(const QString &row)
{
    const QByteArray json = row.toUtf8();
    const QJsonDocument document = QJsonDocument::fromJson(json);
    const QByteArray text = document.isNull() ? json : document.toJson(QJsonDocument::Indented);
    QStringList lines;
    for (const QByteArray &line : text.split('\n'))
        lines << shownText(QString::fromUtf8(line));
    return lines.join('\n');
}

} // namespace

TrailTab::TrailTab(RegistryCaller &caller, QWidget *parent)
    : QWidget(parent)
    , m_caller(caller)
    , m_table(new RowsView("trailTable", this))
    , m_entry(new QPlainTextEdit(this))
{
    m_entry->setObjectName("trailEntry");
    m_entry->setReadOnly(true);
    m_entry->setTabChangesFocus(true);
    m_entry->setMaximumHeight(kHeightOfEntry_lines * fontMetrics().lineSpacing());
    auto *column = new QVBoxLayout(this);
    column->addWidget(m_table, 1);
    column->addWidget(m_entry);
    connect(m_table, &RowsView::selectionChanged, this, &TrailTab::showEntry);
}

void TrailTab::showWords()
{
    m_table->setTitles(
        {tr("Entry"), tr("Time (UTC)"), tr("Who"), tr("What"), tr("About"), tr("Reason")},
        tr("Audit trail"));
    m_entry->setAccessibleName(tr("The entry that is selected, before and after"));
    m_entry->setPlaceholderText(tr("Select an entry to see what it changed."));
    showEntry();
}

void TrailTab::refresh()
{
    m_caller.read(*this, {"registry", "trail", "--json"}, [this](const ProgramAnswer &answer) {
        m_entries = listOf(answer.out);
        m_table->setRows(trailRows(m_entries));
    });
}

void TrailTab::showEntry()
{
    const int row = m_table->selected();
    if (row < 0) {
        m_entry->clear();
        return;
    }
    const QJsonValue entry = m_entries[row];
    QStringList parts{tr("Program: %1").arg(linesOf(entry["program"].toString())),
        tr("SHA-256: %1").arg(linesOf(entry["sha256"].toString()))};
    if (const QString before = entry["before"].toString(); !before.isEmpty())
        parts << tr("Before:") << linesOf(before);
    if (const QString after = entry["after"].toString(); !after.isEmpty())
        parts << tr("After:") << linesOf(after);
    m_entry->setPlainText(parts.join('\n'));
}

} // namespace dyncal
