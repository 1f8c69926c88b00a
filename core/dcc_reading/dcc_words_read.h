// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/xml/parsed_xml.h"

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// What an element of dcc:textType says: its content in English, else the first; "" where it is
/// null or has none.
std::string wordsOfText(const ParsedElement *element);

/// The words of an attribute: refType="basic_measuredValue vib_phase" has two.
std::vector<std::string> wordsOfAttribute(const ParsedElement &element, std::string_view name);

} // namespace dyncal
