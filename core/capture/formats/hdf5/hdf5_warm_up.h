// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// At its first call describes a small file in memory. What library and loader set up for a first
/// file then exists in every helper process that is forked later; otherwise each would do it again,
/// which is a quarter of the time for a folder of small recordings. The library's mutex must be
/// held.
void warmHdf5Up();

} // namespace dyncal
