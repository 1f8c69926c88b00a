// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <string_view>

namespace dyncal {

/// A folder name for the sensor, another one for every id: '/' becomes '+', and what file systems
/// or shells take for something else (controls, quotes, blanks at the ends, '+' and '%' themselves,
/// a leading dot or dash) becomes %XX. Names longer than 150 bytes are cut and end with a hash of
/// the id. `id` is UTF-8.
std::string sensorFolderName(std::string_view id);

} // namespace dyncal
