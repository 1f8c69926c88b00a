// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/main_window.h"

#include "ui/session/work_state.h"
#include "ui/shell/banner/banner.h"
#include "ui/shell/batch/batch_window.h"
#include "ui/shell/control_focus.h"
#include "ui/shell/files/project_notice.h"
#include "ui/shell/files/source_notice.h"
#include "ui/shell/findings/finding_answers.h"
#include "ui/shell/findings/finding_places.h"
#include "ui/shell/findings/findings_panel.h"
#include "ui/shell/findings/problem_panel.h"
#include "ui/shell/main_menus.h"
#include "ui/shell/next_bar.h"
#include "ui/shell/recovery/work_recovery.h"
#include "ui/shell/shot_chips.h"
#include "ui/shell/stage_list.h"
#include "ui/shell/stage_pages.h"
#include "ui/shell/start_page.h"
#include "ui/shell/tool_windows.h"
#include "ui/shell/work_status.h"
#include "ui/stages/frame/inspector_scroll.h"
#include "ui/stages/frame/stage_page.h"
#include "ui/text/shown_text.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QMimeData>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

/// A static library's resources are linked in only when asked for; the macro does not work inside a
/// namespace.
static void initialiseResources()
{
    Q_INIT_RESOURCE(dyncal);
}

namespace dyncal {

namespace {

constexpr QSize kFirstSize(1400, 900);
constexpr QSize kSmallestSize(1000, 640);
constexpr int kStagesWidth = 170;
constexpr int kInspectorWidth = 330;
constexpr int kFindingsHeight = 230;

} // namespace

MainWindow::MainWindow(Session::Pipeline pipeline, CurrentUtc currentUtc, Preferences &preferences,
    Prompts &prompts, Language &language)
    : m_plainText(this)
    , m_tips(this)
    , m_preferences(preferences)
    , m_prompts(prompts)
    , m_language(language)
    , m_currentUtc(std::move(currentUtc))
    , m_session(std::move(pipeline))
    , m_files(new FileActions(m_session, m_currentUtc, prompts, preferences, this))
    , m_recoveryBanner(new Banner("recovery", this))
    , m_sourceBanner(new Banner("source", this))
    , m_projectBanner(new Banner("project", this))
    , m_centre(new QStackedWidget(this))
    , m_inspectors(new QStackedWidget(this))
    , m_work(new WorkStatus(*statusBar(), m_session, *m_files, this))
    , m_sources(new SourceNotice(m_session, m_files->captures(), m_prompts, *m_sourceBanner, this))
    , m_project(new ProjectNotice(*m_files, *m_projectBanner, this))
    , m_tools(new ToolWindows(
          {m_session, m_currentUtc, prompts, preferences, language, *m_files}, this))
    , m_nextLine(new QToolBar(this))
{
    initialiseResources();
    setObjectName("mainWindow");
    setAcceptDrops(true);
    setMinimumSize(kSmallestSize);
    buildCentre();
    buildDocks();
    m_menus = new MainMenus(
        {*this, m_session, *m_files, m_preferences, m_language,
            {{m_stagesDock, "F5"}, {m_inspectorDock, "F4"}, {m_findingsDock, "F6"}},
            [this] { resetLayout(); }, [this] { m_files->exportPlots(m_pages); },
            [this](int row) { showPage(row); },
            [this](int by) { showPage(m_stageList->currentRow() + by); },
            [this] { showBatchWindow(*m_files, m_prompts, m_preferences, *this); }, *m_tools},
        this);
    connectSession();
    buildContents();
    keepFocusInView(*this);
    resize(kFirstSize);
    restoreGeometry(m_preferences.geometry());
    m_layout = m_preferences.layout();
    if (!restoreState(m_layout)) {
        m_layout.clear();
        resetLayout();
        m_sizeDocks = true;
    }
    m_problemsDock->hide();
    showStart();
}

MainWindow::~MainWindow()
{
    delete m_recovery;
    delete m_tools;
    // Pages listen to the session, which would be destroyed before them.
    m_session.disconnect();
    m_session.undoStack().disconnect();
    for (StagePage *page : m_pages)
        delete page;
}

void MainWindow::buildCentre()
{
    setCentralWidget(new QWidget(this));
    auto *column = new QVBoxLayout(centralWidget());
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_recoveryBanner);
    column->addWidget(m_sourceBanner);
    column->addWidget(m_projectBanner);
    column->addWidget(m_centre, 1);
}

