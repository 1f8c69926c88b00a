// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QFontMetrics>
#include <QString>

namespace dyncal {

/// `text` with line breaks between words where a line would be wider than `width_px`, and within a
/// word, with a hyphen, that is wider by itself; "&x" is measured as the mnemonic that it may be.
QString brokenText(const QFontMetrics &metrics, const QString &text, int width_px);

} // namespace dyncal
