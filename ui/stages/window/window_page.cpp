// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/window/window_page.h"

#include "ui/plot/curves/signal_curves.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/window/interval_edit.h"
#include "ui/stages/window/stretch_marking.h"
#include "ui/stages/window/window_ends.h"
#include "ui/stages/window/window_starts.h"
#include "ui/text/level_text.h"
#include "ui/text/quantity_column.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalBlocker>
#include <QSplitter>

#include <algorithm>

namespace dyncal {

namespace {

const QString kBaseline = QStringLiteral("baseline");
const QString kSettle = QStringLiteral("settle");
const QString kStart = QStringLiteral("start");
const QString kEnd = QStringLiteral("end");
const QString kGuard = QStringLiteral("guard");
constexpr double kLongest_s = 100.0;
constexpr double kRoom
    = 0.15; ///< of the view, behind the window's end: to drag it, to see the guard

} // namespace

WindowPage::WindowPage(Session &session)
    : StagePage(session,
        {"windowPage", tr("Window"),
            tr("Drag the bands and lines. All shots are aligned on their own start.")},
        Page::Window)
{
    buildPlots();
    buildInspector();
    connectHandles();
}

void WindowPage::buildPlots()
{
    m_plot = makePlot("windowPlot", tr("Response, remapped, with the bands"));
    m_detail = makePlot("windowDetailPlot", tr("First stretch of the response"));
    shareCursors(CursorAxis::ResponseTime, {m_plot, m_detail});
    m_table = new ValueTable("windowTable", tr("Levels and step of every shot"), this);
    m_table->setMinimumHeight(120);
    auto *split = new QSplitter(Qt::Vertical, this);
    split->addWidget(m_detail); // the ringing large, where it is on the plateau below
    split->addWidget(m_plot);
    split->addWidget(m_table);
    split->setSizes({1000, 800, 300});
    content()->addWidget(split);
}

void WindowPage::buildInspector()
{
    InspectorForm *form = inspector();
    buildStartControls();
    form->addSection(tr("Baseline, after the start"));
    m_subtract = new WrappedCheckBox(tr("Subtract the baseline"));
    m_subtract->setObjectName("subtractBaseline");
    form->addWide(m_subtract);
    connect(m_subtract, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Subtract the baseline"), [&](Recipe &r) { r.window.subtractBaseline = on; });
    });
    m_baseline = form->add(
        tr("Baseline"), "baseline", new IntervalEdit(kMicroseconds, -kLongest_s, kLongest_s));
    connect(m_baseline, &IntervalEdit::edited, this, [this](const Auto<Interval> &band) {
        change(tr("Change the baseline"), [&](Recipe &r) { r.window.baseline_s = band; });
    });

    buildEndControls();
    m_settle = form->add(tr("Settle"), "settle", new IntervalEdit(kMicroseconds, 0.0, kLongest_s));
    connect(m_settle, &IntervalEdit::edited, this, [this](const Auto<Interval> &band) {
        change(tr("Change the settle band"), [&](Recipe &r) { r.window.settle_s = band; });
    });
    m_remap = new WrappedCheckBox(tr("Remap to 0..1"));
    m_remap->setObjectName("remap");
    form->addWide(m_remap);
    connect(m_remap, &QCheckBox::clicked, this,
        [this](bool on) { change(tr("Remap"), [&](Recipe &r) { r.remap = on; }); });
    m_length = form->addReadout(tr("Length"), "windowLength");
    m_resolution = form->addReadout(tr("Resolution"), "windowResolution");

    form->addSection(tr("Left out of the fit, after the start"));
    auto *stretches = new StretchList;
    form->addWide(stretches);
    connect(stretches, &StretchList::reasonWanted, this, &WindowPage::inspectorWanted);
    m_stretches = new StretchMarking(session(), *stretches, {m_plot, m_detail}, this);
}

