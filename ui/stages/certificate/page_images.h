// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <QImage>

#include <string>
#include <vector>

namespace dyncal {

/// The pages of a PDF as pictures, each `width_px` wide and as high as the page wants (1 and more).
/// On any thread. Stops between pages (Cancelled); fails (FileUnreadable) where it is no PDF or a
/// page cannot be drawn.
Result<std::vector<QImage>> pageImages(
    const std::string &pdf, int width_px, const JobControl &control = {});

} // namespace dyncal
