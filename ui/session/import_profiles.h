// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/import_settings.h"

#include <QStringList>

namespace dyncal {

/// Ways to read files under names of their own: recipe import sections in a folder of the user's,
/// one file each, which the command line takes as recipes, too.
class ImportProfiles
{
public:
    explicit ImportProfiles(const QString &folder);

    QStringList names() const; ///< sorted
    Result<ImportSettings> load(const QString &name) const;
    /// Leaves out settings of single shots and files. Replaces a profile of the same name.
    Result<void> save(const QString &name, ImportSettings settings) const;

private:
    QString pathOf(const QString &name) const;

    QString m_folder;
};

/// Whether the text can be a profile's name: it becomes the name of a file.
bool isProfileName(const QString &name);

} // namespace dyncal
