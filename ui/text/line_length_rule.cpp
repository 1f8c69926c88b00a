// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/line_length_rule.h"

#include <QApplication>
#include <QEvent>
#include <QLineEdit>

namespace dyncal {

LineLengthRule::LineLengthRule()
{
    qApp->installEventFilter(this);
}

bool LineLengthRule::eventFilter(QObject *watched, QEvent *event)
{
    constexpr int kUnstated = 32767; // of a QLineEdit
    if (event->type() == QEvent::Polish)
        if (auto *line = qobject_cast<QLineEdit *>(watched);
            line && line->maxLength() == kUnstated && line->text().size() <= kMostLettersOfLine)
            line->setMaxLength(kMostLettersOfLine);
    return false;
}

} // namespace dyncal
