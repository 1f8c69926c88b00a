// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock_page.h"

#include "ui/plot/shock_curves.h"
#include "ui/stages/gas_edit.h"
#include "ui/stages/value_table.h"
#include "ui/text/core_text.h"
#include "ui/text/level_text.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

const ShownUnit kKilopascal{"kPa", 1e3};
const ShownUnit kKelvin{"K", 1.0};
const ShownUnit kMetre{"m", 1.0};
const ShownUnit kMillimetre{"mm", 1e-3};
const ShownUnit kMicroseconds{"µs", 1e-6};
const QString kArrival = QStringLiteral("arrival");
constexpr double kLongest_s = 1e4;

std::optional<double> recorded(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> notZero(double value)
{
    return value > 0.0 ? std::optional(value) : std::nullopt;
}

/// Words of the recipe for a sensor's channel: the roles, then the channels by name.
QStringList channelWords(const CaptureSet &set)
{
    QStringList words;
    for (const ChannelRole role :
        {ChannelRole::DrivenSide, ChannelRole::Driver, ChannelRole::Trigger})
        words << QString::fromLatin1(channelRoleName(role));
    if (!set.shots.empty()) {
        for (const Channel &channel : set.shots.front().channels)
            words << QString::fromStdString(channel.name);
    }
    words.removeDuplicates();
    return words;
}

QString channelText(const QString &word)
{
    const ChannelRole role = channelRoleFromName(word.toStdString());
    return role == ChannelRole::Other ? word : roleText(role);
}

/// What is typed as the arrival of a sensor in a shot (from 1).
std::optional<double> typedArrival_s(const ArrivalSensor &sensor, Index shot)
{
    const auto at = static_cast<std::size_t>(shot - 1);
    return at < sensor.shotArrival_s.size() ? sensor.shotArrival_s[at] : sensor.arrival_s;
}

/// What was used: found in the record, or typed.
std::optional<double> usedArrival_s(const ShockConditions &shot, const ArrivalSensor &sensor)
{
    if (const auto typed_s = typedArrival_s(sensor, shot.shot))
        return typed_s;
    for (const SeenArrival &seen : shot.seen) {
        if (seen.channel == sensor.channel && seen.found)
            return seen.found->time_s;
    }
    return std::nullopt;
}

/// The long records that every page shows, and this one.
std::vector<Channel> wantedRecords(const CaptureSet &set, const Channel &channel)
{
    std::vector<Channel> wanted = longRecords(set);
    const bool others = channel.role == ChannelRole::Trigger || channel.role == ChannelRole::Other;
    if (others && isLongRecord(channel))
        wanted.push_back(channel);
    return wanted;
}

} // namespace

ShockPage::ShockPage(Session &session)
    : StagePage(session,
        {"shockPage", tr("Reference step"),
            tr("Gas state and shock velocity, or a typed step, give the pressure that the sensor "
               "saw.")},
        {StageId::Shock, StageId::MonteCarlo})
{
    buildPlots();
    buildReferenceControls();
    buildArrivalControls();
    buildGasControls();
    buildTubeControls();
    connect(&session.envelopes(), &EnvelopeStore::changed, this, [this] {
        if (isVisible())
            showArrival();
    });
    connect(m_side, &PlotWidget::lineMoved, this,
        [this](const QString &, double time_s, bool finished) { moveArrival(time_s, finished); });
}

void ShockPage::buildPlots()
{
    m_diagram = makePlot("tubeDiagram", tr("Waves in the tube over distance and time"));
    m_side = makePlot("sidePlot", tr("Arrival of the shock at a sensor"));
    auto *plots = new QSplitter(Qt::Horizontal, this);
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
    m_shot = form->addChoice(tr("Show"), "shockShot", {});
    connect(m_shot, &QComboBox::activated, this, [this] {
        showRecipe();
        showResults();
    });
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
}

