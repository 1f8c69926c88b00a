// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"
#include "ui/shell/files/file_actions.h"
#include "ui/shell/preferences/language.h"
#include "ui/shell/preferences/preferences.h"

#include <QKeySequence>
#include <QStringList>

#include <functional>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QToolBar;

namespace dyncal {

class ToolWindows;

/// The menu bar and the tool bar of the main window.
class MainMenus : public QObject
{
    Q_OBJECT

public:
    /// What the menus act on.
    struct Parts
    {
        QMainWindow &window;
        Session &session;
        FileActions &files;
        Preferences &preferences;
        Language &language;
        std::vector<std::pair<QDockWidget *, QString>> docks; ///< with the key that shows or hides
        std::function<void()> resetLayout;
        std::function<void()> savePlots; ///< of all pages
        std::function<void(int row)> showPage;
        std::function<void(int by)> turnPage; ///< to the next stage or the one before
        std::function<void()> showBatch;
        ToolWindows &tools;
    };

    explicit MainMenus(Parts parts, QObject *parent);

    /// Builds the menus in the current language; to be called again after it has changed. `stages`:
    /// the titles of the pages.
    void build(const QStringList &stages);

private:
    void addFileMenu();
    void addViewMenu();
    void addThemeMenu(QMenu *view);
    void addStageMenu(const QStringList &stages);
    void addLanguageMenu();
    void addHelpMenu();
    void fillToolBar();
    QAction *addAction(QMenu *menu, const QString &name, const QString &text,
        const QKeySequence &keys, const std::function<void()> &what);
    void fillRecent();

    Parts m_parts;
    QMenu *m_recent = nullptr;
    QToolBar *m_toolBar;
};

} // namespace dyncal
