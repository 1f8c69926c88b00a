// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/project/certificate_template.h"

namespace dyncal {

/// The section kHistorySection in a draft, which knows of no other certificate: it says when it is
/// filled.
CertificateSection historyToCome();

} // namespace dyncal
