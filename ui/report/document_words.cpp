// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/document_words.h"

#include "ui/text/core_text.h"
#include "ui/text/filled_words.h"

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
    const QString second = filledWords(
        message, [this](const char *text) { return m_second->translate("core", text); });
    if (second == first)
        return first;
    const bool isLabel = first.size() <= kLongestLabel && !first.contains(QLatin1Char('\n'));
    return first + (isLabel ? QStringLiteral(" / ") : QStringLiteral("\n")) + second;
}

} // namespace dyncal
