// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/certificate/certificate_data.h"

#include <string>

namespace dyncal {

/// A document of words and tables, without figures, as the bytes of a PDF, in its own language
/// (CertificatePdf). All at once: a few pages take a tenth of a second. Needs a QApplication; fails
/// (Internal) without one, or if it could not be painted.
Result<std::string> documentPdf(const CertificateData &data);

} // namespace dyncal
