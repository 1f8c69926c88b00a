// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"
#include "ui/shell/findings/finding_corrections.h"
#include "ui/shell/import/capture_import.h"
#include "ui/stages/frame/prompts.h"

namespace dyncal {

/// Asks why a result is used in spite of findings of one id, and keeps the reason in the recipe.
void acknowledge(const Findings &findings, Session &session, Prompts &prompts, QWidget *parent);

/// Does what a finding's button offers: opens the import of a file, or changes the recipe, with a
/// reason where one is needed.
void applyCorrection(const OfferedCorrection &correction, Session &session, CaptureImport &captures,
    Prompts &prompts, QWidget *parent);

} // namespace dyncal