void ShockPage::buildArrivalControls()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Arrival of the shock"));
    m_sensor = form->addChoice(tr("Sensor"), "arrivalSensor", {});
    connect(m_sensor, &QComboBox::activated, this, [this] {
        showSensorFields();
        showArrival();
    });
    m_sideChannel = form->addChoice(tr("Channel"), "arrivalChannel", {});
    connect(m_sideChannel, &QComboBox::activated, this, [this] {
        const std::string word = m_sideChannel->currentData().toString().toStdString();
        editSensor(tr("Change the arrival sensor"), [&](ArrivalSensor &s) { s.channel = word; });
    });
    m_distance = form->add(
        tr("Distance to end wall"), "arrivalDistance", new OptionalEdit(kMetre, 1e-4, 100.0));
    connect(m_distance, &OptionalEdit::edited, this, &ShockPage::setDistance);
    m_distanceUncertainty = form->add(
        tr("u (distance)"), "arrivalDistanceUncertainty", new OptionalEdit(kMillimetre, 0.0, 1.0));
    connect(m_distanceUncertainty, &OptionalEdit::edited, this,
        [this](const std::optional<double> &u_m) {
            editSensor(tr("Change u of the distance"),
                [&](ArrivalSensor &s) { s.u_distance_m = u_m.value_or(0.0); });
        });
    m_arrival = form->add(
        tr("Arrival"), "arrivalTime", new AutoEdit(kMicroseconds, -kLongest_s, kLongest_s, 4));
    connect(m_arrival, &AutoEdit::edited, this,
        [this](const Auto<double> &arrival_s) { setArrival(arrival_s.value); });
    m_arrivalUncertainty = form->addReadout(tr("u (arrival)"), "arrivalUncertainty");
    m_delay = form->add(tr("Delay of the sensor"), "arrivalDelay",
        new OptionalEdit(kMicroseconds, -kLongest_s, kLongest_s));
    m_delay->setEmptyText(tr("unknown"));
    connect(m_delay, &OptionalEdit::edited, this, [this](const std::optional<double> &delay_s) {
        editSensor(tr("Change the delay"), [&](ArrivalSensor &s) { s.delay_s = delay_s; });
    });
    m_addSensor = new QPushButton(tr("Add a sensor"));
    m_addSensor->setObjectName("addArrivalSensor");
    m_removeSensor = new QPushButton(tr("Remove this sensor"));
    m_removeSensor->setObjectName("removeArrivalSensor");
    form->addWide(m_addSensor);
    form->addWide(m_removeSensor);
    connect(m_addSensor, &QPushButton::clicked, this, &ShockPage::addSensor);
    connect(m_removeSensor, &QPushButton::clicked, this, &ShockPage::removeSensor);
}

void ShockPage::buildGasControls()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Gas before the shot"));
    addOptional(m_p1, tr("p1, absolute"), "p1", new OptionalEdit(kKilopascal, 1e-3, 1e12),
        &ShockSettings::p1_Pa);
    addOptional(m_T1, tr("T1"), "T1", new OptionalEdit(kKelvin, 1.0, 5000.0), &ShockSettings::T1_K);
    addOptional(m_T4, tr("T4 (driver)"), "T4", new OptionalEdit(kKelvin, 1.0, 5000.0),
        &ShockSettings::T4_K);
    m_driven = new GasEdit(*form, tr("Driven gas"), "driven", this);
    connect(m_driven, &GasEdit::edited, this, [this](const GasSettings &gas) {
        change(tr("Change the driven gas"), [&](Recipe &r) { r.shock.drivenGas = gas; });
    });
    m_variable = new QCheckBox(tr("Heat capacity varies with temperature"));
    m_variable->setObjectName("variableHeatCapacity");
    form->addWide(m_variable);
    connect(m_variable, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Change the heat capacity"), [&](Recipe &r) {
            r.shock.drivenGas.heatCapacity = on ? kVariableHeatCapacity : kConstantHeatCapacity;
        });
    });
    addOptional(m_humidity, tr("Relative humidity"), "humidity",
        new OptionalEdit({"%", 0.01}, 0.0, 1.0), &ShockSettings::relativeHumidity);
    m_dioxide = form->add(tr("CO₂"), "carbonDioxide", new OptionalEdit({"ppm", 1e-6}, 0.0, 0.01));
    connect(m_dioxide, &OptionalEdit::edited, this, [this](const std::optional<double> &share) {
        change(tr("Change the CO₂ of the air"), [&](Recipe &r) {
            r.shock.carbonDioxide = share.value_or(ShockSettings().carbonDioxide);
        });
    });
    m_driver = new GasEdit(*form, tr("Driver gas"), "driver", this);
    connect(m_driver, &GasEdit::edited, this, [this](const GasSettings &gas) {
        change(tr("Change the driver gas"), [&](Recipe &r) { r.shock.driverGas = gas; });
    });
}

