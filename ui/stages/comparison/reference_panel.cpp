// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/comparison/reference_panel.h"

#include "ui/stages/comparison/source_panel.h"
#include "ui/stages/frame/checked_change.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/needed_numbers.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/recipe_change.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/text/level_text.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <array>

namespace dyncal {

namespace {

constexpr std::array<const char *, 4> kAgainst{
    "computed-step", "transducer", "static-sensitivity", "unit-step"};
constexpr double kLeast = 1e-30; ///< of what must be above 0
constexpr double kMost = 1e12; ///< as typed numbers elsewhere
constexpr double kLongestDelay_s = 1.0;

const ShownUnit kKilohertz{QStringLiteral("kHz"), 1e3};

/// The channel that a recipe means; null where a recording has none.
const Channel *channelOf(const Shot &shot, const ComparisonSettings &settings)
{
    return settings.channel.empty() ? shot.channelWithRole(ChannelRole::Reference)
                                    : shot.channelCalled(settings.channel);
}

/// With the roles that the recipe gives them, as far as they were read.
const CaptureSet &capturesOf(const Session &session)
{
    const auto &prepared = session.results().captures;
    return prepared ? prepared->set : *session.state().captures;
}

const Channel *firstChannel(const Session &session)
{
    const CaptureSet &set = capturesOf(session);
    return set.shots.empty() ? nullptr : channelOf(set.shots.front(), session.recipe().comparison);
}

/// A channel in Pa has a sensitivity of 1.
std::string unitFor(const Channel &channel)
{
    return channel.unit == "Pa" ? "1" : channel.unit + "/Pa";
}

std::optional<std::vector<double>> numbersOf(const std::optional<ReferenceModel> &model)
{
    if (!model)
        return std::nullopt;
    return std::vector{model->sensitivity, model->u_sensitivity, model->f0_Hz, model->u_f0_Hz,
        model->zeta, model->u_zeta};
}

} // namespace

ReferencePanel::ReferencePanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_form(form)
{
}

void ReferencePanel::buildUse()
{
    m_enabled = new WrappedCheckBox(tr("Compare with a reference transducer"));
    m_enabled->setObjectName("comparisonEnabled");
    m_form.addWide(m_enabled);
    connect(m_enabled, &QCheckBox::clicked, this, &ReferencePanel::setEnabled);
    m_against = m_form.addChoice(tr("S(f) is stated against"), "responseReference",
        {tr("the computed pressure step"), tr("the reference transducer"),
            tr("the static sensitivity"), tr("a step of 1")});
    connect(m_against, &QComboBox::activated, this, &ReferencePanel::setAgainst);
    m_channel = m_form.addChoice(tr("Channel"), "referenceChannel", {});
    connect(m_channel, &QComboBox::activated, this, [this] {
        const std::string name = m_channel->currentData().toString().toStdString();
        changeRecipe(m_session, tr("Choose the channel of the reference"),
            [&](Recipe &r) { r.comparison.channel = name; });
    });
    m_unit = m_form.add(tr("Unit of its sensitivity"), "referenceUnit", new QLineEdit);
    connect(m_unit, &QLineEdit::editingFinished, this, &ReferencePanel::setUnit);
    m_form.follow([this](const Recipe &recipe) { showUse(recipe); });
}

void ReferencePanel::showUse(const Recipe &recipe)
{
    m_enabled->setChecked(recipe.comparison.enabled);
    const auto at = std::ranges::find(kAgainst, recipe.response.reference);
    m_against->setCurrentIndex(static_cast<int>(at - kAgainst.begin()));
    showChannels(recipe);
    showUnit(recipe);
}

QString ReferencePanel::obstacle() const
{
    const ComparisonSettings &settings = m_session.recipe().comparison;
    if (settings.source.empty() && !settings.model)
        return tr(
            "First say what the reference transducer is: choose the file with its sensitivity, or type all values of the second-order sensor.");
    const auto &shots = capturesOf(m_session).shots;
    const auto without
        = std::ranges::find_if(shots, [&](const Shot &shot) { return !channelOf(shot, settings); });
    if (without != shots.end())
        return tr(
            "Shot %1 has no channel of a reference transducer; give one the role %2 on the page Captures, or choose the channel.")
            .arg(without - shots.begin() + 1)
            .arg(roleText(ChannelRole::Reference));
    return {};
}

void ReferencePanel::setEnabled(bool on)
{
    const QString why = on ? obstacle() : QString();
    showRefusal(m_enabled, why);
    if (!why.isEmpty()) {
        m_enabled->setChecked(false);
        return;
    }
    changeRecipe(m_session,
        on ? tr("Compare with a reference transducer") : tr("Compare with nothing"),
        [&](Recipe &r) {
            r.comparison.enabled = on;
            if (!on && r.response.isByTransducer())
                r.response.reference = ResponseSettings().reference;
        });
}

void ReferencePanel::setAgainst(int choice)
{
    const std::string reference = kAgainst[static_cast<std::size_t>(choice)];
    const bool isPossible = reference != "transducer" || m_session.recipe().comparison.enabled;
    showRefusal(m_against,
        isPossible
            ? QString()
            : tr(
                "S(f) can be stated against the reference transducer once the comparison is switched on."));
    if (isPossible)
        changeRecipe(m_session, tr("Change what S(f) is stated against"),
            [&](Recipe &r) { r.response.reference = reference; });
    else
        showUse(m_session.recipe());
}

void ReferencePanel::showChannels(const Recipe &recipe)
{
    const QSignalBlocker quiet(m_channel);
    const auto &shots = capturesOf(m_session).shots;
    const QString chosen = rawText(recipe.comparison.channel);
    m_channel->clear();
    m_channel->addItem(tr("by its role: %1").arg(roleText(ChannelRole::Reference)), QString());
    if (!shots.empty())
        for (const Channel &channel : shots.front().channels)
            if (channel.role != ChannelRole::Dut)
                m_channel->addItem(withoutMnemonic(shownText(channel.name)), rawText(channel.name));
    if (m_channel->findData(chosen) < 0)
        m_channel->addItem(withoutMnemonic(shownText(chosen)), chosen);
    m_channel->setCurrentIndex(m_channel->findData(chosen));
}

/// The unit of its records decides: another one would only be refused by the run.
void ReferencePanel::setUnit()
{
    if (!m_unit->isModified())
        return;
    m_unit->setModified(false);
    const std::string unit = m_unit->text().trimmed().toStdString();
    const Channel *channel = firstChannel(m_session);
    QString fault;
    if (channel && unit != unitFor(*channel))
        fault = tr(
            "Its channel is recorded in %1, so that its sensitivity is in %2; change the unit of the channel in the import settings, where that is wrong.")
                    .arg(shownText(channel->unit), shownText(unitFor(*channel)));
    showRefusal(m_unit, fault);
    if (fault.isEmpty())
        changeIfAllowed(m_session, m_unit, tr("Change the unit of the reference"),
            [&](Recipe &r) { r.comparison.unit = unit; });
    showUnit(m_session.recipe());
}

void ReferencePanel::showUnit(const Recipe &recipe)
{
    if (!m_unit->hasFocus() || !m_unit->isModified())
        m_unit->setText(rawText(recipe.comparison.unit));
}

void ReferencePanel::buildModel()
{
    m_form.addSection(tr("Or a second-order sensor, all u at k = 1"));
    m_model = new NeededNumbers(m_form, this);
    const auto add
        = [&](const QString &label, const char *name, const ShownUnit &unit, double least) {
              return m_model->add(label, name, new OptionalEdit(unit, least, kMost));
          };
    m_sensitivity = add(tr("Sensitivity"), "referenceSensitivity", {}, kLeast);
    m_u_sensitivity = add(tr("u of the sensitivity"), "referenceSensitivityU", {}, 0.0);
    add(tr("Resonance f₀"), "referenceF0", kKilohertz, kLeast);
    add(tr("u of f₀"), "referenceF0U", kKilohertz, 0.0);
    add(tr("Damping ζ"), "referenceZeta", {}, kLeast);
    add(tr("u of ζ"), "referenceZetaU", {}, 0.0);
    m_model->addNote("referenceModelNote");
    m_dropModel = new WrappedButton(tr("Use no second-order sensor"));
    m_dropModel->setObjectName("referenceModelRemove");
    m_form.addWide(m_dropModel);
    connect(m_model, &NeededNumbers::completed, this, &ReferencePanel::takeModel);
    connect(m_dropModel, &QPushButton::clicked, this, [this] {
        m_model->forget();
        if (m_session.recipe().comparison.model)
            changeRecipe(m_session, tr("Use no second-order sensor"), dropReference);
    });
    connect(&m_session, &Session::capturesChanged, m_model, &NeededNumbers::forget);
    m_form.follow([this](const Recipe &recipe) { showModel(recipe); });
}

void ReferencePanel::takeModel(const std::vector<double> &v, QWidget *field)
{
    changeIfAllowed(m_session, field, tr("Describe the reference transducer"), [&](Recipe &r) {
        useModel(r, {v[0], v[1], v[2], v[3], v[4], v[5]});
    });
}

void ReferencePanel::showModel(const Recipe &recipe)
{
    const ShownUnit unit{
        recipe.comparison.unit == "1" ? QString() : shownText(recipe.comparison.unit), 1.0};
    m_sensitivity->setUnit(unit);
    m_u_sensitivity->setUnit(unit);
    m_model->show(numbersOf(recipe.comparison.model));
    m_dropModel->setEnabled(m_model->typed() > 0);
}

void ReferencePanel::buildMounting()
{
    using Edit = std::function<void(ComparisonSettings &, const std::optional<double> &)>;
    const auto add = [&](const QString &label, const char *name, OptionalEdit *control,
                         const QString &empty, const Edit &edit) {
        m_form.add(label, name, control);
        control->setEmptyText(empty);
        connect(
            control, &OptionalEdit::edited, this, [=, this](const std::optional<double> &value) {
                changeIfAllowed(m_session, control, tr("Change %1").arg(label),
                    [&](Recipe &r) { edit(r.comparison, value); });
            });
        return control;
    };
    m_form.addSection(tr("Its place"));
    auto *delay = add(tr("Delay behind the sensor"), "referenceDelay",
        new OptionalEdit(kMicroseconds, -kLongestDelay_s, kLongestDelay_s), tr("none"),
        [](auto &s, const auto &value) { s.delay_s = value.value_or(0.0); });
    auto *u_delay = add(tr("u of the delay"), "referenceDelayU",
        new OptionalEdit(kMicroseconds, 0.0, kLongestDelay_s), tr("within ±0.5 µs"),
        [](auto &s, const auto &value) { s.u_delay_s = value; });
    auto *correlation = add(tr("Correlation with the step"), "referenceCorrelation",
        new OptionalEdit({}, -1.0, 1.0), tr("none"),
        [](auto &s, const auto &value) { s.correlationWithStep = value.value_or(0.0); });
    m_form.follow([=](const Recipe &recipe) {
        const auto unlessNone
            = [](double value) { return value == 0.0 ? std::nullopt : std::optional(value); };
        delay->set(unlessNone(recipe.comparison.delay_s));
        u_delay->set(recipe.comparison.u_delay_s);
        correlation->set(unlessNone(recipe.comparison.correlationWithStep));
    });
}

} // namespace dyncal
