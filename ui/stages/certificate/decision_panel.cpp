// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate/decision_panel.h"

#include "core/certificate/certificate_conformity.h"
#include "ui/stages/frame/checked_change.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/needed_numbers.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/recipe_change.h"
#include "ui/text/core_text.h"

#include <QComboBox>

namespace dyncal {

namespace {

constexpr int kNoRule = 0; ///< the others are DecisionRule, from 1 on
constexpr double kLeastOfClaim = 1e-9; ///< what must be above 0
constexpr double kMostOfClaim = 1e12; ///< as typed numbers elsewhere
constexpr double kMostRisk_percent = 50.0;

const ShownUnit kPercentOfValue{QStringLiteral("%"), 1.0}; // the recipe has percent too

std::optional<std::vector<double>> claimOf(const std::optional<DecisionSettings> &decision)
{
    if (!decision)
        return std::nullopt;
    return std::vector{decision->within_percent, decision->from_Hz, decision->to_Hz};
}

} // namespace

DecisionPanel::DecisionPanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
{
    build(form);
    connect(m_rule, &QComboBox::activated, this, &DecisionPanel::chooseRule);
    connect(m_claim, &NeededNumbers::completed, this, &DecisionPanel::takeClaim);
    connect(m_risk, &OptionalEdit::edited, this, &DecisionPanel::takeRisk);
    connect(&session, &Session::capturesChanged, m_claim, &NeededNumbers::forget);
    form.follow([this](const Recipe &recipe) { showRecipe(recipe); });
}

void DecisionPanel::build(InspectorForm &form)
{
    form.addSection(tr("Statement of conformity"));
    m_rule = form.addChoice(tr("Decision rule"), "decisionRule",
        {tr("no statement"), tr("simple acceptance"), tr("guard band of U"), tr("largest risk")});
    m_claim = new NeededNumbers(form, this);
    const ShownUnit kilohertz{QStringLiteral("kHz"), 1e3};
    const auto add = [&](const QString &label, const char *name, const ShownUnit &unit) {
        m_edits.push_back(
            m_claim->add(label, name, new OptionalEdit(unit, kLeastOfClaim, kMostOfClaim)));
    };
    add(tr("Magnitude within ±"), "decisionWithin", kPercentOfValue);
    add(tr("From"), "decisionFrom", kilohertz);
    add(tr("To"), "decisionTo", kilohertz);
    m_claim->addNote("decisionNote");
    m_risk = form.add(tr("Largest risk"), "decisionRisk",
        new OptionalEdit(kPercentOfValue, kLeastOfClaim, kMostRisk_percent));
    m_risk->setEmptyText(QString());
    m_outcome = form.addNote("decisionOutcome");
}

void DecisionPanel::chooseRule(int choice)
{
    if (choice == kNoRule)
        m_claim->forget();
    if (m_isMade)
        changeRecipe(m_session, tr("Change the decision rule"), [&](Recipe &r) {
            if (choice == kNoRule)
                r.certificate.decision.reset();
            else
                r.certificate.decision->rule = static_cast<DecisionRule>(choice - 1);
        });
    allowWhatCounts(m_session.recipe().certificate.decision);
}

void DecisionPanel::takeClaim(const std::vector<double> &v, QWidget *field)
{
    changeIfAllowed(m_session, field, tr("Change the claim"), [&](Recipe &r) {
        DecisionSettings decision = r.certificate.decision.value_or(DecisionSettings());
        decision.rule = static_cast<DecisionRule>(m_rule->currentIndex() - 1);
        decision.within_percent = v[0];
        decision.from_Hz = v[1];
        decision.to_Hz = v[2];
        r.certificate.decision = decision;
    });
}

void DecisionPanel::takeRisk(const std::optional<double> &risk_percent)
{
    changeIfAllowed(m_session, m_risk, tr("Change the largest risk"), [&](Recipe &r) {
        r.certificate.decision->maxRisk_percent
            = risk_percent.value_or(DecisionSettings().maxRisk_percent);
    });
    showRecipe(m_session.recipe());
}

void DecisionPanel::showRecipe(const Recipe &recipe)
{
    const std::optional<DecisionSettings> &decision = recipe.certificate.decision;
    const bool wasMade = std::exchange(m_isMade, decision.has_value());
    if (decision)
        m_rule->setCurrentIndex(static_cast<int>(decision->rule) + 1);
    else if (wasMade)
        m_rule->setCurrentIndex(kNoRule);
    m_claim->show(claimOf(decision));
    m_risk->set(decision ? std::optional(decision->maxRisk_percent) : std::nullopt);
    allowWhatCounts(decision);
    showOutcome();
}

void DecisionPanel::allowWhatCounts(const std::optional<DecisionSettings> &decision)
{
    for (OptionalEdit *edit : m_edits)
        edit->setEnabled(m_rule->currentIndex() != kNoRule);
    m_risk->setEnabled(decision && decision->rule == DecisionRule::Risk);
}

void DecisionPanel::showOutcome()
{
    const auto section = conformitySection(m_session.results(), m_session.recipe());
    QStringList lines;
    if (section)
        for (const CertificateField &field : section->fields)
            if (field.id == "verdict" || field.id == "worst")
                lines << tr("%1: %2").arg(translated(field.label), translated(field.value));
    m_outcome->setText(lines.join(QLatin1Char('\n')));
}

} // namespace dyncal
