// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <QDateTime>
#include <QString>

#include <functional>
#include <string>

namespace dyncal {

/// ISO 8601 with Z, from the program: the window reads no clock.
using CurrentUtc = std::function<Result<std::string>()>;

/// The time that it tells, invalid where it tells none.
inline QDateTime timeOf(const CurrentUtc &currentUtc)
{
    const Result<std::string> text = currentUtc();
    return text ? QDateTime::fromString(QString::fromStdString(*text), Qt::ISODate) : QDateTime();
}

} // namespace dyncal
