// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/import_settings.h"
#include "ui/session/import_view.h"

#include <QString>

namespace dyncal {

/// Whether the file can be imported as it reads, and one sentence: what prevents it, what to look
/// at, or that all is well.
struct ImportVerdict
{
    bool mayImport = false;
    QString sentence;
};

/// `view` is null while the file is being read. `lacksName`: a profile is to be kept and has no
/// name that a file can have.
ImportVerdict importVerdict(const ImportView *view, const ImportSettings &settings, bool lacksName);

/// Marks a sentence as one that prevents the import.
QString blockingSentence(const QString &sentence);

} // namespace dyncal
