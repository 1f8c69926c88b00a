// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/capability_panel.h"

#include "core/project/capability_quantities.h"
#include "ui/stages/frame/entry_edits.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/recipe_change.h"
#include "ui/stages/uncertainty/capability_words.h"
#include "ui/text/shown_text.h"

#include <QComboBox>

namespace dyncal {

namespace {

constexpr double kLeastCapability = 1e-30; ///< above 0
constexpr double kMostCapability = 1e9;
constexpr double kMostFrequency_Hz = 1e12;

QString sensitivityUnit(const Session &session)
{
    const auto &response = session.resultsOnShow().response;
    return response ? shownText(response->sensitivityUnit) : QString();
}

} // namespace

CapabilityPanel::CapabilityPanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
{
    form.addSection(tr("Least U of the laboratory (CMC)"));
    m_list = new EntryList(form, "capability", tr("Entries of the CMC"), this);
    buildFields(form);
    m_list->addButtons(form);
    connect(m_list, &EntryList::selected, this, &CapabilityPanel::showEntry);
    const auto entries
        = [](Recipe &recipe) -> std::vector<CapabilityEntry> & { return recipe.uncertainty.cmc; };
    connectEdits<CapabilityEntry>(session, *m_list,
        {entries, [this] { return typed(); }, tr("Add an entry of the CMC"),
            tr("Change an entry of the CMC"), tr("Remove an entry of the CMC")});
    form.follow([this](const Recipe &recipe) { showRecipe(recipe); });
    useUnit();
}

void CapabilityPanel::buildFields(InspectorForm &form)
{
    m_of = form.addChoice(tr("Quantity"), "capabilityOf", {});
    for (const char *of : kCapabilityQuantities)
        m_of->addItem(capabilityName(of), QString::fromLatin1(of));
    m_counted = form.addChoice(
        tr("Counted in"), "capabilityIn", {tr("percent of the value"), tr("the value's unit")});
    m_expanded = form.add(
        tr("Least U"), "capabilityU", new OptionalEdit({}, kLeastCapability, kMostCapability));
    const ShownUnit kilohertz{QStringLiteral("kHz"), 1e3};
    m_from = form.add(
        tr("From"), "capabilityFrom", new OptionalEdit(kilohertz, 0.0, kMostFrequency_Hz));
    m_to = form.add(
        tr("To"), "capabilityTo", new OptionalEdit(kilohertz, kLeastCapability, kMostFrequency_Hz));
    m_expanded->setEmptyText(tr("needed"));
    m_from->setEmptyText(tr("any"));
    m_to->setEmptyText(tr("any"));
    for (QComboBox *box : {m_of, m_counted})
        connect(box, &QComboBox::activated, this, [this] {
            m_typed.expanded = 0.0; // it was of another quantity
            useUnit();
        });
    connect(m_expanded, &OptionalEdit::edited, this, [this](const std::optional<double> &U) {
        m_typed.expanded = U.value_or(0.0);
        allowWhatIsComplete();
    });
    connect(m_from, &OptionalEdit::edited, this,
        [this](const std::optional<double> &f_Hz) { m_typed.from_Hz = f_Hz.value_or(0.0); });
    connect(m_to, &OptionalEdit::edited, this,
        [this](const std::optional<double> &f_Hz) { m_typed.to_Hz = f_Hz; });
}

int CapabilityPanel::row() const
{
    return m_list->row();
}

void CapabilityPanel::showRecipe(const Recipe &recipe)
{
    QStringList entries;
    for (const CapabilityEntry &entry : recipe.uncertainty.cmc)
        entries.append(capabilityText(entry, sensitivityUnit(m_session)));
    m_list->show(entries);
    useUnit();
}

void CapabilityPanel::showEntry()
{
    const auto &cmc = m_session.recipe().uncertainty.cmc;
    if (row() < 0 || selected() >= cmc.size())
        return;
    m_typed = cmc[selected()];
    m_of->setCurrentIndex(m_of->findData(rawText(m_typed.of)));
    m_counted->setCurrentIndex(m_typed.isRelative ? 0 : 1);
    useUnit();
}

void CapabilityPanel::useUnit()
{
    m_typed.of = m_of->currentData().toString().toStdString();
    m_typed.isRelative = m_counted->currentIndex() == 0;
    m_counted->setEnabled(m_typed.of != "phase_rad"); // always an angle
    m_expanded->setUnit(capabilityUnit(m_typed, sensitivityUnit(m_session)));
    m_expanded->set(m_typed.expanded > 0.0 ? std::optional(m_typed.expanded) : std::nullopt);
    const bool hasBand = isOverFrequency(m_typed);
    m_from->set(m_typed.from_Hz > 0.0 ? std::optional(m_typed.from_Hz) : std::nullopt);
    m_to->set(m_typed.to_Hz);
    m_from->setEnabled(hasBand);
    m_to->setEnabled(hasBand);
    allowWhatIsComplete();
}

void CapabilityPanel::allowWhatIsComplete()
{
    m_list->allow(m_typed.expanded > 0.0);
}

/// A band that the quantity has not is left out.
CapabilityEntry CapabilityPanel::typed() const
{
    CapabilityEntry entry = m_typed;
    if (!isOverFrequency(entry)) {
        entry.from_Hz = 0.0;
        entry.to_Hz.reset();
    }
    return entry;
}

} // namespace dyncal
