// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock_page.h"

#include "ui/plot/signal_curves.h"
#include "ui/stages/quantity_edit.h"
#include "ui/stages/value_table.h"
#include "ui/text/core_text.h"
#include "ui/text/level_text.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSplitter>

#include <cmath>

namespace dyncal {

namespace {

const ShownUnit kKilopascal{"kPa", 1e3};
const ShownUnit kKelvin{"K", 1.0};
const ShownUnit kMetre{"m", 1.0};

std::optional<double> recorded(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace

ShockPage::ShockPage(Session &session)
    : StagePage(session,
        {"shockPage", tr("Reference step"),
            tr("Gas state and shock velocity, or a typed step, give the pressure that the sensor "
               "saw.")},
        {StageId::Shock, StageId::MonteCarlo})
{
    m_side = makePlot("sidePlot", tr("Arrival of the shock at the side sensor"));
    connect(&session.envelopes(), &EnvelopeStore::changed, this, [this] {
        if (isVisible())
            showResults();
    });
    m_states = new ValueTable("stateTable", tr("States of the gas per shot"), this);
    m_sensitivity = new ValueTable("sensitivityTable", tr("Sensitivity per shot"), this);
    m_reason = new QLabel(this);
    m_reason->setObjectName("sensitivityReason");
    m_reason->setWordWrap(true);
    auto *lower = new QWidget;
    auto *layout = new QVBoxLayout(lower);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_reason);
    layout->addWidget(m_sensitivity);
    auto *split = new QSplitter(Qt::Vertical, this);
    split->addWidget(m_side);
    split->addWidget(m_states);
    split->addWidget(lower);
    split->setSizes({700, 1000, 450});
    content()->addWidget(split);
    buildReferenceControls();
    buildInspector();
}

void ShockPage::addOptional(OptionalEdit *&edit, const QString &label, const QString &name,
    OptionalEdit *control, std::optional<double> ShockSettings::*member)
{
    edit = inspector()->add(label, name, control);
    connect(edit, &OptionalEdit::edited, this,
        [this, label, member](const std::optional<double> &value) {
            change(tr("Change %1").arg(label), [&](Recipe &r) { r.shock.*member = value; });
        });
}

void ShockPage::buildReferenceControls()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Reference"));
    m_enabled = new QCheckBox(tr("Compute the step from the shock"));
    m_enabled->setObjectName("shockEnabled");
    form->addWide(m_enabled);
    connect(m_enabled, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Compute the step from the shock"), [&](Recipe &r) { r.shock.enabled = on; });
    });
    addOptional(m_step, tr("Pressure step, typed"), "stepPressure",
        new OptionalEdit(kKilopascal, 1e-3, 1e12), &ShockSettings::step_Pa);
    addOptional(m_velocity, tr("Velocity, typed"), "shockVelocity",
        new OptionalEdit({"m/s", 1.0}, 1.0, 1e5), &ShockSettings::velocity_m_s);
    m_step->setEmptyText(tr("computed"));
    m_velocity->setEmptyText(tr("measured"));
    m_sideChannel = form->addChoice(tr("Arrival at"), "arrivalChannel",
        {roleText(ChannelRole::DrivenSide), roleText(ChannelRole::Driver),
            roleText(ChannelRole::Trigger)});
    m_distance = form->add(
        tr("Distance to end wall"), "arrivalDistance", new OptionalEdit(kMetre, 1e-4, 100.0));
    connect(m_distance, &OptionalEdit::edited, this, &ShockPage::setDistance);
    connect(m_sideChannel, &QComboBox::activated, this, [this] {
        if (!recipe().shock.arrivalSensors.empty())
            setDistance(recipe().shock.arrivalSensors.front().distanceToEndWall_m);
    });
}

