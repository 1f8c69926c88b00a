// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/raw_samples.h"

namespace dyncal::testing {

/// Whether type, number and every bit agree.
inline bool sameSamples(const RawSamples &a, const RawSamples &b)
{
    return a.type() == b.type() && a.size() == b.size() && sha256OfSamples(a) == sha256OfSamples(b);
}

} // namespace dyncal::testing