void WindowPage::buildEndControls()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Window, after the start"));
    m_endFor = form->addChoice(
        tr("End of"), "windowEndFor", {tr("all shots"), tr("each shot by itself")});
    connect(m_endFor, &QComboBox::activated, this, [this](int own) { chooseEnds(own == 1); });
    m_end = form->add(tr("End"), "windowEnd", new AutoEdit(kMicroseconds, 1e-10, kLongest_s, 4));
    connect(m_end, &AutoEdit::edited, this, [this](const Auto<double> &end_s) {
        change(tr("Change the window's end"),
            [&](Recipe &r) { typeEnd(r.window, chosenShot(), end_s); });
    });
    m_common = form->addNote("windowEndCommon");
    m_plateau = new WrappedCheckBox(tr("End with the computed plateau"));
    m_plateau->setObjectName("endAtPlateau");
    form->addWide(m_plateau);
    connect(m_plateau, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("End with the plateau"), [&](Recipe &r) { r.window.endAtPlateau = on; });
    });
}

void WindowPage::chooseEnds(bool own)
{
    if (own == hasOwnEnds(recipe().window))
        return;
    if (own)
        change(tr("Give each shot an end of its own"),
            [&](Recipe &r) { giveOwnEnds(r.window, session().state().captures->shots.size()); });
    else
        change(tr("Give all shots one end"),
            [&](Recipe &r) { giveCommonEnd(r.window, chosenShot()); });
}

void WindowPage::buildStartControls()
{
    InspectorForm *form = inspector();
    m_startShot = form->addChoice(tr("Values of"), "startShot", {});
    m_startShot->setToolTip(tr("What is automatic may differ from shot to shot"));
    connect(m_startShot, &QComboBox::activated, this, [this] {
        showLength();
        showRecipe();
    });
    form->addSection(tr("Start, on the record's own axis"));
    m_start = form->add(tr("Start"), "start", new AutoEdit(kMicroseconds, -1e4, 1e4, 6));
    connect(m_start, &AutoEdit::edited, this, &WindowPage::setStart);
}

void WindowPage::connectHandles()
{
    connect(m_plot, &PlotWidget::bandMoved, this, &WindowPage::moveBand);
    connect(m_plot, &PlotWidget::lineMoved, this, &WindowPage::moveLine);
}

void WindowPage::moveBand(const QString &id, Interval band, bool finished)
{
    if (id != kBaseline && id != kSettle)
        return; // a stretch left out
    if (id == kBaseline)
        change(
            tr("Move the baseline"), [&](Recipe &r) { r.window.baseline_s = band; }, id);
    else
        change(
            tr("Move the settle band"), [&](Recipe &r) { r.window.settle_s = band; }, id);
    if (finished)
        session().endMerge();
}

/// The start moves the axis itself, so it is applied once, on release.
void WindowPage::moveLine(const QString &id, double time_s, bool finished)
{
    if (id == kStart && finished)
        shiftStarts(time_s);
    if (id == kEnd && time_s > 0.0) {
        const std::optional<RecordEnd> last = lastEnd(recipe().window, results(), chosenShot());
        change(
            tr("Move the window's end"),
            [&](Recipe &r) {
                typeEnd(r.window, chosenShot(), last ? std::min(time_s, last->end_s) : time_s);
            },
            id);
    }
    if (finished) {
        session().endMerge();
        // The line goes back to where the records allow it, once it is let go.
        QMetaObject::invokeMethod(this, &WindowPage::showHandles, Qt::QueuedConnection);
    }
}

namespace {

/// The first view reaches past the end, so that its line can be seen and dragged outwards.
PlotContent contentWithRoom(const WindowResult &window)
{
    PlotContent content = windowCurves(window);
    double first_s = 0.0;
    double last_s = 0.0;
    for (const WindowedResponse &response : window.responses) {
        first_s = std::min(first_s, -static_cast<double>(response.lead) / response.sampleRate_Hz);
        last_s = std::max(last_s, response.end_s);
    }
    content.xMin = first_s;
    content.xMax = last_s + kRoom * (last_s - first_s);
    return content;
}

} // namespace

void WindowPage::shiftStarts(double by_s)
{
    if (!firstResponse())
        return;
    const WindowResult &window = *results().window;
    std::vector<double> starts_s = usedStarts(window, session().state().captures->shots.size());
    for (double &start_s : starts_s)
        start_s += by_s;
    change(tr("Move the start"), [&](Recipe &r) { typeStarts(r.window, starts_s, window); });
}