void ShockPage::buildInspector()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Gas before the shot"));
    addOptional(m_p1, tr("p1, absolute"), "p1", new OptionalEdit(kKilopascal, 1e-3, 1e12),
        &ShockSettings::p1_Pa);
    addOptional(m_T1, tr("T1"), "T1", new OptionalEdit(kKelvin, 1.0, 5000.0), &ShockSettings::T1_K);
    addOptional(m_T4, tr("T4 (driver)"), "T4", new OptionalEdit(kKelvin, 1.0, 5000.0),
        &ShockSettings::T4_K);
    addOptional(m_humidity, tr("Relative humidity"), "humidity",
        new OptionalEdit({"%", 0.01}, 0.0, 1.0), &ShockSettings::relativeHumidity);
    m_gamma = form->add(tr("Driven gas: γ"), "drivenGamma", new QuantityEdit({}, 1.0001, 2.0, 5));
    connect(m_gamma, &QuantityEdit::edited, this, [this](double gamma) {
        change(tr("Change the gas"), [&](Recipe &r) { r.shock.drivenGas.gamma = gamma; });
    });
    m_molarMass = form->add(
        tr("Molar mass"), "drivenMolarMass", new QuantityEdit({"g/mol", 1e-3}, 1e-3, 1.0, 4));
    connect(m_molarMass, &QuantityEdit::edited, this, [this](double mass) {
        change(tr("Change the gas"), [&](Recipe &r) { r.shock.drivenGas.molarMass_kg_mol = mass; });
    });
    form->addSection(tr("Tube"));
    addOptional(m_drivenLength, tr("Driven section"), "drivenLength",
        new OptionalEdit(kMetre, 1e-3, 1000.0), &ShockSettings::drivenLength_m);
    addOptional(m_driverLength, tr("Driver section"), "driverLength",
        new OptionalEdit(kMetre, 1e-3, 1000.0), &ShockSettings::driverLength_m);
}

void ShockPage::setDistance(const std::optional<double> &distance_m)
{
    static const std::array kChannels{
        ChannelRole::DrivenSide, ChannelRole::Driver, ChannelRole::Trigger};
    change(tr("Change the arrival sensor"), [&](Recipe &r) {
        ArrivalSensor sensor
            = r.shock.arrivalSensors.empty() ? ArrivalSensor{} : r.shock.arrivalSensors.front();
        r.shock.arrivalSensors.clear();
        if (!distance_m)
            return;
        sensor.channel
            = channelRoleName(kChannels[static_cast<std::size_t>(m_sideChannel->currentIndex())]);
        sensor.distanceToEndWall_m = *distance_m;
        r.shock.arrivalSensors.push_back(sensor);
    });
}

void ShockPage::showRecipe()
{
    const ShockSettings &settings = recipe().shock;
    const CaptureSet &set = *session().state().captures;
    const Environment unknown;
    const Environment &around = set.shots.empty() ? unknown : set.shots.front().environment;
    m_enabled->setChecked(settings.enabled);
    m_step->set(settings.step_Pa);
    m_velocity->set(settings.velocity_m_s);
    m_p1->set(settings.p1_Pa, recorded(around.p1_Pa));
    m_T1->set(settings.T1_K, recorded(around.T1_K));
    m_T4->set(settings.T4_K, recorded(around.T4_K));
    m_humidity->set(settings.relativeHumidity, recorded(around.relativeHumidity));
    m_gamma->setSi(settings.drivenGas.gamma);
    m_molarMass->setSi(settings.drivenGas.molarMass_kg_mol);
    const auto &sensors = settings.arrivalSensors;
    std::optional<double> used;
    if (results().shock && !results().shock->shots.empty()
        && results().shock->shots.front().distance_m > 0.0)
        used = results().shock->shots.front().distance_m;
    m_distance->set(
        sensors.empty() ? std::nullopt : std::optional(sensors.front().distanceToEndWall_m), used);
    m_drivenLength->set(settings.drivenLength_m, set.tubeNumber("driven_length_m"));
    m_driverLength->set(settings.driverLength_m, set.tubeNumber("driver_length_m"));
}

