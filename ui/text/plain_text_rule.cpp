// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/plain_text_rule.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>

namespace dyncal {

PlainTextRule::PlainTextRule(QObject *parent)
    : QObject(parent)
{
    qApp->installEventFilter(this);
}

/// A label is polished before its text is first laid out; the label of tooltips when it is created.
bool PlainTextRule::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Polish)
        if (auto *label = qobject_cast<QLabel *>(watched);
            label && label->textFormat() == Qt::AutoText)
            label->setTextFormat(Qt::PlainText);
    return false;
}

} // namespace dyncal