void MainWindow::keepWork(const QString &folder, const AutoSaveDelays &delays)
{
    m_recovery = new WorkRecovery({m_session, *m_files, m_prompts, *m_recoveryBanner, *statusBar()},
        m_currentUtc, folder, delays, this);
}

void MainWindow::leaveWork()
{
    m_files->cancel();
    if (m_recovery)
        m_recovery->leave();
}

void MainWindow::buildDocks()
{
    const auto dock = [this](const QString &name, Qt::DockWidgetArea area) {
        auto *widget = new QDockWidget(this);
        widget->setObjectName(name);
        widget->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
        addDockWidget(area, widget);
        return widget;
    };
    m_stagesDock = dock("stagesDock", Qt::LeftDockWidgetArea);
    m_inspectorDock = dock("inspectorDock", Qt::RightDockWidgetArea);
    m_findingsDock = dock("findingsDock", Qt::RightDockWidgetArea);
    m_inspectorDock->setWidget(m_inspectors);
    m_nextLine->setObjectName("nextLine");
    m_nextLine->setMovable(false);
    m_nextLine->toggleViewAction()->setVisible(false); // always in view
    addToolBar(Qt::BottomToolBarArea, m_nextLine);
    // Of a moment, so no part of the layout that is kept.
    m_problemsDock = dock("problemsDock", Qt::BottomDockWidgetArea);
}

void MainWindow::resetLayout()
{
    for (QDockWidget *dock : {m_stagesDock, m_inspectorDock, m_findingsDock}) {
        dock->setFloating(false);
        dock->show();
    }
    addDockWidget(Qt::LeftDockWidgetArea, m_stagesDock);
    addDockWidget(Qt::RightDockWidgetArea, m_inspectorDock);
    addDockWidget(Qt::RightDockWidgetArea, m_findingsDock);
    sizeDocks();
}

void MainWindow::sizeDocks()
{
    resizeDocks({m_stagesDock, m_inspectorDock}, {kStagesWidth, kInspectorWidth}, Qt::Horizontal);
    resizeDocks({m_inspectorDock, m_findingsDock}, {height() - kFindingsHeight, kFindingsHeight},
        Qt::Vertical);
}

void MainWindow::connectSession()
{
    connect(m_files, &FileActions::projectChanged, this, &MainWindow::showTitle);
    connect(&m_session, &Session::capturesChanged, this, &MainWindow::showCaptures);
    for (const auto signal :
        {&Session::resultsChanged, &Session::recipeChanged, &Session::sourcesChanged})
        connect(&m_session, signal, this, &MainWindow::showFindings);
    for (const auto signal : {&Session::stageStatusChanged, &Session::sourcesChanged})
        connect(&m_session, signal, this, &MainWindow::showStatuses);
}

void MainWindow::buildContents()
{
    m_shownLanguage = m_language.code();
    const int row = m_stageList ? m_stageList->currentRow() : 0;
    const bool started = m_session.state().hasShots();
    m_stagesDock->setWindowTitle(tr("Stages"));
    m_inspectorDock->setWindowTitle(tr("Inspector"));
    m_findingsDock->setWindowTitle(tr("Findings"));

    buildFindings();
    buildProblems();
    delete m_chips;
    m_chips = new ShotChips(this);
    statusBar()->addWidget(m_chips);
    m_chips->show();

    buildNextBar();
    buildPages();
    QStringList titles;
    for (const StagePage *page : m_pages)
        titles << page->text().title;
    m_menus->build(titles);
    showTitle();
    showFindings();
    showStatuses();
    m_work->showWords();
    m_sources->showWords();
    m_project->showWords();
    if (m_recovery)
        m_recovery->showWords();
    if (started)
        showPage(std::max(row, 0));
}

