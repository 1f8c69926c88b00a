// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/findings/findings_panel.h"

#include "core/pipeline/stage_table.h"
#include "ui/text/finding_text.h"
#include "ui/text/shown_text.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kButtonIndent = 18; ///< below the sentence, not below its sign

} // namespace

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

void FindingsPanel::setFindings(const Findings &findings,
    const std::vector<Acknowledgement> &acknowledged, const CaptureSet &captures)
{
    m_shown = findings;
    std::ranges::stable_sort(
        m_shown, [](const Finding &a, const Finding &b) { return a.severity > b.severity; });
    m_corrections.clear();
    QStringList words;
    for (const Finding &finding : m_shown) {
        QString line = findingLine(finding);
        for (const Acknowledgement &entry : acknowledged)
            if (entry.finding == finding.id && entry.shot == finding.shot)
                line += " " + tr("Accepted: %1").arg(shownText(entry.reason));
        words << line;
        m_corrections.push_back(correctionsOf(finding, captures));
        for (const OfferedCorrection &correction : m_corrections.back())
            words << correction.label;
    }
    // While an order is dragged the same sentences come many times a second.
    if (m_words == words && count() > 0)
        return;
    m_words = words;
    fill();
}

/// Rows for m_shown and m_corrections in the words of m_words.
void FindingsPanel::fill()
{
    clear();
    m_rows.clear();
    qsizetype word = 0;
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
        addItem(m_words[word]);
        word += 1 + std::ssize(m_corrections[i]);
        m_rows.push_back(i);
        item(count() - 1)
            ->setToolTip(m_shown[i].severity == Severity::Caution
                    ? tr("Click to go to the stage; right click to give a reason")
                    : tr("Click to go to the stage"));
        if (!m_corrections[i].empty()) {
            addButtons(i);
            m_rows.push_back(i);
        }
    }
    if (m_shown.empty()) {
        addItem(tr("No findings."));
        item(0)->setFlags(Qt::NoItemFlags);
    }
}

/// A row of its own, so that the sentence above keeps its width, its menu and its place in the
/// copy.
void FindingsPanel::addButtons(std::size_t shown)
{
    const Finding &finding = m_shown[shown];
    auto *box = new QWidget(this);
    auto *column = new QVBoxLayout(box);
    column->setContentsMargins(kButtonIndent, 0, 4, 6);
    column->setSpacing(3);
    for (std::size_t i = 0; i < m_corrections[shown].size(); ++i) {
        auto *button = new QPushButton(withoutMnemonic(m_corrections[shown][i].label), box);
        button->setObjectName(
            QString("correction_%1_%2").arg(rawText(finding.id)).arg(column->count() + 1));
        button->setAccessibleDescription(findingLine(finding));
        // The panel is filled anew by what the correction changes: not within the click.
        connect(button, &QPushButton::clicked, this, [this, shown, i] {
            QMetaObject::invokeMethod(
                this,
                [this, correction = m_corrections[shown][i]] {
                    emit correctionRequested(correction);
                },
                Qt::QueuedConnection);
        });
        column->addWidget(button, 0, Qt::AlignLeft);
    }
    auto *row = new QListWidgetItem(this);
    row->setFlags(Qt::NoItemFlags);
    row->setSizeHint(box->sizeHint());
    setItemWidget(row, box);
}

const Finding *FindingsPanel::findingAt(int row) const
{
    if (row < 0 || static_cast<std::size_t>(row) >= m_rows.size())
        return nullptr;
    return &m_shown[m_rows[static_cast<std::size_t>(row)]];
}

void FindingsPanel::request(const QListWidgetItem *item)
{
    const Finding *finding = findingAt(row(item));
    if (!finding)
        return;
    if (const std::optional<StageId> stage = stageOfFinding(finding->id))
        emit stageRequested(*stage);
}

void FindingsPanel::contextMenuEvent(QContextMenuEvent *event)
{
    const Finding *found = findingAt(row(itemAt(event->pos())));
    if (!found || found->severity != Severity::Caution)
        return;
    QMenu menu(this);
    menu.addAction(
        tr("Give a reason..."), this, [this, finding = *found] { emit reasonRequested(finding); });
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
        if (!itemWidget(item(row)) && (selectedItems().isEmpty() || item(row)->isSelected()))
            lines << pasted(item(row)->text());
    QApplication::clipboard()->setText(lines.join('\n'));
}

} // namespace dyncal
