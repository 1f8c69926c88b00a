// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/json_codec.h"
#include "core/project/recipe.h"

namespace dyncal {

/// The keys of recipe.json, section by section: the one table that reading, writing and the check
/// of docs/recipe.md go by. Internal to core/project.
Codec<ImportSettings> importCodec();
Codec<CheckSettings> checksCodec();
Codec<ShockSettings> shockCodec();
Codec<WindowSettings> windowCodec();
Codec<SpectrumSettings> spectrumCodec();
Codec<ComponentSettings> componentCodec();
Codec<InputSettings> inputCodec();
Codec<RealizationSettings> realizationCodec();
Codec<ResponseSettings> responseCodec();
Codec<UncertaintySettings> uncertaintyCodec();
Codec<Acknowledgement> acknowledgementCodec();
Codec<CertificateSettings> certificateCodec();

} // namespace dyncal
