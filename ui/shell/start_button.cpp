// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/start_button.h"

#include "ui/stages/frame/layout_scale.h"

#include <QFontMetrics>
#include <QStyleOptionButton>
#include <QStylePainter>

#include <algorithm>
#include <utility>

namespace dyncal {

StartButton::StartButton(const QString &text, QString hint, QWidget *parent)
    : QPushButton(text, parent)
    , m_hint(std::move(hint))
{
    setFlat(true);
    setCursor(Qt::PointingHandCursor);
}

QFont StartButton::headingFont() const
{
    constexpr double kLarger = 1.25;
    QFont heading = font();
    heading.setPointSizeF(kLarger * heading.pointSizeF());
    heading.setBold(true);
    return heading;
}

QSize StartButton::sizeHint() const
{
    const QFontMetrics heading(headingFont());
    const int width = std::max(heading.size(Qt::TextShowMnemonic, text()).width(),
        fontMetrics().horizontalAdvance(m_hint));
    return {
        width + 4 * scale::kMedium, heading.height() + fontMetrics().height() + 3 * scale::kMedium};
}

void StartButton::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text.clear();
    painter.drawControl(QStyle::CE_PushButton, option);
    QRect inside
        = rect().adjusted(2 * scale::kMedium, scale::kMedium, -2 * scale::kMedium, -scale::kMedium);
    painter.setPen(
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::ButtonText));
    painter.setFont(headingFont());
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignTop | Qt::TextShowMnemonic, text());
    painter.setFont(font());
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignBottom, m_hint);
}

} // namespace dyncal
