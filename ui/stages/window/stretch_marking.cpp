// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/window/stretch_marking.h"

#include "ui/stages/frame/recipe_change.h"
#include "ui/text/core_text.h"
#include "ui/text/level_text.h"
#include "ui/text/quantity_format.h"

#include <algorithm>

namespace dyncal {

namespace {

const QString kPrefix = QStringLiteral("stretch");

QString faultText(StretchFault fault, const std::vector<WindowedResponse> &responses)
{
    switch (fault) {
    case StretchFault::NoReason:
        return StretchMarking::tr("Not applied: type a reason.");
    case StretchFault::EndBeforeBegin:
        return StretchMarking::tr("Not applied: the end must lie behind the begin.");
    case StretchFault::OutsideWindow: {
        double end_s = 0.0;
        for (const WindowedResponse &response : responses)
            end_s = std::max(end_s, response.end_s);
        return StretchMarking::tr("Not applied: the window reaches from 0 to %1.")
            .arg(shownQuantity(end_s, "s"));
    }
    case StretchFault::None:
        break;
    }
    return {};
}

} // namespace

StretchMarking::StretchMarking(
    Session &session, StretchList &list, std::vector<PlotWidget *> plots, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_list(list)
    , m_plots(std::move(plots))
{
    for (PlotWidget *plot : m_plots) {
        plot->setMarkable(true);
        connect(plot, &PlotWidget::spanMarked, this, &StretchMarking::mark);
        connect(plot, &PlotWidget::bandMoved, this, &StretchMarking::moveBand);
        connect(plot, &PlotWidget::dragCancelled, this, &StretchMarking::takeBackDraft);
        connect(plot, &PlotWidget::markingChanged, this, [this](bool on) {
            m_list.setMarking(on);
            for (PlotWidget *other : m_plots)
                other->setMarking(on);
        });
    }
    connect(&m_list, &StretchList::markingRequested, this, [this](bool on) {
        m_plots.front()->setMarking(on);
        if (on)
            m_plots.front()->setFocus();
    });
    connect(&m_list, &StretchList::edited, this, &StretchMarking::takeEdit);
    connect(&m_list, &StretchList::removeRequested, this, &StretchMarking::remove);
    connect(&m_session, &Session::capturesChanged, this, [this] { m_draft.reset(); });
}

std::vector<MarkedStretch> StretchMarking::stretches() const
{
    return markedStretches(m_session.recipe().window.excludeStretches);
}

const std::vector<WindowedResponse> &StretchMarking::responses() const
{
    static const std::vector<WindowedResponse> kNone;
    const auto &window = m_session.resultsOnShow().window;
    return window ? window->responses : kNone;
}

void StretchMarking::apply(
    const std::vector<MarkedStretch> &stretches, const QString &label, const QString &mergeKey)
{
    changeRecipe(
        m_session, label,
        [&](Recipe &r) { r.window.excludeStretches = excludedStretches(stretches); }, mergeKey);
}

void StretchMarking::setShot(Index shot)
{
    if (shot == m_shot)
        return;
    m_shot = shot;
    m_list.chooseShots({shot});
}

void StretchMarking::mark(Interval span_s)
{
    const std::vector<Index> shots = m_list.chosenShots();
    if (shots.empty())
        return; // no recordings
    takeDraft({withinWindows(span_s, shots, responses()), shots, {}});
    m_list.askForReason();
}

/// Applies a complete stretch. An incomplete one waits as the draft, and replaces the draft before.
void StretchMarking::takeDraft(const MarkedStretch &stretch)
{
    std::vector<MarkedStretch> all = stretches();
    const auto row = static_cast<int>(all.size());
    if (faultOf(stretch, responses()) != StretchFault::None) {
        m_draft = stretch;
        show();
    } else {
        m_draft.reset();
        all.push_back(stretch);
        apply(all, tr("Leave a stretch out"));
    }
    m_list.select(row);
}

void StretchMarking::takeEdit(int row, const MarkedStretch &stretch)
{
    std::vector<MarkedStretch> all = stretches();
    if (row < 0 || row >= static_cast<int>(all.size())) {
        takeDraft(stretch);
        return;
    }
    // A stretch that is applied takes no change that cannot be applied: the fields go back.
    if (faultOf(stretch, responses()) != StretchFault::None) {
        show();
        return;
    }
    all[static_cast<std::size_t>(row)] = stretch;
    apply(all, tr("Change a stretch left out"));
}

void StretchMarking::remove(int row)
{
    std::vector<MarkedStretch> all = stretches();
    if (row < 0)
        return;
    if (row >= static_cast<int>(all.size())) {
        m_draft.reset();
        show();
        return;
    }
    all.erase(all.begin() + row);
    apply(all, tr("Leave a stretch in again"));
}

void StretchMarking::moveBand(const QString &id, Interval span_s, bool finished)
{
    if (!id.startsWith(kPrefix))
        return;
    const int row = id.mid(kPrefix.size()).toInt();
    std::vector<MarkedStretch> all = stretches();
    const bool isDraft = row >= static_cast<int>(all.size());
    if (isDraft && !m_draft)
        return;
    MarkedStretch moved = isDraft ? *m_draft : all[static_cast<std::size_t>(row)];
    moved.span_s = withinWindows(span_s, moved.shots, responses());
    m_list.select(row);
    if (isDraft) {
        m_draft = moved;
        show();
    } else if (faultOf(moved, responses()) == StretchFault::None) {
        all[static_cast<std::size_t>(row)] = moved;
        apply(all, tr("Move a stretch left out"), id);
    }
    if (finished) {
        m_session.endMerge();
        show();
    }
}

/// The recipe is the page's to take back.
void StretchMarking::takeBackDraft(const QString &id, Interval span_s)
{
    if (m_draft && id == kPrefix + QString::number(stretches().size()))
        m_draft->span_s = span_s;
    show();
}

void StretchMarking::show()
{
    std::vector<StretchRow> rows;
    for (const MarkedStretch &stretch : stretches())
        rows.push_back({stretch, remark(stretch, false)});
    if (m_draft)
        rows.push_back({*m_draft, remark(*m_draft, true)});
    m_list.show(rows, choices());
    if (std::ranges::none_of(m_plots, &PlotWidget::isHandleDragged))
        showBands(rows);
}

QString StretchMarking::remark(const MarkedStretch &stretch, bool isDraft) const
{
    const StretchFault fault = faultOf(stretch, responses());
    if (fault != StretchFault::None)
        return faultText(fault, responses());
    // Complete, but typed when there was no window to judge it by.
    return isDraft ? tr("Not applied.") : whatTheRunSays(stretch);
}

/// Empty if the run left the stretch out in all its shots, else why not.
QString StretchMarking::whatTheRunSays(const MarkedStretch &stretch) const
{
    if (const auto &error = m_session.error(); error && error->findingId == "WIN-008"
        && std::ranges::find(stretch.shots, error->shot) != stretch.shots.end())
        return translated(error->message);
    const auto &input = m_session.results().input;
    if (!input || !m_session.isOfThisRun(StageId::ModelInput))
        return {};
    QStringList missing;
    for (const ExcludedStretch &entry : excludedStretches({stretch}))
        if (std::ranges::find(input->leftOut, entry) == input->leftOut.end())
            missing << QString::number(entry.shot);
    if (missing.isEmpty())
        return {};
    for (const Finding &finding : input->findings)
        if (finding.id == "WIN-009")
            return translated(finding.message);
    return tr("Not used: shot %1 is excluded.").arg(missing.join(", "));
}

std::vector<ShotChoice> StretchMarking::choices() const
{
    std::vector<ShotChoice> choices;
    ShotChoice all{tr("All shots"), {}};
    const CaptureSet &set = *m_session.state().captures;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const auto shot = static_cast<Index>(i) + 1;
        choices.push_back({tr("Shot %1 %2").arg(shot).arg(levelText(set.shots[i].level)), {shot}});
        all.shots.push_back(shot);
    }
    if (choices.size() > 1)
        choices.push_back(all);
    return choices;
}

void StretchMarking::showBands(const std::vector<StretchRow> &rows)
{
    const auto shown = static_cast<int>(rows.size());
    for (PlotWidget *plot : m_plots) {
        for (int row = 0; row < shown; ++row) {
            const MarkedStretch &stretch = rows[static_cast<std::size_t>(row)].stretch;
            QStringList shots;
            for (const Index shot : stretch.shots)
                shots << QString::number(shot);
            const bool isDraft = m_draft && row + 1 == shown;
            const QString text = isDraft ? tr("shot %1: no reason yet") : tr("shot %1: left out");
            plot->setHatchedBand(
                kPrefix + QString::number(row), text.arg(shots.join(", ")), stretch.span_s);
        }
        for (int row = shown; row < m_bands; ++row)
            plot->removeBand(kPrefix + QString::number(row));
    }
    m_bands = shown;
}

} // namespace dyncal