void ShockPage::buildTubeControls()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Tube"));
    addOptional(m_drivenLength, tr("Driven section"), "drivenLength",
        new OptionalEdit(kMetre, 1e-3, 1000.0), &ShockSettings::drivenLength_m);
    addOptional(m_driverLength, tr("Driver section"), "driverLength",
        new OptionalEdit(kMetre, 1e-3, 1000.0), &ShockSettings::driverLength_m);
    addOptional(m_diameter, tr("Inner diameter"), "innerDiameter",
        new OptionalEdit(kMillimetre, 1e-4, 100.0), &ShockSettings::innerDiameter_m);
    m_guard = form->add(tr("Guard before the plateau's end"), "plateauGuard",
        new OptionalEdit(kMicroseconds, 0.0, 1.0));
    m_guard->setEmptyText(tr("none"));
    connect(m_guard, &OptionalEdit::edited, this, [this](const std::optional<double> &guard_s) {
        change(tr("Change the guard"),
            [&](Recipe &r) { r.shock.plateauGuard_s = guard_s.value_or(0.0); });
    });
}

Index ShockPage::shownNumber() const
{
    return m_shot->currentData().toLongLong();
}

const ShockConditions *ShockPage::shownShot() const
{
    return results().shock ? results().shock->ofShot(shownNumber()) : nullptr;
}

std::vector<ArrivalSensor> ShockPage::sensors() const
{
    const CaptureSet &set = *session().state().captures;
    const auto &list = recipe().shock.arrivalSensors;
    return set.shots.empty() ? list : list.empty() ? arrivalSensors(set, 1, recipe().shock) : list;
}

std::size_t ShockPage::shownSensor() const
{
    return static_cast<std::size_t>(std::max(m_sensor->currentIndex(), 0));
}

const Channel *ShockPage::shownChannel() const
{
    const auto &captures = results().captures;
    const auto at = static_cast<std::size_t>(std::max<Index>(shownNumber() - 1, 0));
    if (!captures || at >= captures->set.shots.size())
        return nullptr;
    const Shot &shot = captures->set.shots[at];
    const auto list = sensors();
    return shownSensor() < list.size() ? shot.channelCalled(list[shownSensor()].channel)
                                       : shot.channelWithRole(ChannelRole::Dut);
}

void ShockPage::editSensor(
    const QString &label, const std::function<void(ArrivalSensor &)> &edit, const QString &mergeKey)
{
    std::vector<ArrivalSensor> list = sensors();
    if (list.empty())
        list.push_back({channelRoleName(ChannelRole::DrivenSide)});
    edit(list[std::min(shownSensor(), list.size() - 1)]);
    if (std::any_of(list.begin(), list.end(),
            [](const ArrivalSensor &s) { return !(s.distanceToEndWall_m > 0.0); }))
        return; // a place without a distance is none
    change(
        label, [&](Recipe &r) { r.shock.arrivalSensors = list; }, mergeKey);
}

void ShockPage::setDistance(const std::optional<double> &distance_m)
{
    if (!distance_m)
        removeSensor();
    else
        editSensor(tr("Change the arrival sensor"),
            [&](ArrivalSensor &s) { s.distanceToEndWall_m = *distance_m; });
}

void ShockPage::addSensor()
{
    std::vector<ArrivalSensor> list = sensors();
    ArrivalSensor added{channelRoleName(ChannelRole::DrivenSide), 1.0};
    if (!list.empty())
        added = list.back();
    added.arrival_s.reset();
    added.shotArrival_s.clear();
    list.push_back(added);
    change(tr("Add an arrival sensor"), [&](Recipe &r) { r.shock.arrivalSensors = list; });
    m_sensor->setCurrentIndex(static_cast<int>(list.size()) - 1);
    showSensorFields();
    showArrival();
}

