// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/guarded_run.h"
#include "core/base/progress.h"
#include "core/base/result.h"

#include <functional>
#include <span>
#include <string>

namespace dyncal {

/// Limits for describing a file; sound files take milliseconds and some MiB.
inline constexpr GuardedLimits kDescribingLimits{256U << 20, std::chrono::seconds(2)};

/// runGuarded for work with libhdf5 on the file `path`, while no other thread of ours is inside the
/// library. A helper that died means a damaged file (CAP-018).
Result<void> runHdf5Helper(const std::string &path,
    const std::function<void(GuardedOutput &)> &work,
    const std::function<bool(std::span<const std::byte>)> &receive, const GuardedLimits &limits,
    const JobControl &control);

} // namespace dyncal
