// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/auto_save.h"
#include "ui/session/recovery_store.h"
#include "ui/shell/files/file_actions.h"

#include <QObject>

class QLabel;
class QStatusBar;

namespace dyncal {

class Banner;
enum class BannerAction;

/// Keeps unsaved work while the window is open and offers what stopped programs left behind, one
/// after the other, in the banner. No dialog is opened unasked.
class WorkRecovery : public QObject
{
    Q_OBJECT

public:
    struct Parts
    {
        Session &session;
        FileActions &files;
        Prompts &prompts;
        Banner &banner;
        QStatusBar &statusBar;
    };
    WorkRecovery(const Parts &parts, const CurrentUtc &currentUtc, const QString &folder,
        const AutoSaveDelays &delays, QObject *parent);

    void showWords(); ///< in the language of the moment
    void end(); ///< the window closes in good order
    void leave() { m_autoSave.leave(); } ///< it has to end now; the work is offered again

private:
    void followProject();
    void showNext();
    void obey(BannerAction action);
    void restore(const QString &recordings);
    void locate();
    void nextOffer(); ///< the one on show is settled
    void takeRestored(const QString &file);
    void showFailedRestore(const QString &file, const Error &error);
    void showSaved(const QDateTime &utc);
    void showFailure(const Error &error);
    void showStatus();
    void finishDiscard();
    QString offerSentence(const RecoveredWork &work) const;
    QString timeText(const QDateTime &utc) const;

    Parts m_parts;
    CurrentUtc m_currentUtc;
    RecoveryStore m_store;
    AutoSave m_autoSave;
    std::vector<RecoveredWork> m_offers; ///< the first is on show
    std::vector<UnreadableWork> m_notes; ///< after the offers
    std::optional<Error> m_notRestored; ///< why the offer on show could not be opened
    bool m_isDiscarded = false; ///< the offer on show; its file is removed with the banner
    QDateTime m_saved; ///< invalid: nothing to say
    std::optional<Error> m_failure;
    QLabel *m_status;
};

} // namespace dyncal
