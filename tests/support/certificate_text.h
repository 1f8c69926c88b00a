// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"

#include <string>

namespace dyncal::testing {

/// What the certificate says of a quantity: "2.33 MHz | 0.12 MHz | 2" where it is a key result, the
/// words beside it where it is none, "no row" where it is not named.
inline std::string keyResult(const CertificateData &data, const std::string &label)
{
    const CertificateSection *section = data.section("key-results");
    if (!section)
        return "no section";
    for (const CertificateTable &table : section->tables)
        for (const std::vector<Message> &row : table.rows) {
            if (english(row.front()) != label)
                continue;
            std::string text = english(row.at(1));
            for (std::size_t i = 2; i < row.size(); ++i)
                text += " | " + english(row[i]);
            return text;
        }
    return "no row";
}

} // namespace dyncal::testing
