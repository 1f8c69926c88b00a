// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/document_words.h"

#include "ui/text/core_text.h"
#include "ui/text/filled_words.h"

#include <QCoreApplication>

namespace dyncal {

DocumentWords::DocumentWords(const std::string &secondLanguage)
{
    if (!secondLanguage.empty())
        m_second = std::make_shared<const ReportLanguage>(secondLanguage);
}

QString DocumentWords::operator()(const Message &message) const
{
    constexpr qsizetype kLongestLabel = 70; // letters
    const QString first = printed(message);
    const QString other = second(message);
    if (other.isEmpty())
        return first;
    const bool isLabel = first.size() <= kLongestLabel && !first.contains(QLatin1Char('\n'))
        && !first.endsWith(QLatin1Char('.'));
    return first + (isLabel ? QStringLiteral(" / ") : QStringLiteral("\n")) + other;
}

QString DocumentWords::inTable(const Message &message) const
{
    const QString other = second(message);
    return other.isEmpty() ? printed(message) : printed(message) + QLatin1Char('\n') + other;
}

QString DocumentWords::second(const Message &message) const
{
    if (!m_second)
        return {};
    const auto own = [](const char *text) { return QCoreApplication::translate("core", text); };
    const auto other = [this](const char *text) { return m_second->translate("core", text); };
    constexpr QChar kOfCore('.');
    // Numbers differ by their decimal mark alone: what has no other words stands once.
    if (filledWords(message, own, kOfCore) == filledWords(message, other, kOfCore))
        return {};
    return filledWords(message, other, m_second->numbers().decimalPoint().front());
}

} // namespace dyncal