void MainWindow::buildFindings()
{
    delete m_findings;
    m_findings = new FindingsPanel(m_findingsDock);
    m_findings->setNotesOpen(m_preferences.notesOpen());
    m_findingsDock->setWidget(m_findings);
    connect(m_findings, &FindingsPanel::placeRequested, this, &MainWindow::showFinding);
    connect(m_findings, &FindingsPanel::notesOpened, this,
        [this](bool open) { m_preferences.setNotesOpen(open); });
    connect(m_findings, &FindingsPanel::reasonRequested, this,
        [this](const Findings &findings) { acknowledge(findings, m_session, m_prompts, this); });
    connect(m_findings, &FindingsPanel::correctionRequested, this,
        [this](const OfferedCorrection &correction) {
            applyCorrection(correction, m_session, m_files->captures(), m_prompts, this);
        });
}

void MainWindow::buildNextBar()
{
    qDeleteAll(m_nextLine->actions()); // with the bar
    m_next = new NextBar(m_nextLine);
    m_nextLine->setWindowTitle(tr("What next"));
    m_nextLine->addWidget(m_next);
    connect(m_next, &NextBar::stepRequested, this, [this](const NextStep &step) {
        if (!step.control.isEmpty())
            return showControl(step.page, step.control);
        m_findingsDock->setVisible(true);
        m_findings->setFocus(Qt::OtherFocusReason);
    });
}

/// Made anew in the language of the window; what it lists stays.
void MainWindow::buildProblems()
{
    const auto shown = m_problems ? m_problems->problems() : std::vector<FileProblem>();
    delete m_problems;
    m_problems = new ProblemPanel(m_problemsDock);
    m_problemsDock->setWidget(m_problems);
    m_problemsDock->setWindowTitle(tr("Files that could not be read"));
    connect(m_problems, &ProblemPanel::changed, this,
        [this] { m_problemsDock->setVisible(!m_problems->problems().empty()); });
    CaptureImport *captures = &m_files->captures();
    connect(m_problems, &ProblemPanel::importRequested, captures, &CaptureImport::edit);
    connect(m_problems, &ProblemPanel::retryRequested, m_files, &FileActions::openPaths);
    connect(captures, &CaptureImport::problemsChanged, m_problems, &ProblemPanel::update);
    m_problems->update({}, shown);
}

void MainWindow::buildPages()
{
    if (QWidget *field = focusWidget()) // what is typed is taken while its page still stands
        field->clearFocus();
    for (StagePage *page : m_pages)
        delete page;
    m_pages.clear();
    delete m_start;
    delete m_stageList;
    qDeleteAll(m_inspectors->findChildren<QScrollArea *>(QString(), Qt::FindDirectChildrenOnly));

    m_start = new StartPage(this);
    m_centre->addWidget(m_start);
    connect(m_start, &StartPage::openCapturesRequested, m_files, &FileActions::openCaptures);
    connect(m_start, &StartPage::openExampleRequested, m_files, &FileActions::openExample);
    connect(m_start, &StartPage::openProjectRequested, m_files, &FileActions::openProject);

    m_pages = stagePages(m_session, m_currentUtc, m_prompts, *m_files);

    m_stageList = new StageList(m_stagesDock);
    m_stagesDock->setWidget(m_stageList);
    for (StagePage *page : m_pages) {
        m_stageList->addStage(page->text().title);
        m_centre->addWidget(page);
        m_inspectors->addWidget(new InspectorScroll(page->inspector()));
        connect(page, &StagePage::plotExport, m_files, &FileActions::exportPlot);
        connect(page, &StagePage::inspectorWanted, m_inspectorDock, &QDockWidget::show);
    }
    connect(m_stageList, &QListWidget::currentRowChanged, this, &MainWindow::showPage);
    connect(m_stageList, &QListWidget::itemClicked, this,
        [this] { showPage(m_stageList->currentRow()); });
}

void MainWindow::showStart()
{
    if (m_stageList && m_centre->currentWidget() != m_start && isVisible())
        m_layout = saveState(); // of work: it is what comes back with it, and what is kept
    m_centre->setCurrentWidget(m_start);
    m_inspectorDock->setVisible(false);
    m_findingsDock->setVisible(false);
}

