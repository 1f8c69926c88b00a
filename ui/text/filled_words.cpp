// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/filled_words.h"

namespace dyncal {

QString filledWords(
    const Message &message, const std::function<QString(const char *text)> &translate)
{
    QString sentences = QString::fromStdString(
        fillPlaces(translate(message.text).toStdString(), message.arguments, ArgumentText::Full));
    for (const Message &sentence : message.below)
        sentences += QLatin1Char('\n') + filledWords(sentence, translate);
    return sentences;
}

} // namespace dyncal
