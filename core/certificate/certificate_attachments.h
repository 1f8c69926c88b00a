// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"

#include <map>
#include <string>
#include <vector>

namespace dyncal {

/// Which of the files of an issued certificate (bytes by name) lie inside its PDF too, in the order
/// in which they are attached: dcc.xml, where there is one, as the alternative to the pages, for
/// both are made of the same results; results.json as the data of tables and figures; recipe.json
/// as their supplement.
std::vector<CertificateAttachment> certificateAttachments(
    const std::map<std::string, std::string> &files);

} // namespace dyncal