void MainWindow::showPage(int row)
{
    if (row < 0 || row >= static_cast<int>(m_pages.size()))
        return;
    StagePage *page = m_pages[static_cast<std::size_t>(row)];
    m_session.setFocus(page->focus());
    if (m_centre->currentWidget() == m_start)
        showInspector();
    m_centre->setCurrentWidget(page);
    m_inspectors->setCurrentIndex(row);
    m_stageList->setCurrentRow(row);
}

void MainWindow::showInspector()
{
    m_inspectorDock->setVisible(true);
    m_findingsDock->setVisible(true);
    // Docks that were hidden come back with sizes of their own: those of the layout are set again,
    // once all are there.
    if (m_sizeDocks)
        QMetaObject::invokeMethod(this, &MainWindow::sizeDocks, Qt::QueuedConnection);
    else if (!m_layout.isEmpty())
        QMetaObject::invokeMethod(
            this, [this, layout = m_layout] { restoreState(layout); }, Qt::QueuedConnection);
    m_sizeDocks = false;
}

void MainWindow::showControl(Page page, const QString &control)
{
    showPage(static_cast<int>(page));
    StagePage &shown = *m_pages[static_cast<std::size_t>(page)];
    if (!control.isEmpty() && !controlIn(shown, control))
        m_inspectorDock->setVisible(true);
    bringIntoView(shown, *shown.inspector(), control);
}

void MainWindow::showFinding(const Finding &finding)
{
    const FindingPlace place
        = placeOfFinding(finding.id)
              .value_or(FindingPlace{pageOf(finding, workStateOf(m_session)), ""});
    showControl(place.page, QString::fromLatin1(place.control));
    selectShot(*m_pages[static_cast<std::size_t>(place.page)], finding.shot);
}

void MainWindow::showTitle()
{
    const QString name = m_files->projectName();
    const QString shown
        = m_files->readOnlyReason() ? tr("%1 (read-only)").arg(asTitle(name)) : asTitle(name);
    setWindowTitle(name.isEmpty() ? QString("Dyncal") : shown + "[*] – Dyncal");
    setWindowModified(!name.isEmpty() && m_files->isModified());
}

void MainWindow::showStatuses()
{
    const WorkState work = workStateOf(m_session);
    for (std::size_t row = 0; row < m_pages.size(); ++row)
        m_stageList->setStanding(static_cast<int>(row), standingOf(m_pages[row]->page(), work));
    m_next->showWork(work, m_session);
}

void MainWindow::showFindings()
{
    const Findings findings = m_session.findings();
    const auto &prepared = m_session.results().captures;
    const CaptureSet &shown = prepared ? prepared->set : *m_session.state().captures;
    m_findings->setFindings(findings, m_session.recipe().acknowledge, shown);
    const auto count = std::ranges::count_if(
        findings, [](const Finding &finding) { return finding.severity != Severity::Info; });
    m_findingsDock->setWindowTitle(count > 0 ? tr("Findings (%1)").arg(count) : tr("Findings"));
    m_chips->setShots(shown);
}

void MainWindow::showCaptures()
{
    if (!m_session.state().hasShots())
        showStart();
    else if (m_centre->currentWidget() == m_start)
        showPage(0);
    showTitle();
}

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    if (m_sizeDocks)
        QMetaObject::invokeMethod(this, &MainWindow::sizeDocks, Qt::QueuedConnection);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!m_files->mayQuit()) {
        event->ignore();
        return;
    }
    // The layout of work is kept, not that of the start page.
    const bool isWork = m_centre->currentWidget() != m_start;
    m_preferences.setWindow(saveGeometry(), isWork ? saveState() : m_layout);
    if (m_recovery)
        m_recovery->end();
    event->accept();
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    // Pages hold no state, so they are made anew in the new language; queued, because the menu
    // whose action caused this is replaced too. Such an event without another language changes
    // nothing.
    if (event->type() == QEvent::LanguageChange && m_shownLanguage != m_language.code())
        QMetaObject::invokeMethod(this, &MainWindow::buildContents, Qt::QueuedConnection);
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    m_files->openDropped(event->mimeData()->urls());
}

} // namespace dyncal
