// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/base/writing/claim_text.h"
#include "core/base/writing/folder_recovery.h"

namespace dyncal {

/// Removes or completes what a killed program left under this claim (which plans are trusted:
/// recoverFolder). Fails if it has to stay.
Result<void> clearStray(int folder, const ClaimText &claim, const NameRule &mayWrite);

} // namespace dyncal
