// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Qt 6.4 paints large areas by threads of its global pool and waits for each part. Where the
/// system gives no thread then, the window waits for ever. So the pool gets one thread while there
/// is memory, and keeps it; it never asks for another. Call it before the first painting, and after
/// onEndRequest(), whose blocked signals the thread inherits. False if the system gives no thread:
/// the program can then only leave by _exit(), because the destructor of the pool would wait for
/// the thread too.
bool keepPaintingThread();

} // namespace dyncal
