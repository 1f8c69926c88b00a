// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"
#include "ui/shell/file_actions.h"
#include "ui/shell/language.h"
#include "ui/shell/preferences.h"

#include <QKeySequence>

#include <functional>

class QAction;
class QDockWidget;
class QMenu;

namespace dyncal {

class MainWindow;

/// The menu bar of the main window.
class MainMenus : public QObject
{
    Q_OBJECT

public:
    /// What the menus act on.
    struct Parts
    {
        MainWindow &window;
        Session &session;
        FileActions &files;
        Preferences &preferences;
        Language &language;
        std::vector<std::pair<QDockWidget *, QString>> docks; ///< with the key that shows or hides
    };

    explicit MainMenus(Parts parts, QObject *parent);

    void build(); ///< in the language of the moment; again after it has changed

private:
    void addFileMenu();
    void addViewMenu();
    void addStageMenu();
    void addLanguageMenu();
    void addHelpMenu();
    QAction *addAction(QMenu *menu, const QString &name, const QString &text,
        const QKeySequence &keys, const std::function<void()> &what);
    void fillRecent();

    Parts m_parts;
    QMenu *m_recent = nullptr;
};

} // namespace dyncal
