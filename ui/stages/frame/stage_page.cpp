// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/stage_page.h"

#include "ui/session/work_state.h"
#include "ui/stages/frame/layout_scale.h"
#include "ui/stages/frame/recipe_change.h"
#include "ui/stages/frame/status_text.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/frame/wrapped_controls.h"
#include "ui/text/core_text.h"
#include "ui/text/finding_text.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>

namespace dyncal {

namespace {

/// Where the window is too small for all plots of a page, it scrolls.
QScrollArea *scrolled(QVBoxLayout &content)
{
    auto *inside = new QWidget;
    content.setContentsMargins(0, 0, 0, 0);
    inside->setLayout(&content);
    auto *area = new QScrollArea;
    area->setObjectName("pageScroll");
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus); // keys belong to the page
    area->setWidget(inside);
    return area;
}

} // namespace

StagePage::StagePage(Session &session, const PageText &text, Page page)
    : m_session(session)
    , m_text(text)
    , m_stages(stagesOf(page))
    , m_page(page)
    , m_inspector(new InspectorForm)
    , m_status(new QLabel(this))
    , m_problem(new QLabel(this))
    , m_wayBack(new QPushButton(this))
    , m_content(new QVBoxLayout)
    , m_plotTools(new PlotTools(this))
{
    setObjectName(text.name);
    m_inspector->setObjectName(text.name + "Inspector");
    m_status->setObjectName("pageStatus");
    m_problem->setObjectName("pageProblem");
    m_problem->setWordWrap(true);
    m_problem->hide();
    m_wayBack->setObjectName("pageWayBack");
    m_wayBack->setText(tr("Undo"));
    m_wayBack->setToolTip(tr("Takes the last change back (Ctrl+Z)"));
    m_wayBack->hide();
    connect(m_wayBack, &QPushButton::clicked, &session.undoStack(), &QUndoStack::undo);

    auto *title = new FormLabel(text.title, this);
    title->setFont(scale::title(title->font()));
    auto *instruction = new QLabel(text.instruction, this);
    instruction->setWordWrap(true);
    m_status->setWordWrap(true);
    m_status->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto *head = new QHBoxLayout;
    head->setSpacing(scale::kLarge);
    head->addWidget(title, 1);
    head->addWidget(m_status, 1);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(scale::kMedium, scale::kMedium, scale::kMedium, scale::kMedium);
    layout->setSpacing(scale::kSmall);
    layout->addLayout(head);
    auto *problem = new QHBoxLayout;
    problem->addWidget(m_problem, 1);
    problem->addWidget(m_wayBack);
    layout->addWidget(instruction);
    layout->addLayout(problem);
    layout->addWidget(scrolled(*m_content), 1);

    const auto whenShown = [this](void (StagePage::*what)()) {
        return [this, what] {
            if (isVisible())
                (this->*what)();
        };
    };
    connect(&session, &Session::recipeChanged, this, whenShown(&StagePage::showControls));
    connect(&session, &Session::capturesChanged, this, whenShown(&StagePage::refresh));
    // The change of status that follows shows how the page stands.
    connect(&session, &Session::resultsChanged, this, whenShown(&StagePage::showContents));
    connect(&session, &Session::stageStatusChanged, this, whenShown(&StagePage::showStatus));
    connect(&session, &Session::sourcesChanged, this, whenShown(&StagePage::showStatus));
}

PageStanding StagePage::standing() const
{
    return standingOf(m_page, workStateOf(m_session));
}

StageId StagePage::focus() const
{
    return *std::ranges::max_element(m_stages);
}

void StagePage::showEvent(QShowEvent *event)
{
    refresh();
    QWidget::showEvent(event);
    m_plotTools->setTableVisible(true);
}

void StagePage::hideEvent(QHideEvent *event)
{
    m_plotTools->setTableVisible(false);
    QWidget::hideEvent(event);
}

void StagePage::catchUp()
{
    if (!isVisible())
        refresh();
}

std::vector<PlotWidget *> StagePage::plots() const
{
    std::vector<PlotWidget *> plots;
    for (const ShownPlot &shown : m_shownPlots)
        plots.push_back(shown.plot);
    return plots;
}

void StagePage::refresh()
{
    showStatus();
    showContents();
}

