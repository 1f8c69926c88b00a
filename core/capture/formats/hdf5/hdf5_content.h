// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/capture/formats/hdf5/hdf5_tree.h"

#include <string>

namespace dyncal {

// A capture states hashes of all its content, so that any change is noticed and located. The
// samples count through raw_sha256, an attribute of their dataset.

constexpr const char *kContentHash = "content_sha256"; ///< of the list; attribute of the root
constexpr const char *kContentList = "content_list"; ///< attribute of the root

/// One line for every group and dataset: SHA-256 of its own attributes, member names, type and
/// shape, two blanks, its path. The two attributes of the root that hold the list and its hash are
/// left out. How each is hashed: docs/method/captures.md.
std::string contentList(const Hdf5Tree &tree);

/// Whether a capture states what it must hold.
bool statesContent(const Hdf5Attributes &root);

/// CAP-015, which blocks, for every place where the file no longer says what was written; `path` is
/// the file's. None for a file that states nothing.
Findings checkContent(const Hdf5Tree &tree, const std::string &path);

} // namespace dyncal
