// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/recovery/work_recovery.h"

#include "ui/session/example.h"
#include "ui/shell/banner/banner.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QFileInfo>
#include <QLabel>
#include <QStatusBar>

namespace dyncal {

namespace {

/// "12 s", then minutes, hours and days.
QString durationText(qint64 seconds)
{
    constexpr qint64 kMinute = 60;
    constexpr qint64 kHour = 60 * kMinute;
    constexpr qint64 kDay = 24 * kHour;
    if (seconds < 2 * kMinute)
        return WorkRecovery::tr("%1 s").arg(seconds);
    if (seconds < 2 * kHour)
        return WorkRecovery::tr("%1 min").arg(seconds / kMinute);
    if (seconds < 2 * kDay)
        return WorkRecovery::tr("%1 h").arg(seconds / kHour);
    return WorkRecovery::tr("%1 days").arg(seconds / kDay);
}

/// The project's name, or the recordings' where it was never saved.
QString nameOf(const RecoveredWork &work)
{
    if (!work.project.isEmpty())
        return shownText(QFileInfo(work.project).completeBaseName());
    if (work.recordings.isEmpty())
        return WorkRecovery::tr("an unsaved project");
    if (work.recordings.first() == kExamplePath)
        return WorkRecovery::tr("the example");
    if (work.recordings.size() == 1)
        return shownText(work.recordings.first());
    return WorkRecovery::tr("%1 and %n more", nullptr, static_cast<int>(work.recordings.size()) - 1)
        .arg(shownText(work.recordings.first()));
}

} // namespace

WorkRecovery::WorkRecovery(const Parts &parts, const CurrentUtc &currentUtc, const QString &folder,
    const AutoSaveDelays &delays, QObject *parent)
    : QObject(parent)
    , m_parts(parts)
    , m_currentUtc(currentUtc)
    , m_store(folder)
    , m_autoSave(parts.session, m_store, currentUtc, delays)
    , m_offers(m_store.leftBehind())
    , m_notes(m_store.unreadable())
    , m_status(new QLabel(&parts.statusBar))
{
    m_status->setObjectName("autoSaveStatus");
    m_status->setMinimumWidth(1); // a long reason is cut; the tool tip has all of it
    parts.statusBar.addPermanentWidget(m_status);
    connect(&parts.files, &FileActions::projectChanged, this, [this] { followProject(); });
    connect(&parts.files, &FileActions::workRestored, this, &WorkRecovery::takeRestored);
    connect(&parts.files, &FileActions::restoreFailed, this, &WorkRecovery::showFailedRestore);
    connect(&parts.banner, &Banner::chosen, this, &WorkRecovery::obey);
    connect(&m_autoSave, &AutoSave::saved, this, &WorkRecovery::showSaved);
    connect(&m_autoSave, &AutoSave::failed, this, &WorkRecovery::showFailure);
    connect(&m_autoSave, &AutoSave::nothingToSave, this, [this] { showSaved({}); });
    followProject();
    showNext();
}

void WorkRecovery::followProject()
{
    m_autoSave.setProject(m_parts.files.projectPath(), m_parts.files.projectHash());
}

void WorkRecovery::showWords()
{
    m_parts.banner.showWords();
    showNext();
    showStatus();
}

void WorkRecovery::end()
{
    finishDiscard();
    m_autoSave.end();
}

void WorkRecovery::showNext()
{
    using enum BannerAction;
    if (!m_offers.empty() && m_isDiscarded) {
        m_parts.banner.present(
            tr("The recovered work on %1 is discarded.").arg(nameOf(m_offers.front())),
            {Undo, Close});
    } else if (!m_offers.empty()) {
        const QString sentence = offerSentence(m_offers.front());
        if (m_notRestored)
            m_parts.banner.present(sentence, {Restore, Locate, Discard, NotNow});
        else
            m_parts.banner.present(sentence, {Restore, Discard, NotNow});
    } else if (!m_notes.empty()) {
        m_parts.banner.present(
            tr("Work of a stopped program could not be read: %1 It is kept as %2.")
                .arg(translated(m_notes.front().error.message), shownText(m_notes.front().keptAs)),
            {Close});
    } else {
        m_parts.banner.hide();
    }
}

QString WorkRecovery::offerSentence(const RecoveredWork &work) const
{
    const qint64 before_s = std::max<qint64>(work.saved.secsTo(work.stopped), 0);
    QStringList sentences{tr("Recovered work on %1 from %2 (%3 before stop).")
                              .arg(nameOf(work), timeText(work.saved), durationText(before_s))};
    const QFileInfo project(work.project);
    if (!work.project.isEmpty() && project.lastModified() > work.stopped)
        sentences
            << tr("The project was saved after that, at %1.").arg(timeText(project.lastModified()));
    if (m_offers.size() > 1)
        sentences << tr("%n more after this one.", nullptr, static_cast<int>(m_offers.size()) - 1);
    if (m_notRestored)
        sentences << tr("It is kept, but could not be opened now: %1")
                         .arg(translated(m_notRestored->message));
    return sentences.join(' ');
}

/// The clock's time, with the date unless that is today's.
QString WorkRecovery::timeText(const QDateTime &utc) const
{
    const QDateTime local = utc.toLocalTime();
    const QDateTime today = timeOf(m_currentUtc).toLocalTime();
    return local.toString(local.date() == today.date() ? QStringLiteral("HH:mm:ss")
                                                       : QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

void WorkRecovery::obey(BannerAction action)
{
    switch (action) {
    case BannerAction::Restore:
        restore({});
        break;
    case BannerAction::Locate:
        locate();
        break;
    case BannerAction::Discard:
    case BannerAction::Undo:
        m_isDiscarded = action == BannerAction::Discard;
        showNext();
        break;
    case BannerAction::NotNow:
    case BannerAction::Close:
        nextOffer();
        break;
    case BannerAction::ReadAgain: // not offered here
        break;
    }
}

void WorkRecovery::restore(const QString &recordings)
{
    m_parts.files.restoreWork(m_offers.front(), recordings);
}

/// The recordings were moved: they are taken from another folder, by their names.
void WorkRecovery::locate()
{
    const QString folder = m_parts.prompts.folder(m_parts.banner.window(),
        tr("Folder of the recordings"), QFileInfo(m_offers.front().project).absolutePath());
    if (!folder.isEmpty())
        restore(folder);
}

void WorkRecovery::takeRestored(const QString &file)
{
    m_autoSave.adopt(file);
    m_notRestored.reset();
    std::erase_if(m_offers, [&](const RecoveredWork &work) { return work.file == file; });
    showNext();
}

void WorkRecovery::showFailedRestore(const QString &file, const Error &error)
{
    if (error.kind == ErrorKind::Cancelled || m_offers.empty() || m_offers.front().file != file)
        return;
    m_notRestored = error;
    showNext();
}

void WorkRecovery::finishDiscard()
{
    if (m_isDiscarded)
        m_store.discard(m_offers.front().file);
    m_isDiscarded = false;
}

void WorkRecovery::nextOffer()
{
    finishDiscard();
    m_notRestored.reset();
    if (!m_offers.empty())
        m_offers.erase(m_offers.begin());
    else
        m_notes.erase(m_notes.begin());
    showNext();
}

void WorkRecovery::showSaved(const QDateTime &utc)
{
    m_saved = utc;
    m_failure.reset();
    showStatus();
}

void WorkRecovery::showFailure(const Error &error)
{
    m_failure = error;
    showStatus();
}

void WorkRecovery::showStatus()
{
    QString text;
    if (m_failure)
        text = tr("Not auto-saved: %1").arg(translated(m_failure->message));
    else if (m_saved.isValid())
        text = tr("Auto-saved %1").arg(timeText(m_saved));
    if (text == m_status->text())
        return;
    m_status->setText(text);
    m_status->setToolTip(text);
}

} // namespace dyncal
