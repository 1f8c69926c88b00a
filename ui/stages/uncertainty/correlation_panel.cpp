// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/correlation_panel.h"

#include "core/project/correlated_quantities.h"
#include "ui/stages/frame/entry_edits.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"
#include "ui/text/uncertainty_words.h"

#include <QComboBox>

namespace dyncal {

QString correlationText(const CorrelationEntry &entry)
{
    return CorrelationPanel::tr("%1 with %2: r = %3")
        .arg(inputWords(entry.quantity).name, inputWords(entry.with).name,
            shownNumber(entry.coefficient, 3));
}

CorrelationPanel::CorrelationPanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
{
    form.addSection(tr("Inputs that err together"));
    m_list = new EntryList(form, "correlation", tr("Correlations of the budget"), this);
    m_quantity = addQuantities(form, tr("Input"), "correlationOf");
    m_with = addQuantities(form, tr("Goes along with"), "correlationWith");
    m_with->setCurrentIndex(1);
    m_coefficient = form.add(tr("Correlation r"), "correlationR", new OptionalEdit({}, -1.0, 1.0));
    m_coefficient->setEmptyText(tr("needed"));
    connect(m_coefficient, &OptionalEdit::edited, this, [this](const std::optional<double> &r) {
        m_typed = r;
        allowWhatIsComplete();
    });
    m_list->addButtons(form);
    connect(m_list, &EntryList::selected, this, &CorrelationPanel::showEntry);
    const auto entries = [](Recipe &recipe) -> std::vector<CorrelationEntry> & {
        return recipe.uncertainty.correlations;
    };
    connectEdits<CorrelationEntry>(session, *m_list,
        {entries, [this] { return typed(); }, tr("Add a correlation"), tr("Change a correlation"),
            tr("Remove a correlation")});
    form.follow([this](const Recipe &recipe) { showRecipe(recipe); });
    allowWhatIsComplete();
}

QComboBox *CorrelationPanel::addQuantities(
    InspectorForm &form, const QString &label, const QString &name)
{
    QComboBox *box = form.addChoice(label, name, {});
    for (const char *quantity : kCorrelatedQuantities)
        box->addItem(inputWords(quantity).name, QString::fromLatin1(quantity));
    connect(box, &QComboBox::activated, this, &CorrelationPanel::allowWhatIsComplete);
    return box;
}

std::size_t CorrelationPanel::selected() const
{
    return static_cast<std::size_t>(m_list->row());
}

void CorrelationPanel::showRecipe(const Recipe &recipe)
{
    QStringList entries;
    for (const CorrelationEntry &entry : recipe.uncertainty.correlations)
        entries.append(correlationText(entry));
    m_list->show(entries);
    allowWhatIsComplete();
}

void CorrelationPanel::showEntry()
{
    const auto &all = m_session.recipe().uncertainty.correlations;
    if (m_list->row() < 0 || selected() >= all.size())
        return;
    const CorrelationEntry &entry = all[selected()];
    m_quantity->setCurrentIndex(m_quantity->findData(rawText(entry.quantity)));
    m_with->setCurrentIndex(m_with->findData(rawText(entry.with)));
    m_typed = entry.coefficient;
    m_coefficient->set(m_typed);
    allowWhatIsComplete();
}

CorrelationEntry CorrelationPanel::typed() const
{
    return {m_quantity->currentData().toString().toStdString(),
        m_with->currentData().toString().toStdString(), m_typed.value_or(0.0)};
}

/// Of a velocity there is one for each shot, which may go along with each other.
void CorrelationPanel::allowWhatIsComplete()
{
    const CorrelationEntry entry = typed();
    const bool isPair = entry.quantity != entry.with || entry.quantity == "velocity_m_s";
    m_list->allow(m_typed.has_value() && isPair);
}

} // namespace dyncal
