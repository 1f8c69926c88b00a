// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Memory of the window (docs/adr/0017-drawing-process.md). Qt ends the program where its own
/// allocations fail. So a part is kept back that only the thread of the window gets, once nothing
/// else is left: background jobs run out of memory first, and report it as an error like any other.

/// Called by the thread of the window before it uses Qt: reserves that part. False if this computer
/// or its limits have too little for a window.
bool keepMemoryForWindow();

/// Whether any of that part was used since the last call.
bool wasWindowMemoryUsed();

} // namespace dyncal