void ShockPage::removeSensor()
{
    std::vector<ArrivalSensor> list = recipe().shock.arrivalSensors;
    if (shownSensor() >= list.size())
        return;
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(shownSensor()));
    change(tr("Remove an arrival sensor"), [&](Recipe &r) { r.shock.arrivalSensors = list; });
}

void ShockPage::setArrival(const std::optional<double> &arrival_s, const QString &mergeKey)
{
    const std::size_t shots = session().state().captures->shots.size();
    const auto at = static_cast<std::size_t>(shownNumber() - 1);
    if (at >= shots || shownSensor() >= sensors().size())
        return;
    editSensor(
        arrival_s ? tr("Move an arrival") : tr("Find the arrival"),
        [&](ArrivalSensor &s) {
            if (s.shotArrival_s.empty())
                s.shotArrival_s.assign(shots, s.arrival_s);
            s.shotArrival_s.resize(shots);
            s.shotArrival_s[at] = arrival_s;
            s.arrival_s.reset();
            const bool none = std::none_of(s.shotArrival_s.begin(), s.shotArrival_s.end(),
                [](const std::optional<double> &typed_s) { return typed_s.has_value(); });
            if (none)
                s.shotArrival_s.clear();
        },
        mergeKey);
}

void ShockPage::moveArrival(double time_s, bool finished)
{
    m_dragging = !finished;
    setArrival(time_s, kArrival);
    if (finished)
        session().endMerge();
}

