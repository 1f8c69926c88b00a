// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/share_bar.h"

#include <QPainter>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kBarHeight_px = 3;

} // namespace

void ShareBar::paint(
    QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QStyledItemDelegate::paint(painter, option, index);
    const double share = std::clamp(index.data(kShareRole).toDouble(), 0.0, 1.0);
    QRect bar = option.rect;
    bar.setTop(bar.bottom() - kBarHeight_px + 1);
    bar.setWidth(static_cast<int>(share * option.rect.width()));
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    painter->fillRect(
        bar, option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Highlight));
}

} // namespace dyncal
