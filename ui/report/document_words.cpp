// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/document_words.h"

#include "ui/text/core_text.h"

namespace dyncal {

DocumentWords::DocumentWords(const std::string &secondLanguage)
{
    if (!secondLanguage.empty())
        m_second = std::make_shared<const ReportLanguage>(secondLanguage);
}

QString DocumentWords::operator()(const Message &message) const
{
    constexpr qsizetype kLongestLabel = 70; // letters; what is longer is a sentence
    const QString first = printed(message);
    if (!m_second)
        return first;
    const QString second = inSecond(message);
    if (second == first)
        return first;
    const bool isLabel = first.size() <= kLongestLabel && !first.contains(QLatin1Char('\n'));
    return first + (isLabel ? QStringLiteral(" / ") : QStringLiteral("\n")) + second;
}

QString DocumentWords::inSecond(const Message &message) const
{
    const QString text = m_second->translate("core", message.text);
    QString sentences = QString::fromStdString(
        fillPlaces(text.toStdString(), message.arguments, ArgumentText::Full));
    for (const Message &sentence : message.below)
        sentences += QLatin1Char('\n') + inSecond(sentence);
    return sentences;
}

} // namespace dyncal
