// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/core_text.h"

#include <QCoreApplication>

namespace dyncal {

QString translated(const Message &message, ArgumentText shown)
{
    const QString text = QCoreApplication::translate("core", message.text);
    QString sentences
        = QString::fromStdString(fillPlaces(text.toStdString(), message.arguments, shown));
    for (const Message &sentence : message.below)
        sentences += QLatin1Char('\n') + translated(sentence, shown);
    return sentences;
}

} // namespace dyncal
