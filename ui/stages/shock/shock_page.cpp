// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock/shock_page.h"

#include "ui/plot/curves/shock_curves.h"
#include "ui/stages/frame/folding_splitter.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/shock/arrival_panel.h"
#include "ui/stages/shock/conditions_panel.h"
#include "ui/stages/shock/shock_budget_table.h"
#include "ui/stages/shock/shock_on_show.h"
#include "ui/stages/shock/shock_tables.h"
#include "ui/text/core_text.h"
#include "ui/text/level_text.h"
#include "ui/text/quantity_column.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>

#include <algorithm>

namespace dyncal {

ShockPage::ShockPage(Session &session)
    : StagePage(session,
        {"shockPage", tr("Reference step"),
            tr("Gas state and shock velocity, or a typed step, give the pressure that the sensor saw.")},
        Page::Shock)
{
    buildPlots();
    buildReferenceControls();
    m_arrivalPanel = new ArrivalPanel(session, *inspector(), *m_side, this);
    m_conditions = new ConditionsPanel(session, *inspector(), this);
    connect(&session.envelopes(), &EnvelopeStore::changed, this, [this] {
        if (isVisible())
            m_arrivalPanel->showRecord();
    });
}

void ShockPage::buildPlots()
{
    m_diagram = makePlot("tubeDiagram", tr("Waves in the tube over distance and time"));
    m_side = makePlot("sidePlot", tr("Arrival of the shock at a sensor"));
    shareCursors(CursorAxis::RecordTime, {m_side});
    auto *plots = new FoldingSplitter(this);
    plots->addWidget(m_diagram);
    plots->addWidget(m_side);
    plots->setSizes({1000, 1000});
    m_reason = new QLabel(this);
    m_reason->setObjectName("sensitivityReason");
    m_reason->setWordWrap(true);
    m_tabs = new QTabWidget(this);
    m_tabs->setObjectName("shockTables");
    m_states = addTable(tr("States"), "stateTable");
    m_measured = addTable(tr("Measured"), "measuredTable");
    m_arrivals = addTable(tr("Arrivals"), "arrivalTable");
    m_uncertainty = addTable(tr("Uncertainty"), "stepUncertaintyTable");
    m_budget = addTable(tr("Budget of the shot"), "stepBudgetTable");
    m_peaks = addTable(tr("Peaks and gas"), "followedPeakTable");
    m_sensitivity = addTable(tr("Sensitivity"), "sensitivityTable");
    auto *lower = new QWidget;
    auto *layout = new QVBoxLayout(lower);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_reason);
    layout->addWidget(m_tabs);
    auto *split = new QSplitter(Qt::Vertical, this);
    split->addWidget(plots);
    split->addWidget(lower);
    split->setSizes({1000, 900});
    content()->addWidget(split);
}

ValueTable *ShockPage::addTable(const QString &title, const QString &objectName)
{
    auto *table = new ValueTable(objectName, title, this);
    m_tabs->addTab(table, title);
    return table;
}

void ShockPage::buildReferenceControls()
{
    InspectorForm *form = inspector();
    m_shot = form->addChoice(tr("Show"), "shockShot", {});
    connect(m_shot, &QComboBox::activated, this, [this] {
        showRecipe();
        showResults();
    });
    form->addSection(tr("Reference"));
    m_enabled = new WrappedCheckBox(tr("Compute the step from the shock"));
    m_enabled->setObjectName("shockEnabled");
    form->addWide(m_enabled);
    connect(m_enabled, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Compute the step from the shock"), [&](Recipe &r) { r.shock.enabled = on; });
    });
    m_step = addTyped(tr("Pressure step, typed"), "stepPressure",
        new OptionalEdit({"kPa", 1e3}, 1e-3, 1e12), &ShockSettings::step_Pa);
    m_velocity = addTyped(tr("Velocity, typed"), "shockVelocity",
        new OptionalEdit({"m/s", 1.0}, 1.0, 1e5), &ShockSettings::velocity_m_s);
    m_step->setEmptyText(tr("computed"));
    m_velocity->setEmptyText(tr("measured"));
}

/// What is typed belongs to the shot on show: every shot has a step of its own.
OptionalEdit *ShockPage::addTyped(const QString &label, const QString &objectName,
    OptionalEdit *control, PerShot ShockSettings::*member)
{
    inspector()->add(label, objectName, control);
    connect(control, &OptionalEdit::edited, this, [=, this](const std::optional<double> &value) {
        const auto shots = std::ssize(session().state().captures->shots);
        const Index shot = std::max<Index>(shownNumber(), 1);
        change(tr("Change %1 of shot %2").arg(label).arg(shot),
            [&](Recipe &r) { r.shock.*member = (r.shock.*member).with(shot, shots, value); });
    });
    return control;
}

