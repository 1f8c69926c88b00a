// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <span>

namespace dyncal {

/// What a control does, by its object name; one that ends in '_' is the beginning of several.
struct TipText
{
    const char *name;
    const char *sentence; ///< in English, of the translation context "ControlTips"
};

std::span<const TipText> tipTexts();

} // namespace dyncal
