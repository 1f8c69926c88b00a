// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/reference/comparison_settings.h"

#include <memory>
#include <string>

namespace dyncal {

/// The file at `source`, relative to `folder` ("" = where the program runs); null where it cannot
/// be read and where it is larger than the 16 MiB that any certificate needs.
std::shared_ptr<const ReferenceSource> sourceAt(
    const std::string &folder, const std::string &source);

/// Where a run keeps a copy of the file, relative to its folder: by this name a recipe that lies
/// there is repeated though its `source` is relative to where it lay before.
std::string keptSourceName(const std::string &source, const std::string &sha256);

/// Whether a run may have given this name to such a copy.
bool isKeptSourceName(const std::string &name);

/// Reads the file of settings.source into settings.loaded, which stays empty without a source;
/// where there is no such file the copy that a run kept of it. Its hash is stated from then on:
/// what was computed with it must not be repeated with another one.
template <typename Settings>
void loadSource(const std::string &folder, Settings &settings)
{
    settings.loaded = settings.source.empty() ? nullptr : sourceAt(folder, settings.source);
    if (!settings.source.empty() && !settings.loaded && !settings.sha256.empty())
        settings.loaded = sourceAt(folder, keptSourceName(settings.source, settings.sha256));
    if (settings.loaded && settings.sha256.empty())
        settings.sha256 = settings.loaded->sha256;
}

} // namespace dyncal
