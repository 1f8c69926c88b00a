// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>

namespace dyncal {

class Banner;
class FileActions;
enum class BannerAction;

/// Says above every page why the project that is open is read-only, and by whom it is held, or that
/// it is of an older version, before it is written anew.
class ProjectNotice : public QObject
{
    Q_OBJECT

public:
    ProjectNotice(FileActions &files, Banner &banner, QObject *parent);

    void showWords(); ///< in the language of the moment

private:
    QString sentence() const;
    void show();
    void obey(BannerAction action);

    FileActions &m_files;
    Banner &m_banner;
    QString m_closed; ///< the sentence that was closed; empty: none
};

} // namespace dyncal