void ShockPage::showRecipe()
{
    showShots();
    showSensors();
    const ShockSettings &settings = recipe().shock;
    const CaptureSet &set = *session().state().captures;
    const Environment unknown;
    const auto at = static_cast<std::size_t>(std::max<Index>(shownNumber() - 1, 0));
    const Environment &around = at < set.shots.size() ? set.shots[at].environment : unknown;
    m_enabled->setChecked(settings.enabled);
    m_step->set(settings.step_Pa);
    m_velocity->set(settings.velocity_m_s);
    m_p1->set(settings.p1_Pa, recorded(around.p1_Pa));
    m_T1->set(settings.T1_K, recorded(around.T1_K));
    m_T4->set(settings.T4_K, recorded(around.T4_K));
    m_humidity->set(settings.relativeHumidity, recorded(around.relativeHumidity));
    m_dioxide->set(settings.carbonDioxide);
    const GasSettings &gas = settings.drivenGas;
    const bool moist = gas.substance == "humid-air";
    m_humidity->setEnabled(moist);
    m_dioxide->setEnabled(moist);
    m_variable->setChecked(gas.heatCapacity == kVariableHeatCapacity);
    m_variable->setEnabled(!moist && gas.substance != "custom");
    const ShockConditions *shot = shownShot();
    m_driven->set(gas, shot ? shot->drivenGas : std::nullopt);
    m_driver->set(settings.driverGas, shot ? shot->driverGas : std::nullopt);
    m_drivenLength->set(settings.drivenLength_m, set.tubeNumber("driven_length_m"));
    m_driverLength->set(settings.driverLength_m, set.tubeNumber("driver_length_m"));
    m_diameter->set(settings.innerDiameter_m, set.tubeNumber("inner_diameter_m"));
    m_guard->set(notZero(settings.plateauGuard_s));
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

void ShockPage::showSensors()
{
    const CaptureSet &set = *session().state().captures;
    const auto list = sensors();
    const int chosen = m_sensor->currentIndex();
    m_sensor->clear();
    for (const ArrivalSensor &sensor : list)
        m_sensor->addItem(tr("%1, %2").arg(channelText(QString::fromStdString(sensor.channel)),
            shownQuantity(sensor.distanceToEndWall_m, "m", 4)));
    m_sensor->addItem(roleText(ChannelRole::Dut));
    m_sensor->setCurrentIndex(std::clamp(chosen, 0, m_sensor->count() - 1));
    m_sideChannel->clear();
    for (const QString &word : channelWords(set))
        m_sideChannel->addItem(channelText(word), word);
    showSensorFields();
}

void ShockPage::showSensorFields()
{
    const auto list = sensors();
    const bool isSensor = shownSensor() < list.size();
    const bool mayAdd = isSensor || list.empty();
    const ArrivalSensor sensor = isSensor ? list[shownSensor()] : ArrivalSensor{};
    const bool typed = !recipe().shock.arrivalSensors.empty();
    m_sideChannel->setCurrentIndex(
        std::max(m_sideChannel->findData(QString::fromStdString(sensor.channel)), 0));
    const auto distance_m = notZero(sensor.distanceToEndWall_m);
    m_distance->set(typed ? distance_m : std::nullopt, distance_m);
    m_distanceUncertainty->set(
        typed ? notZero(sensor.u_distance_m) : std::nullopt, notZero(sensor.u_distance_m));
    m_delay->set(sensor.delay_s);
    const ShockConditions *shot = shownShot();
    const auto arrival_s = typedArrival_s(sensor, shownNumber());
    m_arrival->set(arrival_s ? Auto<double>(*arrival_s) : Auto<double>(),
        shot && isSensor ? usedArrival_s(*shot, sensor) : std::nullopt);
    m_arrivalUncertainty->setText("–");
    for (const Sighting &seen : shot ? shot->sightings : std::vector<Sighting>()) {
        if (seen.channel == sensor.channel || (!isSensor && seen.isDut))
            m_arrivalUncertainty->setText(tr("%1; delay %2")
                                              .arg(shownQuantity(seen.u_time_s, "s", 2),
                                                  shownQuantity(notZero(seen.u_delay_s), "s", 2)));
    }
    for (QWidget *control :
        std::initializer_list<QWidget *>{m_sideChannel, m_distance, m_distanceUncertainty, m_delay})
        control->setEnabled(mayAdd);
    m_arrival->setEnabled(isSensor);
    m_removeSensor->setEnabled(typed && isSensor);
}

void ShockPage::showResults()
{
    showShots();
    showSensors();
    showDiagram();
    showArrival();
    showTables();
    showSensitivity();
}

void ShockPage::showDiagram()
{
    const ShockConditions *shot = shownShot();
    m_diagram->setContent(shot && shot->diagram ? tubeDiagramCurves(*shot) : nothingYet());
}

void ShockPage::showArrival()
{
    const Channel *channel = shownChannel();
    const ShockConditions *shot = shownShot();
    m_side->setVisible(channel != nullptr);
    if (channel == nullptr || shot == nullptr) {
        m_side->setContent(nothingYet());
        m_side->removeLine(kArrival);
        return;
    }
    const auto list = sensors();
    const bool isSensor = shownSensor() < list.size();
    EnvelopeStore &envelopes = session().envelopes();
    envelopes.want(wantedRecords(results().captures->set, *channel));
    const double distance_m = isSensor ? list[shownSensor()].distanceToEndWall_m : 0.0;
    PlotContent content = arrivalCurves(
        *channel, *shot, distance_m, [&](const Channel &record) { return envelopes.find(record); });
    content.growing = envelopes.isBusy();
    m_side->setContent(content);
    const QString view = QStringLiteral("%1 %2").arg(shot->shot).arg(m_sensor->currentIndex());
    if (view != m_fittedView)
        m_side->fit();
    m_fittedView = view;
    const auto arrival_s = isSensor ? usedArrival_s(*shot, list[shownSensor()]) : std::nullopt;
    if (m_dragging)
        return;
    if (arrival_s)
        m_side->setLine(kArrival, tr("arrival"), *arrival_s);
    else
        m_side->removeLine(kArrival);
}

void ShockPage::showTables()
{
    const auto show = [](ValueTable *table, const ShownTable &values) {
        table->setValues(values.headers, values.rows);
    };
    const ShockConditionsSet none;
    const ShockConditionsSet &shock = results().shock ? *results().shock : none;
    const ShockConditions *shot = shownShot();
    show(m_states, results().shock ? stateTable(shock) : ShownTable{{tr("Quantity")}, {}});
    show(m_measured, measuredTable(shock));
    show(m_arrivals, arrivalTable(shock));
    show(m_uncertainty, uncertaintyTable(shock, results().monteCarlo.get()));
    show(m_budget, budgetTable(shot ? *shot : ShockConditions()));
    show(m_peaks, followedPeakTable(shock));
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
