// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/capture/check_settings.h"

namespace dyncal {

/// Findings about the recordings as such, before anything is cut (catalogue: docs/findings.md):
/// CAP-002 no DUT, CAP-004 rates differ, CAP-005 lengths differ, CAP-006 invalid samples (caution
/// here; the window stage blocks those inside it), CAP-007 saturated, CAP-008 flat, CAP-011 same
/// data twice, CAP-015 samples out of reach, CAP-017 one shot. Only included shots are looked at,
/// each channel in one pass.
Findings checkCaptures(const CaptureSet &set, const CheckSettings &settings = {});

} // namespace dyncal
