// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string_view>

namespace dyncal {

/// Whether an XML document keeps the limits of xml_limits.h in elements, levels, and attributes and
/// namespaces of an element, counted by its tags before anything parses it: libraries compare each
/// name of an element with each other, and look for a namespace in all elements around. Of what is
/// no sound XML as far as its tags go. Takes time linear in the bytes.
bool keepsXmlLimits(std::string_view xml);

} // namespace dyncal
