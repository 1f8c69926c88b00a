// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/base/writing/claim_text.h"

namespace dyncal {

/// Removes what a claim without a program stands for, or completes it. Fails if it has to stay.
Result<void> clearStray(int folder, const ClaimText &claim);

} // namespace dyncal
