// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/stage_list.h"

#include "ui/shell/drawn_icon.h"
#include "ui/stages/frame/status_text.h"

#include <QEvent>
#include <QRegularExpression>
#include <QScrollBar>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kSignSize_px = 18;
constexpr int kSpacing_px = 2; ///< around a row: a target that is hit without aiming
constexpr int kAroundText_px = 8;
constexpr int kRowHeight = 40; ///< a target that is hit without aiming

} // namespace

QKeySequence stageKeys(Page page)
{
    constexpr int kDigits = 9;
    const int number = static_cast<int>(page) + 1;
    if (number <= kDigits)
        return QKeySequence(QString("Alt+%1").arg(number));
    return QKeySequence(page == Page::Certificate ? "Alt+0"
            : page == Page::Comparison            ? "Alt+J"
                                                  : "Alt+Y");
}

StageList::StageList(QWidget *parent)
    : QListWidget(parent)
{
    setObjectName("stageList");
    setAccessibleName(tr("Stages"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWordWrap(true); // "blocked by Reference step" is never cut
    setTextElideMode(Qt::ElideNone);
    setResizeMode(QListView::Adjust);
    setIconSize({kSignSize_px, kSignSize_px});
    setSpacing(kSpacing_px);
    setVerticalScrollMode(ScrollPerPixel);
}

void StageList::addStage(const QString &title)
{
    new QListWidgetItem(this);
    m_titles << title;
    m_widestWords << 0;
    setStanding(count() - 1, {});
}

void StageList::setStanding(int row, const PageStanding &standing)
{
    const QString word = standingWord(standing, static_cast<Page>(row));
    const QString text = QString("%1  %2\n%3").arg(row + 1).arg(m_titles[row], word);
    if (item(row)->text() == text)
        return;
    item(row)->setText(text);
    item(row)->setIcon(statusIcon(standing.status));
    item(row)->setToolTip(
        tr("Stage %1: %2, %3 (%4)")
            .arg(QString::number(row + 1), m_titles[row], word,
                stageKeys(static_cast<Page>(row)).toString(QKeySequence::NativeText)));
    fitRow(row);
    fitWidth();
}

void StageList::fitRows()
{
    for (int row = 0; row < count(); ++row)
        fitRow(row);
    fitWidth();
}

void StageList::fitRow(int row)
{
    static const QRegularExpression kSpaces("\\s+");
    const QRect room(0, 0, std::max(1, viewport()->width() - kSignSize_px - 2 * kAroundText_px),
        QWIDGETSIZE_MAX);
    const QString text = item(row)->text();
    const int height = fontMetrics().boundingRect(room, Qt::TextWordWrap, text).height();
    item(row)->setSizeHint({0, std::max(kRowHeight, height + kAroundText_px)});
    int &widest = m_widestWords[row];
    widest = 0;
    for (const QString &word : text.split(kSpaces))
        widest = std::max(widest, fontMetrics().horizontalAdvance(word));
}

void StageList::fitWidth()
{
    const auto widest = std::ranges::max_element(m_widestWords);
    const int words = widest == m_widestWords.end() ? 0 : *widest;
    const int bar = verticalScrollBar()->sizeHint().width();
    setMinimumWidth(words + kSignSize_px + 3 * kAroundText_px + bar + 2 * frameWidth());
}

void StageList::resizeEvent(QResizeEvent *event)
{
    QListWidget::resizeEvent(event);
    fitRows();
}

void StageList::changeEvent(QEvent *event)
{
    QListWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        fitRows();
}

} // namespace dyncal
