// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock/arrival_panel.h"

#include "ui/plot/curves/shock_curves.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/recipe_change.h"
#include "ui/stages/frame/stage_page.h"
#include "ui/stages/shock/sensor_arrivals.h"
#include "ui/stages/shock/shock_on_show.h"
#include "ui/text/level_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace dyncal {

namespace {

const QString kArrival = QStringLiteral("arrival");
constexpr double kLongest_s = 1e4;
constexpr int kSensorLength = 18; ///< characters: a channel and its place

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
            words << rawText(channel.name);
    }
    words.removeDuplicates();
    return words;
}

QString channelText(const QString &word)
{
    const ChannelRole role = channelRoleFromName(word.toStdString());
    return role == ChannelRole::Other ? shownText(word) : roleText(role);
}

/// The last sighting of a channel, or of the DUT, that the velocity was computed from; null = none.
const Sighting *sightingOf(const ShockConditions &shot, const std::string &channel, bool ofDut)
{
    const Sighting *last = nullptr;
    for (const Sighting &seen : shot.sightings)
        if (seen.channel == channel || (ofDut && seen.isDut))
            last = &seen;
    return last;
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

ArrivalPanel::ArrivalPanel(
    Session &session, InspectorForm &form, PlotWidget &record, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_record(record)
{
    build(&form);
    connect(&record, &PlotWidget::lineMoved, this,
        [this](const QString &, double time_s, bool finished) { moveArrival(time_s, finished); });
}

void ArrivalPanel::build(InspectorForm *form)
{
    form->addSection(tr("Arrival of the shock"));
    m_sensor = form->addChoice(tr("Sensor"), "arrivalSensor", {});
    m_sensor->setMinimumContentsLength(kSensorLength);
    connect(m_sensor, &QComboBox::activated, this, [this] {
        showFields();
        showRecord();
    });
    m_channel = form->addChoice(tr("Channel"), "arrivalChannel", {});
    connect(m_channel, &QComboBox::activated, this, [this] {
        const std::string word = m_channel->currentData().toString().toStdString();
        editSensor(tr("Change the arrival sensor"), [&](ArrivalSensor &s) { s.channel = word; });
    });
    m_distance = form->add(
        tr("Distance to end wall"), "arrivalDistance", new OptionalEdit(kMetre, 1e-4, 100.0));
    connect(m_distance, &OptionalEdit::edited, this, &ArrivalPanel::setDistance);
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
    m_delayUncertainty = form->addReadout(tr("u (delay)"), "arrivalDelayUncertainty");
    m_delay = form->add(tr("Delay of the sensor"), "arrivalDelay",
        new OptionalEdit(kMicroseconds, -kLongest_s, kLongest_s));
    m_delay->setEmptyText(tr("unknown"));
    connect(m_delay, &OptionalEdit::edited, this, [this](const std::optional<double> &delay_s) {
        editSensor(tr("Change the delay"), [&](ArrivalSensor &s) { s.delay_s = delay_s; });
    });
    m_addSensor = new WrappedButton(tr("Add a sensor"));
    m_addSensor->setObjectName("addArrivalSensor");
    m_removeSensor = new WrappedButton(tr("Remove this sensor"));
    m_removeSensor->setObjectName("removeArrivalSensor");
    form->addWide(m_addSensor);
    form->addWide(m_removeSensor);
    connect(m_addSensor, &QPushButton::clicked, this, &ArrivalPanel::addSensor);
    connect(m_removeSensor, &QPushButton::clicked, this, &ArrivalPanel::removeSensor);
}

const ShockConditions *ArrivalPanel::shownShot() const
{
    const ShockConditionsSet *shock = shockOnShow(m_session);
    return shock ? shock->ofShot(m_shot) : nullptr;
}

std::vector<ArrivalSensor> ArrivalPanel::sensors() const
{
    const CaptureSet &set = *m_session.state().captures;
    const auto &list = m_session.recipe().shock.arrivalSensors;
    return set.shots.empty() ? list
        : list.empty()       ? arrivalSensors(set, 1, m_session.recipe().shock)
                             : list;
}

std::size_t ArrivalPanel::shownSensor() const
{
    return static_cast<std::size_t>(std::max(m_sensor->currentIndex(), 0));
}

const Channel *ArrivalPanel::shownChannel() const
{
    const auto &captures = m_session.resultsOnShow().captures;
    const auto at = static_cast<std::size_t>(std::max<Index>(m_shot - 1, 0));
    if (!captures || at >= captures->set.shots.size())
        return nullptr;
    const Shot &shot = captures->set.shots[at];
    const auto list = sensors();
    return shownSensor() < list.size() ? shot.channelCalled(list[shownSensor()].channel)
                                       : shot.channelWithRole(ChannelRole::Dut);
}

void ArrivalPanel::editSensor(
    const QString &label, const std::function<void(ArrivalSensor &)> &edit, const QString &mergeKey)
{
    std::vector<ArrivalSensor> list = sensors();
    if (list.empty())
        list.push_back({channelRoleName(ChannelRole::DrivenSide)});
    edit(list[std::min(shownSensor(), list.size() - 1)]);
    if (std::any_of(list.begin(), list.end(),
            [](const ArrivalSensor &s) { return !(s.distanceToEndWall_m > 0.0); })) {
        showFields(); // a sensor without a distance has no place: nothing is changed
        return;
    }
    changeRecipe(
        m_session, label, [&](Recipe &r) { r.shock.arrivalSensors = list; }, mergeKey);
}

void ArrivalPanel::setDistance(const std::optional<double> &distance_m)
{
    if (!distance_m)
        removeSensor();
    else
        editSensor(tr("Change the arrival sensor"),
            [&](ArrivalSensor &s) { s.distanceToEndWall_m = *distance_m; });
}

void ArrivalPanel::addSensor()
{
    std::vector<ArrivalSensor> list = sensors();
    ArrivalSensor added{channelRoleName(ChannelRole::DrivenSide), 1.0};
    if (!list.empty())
        added = list.back();
    added.arrival_s.reset();
    added.shotArrival_s.clear();
    list.push_back(added);
    changeRecipe(
        m_session, tr("Add an arrival sensor"), [&](Recipe &r) { r.shock.arrivalSensors = list; });
    m_sensor->setCurrentIndex(static_cast<int>(list.size()) - 1);
    showFields();
    showRecord();
}

void ArrivalPanel::removeSensor()
{
    std::vector<ArrivalSensor> list = m_session.recipe().shock.arrivalSensors;
    if (shownSensor() >= list.size())
        return;
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(shownSensor()));
    changeRecipe(m_session, tr("Remove an arrival sensor"),
        [&](Recipe &r) { r.shock.arrivalSensors = list; });
}

void ArrivalPanel::setArrival(const std::optional<double> &arrival_s, const QString &mergeKey)
{
    const std::size_t shots = m_session.state().captures->shots.size();
    const auto at = static_cast<std::size_t>(m_shot - 1);
    if (at >= shots || shownSensor() >= sensors().size())
        return;
    editSensor(
        arrival_s ? tr("Move an arrival") : tr("Find the arrival"),
        [&](ArrivalSensor &sensor) { typeArrival(sensor, m_shot, shots, arrival_s); }, mergeKey);
}

void ArrivalPanel::moveArrival(double time_s, bool finished)
{
    setArrival(time_s, kArrival);
    if (finished)
        m_session.endMerge();
}

void ArrivalPanel::showSensors()
{
    const CaptureSet &set = *m_session.state().captures;
    const auto list = sensors();
    const int chosen = m_sensor->currentIndex();
    m_sensor->clear();
    for (const ArrivalSensor &sensor : list)
        m_sensor->addItem(tr("%1, %2").arg(channelText(rawText(sensor.channel)),
            shownQuantity(sensor.distanceToEndWall_m, "m", 4)));
    m_sensor->addItem(roleText(ChannelRole::Dut));
    m_sensor->setCurrentIndex(std::clamp(chosen, 0, m_sensor->count() - 1));
    m_channel->clear();
    for (const QString &word : channelWords(set))
        m_channel->addItem(channelText(word), word);
    showFields();
}

void ArrivalPanel::showFields()
{
    const auto list = sensors();
    const bool isSensor = shownSensor() < list.size();
    const bool mayAdd = isSensor || list.empty();
    const ArrivalSensor sensor = isSensor ? list[shownSensor()] : ArrivalSensor{};
    const bool typed = !m_session.recipe().shock.arrivalSensors.empty();
    m_channel->setCurrentIndex(std::max(m_channel->findData(rawText(sensor.channel)), 0));
    const auto distance_m = notZero(sensor.distanceToEndWall_m);
    m_distance->set(typed ? distance_m : std::nullopt, distance_m);
    m_distanceUncertainty->set(
        typed ? notZero(sensor.u_distance_m) : std::nullopt, notZero(sensor.u_distance_m));
    m_delay->set(sensor.delay_s);
    const ShockConditions *shot = shownShot();
    const auto arrival_s = typedArrival_s(sensor, m_shot);
    m_arrival->set(arrival_s ? Auto<double>(*arrival_s) : Auto<double>(),
        shot && isSensor ? usedArrival_s(*shot, sensor) : std::nullopt);
    const Sighting *seen = shot ? sightingOf(*shot, sensor.channel, !isSensor) : nullptr;
    m_arrivalUncertainty->setText(seen ? shownQuantity(seen->u_time_s, "s", 2) : "–");
    m_delayUncertainty->setText(seen ? shownQuantity(notZero(seen->u_delay_s), "s", 2) : "–");
    for (QWidget *control :
        std::initializer_list<QWidget *>{m_channel, m_distance, m_distanceUncertainty, m_delay})
        control->setEnabled(mayAdd);
    m_arrival->setEnabled(isSensor);
    m_removeSensor->setEnabled(typed && isSensor);
}

void ArrivalPanel::showRecord()
{
    const Channel *channel = shownChannel();
    const ShockConditions *shot = shownShot();
    m_record.setVisible(channel != nullptr);
    if (channel == nullptr || shot == nullptr) {
        m_record.setContent(StagePage::nothingYet());
        m_record.removeLine(kArrival);
        return;
    }
    const auto list = sensors();
    const bool isSensor = shownSensor() < list.size();
    EnvelopeStore &envelopes = m_session.envelopes();
    envelopes.want(wantedRecords(m_session.resultsOnShow().captures->set, *channel));
    const double distance_m = isSensor ? list[shownSensor()].distanceToEndWall_m : 0.0;
    PlotContent content = arrivalCurves(
        *channel, *shot, distance_m, [&](const Channel &record) { return envelopes.find(record); });
    content.growing = envelopes.isBusy();
    m_record.setContent(content);
    const QString view = QStringLiteral("%1 %2").arg(shot->shot).arg(m_sensor->currentIndex());
    if (view != m_fittedView)
        m_record.fit();
    m_fittedView = view;
    const auto arrival_s = isSensor ? usedArrival_s(*shot, list[shownSensor()]) : std::nullopt;
    if (m_record.isHandleDragged())
        return;
    if (arrival_s)
        m_record.setLine(kArrival, tr("arrival"), *arrival_s);
    else
        m_record.removeLine(kArrival);
}

} // namespace dyncal
