// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/level_text.h"

#include <QCoreApplication>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct CaptureText
{
    Q_DECLARE_TR_FUNCTIONS(CaptureText)
};

} // namespace

QString levelText(ShotLevel level)
{
    switch (level) {
    case ShotLevel::Low:
        return CaptureText::tr("Low");
    case ShotLevel::Medium:
        return CaptureText::tr("Medium");
    case ShotLevel::High:
        return CaptureText::tr("High");
    case ShotLevel::None:
        break;
    }
    return QStringLiteral("–");
}

QString roleText(ChannelRole role)
{
    switch (role) {
    case ChannelRole::Dut:
        return CaptureText::tr("DUT");
    case ChannelRole::DrivenSide:
        return CaptureText::tr("Driven side");
    case ChannelRole::Driver:
        return CaptureText::tr("Driver");
    case ChannelRole::Trigger:
        return CaptureText::tr("Trigger");
    case ChannelRole::Reference:
        return CaptureText::tr("Reference");
    case ChannelRole::Other:
        break;
    }
    return CaptureText::tr("Other");
}

} // namespace dyncal
