// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/findings_panel.h"

#include "ui/text/finding_text.h"

#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>

#include <algorithm>

namespace dyncal {

FindingsPanel::FindingsPanel(QWidget *parent)
    : QListWidget(parent)
{
    setObjectName("findingsPanel");
    setAccessibleName(tr("Findings"));
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setResizeMode(QListView::Adjust);
    setSelectionMode(ExtendedSelection);
    setAlternatingRowColors(true);
    connect(this, &QListWidget::itemClicked, this, &FindingsPanel::request);
    connect(this, &QListWidget::itemActivated, this, &FindingsPanel::request);
}

void FindingsPanel::setFindings(const Findings &findings)
{
    Findings sorted = findings;
    std::ranges::stable_sort(
        sorted, [](const Finding &a, const Finding &b) { return a.severity > b.severity; });
    clear();
    for (const Finding &finding : sorted) {
        auto *item = new QListWidgetItem(findingLine(finding), this);
        const std::optional<StageId> stage = stageOfFinding(finding.id);
        item->setData(Qt::UserRole, stage ? static_cast<int>(*stage) : -1);
        item->setToolTip(tr("Click to go to the stage"));
    }
    if (findings.empty()) {
        auto *item = new QListWidgetItem(tr("No findings."), this);
        item->setFlags(Qt::NoItemFlags);
    }
}

void FindingsPanel::request(const QListWidgetItem *item)
{
    const int stage = item->data(Qt::UserRole).toInt();
    if (item->data(Qt::UserRole).isValid() && stage >= 0)
        emit stageRequested(static_cast<StageId>(stage));
}

void FindingsPanel::keyPressEvent(QKeyEvent *event)
{
    if (!event->matches(QKeySequence::Copy)) {
        QListWidget::keyPressEvent(event);
        return;
    }
    QStringList lines;
    for (int row = 0; row < count(); ++row)
        if (selectedItems().isEmpty() || item(row)->isSelected())
            lines << item(row)->text();
    QApplication::clipboard()->setText(lines.join('\n'));
}

} // namespace dyncal
