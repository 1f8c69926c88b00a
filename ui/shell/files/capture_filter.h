// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

namespace dyncal {

/// What a file dialog offers: recordings of every format that can be read, and all files.
QString captureFilter();

} // namespace dyncal