void WindowPage::setStart(const Auto<double> &start_s)
{
    if (start_s.isAuto()) {
        change(tr("Detect the start"), [&](Recipe &r) { detectStartsAgain(r.window, results()); });
        return;
    }
    const WindowedResponse *chosen = responseOfChosenShot();
    if (!chosen) {
        showRecipe(); // there is no record to put it in
        return;
    }
    const WindowResult &window = *results().window;
    std::vector<double> starts_s = usedStarts(window, session().state().captures->shots.size());
    starts_s[static_cast<std::size_t>(chosen->shot - 1)] = *start_s.value;
    change(tr("Change the start"), [&](Recipe &r) { typeStarts(r.window, starts_s, window); });
}

const WindowedResponse *WindowPage::firstResponse() const
{
    const auto &window = results().window;
    return window && !window->responses.empty() ? &window->responses.front() : nullptr;
}

const WindowedResponse *WindowPage::responseOfChosenShot() const
{
    if (!firstResponse())
        return nullptr;
    const auto position = static_cast<std::size_t>(std::max(m_startShot->currentIndex(), 0));
    const auto &responses = results().window->responses;
    return position < responses.size() ? &responses[position] : &responses.front();
}

Index WindowPage::chosenShot() const
{
    const WindowedResponse *chosen = responseOfChosenShot();
    return chosen ? chosen->shot : 1;
}

void WindowPage::showRecipe()
{
    const WindowSettings &settings = recipe().window;
    const WindowedResponse *chosen = responseOfChosenShot();
    const auto used = [](const WindowedResponse *response, auto member) {
        return response ? std::optional(response->*member) : std::nullopt;
    };
    const std::optional<double> start_s = used(chosen, &WindowedResponse::start_s);
    m_start->set(
        settings.start_s.empty() || !start_s ? Auto<double>() : Auto<double>(*start_s), start_s);
    m_subtract->setChecked(settings.subtractBaseline);
    m_baseline->setEnabled(settings.subtractBaseline);
    m_baseline->set(settings.baseline_s, used(chosen, &WindowedResponse::baseline_s));
    const std::size_t shots = session().state().captures->shots.size();
    m_endFor->setCurrentIndex(hasOwnEnds(settings) ? 1 : 0);
    m_endFor->setEnabled(!settings.endAtPlateau && (shots > 1 || hasOwnEnds(settings)));
    m_end->set(settings.endOfShot_s(chosenShot()), used(chosen, &WindowedResponse::end_s));
    m_end->setEnabled(!settings.endAtPlateau);
    m_common->setText(endText(settings, results(), chosenShot()));
    m_plateau->setChecked(settings.endAtPlateau);
    m_settle->set(settings.settle_s, used(chosen, &WindowedResponse::settle_s));
    m_remap->setChecked(recipe().remap);
    const bool step = isStepTreatment(recipe().input.treatment);
    m_remap->setEnabled(step);
    m_settle->setEnabled(step);
    showHandles();
    m_stretches->setShot(chosenShot());
    m_stretches->show();
}

void WindowPage::showHandles()
{
    if (m_plot->isHandleDragged())
        return;
    const WindowedResponse *chosen = responseOfChosenShot();
    if (!chosen) {
        for (const QString &id : {kBaseline, kSettle, kGuard})
            m_plot->removeBand(id);
        for (const QString &id : {kStart, kEnd})
            m_plot->removeLine(id);
        return;
    }
    const WindowSettings &settings = recipe().window;
    if (settings.subtractBaseline)
        m_plot->setBand(
            kBaseline, tr("baseline"), settings.baseline_s.value.value_or(chosen->baseline_s));
    else
        m_plot->removeBand(kBaseline);
    if (isStepTreatment(recipe().input.treatment))
        m_plot->setBand(kSettle, tr("settle"), settings.settle_s.value.value_or(chosen->settle_s));
    else
        m_plot->removeBand(kSettle);
    showGuard(*chosen);
    m_plot->setLine(kStart, tr("start"), 0.0);
    const bool own = hasOwnEnds(settings) && !settings.endAtPlateau;
    m_plot->setLine(kEnd, own ? tr("end of shot %1").arg(chosen->shot) : tr("end"),
        settings.endAtPlateau ? chosen->end_s
                              : settings.endOfShot_s(chosen->shot).value.value_or(chosen->end_s));
}

