// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/findings_panel.h"

#include "ui/text/finding_text.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>

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

void FindingsPanel::setFindings(
    const Findings &findings, const std::vector<Acknowledgement> &acknowledged)
{
    m_shown = findings;
    std::ranges::stable_sort(
        m_shown, [](const Finding &a, const Finding &b) { return a.severity > b.severity; });
    clear();
    for (const Finding &finding : m_shown) {
        QString line = findingLine(finding);
        for (const Acknowledgement &entry : acknowledged)
            if (entry.finding == finding.id && entry.shot == finding.shot)
                line += " " + tr("Accepted: %1").arg(QString::fromStdString(entry.reason));
        addItem(line);
        item(count() - 1)
            ->setToolTip(finding.severity == Severity::Caution
                    ? tr("Click to go to the stage; right click to give a reason")
                    : tr("Click to go to the stage"));
    }
    if (m_shown.empty()) {
        addItem(tr("No findings."));
        item(0)->setFlags(Qt::NoItemFlags);
    }
}

void FindingsPanel::request(const QListWidgetItem *item)
{
    const auto position = static_cast<std::size_t>(row(item));
    if (position >= m_shown.size())
        return;
    if (const std::optional<StageId> stage = stageOfFinding(m_shown[position].id))
        emit stageRequested(*stage);
}

void FindingsPanel::contextMenuEvent(QContextMenuEvent *event)
{
    const int position = row(itemAt(event->pos()));
    if (position < 0 || position >= static_cast<int>(m_shown.size()))
        return;
    const Finding finding = m_shown[static_cast<std::size_t>(position)];
    if (finding.severity != Severity::Caution)
        return;
    QMenu menu(this);
    menu.addAction(
        tr("Give a reason..."), this, [this, finding] { emit reasonRequested(finding); });
    menu.exec(event->globalPos());
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
