// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>

namespace dyncal {

/// Whether the bytes of a logo's file (ends in .png or .svg) can be drawn without harm. Fails
/// (Usage) where a PNG has no head of one or is larger than 4000 pixels in width or height; and
/// where an SVG has no element svg, or refers to anything (href, url beyond its own parts),
/// declares entities or holds scripts or style sheets: it must stand by itself.
Result<void> checkLogo(const std::string &name, const std::string &bytes);

} // namespace dyncal