/// After the computed end of the plateau, less the guard, the record is no longer the response to
/// the step.
void WindowPage::showGuard(const WindowedResponse &response)
{
    const auto &expected = results().expected;
    const ShockConditions *shot = expected ? expected->conditions.ofShot(response.shot) : nullptr;
    if (!shot || !shot->plateau_s || !results().captures) {
        m_plot->removeBand(kGuard);
        return;
    }
    const auto at = static_cast<std::size_t>(response.shot - 1);
    const Channel *dut = results().captures->set.shots[at].channelWithRole(ChannelRole::Dut);
    const double last_s = dut ? dut->t0_s + dut->duration_s() - response.start_s : 0.0;
    m_plot->setBand(kGuard, tr("plateau over (computed)"),
        {*shot->plateau_s, std::max(last_s, 1.5 * *shot->plateau_s)}, false);
}

void WindowPage::showResults()
{
    const auto window = results().window;
    const WindowedResponse *first = firstResponse();
    if (first) {
        const Index points = pointsOf(*window);
        draw(m_plot, {{window}, points, [window] { return contentWithRoom(*window); }});
        draw(m_detail, {{window}, points, [window] { return startCurves(*window); }});
    } else {
        clear(m_plot);
        clear(m_detail);
    }
    showTable();
    const QSignalBlocker quiet(m_startShot);
    const QVariant chosen = m_startShot->currentData();
    m_startShot->clear();
    if (first)
        for (const WindowedResponse &response : window->responses)
            m_startShot->addItem(tr("Shot %1 %2").arg(response.shot).arg(levelText(response.level)),
                QVariant::fromValue<qlonglong>(response.shot));
    if (m_startShot->count() > 0)
        m_startShot->setCurrentIndex(std::max(0, m_startShot->findData(chosen)));
    showLength();
}

void WindowPage::showLength()
{
    const WindowedResponse *chosen = responseOfChosenShot();
    const bool cut = chosen && chosen->end_s > 0.0;
    m_length->setText(cut
            ? tr("%1, %2 samples").arg(shownQuantity(chosen->end_s, "s")).arg(chosen->length)
            : "–");
    m_resolution->setText(
        cut ? tr("%1 (1 / length)").arg(shownQuantity(1.0 / chosen->end_s, "Hz", 3)) : "–");
}

void WindowPage::showTable()
{
    QVector<QStringList> rows;
    if (const auto &window = results().window) {
        const auto column = [&](auto member, const QString &unit, int digits) {
            std::vector<std::optional<double>> values;
            values.reserve(window->responses.size());
            for (const WindowedResponse &r : window->responses)
                values.push_back(r.*member);
            return shownColumn(values, unit, digits);
        };
        using R = WindowedResponse;
        // Of shots in different units each has its own.
        const auto levels = [&](double R::*member) {
            constexpr int kDigits = 4;
            const auto &all = window->responses;
            const bool alike
                = std::ranges::all_of(all, [&](const R &r) { return r.unit == all.front().unit; });
            if (alike && !all.empty())
                return column(member, rawText(all.front().unit), kDigits);
            QStringList texts;
            for (const R &r : all)
                texts << shownQuantity(r.*member, rawText(r.unit), kDigits);
            return texts;
        };
        for (const R &r : window->responses)
            rows.push_back({QString("%1 %2").arg(r.shot).arg(levelText(r.level))});
        for (const QStringList &cells : {column(&R::start_s, "s", 8), column(&R::end_s, "s", 4),
                 levels(&R::baseline), levels(&R::settled), levels(&R::step),
                 column(&R::snr_dB, "dB", 3), column(&R::riseTime_s, "s", 3),
                 column(&R::overshoot_percent, "%", 3), column(&R::settlingTime_s, "s", 3)})
            for (qsizetype row = 0; row < rows.size(); ++row)
                rows[row] << cells[row];
    }
    m_table->setValues(
        {tr("Shot"), tr("Start"), tr("End"), tr("Baseline"), tr("Settled"), tr("Step"), tr("SNR"),
            tr("Rise 10–90 %"), tr("Overshoot"), tr("Settling ±5 %")},
        rows);
}

} // namespace dyncal
