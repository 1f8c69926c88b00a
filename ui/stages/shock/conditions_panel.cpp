// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock/conditions_panel.h"

#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/recipe_change.h"
#include "ui/stages/shock/gas_edit.h"

#include <QCheckBox>

#include <cmath>

namespace dyncal {

namespace {

const ShownUnit kKilopascal{"kPa", 1e3};
const ShownUnit kKelvin{"K", 1.0};
const ShownUnit kNanoseconds{"ns", 1e-9};

std::optional<double> recorded(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Of a time that nobody stated nothing stands in its field.
std::optional<double> stated(double time_s)
{
    return time_s > 0.0 ? std::optional(time_s) : std::nullopt;
}

} // namespace

OptionalEdit *addShockNumber(Session &session, InspectorForm &form, const QString &label,
    const QString &objectName, OptionalEdit *control, std::optional<double> ShockSettings::*member)
{
    form.add(label, objectName, control);
    QObject::connect(control, &OptionalEdit::edited, control,
        [&session, label, member](const std::optional<double> &value) {
            changeRecipe(session, ConditionsPanel::tr("Change %1").arg(label),
                [&](Recipe &r) { r.shock.*member = value; });
        });
    return control;
}

ConditionsPanel::ConditionsPanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_form(form)
{
    buildGasControls();
    buildTubeControls();
}

void ConditionsPanel::buildGasControls()
{
    m_form.addSection(tr("Gas before the shot"));
    m_p1 = addShockNumber(m_session, m_form, tr("p1, absolute"), "p1",
        new OptionalEdit(kKilopascal, 1e-3, 1e12), &ShockSettings::p1_Pa);
    m_T1 = addShockNumber(m_session, m_form, tr("T1"), "T1", new OptionalEdit(kKelvin, 1.0, 5000.0),
        &ShockSettings::T1_K);
    m_T4 = addShockNumber(m_session, m_form, tr("T4 (driver)"), "T4",
        new OptionalEdit(kKelvin, 1.0, 5000.0), &ShockSettings::T4_K);
    m_driven = new GasEdit(m_form, tr("Driven gas"), "driven", this);
    connect(m_driven, &GasEdit::edited, this, [this](const GasSettings &gas) {
        changeRecipe(
            m_session, tr("Change the driven gas"), [&](Recipe &r) { r.shock.drivenGas = gas; });
    });
    m_variable = new WrappedCheckBox(tr("Heat capacity varies with temperature"));
    m_variable->setObjectName("variableHeatCapacity");
    m_form.addWide(m_variable);
    connect(m_variable, &QCheckBox::clicked, this, [this](bool on) {
        changeRecipe(m_session, tr("Change the heat capacity"), [&](Recipe &r) {
            r.shock.drivenGas.heatCapacity = on ? kVariableHeatCapacity : kConstantHeatCapacity;
        });
    });
    m_humidity = addShockNumber(m_session, m_form, tr("Relative humidity"), "humidity",
        new OptionalEdit({"%", 0.01}, 0.0, 1.0), &ShockSettings::relativeHumidity);
    m_dioxide = m_form.add(tr("CO₂"), "carbonDioxide", new OptionalEdit({"ppm", 1e-6}, 0.0, 0.01));
    connect(m_dioxide, &OptionalEdit::edited, this, [this](const std::optional<double> &share) {
        changeRecipe(m_session, tr("Change the CO₂ of the air"), [&](Recipe &r) {
            r.shock.carbonDioxide = share.value_or(ShockSettings().carbonDioxide);
        });
    });
    m_driver = new GasEdit(m_form, tr("Driver gas"), "driver", this);
    connect(m_driver, &GasEdit::edited, this, [this](const GasSettings &gas) {
        changeRecipe(
            m_session, tr("Change the driver gas"), [&](Recipe &r) { r.shock.driverGas = gas; });
    });
}

void ConditionsPanel::buildTubeControls()
{
    m_form.addSection(tr("Tube"));
    m_drivenLength = addShockNumber(m_session, m_form, tr("Driven section"), "drivenLength",
        new OptionalEdit(kMetre, 1e-3, 1000.0), &ShockSettings::drivenLength_m);
    m_driverLength = addShockNumber(m_session, m_form, tr("Driver section"), "driverLength",
        new OptionalEdit(kMetre, 1e-3, 1000.0), &ShockSettings::driverLength_m);
    m_diameter = addShockNumber(m_session, m_form, tr("Inner diameter"), "innerDiameter",
        new OptionalEdit(kMillimetre, 1e-4, 100.0), &ShockSettings::innerDiameter_m);
    addAttenuation();
    m_front = addTime(tr("Duration of the front"), "frontDuration", kNanoseconds,
        tr("Change the duration of the front"), &ShockSettings::frontDuration_s);
    m_front->setEmptyText(tr("not stated"));
    m_u_front = addTime(tr("u (duration of the front)"), "frontDurationU", kNanoseconds,
        tr("Change the duration of the front"), &ShockSettings::u_frontDuration_s);
    m_guard = addTime(tr("Guard before the plateau's end"), "plateauGuard", kMicroseconds,
        tr("Change the guard"), &ShockSettings::plateauGuard_s);
    m_guard->setEmptyText(tr("none"));
}

OptionalEdit *ConditionsPanel::addTime(const QString &label, const QString &objectName,
    const ShownUnit &unit, const QString &change, double ShockSettings::*member)
{
    auto *edit = m_form.add(label, objectName, new OptionalEdit(unit, 0.0, 1.0));
    connect(edit, &OptionalEdit::edited, this, [=, this](const std::optional<double> &typed_s) {
        changeRecipe(
            m_session, change, [&](Recipe &r) { r.shock.*member = typed_s.value_or(0.0); });
    });
    return edit;
}

void ConditionsPanel::addAttenuation()
{
    const ShownUnit percent{"%/m", 0.01};
    const auto add = [&](const QString &label, const QString &name, double Interval::*end) {
        auto *edit = m_form.add(label, name, new OptionalEdit(percent, -0.5, 0.5));
        connect(edit, &OptionalEdit::edited, this, [=, this](const std::optional<double> &typed) {
            Interval range = m_session.recipe().shock.attenuation_per_m;
            range.*end = typed.value_or(kUsualAttenuation_per_m.*end);
            if (range.begin < range.end)
                changeRecipe(m_session, tr("Change the range of the attenuation"),
                    [&](Recipe &r) { r.shock.attenuation_per_m = range; });
            else
                edit->set(m_session.recipe().shock.attenuation_per_m.*end);
        });
        return edit;
    };
    m_leastAttenuation = add(tr("Attenuation, at least"), "leastAttenuation", &Interval::begin);
    m_largestAttenuation = add(tr("Attenuation, at most"), "largestAttenuation", &Interval::end);
}

void ConditionsPanel::show(const Shot *recording, const ShockConditions *shot)
{
    const ShockSettings &settings = m_session.recipe().shock;
    const CaptureSet &set = *m_session.state().captures;
    const Environment around = recording ? recording->environment : Environment();
    m_leastAttenuation->set(settings.attenuation_per_m.begin);
    m_largestAttenuation->set(settings.attenuation_per_m.end);
    m_p1->set(settings.p1_Pa, recorded(around.p1_Pa));
    m_T1->set(settings.T1_K, recorded(around.T1_K));
    m_T4->set(settings.T4_K, recorded(around.T4_K));
    m_humidity->set(settings.relativeHumidity, recorded(around.relativeHumidity));
    m_dioxide->set(settings.carbonDioxide);
    const GasSettings &gas = settings.drivenGas;
    const bool moist = gas.substance == "humid-air";
    const bool mayBeMoist = moist || gas.substance == kAutoGas;
    m_humidity->setEnabled(mayBeMoist);
    m_dioxide->setEnabled(mayBeMoist);
    m_variable->setChecked(gas.heatCapacity == kVariableHeatCapacity);
    m_variable->setEnabled(!moist && gas.substance != "custom");
    m_driven->set(gas, shot ? shot->drivenGas : std::nullopt);
    m_driver->set(settings.driverGas, shot ? shot->driverGas : std::nullopt);
    m_drivenLength->set(settings.drivenLength_m, set.tubeNumber("driven_length_m"));
    m_driverLength->set(settings.driverLength_m, set.tubeNumber("driver_length_m"));
    m_diameter->set(settings.innerDiameter_m, set.tubeNumber("inner_diameter_m"));
    m_front->set(stated(settings.frontDuration_s));
    m_u_front->set(stated(settings.u_frontDuration_s));
    m_guard->set(stated(settings.plateauGuard_s));
}

} // namespace dyncal
