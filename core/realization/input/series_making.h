// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/series_source.h"
#include "core/signal/resampler.h"

namespace dyncal {

/// The series of `samples` samples from sample `first` of the source on, resampled through the
/// filter, with its noise and rounding. Level and step are not filled in.
ModelSeries makeSeries(
    const SeriesSource &source, const AntiAliasFilter &filter, Index first, Index samples);

} // namespace dyncal
