// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/status_text.h"

#include <QCoreApplication>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct StatusText
{
    Q_DECLARE_TR_FUNCTIONS(StatusText)
};

} // namespace

QString statusGlyph(StageStatus status)
{
    switch (status) {
    case StageStatus::NotStarted:
        return QStringLiteral("–");
    case StageStatus::Blocked:
        return QStringLiteral("■");
    case StageStatus::Computing:
        return QStringLiteral("⟳");
    case StageStatus::Stale:
        return QStringLiteral("◌");
    case StageStatus::Done:
        return QStringLiteral("●");
    case StageStatus::DoneWithCautions:
        return QStringLiteral("▲");
    }
    return {};
}

QString statusWord(StageStatus status)
{
    switch (status) {
    case StageStatus::NotStarted:
        return StatusText::tr("not started");
    case StageStatus::Blocked:
        return StatusText::tr("blocked");
    case StageStatus::Computing:
        return StatusText::tr("computing");
    case StageStatus::Stale:
        return StatusText::tr("out of date");
    case StageStatus::Done:
        return StatusText::tr("done");
    case StageStatus::DoneWithCautions:
        return StatusText::tr("cautions");
    }
    return {};
}

} // namespace dyncal
