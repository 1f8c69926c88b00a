// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/widget/plot_notice.h"

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kMargin_px = 8;

} // namespace

PlotNotice::PlotNotice(QWidget *plot)
    : QLabel(plot)
{
    setObjectName("plotNotice");
    setWordWrap(true);
    setMargin(kMargin_px);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAutoFillBackground(true);
    hide();
}

void PlotNotice::say(const QString &sentence)
{
    setText(sentence);
    setHidden(sentence.isEmpty());
}

void PlotNotice::placeIn(const QRect &axes)
{
    if (isHidden())
        return;
    const QRect room = axes.adjusted(kMargin_px, kMargin_px, -kMargin_px, -kMargin_px);
    const int width = std::max(room.width(), 0);
    const QRect words = fontMetrics().boundingRect(
        QRect(0, 0, std::max(width - 2 * kMargin_px, 1), QWIDGETSIZE_MAX), Qt::TextWordWrap,
        text());
    const int height = std::min(words.height() + 2 * kMargin_px, std::max(room.height(), 0));
    setGeometry(room.left(), room.top(), width, height);
}

} // namespace dyncal
