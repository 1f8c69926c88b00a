// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/dcc/dcc_quantity.h"

namespace dyncal {

/// A table of the certificate as dcc:list: a quantity for each column, its U and k with the values
/// they belong to, digit by digit as printed. A cell without a number is NaN, and its words stand
/// in a quantity of words beside it, one content for each row.
XmlElement dccListOf(const DccWords &words, const CertificateTable &table);

/// A section of the certificate as dcc:result: its sentences, fields and tables.
XmlElement dccResultOf(const DccWords &words, const CertificateSection &section);

/// The key results: each row a quantity of its own, and what is known of those that are none.
XmlElement dccKeyResults(const DccWords &words, const CertificateSection &section);

} // namespace dyncal
