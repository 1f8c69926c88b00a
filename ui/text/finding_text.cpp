// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/finding_text.h"

#include "ui/text/core_text.h"

#include <QCoreApplication>

#include <string_view>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct FindingText
{
    Q_DECLARE_TR_FUNCTIONS(FindingText)
};

} // namespace

QString severityGlyph(Severity severity)
{
    switch (severity) {
    case Severity::Info:
        return QStringLiteral("○");
    case Severity::Caution:
        return QStringLiteral("▲");
    case Severity::Block:
        return QStringLiteral("■");
    }
    return {};
}

QString severityWord(Severity severity)
{
    switch (severity) {
    case Severity::Info:
        return FindingText::tr("Info");
    case Severity::Caution:
        return FindingText::tr("Caution");
    case Severity::Block:
        return FindingText::tr("Blocked");
    }
    return {};
}

QString findingLine(const Finding &finding)
{
    QString head = severityGlyph(finding.severity) + " " + severityWord(finding.severity);
    if (!finding.id.empty())
        head += " " + QString::fromStdString(finding.id);
    // Most sentences begin with the shot themselves.
    const bool named
        = finding.message.text && std::string_view(finding.message.text).starts_with("Shot %1");
    if (finding.shot > 0 && !named)
        head += FindingText::tr(", shot %1").arg(finding.shot);
    return head + ": " + translated(finding.message);
}

} // namespace dyncal