/// One row per quantity, one column per shot, as tables 4.1 and 4.2 of the thesis.
QVector<QStringList> ShockPage::stateRows() const
{
    QVector<QStringList> rows;
    const auto add = [&](const QString &name, auto value) {
        QStringList row{name};
        for (const ShockConditions &shot : results().shock->shots)
            row << value(shot);
        rows.push_back(row);
    };
    const auto state = [&](const QString &name, auto value, const QString &unit, int digits) {
        add(name, [&](const ShockConditions &shot) {
            return shot.states ? shownQuantity(value(*shot.states), unit, digits) : QString("–");
        });
    };
    using States = const ShockStates &;
    add(tr("Pressure step"), [](const ShockConditions &shot) {
        return shot.step_Pa
            ? shownQuantity(*shot.step_Pa, "Pa", 5) + (shot.stepTyped ? tr(" (typed)") : QString())
            : tr("not determined");
    });
    state(
        tr("Velocity W"), [](States s) { return s.velocity_m_s; }, "m/s", 6);
    state(
        tr("Mach number"), [](States s) { return s.mach; }, {}, 5);
    state(
        tr("p1"), [](States s) { return s.driven.pressure_Pa; }, "Pa", 5);
    state(
        tr("p2"), [](States s) { return s.shocked.pressure_Pa; }, "Pa", 5);
    state(
        tr("p5"), [](States s) { return s.reflected.pressure_Pa; }, "Pa", 5);
    state(
        tr("T1"), [](States s) { return s.driven.temperature_K; }, "K", 5);
    state(
        tr("T2"), [](States s) { return s.shocked.temperature_K; }, "K", 5);
    state(
        tr("T5"), [](States s) { return s.reflected.temperature_K; }, "K", 5);
    state(
        tr("Gas velocity u2"), [](States s) { return s.shocked.velocity_m_s; }, "m/s", 4);
    state(
        tr("Reflected shock"), [](States s) { return s.reflectedVelocity_m_s; }, "m/s", 4);
    add(tr("Plateau lasts"),
        [](const ShockConditions &shot) { return shownQuantity(shot.plateau_s, "s", 4); });
    add(tr("Arrival at the side"),
        [](const ShockConditions &shot) { return shownQuantity(shot.arrival_s, "s", 5); });
    return rows;
}

PlotContent ShockPage::rawSideCurves()
{
    const CaptureSet &set = results().captures->set;
    EnvelopeStore &envelopes = session().envelopes();
    envelopes.want(longRecords(set));
    PlotContent content = rawCurves(set, ChannelRole::DrivenSide,
        [&](const Channel &channel) { return envelopes.find(channel); });
    content.growing = envelopes.isBusy();
    return content;
}

void ShockPage::showResults()
{
    const auto &shock = results().shock;
    const auto &captures = results().captures;
    bool side = false;
    PlotContent content;
    if (captures) {
        for (const Shot &shot : captures->set.shots)
            side = side || shot.channelWithRole(ChannelRole::DrivenSide);
        if (side)
            content = rawSideCurves();
    }
    QStringList headers{tr("Quantity")};
    if (shock) {
        for (const ShockConditions &shot : shock->shots) {
            headers << tr("Shot %1").arg(shot.shot);
            if (shot.arrival_s)
                content.marks.push_back(
                    {*shot.arrival_s, tr("arrival %1").arg(shot.shot), CurveRole::Reference});
        }
    }
    m_side->setVisible(side);
    m_side->setContent(content);
    m_states->setValues(headers, shock ? stateRows() : QVector<QStringList>());
    showSensitivity();
}

void ShockPage::showSensitivity()
{
    const auto &response = results().response;
    QVector<QStringList> rows;
    if (response)
        for (const ShotSensitivity &shot : response->shots)
            rows.push_back({tr("Shot %1").arg(shot.shot),
                shot.sensitivity
                    ? shownQuantity(*shot.sensitivity, QString::fromStdString(shot.unit), 5)
                    : tr("not determined")});
    m_sensitivity->setValues({tr("Shot"), tr("Sensitivity")}, rows);
    if (response && response->sensitivity) {
        m_reason->setText(tr("Sensitivity: <b>%1</b>, mean over the shots.")
                              .arg(shownQuantity(*response->sensitivity,
                                  QString::fromStdString(response->sensitivityUnit), 5)));
        return;
    }
    QStringList reasons;
    if (results().shock)
        for (const Finding &finding : results().shock->findings)
            reasons << translated(finding.message);
    reasons.removeDuplicates();
    m_reason->setText(tr("Sensitivity: <b>not determined</b>. %1").arg(reasons.join(' ')));
}

} // namespace dyncal
