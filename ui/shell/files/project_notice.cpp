// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/project_notice.h"

#include "ui/shell/banner/banner.h"
#include "ui/shell/files/file_actions.h"
#include "ui/text/core_text.h"

namespace dyncal {

ProjectNotice::ProjectNotice(FileActions &files, Banner &banner, QObject *parent)
    : QObject(parent)
    , m_files(files)
    , m_banner(banner)
{
    // What was said of the one before, and closed, is said again.
    connect(&files, &FileActions::jobStarted, this, [this] { m_closed.clear(); });
    connect(&files, &FileActions::projectChanged, this, &ProjectNotice::show);
    connect(&banner, &Banner::chosen, this, &ProjectNotice::obey);
}

void ProjectNotice::showWords()
{
    m_banner.showWords();
    show();
}

QString ProjectNotice::sentence() const
{
    if (m_files.readOnlyReason())
        return translated(*m_files.readOnlyReason());
    return m_files.olderProject() ? translated(m_files.olderProject()->message) : QString();
}

void ProjectNotice::show()
{
    const QString words = sentence();
    if (words.isEmpty())
        m_closed.clear();
    if (words == m_closed) {
        m_banner.hide();
        return;
    }
    std::vector<BannerAction> actions{BannerAction::Close};
    if (m_files.readOnlyReason())
        actions.push_back(BannerAction::ReadAgain);
    m_banner.present(words, actions);
}

void ProjectNotice::obey(BannerAction action)
{
    if (action == BannerAction::ReadAgain) {
        m_files.openAgain();
        return;
    }
    m_closed = sentence();
    m_banner.hide();
}

} // namespace dyncal
