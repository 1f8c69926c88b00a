// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/widget/plot_widget.h"
#include "ui/session/page_standing.h"
#include "ui/session/session.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/plot_filling.h"
#include "ui/stages/frame/plot_tools.h"

#include <QVBoxLayout>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QPushButton;

namespace dyncal {

/// What the head of a page says.
struct PageText
{
    QString name; ///< object name, "windowPage"
    QString title; ///< also in the stage list
    QString instruction; ///< one line: what to do here
};

/// One stage of the method on the screen: head, plots in the middle, inspector beside it. A page
/// holds no analysis state: it draws what the session has and applies changed recipes. Hidden pages
/// do nothing; they catch up when shown.
class StagePage : public QWidget
{
    Q_OBJECT

public:
    StagePage(Session &session, const PageText &text, Page page);

    const PageText &text() const { return m_text; }
    /// The stages shown here; the first is the one that the page is opened for.
    const std::vector<StageId> &stages() const { return m_stages; }
    Page page() const { return m_page; }
    StageStatus status() const { return standing().status; }
    PageStanding standing() const; ///< as the stage list says it too
    /// What is computed first while this page is on show.
    virtual StageId focus() const;
    InspectorForm *inspector() { return m_inspector; }
    static PlotContent nothingYet(); ///< an empty plot that says so
    std::vector<PlotWidget *> plots() const;
    /// Draws what is on show, although the page is hidden; long curves take until isDrawing() ends.
    void catchUp();
    bool isDrawing() const; ///< long curves of a plot are under way

signals:
    void plotExport(const dyncal::PlotWidget *plot); ///< the operator wants it as a file
    void inspectorWanted(); ///< a field there is about to have the keyboard

protected:
    virtual void showRecipe() = 0; ///< sets the controls
    virtual void showResults() = 0; ///< draws plots, tables and read-outs
    /// Whether what is on show of a stage is older than the recipe, as the run did not get there.
    virtual bool showsOld(StageId from) const { return m_session.isLastGood(from); }
    virtual void takeBackDrag(); ///< after Esc in a drag: the recipe is as before it
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

    Session &session() { return m_session; }
    const Session &session() const { return m_session; }
    /// What is on show: of stages that the last run could not reach, their last good results.
    const CalibrationResults &results() const { return m_session.resultsOnShow(); }
    const Recipe &recipe() const { return m_session.recipe(); }
    QVBoxLayout *content() { return m_content; }
    /// `from`: the stage whose result it shows; without, that of the page.
    PlotWidget *makePlot(
        const QString &objectName, const QString &accessibleName, std::optional<StageId> from = {});
    /// Shows it as soon as it is made: at once, unless curves are long.
    void draw(PlotWidget *plot, PlotMaking making);
    /// Shows that there is nothing to show yet.
    void clear(PlotWidget *plot);
    /// Cursors of these plots stand where those of all other plots with this axis stand.
    void shareCursors(CursorAxis axis, const std::vector<PlotWidget *> &plots);

    /// Changes the recipe as one undo step.
    void change(const QString &label, const std::function<void(Recipe &)> &edit,
        const QString &mergeKey = {});

private:
    void refresh();
    void showContents();
    void showStatus();
    void showControls();
    void showNotices();
    void setTablesEnabled(bool enabled);
    QString reasonWhyBlocked() const;

    Session &m_session;
    PageText m_text;
    std::vector<StageId> m_stages;
    Page m_page;
    InspectorForm *m_inspector;
    QLabel *m_status;
    bool m_isCurrent = true; ///< else tables and read-outs are pale
    QLabel *m_problem;
    QPushButton *m_wayBack; ///< undoes what blocked the page
    QVBoxLayout *m_content;
    struct ShownPlot
    {
        PlotWidget *plot;
        StageId from;
        PlotFilling *filling;
    };
    PlotFilling &fillingOf(const PlotWidget *plot);
    std::vector<ShownPlot> m_shownPlots;
    PlotTools *m_plotTools;
};

} // namespace dyncal
