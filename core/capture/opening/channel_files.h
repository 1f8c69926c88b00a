// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

// Oscilloscopes that save every channel to a file of its own: C1shot00001.trc, C2shot00001.trc.

/// The one place in a file's name that says which channel it holds.
struct ChannelFileName
{
    std::string others; ///< the path without that digit: equal for files of one recording
    std::size_t digit = 0; ///< where in the path it is
    int channel = 0; ///< 1 to 8
};

/// Empty if the name states no channel ("C1", "ch2", "CHAN3" as a word; "C1" also before a word),
/// or more than one.
std::optional<ChannelFileName> channelFileName(const std::string &path);

/// Files in the same folder that may be the other channels of `path`, itself included, by channel;
/// empty if there are none.
std::vector<std::string> channelFilesBeside(const std::string &path);

/// Makes one shot of the shots that oscilloscope files hold of the same recording: the names differ
/// in the channel only, and format, number of shots, length, rate, time of the first sample (to
/// half an interval) and, where one states it, the time of recording are equal; no two channels
/// have the same name. Otherwise the files stay apart. The first shot takes the channels of the
/// others, which are dropped, so that earlier shots keep their numbers. Reports what it joined
/// (CAP-029).
void joinChannelFiles(CaptureSet &set);

} // namespace dyncal
