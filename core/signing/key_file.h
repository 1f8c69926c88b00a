// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/signing/key_material.h"
#include "core/signing/secret_bytes.h"

namespace dyncal {

/// Key and certificates of a PKCS#12 or PEM file, whichever it is; of a PEM file the first key
/// to which one of its certificates belongs, wherever they stand. Errors as SigningKey::open() has
/// them.
Result<KeyMaterial> keyOfFile(const std::string &path, const SecretBytes &secret);

} // namespace dyncal
