// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/stated_panel.h"

#include "core/shock/shock_uncertainty.h"
#include "ui/stages/frame/calendar_button.h"
#include "ui/stages/frame/entry_edits.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"
#include "ui/text/uncertainty_words.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>

namespace dyncal {

namespace {

constexpr double kLargestStatedU = 1e12; ///< as typed numbers elsewhere
constexpr double kLeastDof = 1e-30; ///< above 0
constexpr double kMostDof = 1e12;
constexpr int kUDigits = 4;

ShownUnit unitOfStated(const std::string &quantity, const std::optional<double> &u)
{
    const InputWords words = inputWords(quantity);
    if (words.in == CountedIn::Value)
        return {QStringLiteral("%"), 0.01};
    if (words.unit.isEmpty() || u.value_or(0.0) <= 0.0)
        return {words.unit, 1.0};
    const PrefixedUnit prefixed = prefixedUnit(*u, words.unit);
    return {prefixed.unit.trimmed(), prefixed.factor};
}

void choose(QComboBox &box, const std::string &key)
{
    box.setCurrentIndex(box.findData(rawText(key)));
}

std::string keyOf(const QComboBox &box)
{
    return box.currentData().toString().toStdString();
}

} // namespace

QString statedText(const BudgetEntry &entry)
{
    const ShownUnit unit = unitOfStated(entry.quantity, entry.u);
    const QString u = shownNumber(entry.u / unit.si, kUDigits);
    QString text = StatedPanel::tr("%1: u = %2")
                       .arg(inputWords(entry.quantity).name,
                           unit.text.isEmpty() ? u : u + QLatin1Char(' ') + unit.text);
    if (!entry.certificate.empty())
        text = StatedPanel::tr("%1, certificate %2").arg(text, shownText(entry.certificate));
    if (!entry.due.empty())
        text = StatedPanel::tr("%1, due %2").arg(text, shownText(entry.due));
    return text;
}

StatedPanel::StatedPanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
{
    form.addSection(tr("Stated u and their references"));
    m_list = new EntryList(form, "stated", tr("Stated u of the budget"), this);
    buildFields(form);
    buildReference(form);
    m_list->addButtons(form);
    connect(m_list, &EntryList::selected, this, &StatedPanel::showEntry);
    const auto entries
        = [](Recipe &recipe) -> std::vector<BudgetEntry> & { return recipe.uncertainty.budget; };
    connectEdits<BudgetEntry>(session, *m_list,
        {entries, [this] { return typed(); }, tr("Add a stated u"), tr("Change a stated u"),
            tr("Remove a stated u")});
    form.follow([this](const Recipe &recipe) { showRecipe(recipe); });
    chooseQuantity();
}

void StatedPanel::buildFields(InspectorForm &form)
{
    m_quantity = form.addChoice(tr("Input"), "statedOf", {});
    m_quantity->setToolTip(tr("The input of the budget that this u is of"));
    for (const std::string &quantity : statedQuantities())
        m_quantity->addItem(inputWords(quantity).name, rawText(quantity));
    connect(m_quantity, &QComboBox::activated, this, &StatedPanel::chooseQuantity);
    m_uField = form.add(
        tr("Standard uncertainty u"), "statedU", new OptionalEdit({}, 0.0, kLargestStatedU));
    m_uField->setEmptyText(tr("needed"));
    connect(m_uField, &OptionalEdit::edited, this, [this](const std::optional<double> &u) {
        m_u = u;
        allowWhatIsComplete();
    });
    m_distribution = form.addChoice(tr("Distribution"), "statedDistribution", {});
    m_distribution->setToolTip(tr("The shape that the Monte Carlo draws from"));
    using enum Distribution;
    for (const Distribution one : {Normal, Rectangular, Triangular, UShaped})
        m_distribution->addItem(distributionText(one), QString::fromLatin1(distributionName(one)));
    m_dofField = form.add(
        tr("Degrees of freedom"), "statedDof", new OptionalEdit({}, kLeastDof, kMostDof));
    m_dofField->setEmptyText(QStringLiteral("∞"));
    connect(m_dofField, &OptionalEdit::edited, this,
        [this](const std::optional<double> &dof) { m_dof = dof; });
}

void StatedPanel::buildReference(InspectorForm &form)
{
    m_certificate
        = form.add(tr("Certificate of the reference"), "statedCertificate", new QLineEdit);
    m_certificate->setToolTip(
        tr("Number of the certificate that this u is taken from; it makes the result traceable"));
    m_due = new QLineEdit;
    m_due->setObjectName("statedDue");
    m_due->setAccessibleName(tr("Due date of the reference"));
    m_due->setToolTip(tr("The day until which the reference's calibration holds"));
    setWholePlaceholder(*m_due, tr("YYYY-MM-DD"));
    auto *row = rowWithCalendar(*m_due, "calendar_statedDue");
    row->setContentsMargins(0, 0, 0, 0);
    auto *box = new QWidget;
    box->setLayout(row);
    box->setFocusProxy(m_due);
    form.add(m_due->accessibleName(), "statedDueRow", box);
}

/// A u that was typed for another input is none of this one.
void StatedPanel::chooseQuantity()
{
    m_u.reset();
    showU();
}

void StatedPanel::showU()
{
    m_uField->setUnit(unitOfStated(keyOf(*m_quantity), m_u));
    m_uField->set(m_u);
    allowWhatIsComplete();
}

void StatedPanel::showRecipe(const Recipe &recipe)
{
    QStringList entries;
    for (const BudgetEntry &entry : recipe.uncertainty.budget)
        entries.append(statedText(entry));
    m_list->show(entries);
    if (m_shown != recipe.uncertainty.budget) { // an undo takes back what stands in the fields, too
        m_shown = recipe.uncertainty.budget;
        showEntry();
    }
}

void StatedPanel::showEntry()
{
    const auto &budget = m_session.recipe().uncertainty.budget;
    const auto row = static_cast<std::size_t>(m_list->row());
    if (m_list->row() < 0 || row >= budget.size()) {
        allowWhatIsComplete();
        return;
    }
    const BudgetEntry &entry = budget[row];
    choose(*m_quantity, entry.quantity);
    choose(*m_distribution, entry.distribution);
    m_dof = entry.dof;
    m_dofField->set(m_dof);
    m_certificate->setText(rawText(entry.certificate));
    m_due->setText(rawText(entry.due));
    m_u = entry.u;
    showU();
}

void StatedPanel::allowWhatIsComplete()
{
    m_list->allow(m_u.has_value() && m_quantity->currentIndex() >= 0);
}

BudgetEntry StatedPanel::typed() const
{
    return {keyOf(*m_quantity), m_u.value_or(0.0), keyOf(*m_distribution), m_dof,
        m_certificate->text().trimmed().toStdString(), m_due->text().trimmed().toStdString()};
}

} // namespace dyncal
