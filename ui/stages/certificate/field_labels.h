// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"

#include <QString>

#include <string>
#include <string_view>

namespace dyncal {

/// The field of certificate.fields in that certificate; null where it is not printed.
const CertificateField *fieldOf(const CertificateData &data, std::string_view key);

/// A field of certificate.fields as a certificate prints it, with nothing in it: its label, and
/// whether it must be there; null where it is not printed. Valid for ever.
const CertificateField *printedField(const std::string &key);

/// What a form calls a field of certificate.fields, in the language of the window: as it is
/// printed, or "Country of the laboratory" for "laboratory_country"; empty for what is no field.
QString fieldLabel(const std::string &key);

} // namespace dyncal
