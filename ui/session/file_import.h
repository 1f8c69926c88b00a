// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/import_settings.h"

namespace dyncal {

/// The import section in which the file `path` is read as `wanted` says, and every other file as
/// before. What `wanted` says of shots and of other files is ignored.
ImportSettings withOwnSettings(
    const ImportSettings &settings, const std::string &path, const ImportSettings &wanted);

/// The import section in which all files are read as `wanted` says, the file `path` included.
ImportSettings withSettingsForAll(
    const ImportSettings &settings, const std::string &path, const ImportSettings &wanted);

} // namespace dyncal
