// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Keeps what a program holds of the system's memory near what it uses, over a day of opening and
/// closing: blocks from 4 MiB on go back to the system when they are freed, and threads share two
/// heaps. Without it the window had 230 MiB where it used 90 (docs/benchmarks.md). To be called
/// once, before threads start. Does nothing but with the GNU C library.
void keepHeapCompact();

} // namespace dyncal
