// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/source_notice.h"

#include "ui/session/session.h"
#include "ui/shell/banner/banner.h"
#include "ui/shell/import/capture_import.h"
#include "ui/stages/frame/prompts.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QFileInfo>

#include <algorithm>

namespace dyncal {

SourceNotice::SourceNotice(
    Session &session, CaptureImport &captures, Prompts &prompts, Banner &banner, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_captures(captures)
    , m_prompts(prompts)
    , m_banner(banner)
{
    connect(&session, &Session::sourcesChanged, this, &SourceNotice::show);
    connect(&banner, &Banner::chosen, this, &SourceNotice::obey);
}

void SourceNotice::showWords()
{
    m_banner.showWords();
    show();
}

void SourceNotice::show()
{
    const std::vector<ChangedSource> &changed = m_session.changedSources();
    if (changed.empty()) {
        m_banner.hide();
        return;
    }
    QStringList sentences{translated(changed.front().finding.message)};
    if (changed.size() > 1)
        sentences << tr("%n more file(s) likewise.", nullptr, static_cast<int>(changed.size()) - 1);
    std::vector<BannerAction> actions{BannerAction::ReadAgain};
    if (std::ranges::any_of(changed, &ChangedSource::isMissing))
        actions.push_back(BannerAction::Locate);
    m_banner.present(sentences.join(' '), actions);
}

void SourceNotice::obey(BannerAction action)
{
    if (action == BannerAction::ReadAgain) {
        m_captures.rereadJob({});
        return;
    }
    const auto &inputs = m_session.state().captures->inputs;
    const QString beside
        = inputs.empty() ? QString() : QFileInfo(rawText(inputs.front().path)).absolutePath();
    const QString folder
        = m_prompts.folder(m_banner.window(), tr("Folder of the recordings"), beside);
    if (!folder.isEmpty())
        m_captures.rereadJob(folder);
}

} // namespace dyncal
