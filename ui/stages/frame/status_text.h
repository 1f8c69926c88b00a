// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/stage_status.h"

#include <QString>

namespace dyncal {

/// Shape and word of how a stage stands: never colour alone.
QString statusGlyph(StageStatus status); ///< "●", "▲", "■", "◌", "–", "⟳"
QString statusWord(StageStatus status);

} // namespace dyncal
