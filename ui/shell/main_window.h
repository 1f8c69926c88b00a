// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/auto_save.h"
#include "ui/session/page_standing.h"
#include "ui/session/session.h"
#include "ui/shell/files/file_actions.h"
#include "ui/shell/preferences/language.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/shell/tips/control_tips.h"
#include "ui/stages/frame/prompts.h"
#include "ui/text/line_length_rule.h"
#include "ui/text/plain_text_rule.h"

#include <QMainWindow>

class QStackedWidget;
class QToolBar;

namespace dyncal {

class FindingsPanel;
class MainMenus;
class NextBar;
class ProblemPanel;
class ProjectNotice;
class Banner;
class ShotChips;
class SourceNotice;
class StageList;
class StagePage;
class StartPage;
class ToolWindows;
class WorkRecovery;
class WorkStatus;

/// The workbench: stage list, page, inspector, findings, menus. It only builds these and connects
/// them; the work is done by the session, the file actions and the pages.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    MainWindow(Session::Pipeline pipeline, CurrentUtc currentUtc, Preferences &preferences,
        Prompts &prompts, Language &language);
    ~MainWindow() override;

    Session &session() { return m_session; }
    FileActions &files() { return *m_files; }
    const std::vector<StagePage *> &pages() const { return m_pages; }
    void showPage(int row); ///< row of the stage list, from 0
    /// Shows a page with the focus on a control of it; the name as FindingPlace has it.
    void showControl(Page page, const QString &control);
    void showStart();
    void resetLayout(); ///< docks where they were at first
    /// From now on unsaved work is kept in `folder`, and what stopped programs left there is
    /// offered. Without this call neither is done.
    void keepWork(const QString &folder, const AutoSaveDelays &delays = {});
    /// The program is asked to end at once: work in hand stops, unsaved work is kept and offered at
    /// the next start.
    void leaveWork();

protected:
    void showEvent(QShowEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void changeEvent(QEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void buildCentre();
    void buildDocks();
    void connectSession();
    void buildContents(); ///< everything with words in it; again after a change of language
    void buildProblems();
    void buildPages();

    void buildFindings();
    void buildNextBar();
    void showTitle();
    void showStatuses();
    void showFindings();
    void showFinding(const Finding &finding);
    void showCaptures();
    void sizeDocks();
    void showInspector();

    PlainTextRule m_plainText; ///< first: before any label is made
    LineLengthRule m_lineLength; ///< so before any line of text
    ControlTips m_tips; ///< so for any control
    Preferences &m_preferences;
    Prompts &m_prompts;
    Language &m_language;
    CurrentUtc m_currentUtc;
    QString m_shownLanguage; ///< of the contents built last
    Session m_session;
    FileActions *m_files;
    std::vector<StagePage *> m_pages;

    StageList *m_stageList = nullptr;
    StartPage *m_start = nullptr;
    Banner *m_recoveryBanner;
    Banner *m_sourceBanner;
    Banner *m_projectBanner;
    QStackedWidget *m_centre;
    QStackedWidget *m_inspectors;
    QDockWidget *m_stagesDock;
    QDockWidget *m_inspectorDock;
    QDockWidget *m_problemsDock = nullptr;
    ProblemPanel *m_problems = nullptr;
    QDockWidget *m_findingsDock;
    FindingsPanel *m_findings = nullptr;
    ShotChips *m_chips = nullptr;
    WorkStatus *m_work;
    WorkRecovery *m_recovery = nullptr;
    SourceNotice *m_sources;
    ProjectNotice *m_project;
    ToolWindows *m_tools;
    MainMenus *m_menus = nullptr;
    NextBar *m_next = nullptr;
    QToolBar *m_nextLine; ///< holds it, above the status bar
    bool m_sizeDocks = false; ///< sizes count only once the window is laid out
    QByteArray m_layout; ///< of work, while the start page is on show
};

} // namespace dyncal
