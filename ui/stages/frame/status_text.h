// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/page_standing.h"

#include <QString>

namespace dyncal {

/// Shape and word of how a stage stands: never colour alone.
QString statusGlyph(StageStatus status); ///< "●", "▲", "■", "◌", "□", "–", "⟳"
QString statusWord(StageStatus status);
/// With the reason where there is one: "blocked by Captures", "not complete: 12 fields are empty".
QString standingWord(const PageStanding &standing, Page page);
/// As the stage list and the head of the page have it.
QString pageTitle(Page page);

} // namespace dyncal
