// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/json_codec.h"
#include "core/shock/shock_settings.h"
#include "core/signal/signal_settings.h"

namespace dyncal {

/// The keys of recipe.json for shock, window and spectrum, as recipe_fields_import.h.
Codec<ShockSettings> shockCodec();
Codec<WindowSettings> windowCodec();
Codec<SpectrumSettings> spectrumCodec();

} // namespace dyncal
