// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/stage_list.h"

#include "ui/stages/frame/status_text.h"

namespace dyncal {

namespace {

constexpr int kRowHeight = 40; ///< a target that is hit without aiming

} // namespace

StageList::StageList(QWidget *parent)
    : QListWidget(parent)
{
    setObjectName("stageList");
    setAccessibleName(tr("Stages"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void StageList::addStage(const QString &title)
{
    auto *item = new QListWidgetItem(this);
    item->setSizeHint({0, kRowHeight});
    m_titles << title;
    setStatus(count() - 1, StageStatus::NotStarted);
}

void StageList::setStatus(int row, StageStatus status)
{
    item(row)->setText(QString("%1  %2\n    %3 %4")
                           .arg(row + 1)
                           .arg(m_titles[row], statusGlyph(status), statusWord(status)));
}

} // namespace dyncal
