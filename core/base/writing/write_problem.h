// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>

namespace dyncal {

/// Finding id of the error of a file that another program changed meanwhile.
inline constexpr const char *kChangedMeanwhile = "FIL-001";

/// "PATH cannot be written: REASON; WHAT TO DO." for an errno: Usage where the place is at fault,
/// Internal where writing itself is (a full disk, a limit).
tl::unexpected<Error> cannotWrite(const std::string &path, int errorNumber);

/// The same for the errno at hand.
tl::unexpected<Error> cannotWrite(const std::string &path);

/// Usage: the name is taken by something that may not be replaced.
tl::unexpected<Error> existsAlready(const std::string &path);

/// Usage: the folder was renamed, moved or replaced while it was being written.
tl::unexpected<Error> wasMoved(const std::string &path);

/// Usage: another program is writing there now.
tl::unexpected<Error> isBeingWritten(const std::string &path);

} // namespace dyncal
