// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"
#include "ui/shell/file_actions.h"
#include "ui/shell/finding_mends.h"
#include "ui/shell/language.h"
#include "ui/shell/preferences.h"
#include "ui/shell/prompts.h"

#include <QMainWindow>
#include <QTimer>

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace dyncal {

class FindingsPanel;
class ProblemPanel;
class ShotChips;
class StageList;
class StagePage;
class StartPage;

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
    void showStage(StageId stage);
    void showStart();

protected:
    void showEvent(QShowEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void changeEvent(QEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void buildDocks();
    void buildStatusBar();
    void connectSession();
    void buildContents(); ///< everything with words in it; again after a change of language
    void buildProblems();
    void buildPages();
    void buildMenus();
    void buildFileMenu();
    void buildViewMenu();
    void buildStageMenu();
    void buildLanguageMenu();
    void buildHelpMenu();
    QAction *addAction(QMenu *menu, const QString &name, const QString &text,
        const QKeySequence &keys, const std::function<void()> &what);
    void fillRecentMenu();

    void showTitle();
    void showStatuses();
    void showFindings();
    void acknowledge(const Finding &finding);
    void mend(const Remedy &mend);
    void showCaptures();
    void showBusy(const QString &what);
    void showIdle(const QString &outcome);
    void showComputing();
    void resetLayout();
    void sizeDocks();
    void showInspector();

    Preferences &m_preferences;
    Prompts &m_prompts;
    Language &m_language;
    QString m_shownLanguage; ///< of the contents built last
    Session m_session;
    FileActions *m_files;
    std::vector<StagePage *> m_pages;

    StageList *m_stageList = nullptr;
    StartPage *m_start = nullptr;
    QStackedWidget *m_centre;
    QStackedWidget *m_inspectors;
    QDockWidget *m_stagesDock;
    QDockWidget *m_inspectorDock;
    QDockWidget *m_problemsDock = nullptr;
    ProblemPanel *m_problems = nullptr;
    QDockWidget *m_findingsDock;
    FindingsPanel *m_findings = nullptr;
    QMenu *m_recentMenu = nullptr;
    ShotChips *m_chips = nullptr;
    QLabel *m_message;
    QProgressBar *m_progress;
    QPushButton *m_cancel;
    bool m_sizeDocks = false; ///< sizes count only once the window is laid out
    QTimer m_slow; ///< short computations show no progress bar
};

} // namespace dyncal
