// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Qt 6.4 paints large areas by threads of its global pool and waits for each part. Where the
/// system gives no thread then, the window waits for ever. So the pool gets one thread while there
/// is memory, and keeps it; it never asks for another. To be called before the first painting and
/// after onEndRequest(), which every thread has to know. False if there is no thread to be had:
/// then the program can only leave by _exit(), as the pool's own end waits for it too.
bool keepPaintingThread();

} // namespace dyncal
