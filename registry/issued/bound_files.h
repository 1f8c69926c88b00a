// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <map>
#include <string>

namespace dyncal {

/// What the PDF of an issued certificate states of all files beside it (its mark "files"), so that
/// its signature binds them too: the SHA-256 of the lines "NAME SHA256", each with LF, in the order
/// of the names. Left out are the PDF itself; dcc.xml, which lies inside it and whose signature, by
/// a curve, is another each time; and what is written after it: the trail, whose head the PDF
/// states, the manifest and the list of what was written. `hashes`: SHA-256 by name.
std::string boundFilesHash(const std::map<std::string, std::string> &hashes);

} // namespace dyncal
