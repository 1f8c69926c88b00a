// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QByteArray>
#include <QString>

namespace dyncal {

/// A PDF from QPdfWriter with its dates set to `createdUtc` (ISO 8601 with Z) and its document id
/// to a hash of the content, so that the same content gives the same bytes, in every time zone. A
/// local time is cut to the length of UTC, and the offsets in the file are corrected for it;
/// everything else is replaced by as many bytes. Qt 6.4 offers no way to set these values.
QByteArray withFixedDates(QByteArray pdf, const QString &createdUtc);

} // namespace dyncal
