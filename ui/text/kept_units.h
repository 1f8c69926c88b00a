// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

namespace dyncal {

/// `text` for a place that breaks lines: with a no-break space between a number and its unit, so
/// that "12 kHz" is never parted, nor "(u = 3" (SI Brochure, 5.4.3). For show only; what is copied
/// stays as it is.
QString withUnitsKept(QString text);

} // namespace dyncal
