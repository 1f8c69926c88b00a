// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"

#include <QString>

namespace dyncal {

/// Shape and word of a severity: never colour alone.
QString severityGlyph(Severity severity); ///< "○", "▲", "■"
QString severityWord(Severity severity);

/// "▲ Caution WIN-001: Shot 2: sentence"; a sentence that does not begin with its shot gets it
/// after the id: "▲ Caution WIN-001, shot 2: sentence".
QString findingLine(const Finding &finding);

} // namespace dyncal
