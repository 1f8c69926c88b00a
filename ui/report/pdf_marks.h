// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QByteArray>

#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// The metadata (XMP) of an issued certificate, with its marks as properties of a namespace of
/// Dyncal's. They stand in the file as readable text, so that dyncal verify can compare them
/// without reading pages (registry/issued).
QByteArray metadataOf(const std::vector<std::pair<std::string, std::string>> &marks);

} // namespace dyncal
