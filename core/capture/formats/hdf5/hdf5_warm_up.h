// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Describes a small file in memory, the first time it is called. What the library sets up and the
/// loader looks up for its first file is then there for every helper process that is forked later,
/// which would do it anew for each file: a quarter of the time of a folder of small recordings.
/// The library's mutex must be held.
void warmHdf5Up();

} // namespace dyncal
