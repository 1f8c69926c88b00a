// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/current_utc.h"
#include "ui/shell/correction/correction_window.h"

#include <QPointer>

namespace dyncal {

class FileActions;
class Language;
class RegistryWindow;

/// Windows beside the main one that are opened by its menus.
class ToolWindows : public QObject
{
    Q_OBJECT

public:
    /// What they work with.
    struct Parts
    {
        Session &session;
        CurrentUtc currentUtc;
        Prompts &prompts;
        Preferences &preferences;
        Language &language;
        FileActions &files;
    };

    ToolWindows(Parts parts, QWidget *window);
    ~ToolWindows() override; ///< work in hand stops

    void testInstallation();
    void correctRecording(); ///< the one that is there comes to the front
    void showRegistry(); ///< the same
    void issueCertificate();

private:
    Parts m_parts;
    QWidget *m_window;
    QPointer<CorrectionWindow> m_correction;
    QPointer<RegistryWindow> m_registry;
};

} // namespace dyncal
