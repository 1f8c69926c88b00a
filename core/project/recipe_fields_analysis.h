// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/decomposition/component_settings.h"
#include "core/model_analysis/response_settings.h"
#include "core/project/certificate_settings.h"
#include "core/project/json_codec.h"
#include "core/realization/input/realization_settings.h"
#include "core/shock/uncertainty_settings.h"
#include "core/signal/signal_settings.h"

namespace dyncal {

/// The keys of recipe.json for components, model and results, as recipe_fields_import.h.
Codec<ComponentSettings> componentCodec();
Codec<InputSettings> inputCodec();
Codec<RealizationSettings> realizationCodec();
Codec<ResponseSettings> responseCodec();
Codec<UncertaintySettings> uncertaintyCodec();
Codec<Acknowledgement> acknowledgementCodec();
Codec<CertificateSettings> certificateCodec();

} // namespace dyncal
