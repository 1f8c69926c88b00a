// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <QDateTime>
#include <QString>

#include <functional>
#include <string>

namespace dyncal {

/// Gives the time as ISO 8601 with Z. The program passes it in: the window reads no clock.
using CurrentUtc = std::function<Result<std::string>()>;

/// The time that the function gives; invalid if it fails.
inline QDateTime timeOf(const CurrentUtc &currentUtc)
{
    const Result<std::string> text = currentUtc();
    return text ? QDateTime::fromString(QString::fromStdString(*text), Qt::ISODate) : QDateTime();
}

} // namespace dyncal
