// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/main_menus.h"

#include "ui/shell/drawn_icon.h"
#include "ui/shell/help_dialogs.h"
#include "ui/shell/preferences/theme_style.h"
#include "ui/shell/shortcut_sheet.h"
#include "ui/shell/stage_list.h"
#include "ui/shell/tool_windows.h"
#include "ui/text/shown_text.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>

namespace dyncal {

MainMenus::MainMenus(Parts parts, QObject *parent)
    : QObject(parent)
    , m_parts(std::move(parts))
    , m_toolBar(new QToolBar(&m_parts.window))
{
    m_toolBar->setObjectName("toolBar");
    m_toolBar->setMovable(false);
    m_toolBar->setToolButtonStyle(Qt::ToolButtonIconOnly);
    m_parts.window.addToolBar(Qt::TopToolBarArea, m_toolBar);
}

QAction *MainMenus::addAction(QMenu *menu, const QString &name, const QString &text,
    const QKeySequence &keys, const std::function<void()> &what)
{
    QAction *action = menu->addAction(text);
    action->setObjectName(name);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, [what] { what(); });
    return action;
}

void MainMenus::build(const QStringList &stages)
{
    for (QAction *action : m_toolBar->actions())
        if (action->isSeparator())
            delete action; // all others are the menus'
    m_parts.window.menuBar()->clear();
    // Menus of another language would keep their actions' names.
    qDeleteAll(m_parts.window.menuBar()->findChildren<QMenu *>(Qt::FindDirectChildrenOnly));
    addFileMenu();
    QMenu *edit = m_parts.window.menuBar()->addMenu(tr("&Edit"));
    QAction *undo = m_parts.session.undoStack().createUndoAction(edit, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    undo->setObjectName("undoAction");
    QAction *redo = m_parts.session.undoStack().createRedoAction(edit, tr("&Redo"));
    redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    redo->setObjectName("redoAction");
    edit->addAction(undo);
    edit->addAction(redo);
    addViewMenu();
    addStageMenu(stages);
    addLanguageMenu();
    addHelpMenu();
    fillToolBar();
}

void MainMenus::fillToolBar()
{
    const std::pair<const char *, ToolSign> signs[]{{"openCapturesAction", ToolSign::OpenCaptures},
        {"openProjectAction", ToolSign::OpenProject}, {"saveAction", ToolSign::Save},
        {"exportCertificateAction", ToolSign::Export}, {"undoAction", ToolSign::Undo},
        {"redoAction", ToolSign::Redo}, {"previousStageAction", ToolSign::Back},
        {"nextStageAction", ToolSign::Forward}, {"recomputeAction", ToolSign::Compute}};
    m_toolBar->setWindowTitle(tr("Tool bar"));
    for (const auto &[name, sign] : signs) {
        auto *action = m_parts.window.menuBar()->findChild<QAction *>(QLatin1String(name));
        action->setIcon(toolIcon(sign));
        m_toolBar->addAction(action);
        if (sign == ToolSign::Export || sign == ToolSign::Redo || sign == ToolSign::Forward)
            m_toolBar->addSeparator();
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        const QString words = plainText(*action);
        action->setToolTip(keys.isEmpty() ? words : words + " (" + keys + ")");
    }
}

void MainMenus::addFileMenu()
{
    QMenu *menu = m_parts.window.menuBar()->addMenu(tr("&File"));
    FileActions *files = &m_parts.files;
    addAction(menu, "openCapturesAction", tr("Open &captures..."), QKeySequence("Ctrl+Shift+O"),
        [=] { files->openCaptures(); });
    addAction(menu, "openExampleAction", tr("Open &example"), {}, [=] { files->openExample(); });
    addAction(menu, "openProjectAction", tr("&Open project..."), QKeySequence::Open,
        [=] { files->openProject(); });
    m_recent = menu->addMenu(tr("&Recent"));
    connect(m_recent, &QMenu::aboutToShow, this, &MainMenus::fillRecent);
    addAction(menu, "useProfileAction", tr("Use pro&file of the laboratory..."), {},
        [=] { files->useProfile(); });
    addAction(menu, "batchAction", tr("&Batch..."), QKeySequence("Ctrl+B"), m_parts.showBatch);
    menu->addSeparator();
    addAction(menu, "saveAction", tr("&Save"), QKeySequence::Save, [=] { files->save(); });
    addAction(menu, "saveAsAction", tr("Save &as..."), QKeySequence("Ctrl+Shift+S"),
        [=] { files->saveAs(); });
    menu->addSeparator();
    addAction(menu, "exportResultsAction", tr("Export &results..."), QKeySequence("Ctrl+E"),
        [=] { files->exportResults(); });
    addAction(menu, "exportModelAction", tr("Export &model..."), QKeySequence("Ctrl+Shift+E"),
        [=] { files->exportModel(); });
    addAction(menu, "exportCertificateAction", tr("Export cer&tificate..."), QKeySequence("Ctrl+P"),
        [=] { files->exportCertificate(); });
    addAction(menu, "issueAction", tr("&Issue certificate..."), QKeySequence("Ctrl+I"),
        [this] { m_parts.tools.issueCertificate(); });
    addAction(
        menu, "registryAction", tr("Re&gistry..."), {}, [this] { m_parts.tools.showRegistry(); });
    addAction(menu, "saveAllPlotsAction", tr("Save all p&lots..."), QKeySequence("Ctrl+Shift+P"),
        m_parts.savePlots);
    menu->addSeparator();
    addAction(menu, "correctAction", tr("Correct a recordi&ng..."), {},
        [this] { m_parts.tools.correctRecording(); });
    menu->addSeparator();
    addAction(
        menu, "quitAction", tr("&Quit"), QKeySequence::Quit, [this] { m_parts.window.close(); });
}

void MainMenus::fillRecent()
{
    m_recent->clear();
    const QStringList recent = m_parts.preferences.recentFiles();
    for (const QString &path : recent)
        addAction(m_recent, {}, withoutMnemonic(shownText(path)), {}, [this, path] {
            if (m_parts.files.mayDiscard())
                m_parts.files.openProjectFile(path);
        });
    if (recent.isEmpty())
        m_recent->addAction(tr("Nothing yet"))->setEnabled(false);
}

void MainMenus::addViewMenu()
{
    QMenu *menu = m_parts.window.menuBar()->addMenu(tr("&View"));
    for (const auto &[dock, key] : m_parts.docks) {
        QAction *action = dock->toggleViewAction();
        action->setShortcut(QKeySequence(key));
        menu->addAction(action);
    }
    menu->addSeparator();
    addThemeMenu(menu);
    addAction(menu, "resetLayoutAction", tr("&Reset layout"), {}, m_parts.resetLayout);
}

void MainMenus::addThemeMenu(QMenu *view)
{
    QMenu *menu = view->addMenu(tr("&Colours"));
    auto *only = new QActionGroup(menu); // one is ticked, and goes with the menu
    const auto add = [&](ThemeKind kind, const QString &text) {
        QAction *action = addAction(menu, "themeAction_" + themeName(kind), text, {}, [this, kind] {
            m_parts.preferences.setTheme(kind);
            useTheme(kind);
        });
        action->setCheckable(true);
        action->setChecked(kind == themeKindOf(QGuiApplication::palette()));
        only->addAction(action);
    };
    add(ThemeKind::Light, tr("&Light"));
    add(ThemeKind::Dark, tr("&Dark"));
    add(ThemeKind::HighContrast, tr("&High contrast"));
}

void MainMenus::addStageMenu(const QStringList &stages)
{
    QMenu *menu = m_parts.window.menuBar()->addMenu(tr("&Stage"));
    for (int row = 0; row < static_cast<int>(stages.size()); ++row)
        addAction(menu, QString("stageAction%1").arg(row + 1), stages[row],
            stageKeys(static_cast<Page>(row)), [this, row] { m_parts.showPage(row); });
    menu->addSeparator();
    addAction(menu, "previousStageAction", tr("&Previous stage"), QKeySequence("Alt+Left"),
        [this] { m_parts.turnPage(-1); });
    addAction(menu, "nextStageAction", tr("&Next stage"), QKeySequence("Alt+Right"),
        [this] { m_parts.turnPage(1); });
    menu->addSeparator();
    addAction(menu, "recomputeAction", tr("Compute &again"), QKeySequence("F9"),
        [this] { m_parts.session.recompute(); });
}

void MainMenus::addLanguageMenu()
{
    QMenu *menu = m_parts.window.menuBar()->addMenu(tr("&Language"));
    // Every language has its own name for itself, so that everyone finds theirs.
    const std::pair<QString, QString> languages[]
        = {{"en", QStringLiteral("English")}, {"sv", QStringLiteral("Svenska")}};
    auto *onlyOne = new QActionGroup(menu);
    for (const auto &[code, name] : languages) {
        QAction *action = addAction(menu, "languageAction_" + code, name, {}, [this, c = code] {
            m_parts.preferences.setLanguage(c);
            m_parts.language.install(c);
        });
        action->setCheckable(true);
        action->setChecked(m_parts.language.code() == code);
        onlyOne->addAction(action);
    }
}

void MainMenus::addHelpMenu()
{
    QMenu *menu = m_parts.window.menuBar()->addMenu(tr("&Help"));
    QAction *keys = addAction(menu, "shortcutsAction", tr("&Keyboard and mouse"), {},
        [this] { showShortcuts(m_parts.window); });
    keys->setShortcuts({QKeySequence::HelpContents, QKeySequence("?")});
    addAction(menu, "selfTestAction", tr("&Self-test..."), {},
        [this] { m_parts.tools.testInstallation(); });
    addAction(menu, "aboutAction", tr("&About Dyncal"), {}, [this] { showAbout(&m_parts.window); });
}

} // namespace dyncal
