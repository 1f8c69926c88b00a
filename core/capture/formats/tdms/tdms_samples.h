// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/capture/formats/tdms/tdms_layout.h"
#include "core/capture/formats/tdms/tdms_scale.h"
#include "core/capture/raw_samples.h"

#include <memory>
#include <string>
#include <vector>

namespace dyncal {

/// One record of a TDMS channel.
struct TdmsRecord
{
    RawSamples samples;
    std::vector<double> polynomial{0.0, 1.0}; ///< of Channel
    bool bareCounts = false; ///< counts of a converter without any scale
    std::string suffix; ///< of the channel's name, where it gives several records
};

/// Makes records of channels. Samples stay in the file: integers and floating point numbers as they
/// are, all others (32 bit unsigned, 64 bit integers, truth values, digital lines, scales that are
/// no polynomial) computed as they are read.
class TdmsRecords
{
public:
    explicit TdmsRecords(std::shared_ptr<const SampleFile> file);

    /// The records of a channel that has samples: one, or one per kind of count where DAQmx counts
    /// of several kinds have no scale. `holders`: see tdmsScaleChain. Fails with a sentence (%1 =
    /// channel) on scales that cannot be applied and on integers beyond 2^53, which a double cannot
    /// hold exactly.
    tl::expected<std::vector<TdmsRecord>, Message> of(
        const TdmsObject &channel, std::span<const TdmsProperties *const> holders);

private:
    tl::expected<TdmsRecord, Message> unscaled(const TdmsObject &channel, std::size_t stream);
    tl::expected<TdmsRecord, Message> scaled(const TdmsObject &channel, TdmsScaleChain chain);
    tl::expected<void, Message> checkLargeIntegers(
        const std::string &channel, const TdmsStream &stream);

    std::shared_ptr<const SampleFile> m_file;
    std::uint64_t m_scanBytesLeft; ///< all channels together have no more than the file
};

} // namespace dyncal