Index ShockPage::shownNumber() const
{
    return m_shot->currentData().toLongLong();
}

const ShockConditions *ShockPage::shownShot() const
{
    const ShockConditionsSet *shock = shockOnShow(session());
    return shock ? shock->ofShot(shownNumber()) : nullptr;
}

bool ShockPage::showsOld(StageId from) const
{
    return from == StageId::Shock ? isOldShockOnShow(session()) : StagePage::showsOld(from);
}

void ShockPage::showRecipe()
{
    showShots();
    m_arrivalPanel->setShot(shownNumber());
    m_arrivalPanel->showSensors();
    const ShockSettings &settings = recipe().shock;
    m_enabled->setChecked(settings.enabled);
    m_step->set(settings.step_Pa.of(shownNumber()));
    m_velocity->set(settings.velocity_m_s.of(shownNumber()));
    const auto &shots = session().state().captures->shots;
    const auto at = static_cast<std::size_t>(std::max<Index>(shownNumber() - 1, 0));
    m_conditions->show(at < shots.size() ? &shots[at] : nullptr, shownShot());
}

void ShockPage::showShots()
{
    const QSignalBlocker quiet(m_shot);
    const Index chosen = shownNumber();
    m_shot->clear();
    const auto &shots = session().state().captures->shots;
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const auto number = static_cast<Index>(i) + 1;
        m_shot->addItem(tr("Shot %1 %2").arg(number).arg(levelText(shots[i].level)),
            QVariant::fromValue<qlonglong>(number));
    }
    const int again = m_shot->findData(QVariant::fromValue<qlonglong>(chosen));
    m_shot->setCurrentIndex(again >= 0 ? again : m_shot->count() - 1);
}

void ShockPage::showResults()
{
    showShots();
    m_arrivalPanel->setShot(shownNumber());
    m_arrivalPanel->showSensors();
    showDiagram();
    m_arrivalPanel->showRecord();
    showTables();
    showSensitivity();
}

void ShockPage::showDiagram()
{
    const ShockConditions *shot = shownShot();
    m_diagram->setContent(shot && shot->diagram ? tubeDiagramCurves(*shot) : nothingYet());
}

void ShockPage::showTables()
{
    const auto show = [](ValueTable *table, const ShownTable &values) {
        table->setValues(values.headers, values.rows);
    };
    const ShockConditionsSet none;
    const ShockConditionsSet *known = shockOnShow(session());
    const ShockConditionsSet &shock = known ? *known : none;
    const ShockConditions *shot = shownShot();
    show(m_states, known ? stateTable(shock) : ShownTable{{tr("Quantity")}, {}});
    show(m_measured, measuredTable(shock));
    show(m_arrivals, arrivalTable(shock));
    show(m_uncertainty, uncertaintyTable(shock, results().monteCarlo.get()));
    show(m_budget, budgetTable(shot ? *shot : ShockConditions()));
    show(m_peaks, followedPeakTable(shock));
}

static QString sensitivityText(double value, double u, const QString &unit)
{
    return std::isfinite(u) ? shownWithStandardU(value, u, unit) : shownQuantity(value, unit, 5);
}

static QString driftText(const ShotDrift *drift)
{
    return drift
        ? shownWithStandardU(100.0 * drift->relative, 100.0 * drift->u, QStringLiteral("%"))
        : QStringLiteral("\u2013");
}

void ShockPage::showSensitivity()
{
    const auto &response = session().results().response;
    const UncertaintyReport *report = session().results().uncertainty.get();
    QVector<QStringList> rows;
    if (response)
        for (std::size_t i = 0; i < response->shots.size(); ++i) {
            const ShotSensitivity &shot = response->shots[i];
            rows.push_back({tr("Shot %1").arg(shot.shot),
                shot.sensitivity
                    ? sensitivityText(*shot.sensitivity, uOfShot(report, i), rawText(shot.unit))
                    : tr("not determined"),
                driftText(response->drift.ofShot(shot.shot))});
        }
    m_sensitivity->setValues({tr("Shot"), tr("Sensitivity"), tr("Drift to the settle band")}, rows);
    if (response && response->sensitivity) {
        m_reason->setText(tr("Sensitivity: %1, mean over the shots.")
                              .arg(sensitivityText(*response->sensitivity, uOfSensitivity(report),
                                  rawText(response->sensitivityUnit))));
        return;
    }
    QStringList reasons;
    if (const ShockConditionsSet *shock = shockOnShow(session()))
        for (const Finding &finding : shock->findings)
            reasons << translated(finding.message);
    if (session().error() && !session().isComputing())
        reasons << translated(session().error()->message);
    reasons.removeDuplicates();
    m_reason->setText(tr("Sensitivity: not determined. %1").arg(reasons.join(' ')));
}

} // namespace dyncal
