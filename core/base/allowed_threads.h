// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// How many threads one piece of work may use: as many as there are processors, at least 1; 1 after
/// useOneThread(). No result depends on it.
unsigned allowedThreads();

/// From now on everything in this process is done on the thread that asks for it: where many
/// calibrations run side by side, each in a process of its own, further threads only wait.
void useOneThread();

} // namespace dyncal
