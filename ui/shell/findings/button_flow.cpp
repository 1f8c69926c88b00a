// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/findings/button_flow.h"

#include <QPushButton>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kGap = 4;
constexpr int kBelow = 6;

} // namespace

ButtonFlow::ButtonFlow(int indent, QWidget *parent)
    : QWidget(parent)
    , m_indent(indent)
{
}

QPushButton *ButtonFlow::add(const QString &objectName, const QString &text)
{
    auto *button = new QPushButton(text, this);
    button->setObjectName(objectName);
    m_buttons.push_back(button);
    return button;
}

int ButtonFlow::arrange(int width)
{
    int x = m_indent;
    int y = 0;
    int lineHeight = 0;
    for (QPushButton *button : m_buttons) {
        const QSize size = button->sizeHint();
        if (x > m_indent && x + size.width() + kGap > width) {
            x = m_indent;
            y += lineHeight + kGap;
            lineHeight = 0;
        }
        button->setGeometry(x, y, size.width(), size.height());
        x += size.width() + kGap;
        lineHeight = std::max(lineHeight, size.height());
    }
    return y + lineHeight + kBelow;
}

void ButtonFlow::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange(width());
}

} // namespace dyncal