void StagePage::showContents()
{
    const bool wasCurrent = m_isCurrent;
    if (!m_session.isComputing()) // until then it is not known how this goes
        m_isCurrent = reasonWhyBlocked().isEmpty() || !showsOld(m_stages.front());
    if (!wasCurrent)
        setTablesEnabled(true);
    showResults();
    showControls();
    if (!m_isCurrent)
        setTablesEnabled(false);
    m_inspector->setReadoutsEnabled(m_isCurrent);
    showNotices();
}

void StagePage::setTablesEnabled(bool enabled)
{
    for (ValueTable *table : findChildren<ValueTable *>())
        table->setEnabled(enabled);
}

void StagePage::showStatus()
{
    const WorkState work = workStateOf(m_session);
    const PageStanding now = standingOf(m_page, work);
    m_status->setText(statusGlyph(now.status) + " " + standingWord(now, m_page));
    const Finding *block = now.status == StageStatus::Blocked ? blockOf(m_page, work) : nullptr;
    const bool isSaidAbove = block && // of files that changed, for all pages
        std::ranges::find(m_session.changedSources(), *block, &ChangedSource::finding)
            != m_session.changedSources().end();
    const bool isTold = block && !isSaidAbove && !m_session.isComputing();
    m_problem->setVisible(isTold);
    if (isTold)
        m_problem->setText(severityGlyph(Severity::Block) + " " + translated(block->message));
    const QUndoStack &undo = m_session.undoStack();
    m_wayBack->setVisible(isTold && !reasonWhyBlocked().isEmpty() && undo.canUndo());
    m_wayBack->setText(tr("Undo: %1").arg(undo.undoText()));
}

void StagePage::showControls()
{
    showRecipe();
    m_inspector->showRecipe(recipe());
}

QString StagePage::reasonWhyBlocked() const
{
    const std::optional<Error> &error = m_session.error();
    return error && !m_session.isComputing() ? translated(error->message) : QString();
}

/// A plot never is empty, nor out of date, without its reason.
void StagePage::showNotices()
{
    if (m_session.isComputing())
        return; // until it is known whether that goes well
    const QString reason = reasonWhyBlocked();
    for (const ShownPlot &shown : m_shownPlots) {
        const bool isOld = !reason.isEmpty() && showsOld(shown.from);
        const bool isEmpty = m_session.status(shown.from) == StageStatus::Blocked
            && shown.plot->content().curves.empty();
        const bool isWaiting = shown.filling->isBusy();
        shown.plot->setNotice(isOld ? tr("As before the last change: %1").arg(reason)
                : isWaiting         ? tr("These long curves are being drawn.")
                : isEmpty           ? reason
                                    : QString(),
            isOld || isWaiting);
    }
}

void StagePage::takeBackDrag()
{
    m_session.cancelMerge();
    showControls();
}

PlotContent StagePage::nothingYet()
{
    PlotContent content;
    content.title = tr("Nothing to show yet");
    return content;
}

PlotWidget *StagePage::makePlot(
    const QString &objectName, const QString &accessibleName, std::optional<StageId> from)
{
    auto *plot = new PlotWidget(this);
    plot->setObjectName(objectName);
    plot->setAccessibleName(accessibleName);
    auto *filling = new PlotFilling(plot);
    m_shownPlots.push_back({plot, from.value_or(m_stages.front()), filling});
    connect(filling, &PlotFilling::changed, this, &StagePage::showNotices);
    connect(plot, &PlotWidget::dragCancelled, this, &StagePage::takeBackDrag);
    connect(plot, &PlotWidget::exportRequested, this, [this, plot] { emit plotExport(plot); });
    m_plotTools->attach(plot);
    return plot;
}

PlotFilling &StagePage::fillingOf(const PlotWidget *plot)
{
    return *std::ranges::find(m_shownPlots, plot, &ShownPlot::plot)->filling;
}

void StagePage::draw(PlotWidget *plot, PlotMaking making)
{
    fillingOf(plot).show(std::move(making));
}

void StagePage::clear(PlotWidget *plot)
{
    fillingOf(plot).showAtOnce(nothingYet());
}

bool StagePage::isDrawing() const
{
    return std::ranges::any_of(
        m_shownPlots, [](const ShownPlot &shown) { return shown.filling->isBusy(); });
}

void StagePage::shareCursors(CursorAxis axis, const std::vector<PlotWidget *> &plots)
{
    for (PlotWidget *plot : plots)
        PlotTools::share(plot, &m_session.cursors(axis));
}

void StagePage::change(
    const QString &label, const std::function<void(Recipe &)> &edit, const QString &mergeKey)
{
    changeRecipe(m_session, label, edit, mergeKey);
}

} // namespace dyncal
