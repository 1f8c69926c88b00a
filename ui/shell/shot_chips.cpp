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
    qDeleteAll(findChildren<QLabel *>());
    for (std::size_t i = 0; i < std::min(set.shots.size(), kMostChips); ++i) {
        const Shot &shot = set.shots[i];
        const QString text = QString::number(i + 1) + " " + levelText(shot.level);
        auto *chip = new QLabel(text, this);
        QFont face = chip->font();
        face.setStrikeOut(!shot.included);
        chip->setFont(face);
        chip->setToolTip(shot.included
                ? tr("Shot %1: %2").arg(i + 1).arg(shownText(shot.label))
                : tr("Shot %1 is excluded: %2").arg(i + 1).arg(shownText(shot.excludeReason)));
        layout()->addWidget(chip);
    }
    if (set.shots.size() > kMostChips)
        layout()->addWidget(new QLabel(tr("%1 shots").arg(set.shots.size()), this));
}

} // namespace dyncal
