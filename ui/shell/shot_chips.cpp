// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/shot_chips.h"

#include "ui/text/level_text.h"
#include "ui/text/shown_text.h"

#include <QHBoxLayout>
#include <QLabel>

namespace dyncal {

namespace {

/// More would not fit; the Captures stage lists all.
constexpr std::size_t kMostChips = 8;

} // namespace

ShotChips::ShotChips(QWidget *parent)
    : QWidget(parent)
{
    setObjectName("shotChips");
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->setSpacing(10);
}

void ShotChips::setShots(const CaptureSet &set)
{
    std::vector<Chip> chips;
    for (std::size_t i = 0; i < std::min(set.shots.size(), kMostChips); ++i)
        chips.push_back(chipOf(set.shots[i], i + 1));
    if (set.shots.size() > kMostChips)
        chips.push_back({tr("%1 shots").arg(set.shots.size()), {}, false});
    if (chips == m_chips) // a drag asks for them with every move
        return;
    m_chips = std::move(chips);
    qDeleteAll(findChildren<QLabel *>());
    for (const Chip &chip : m_chips) {
        auto *label = new QLabel(chip.text, this);
        QFont face = label->font();
        face.setStrikeOut(chip.isStruck);
        label->setFont(face);
        label->setToolTip(chip.meaning);
        layout()->addWidget(label);
    }
}

ShotChips::Chip ShotChips::chipOf(const Shot &shot, std::size_t number)
{
    return {QString::number(number) + " " + levelText(shot.level),
        shot.included
            ? tr("Shot %1: %2").arg(number).arg(shownText(shot.label))
            : tr("Shot %1 is excluded: %2").arg(number).arg(shownText(shot.excludeReason)),
        !shot.included};
}

} // namespace dyncal
