// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/what_if_panel.h"

#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/recipe_change.h"
#include "ui/stages/uncertainty/budget_table.h"
#include "ui/stages/uncertainty/budget_words.h"
#include "ui/text/shown_text.h"
#include "ui/text/uncertainty_words.h"

#include <QComboBox>
#include <QSignalBlocker>

#include <algorithm>

namespace dyncal {

namespace {

constexpr double kLargestU = 1e12; ///< as typed numbers elsewhere

} // namespace

WhatIfPanel::WhatIfPanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
{
    build(form);
    connect(m_input, &QComboBox::activated, this, &WhatIfPanel::showU);
    connect(m_u, &OptionalEdit::edited, this, &WhatIfPanel::tryU);
    connect(m_takeOver, &QPushButton::clicked, this, &WhatIfPanel::takeOver);
    connect(m_reset, &QPushButton::clicked, this, &WhatIfPanel::reset);
}

void WhatIfPanel::build(InspectorForm &form)
{
    form.addSection(tr("What if"));
    m_input = new WrappedComboBox; // over the whole width: its words are long
    m_input->setObjectName("whatIfInput");
    m_input->setAccessibleName(tr("Input"));
    m_input->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form.addWide(m_input);
    m_u = form.add(
        tr("u, tried"), "whatIfU", new OptionalEdit({QStringLiteral("%"), 0.01}, 0.0, kLargestU));
    m_u->setEmptyText(tr("as it is"));
    m_now = form.addReadout(tr("u as it is"), "whatIfNow");
    m_note = form.addNote("whatIfNote");
    m_takeOver = new WrappedButton(tr("Take over"));
    m_takeOver->setObjectName("whatIfTakeOver");
    m_takeOver->setToolTip(tr("State what is tried in the recipe's uncertainty budget"));
    m_reset = new WrappedButton(tr("Reset"));
    m_reset->setObjectName("whatIfReset");
    m_reset->setToolTip(tr("Drop what is tried; the recipe stays as it is"));
    form.addWide(m_takeOver);
    form.addWide(m_reset);
}

void WhatIfPanel::show(const Budget *budget)
{
    m_reported = budget ? budget->reported : ReportedValue();
    fillInputs();
    showU();
}

/// One entry for each input, the largest first; the chosen one stays.
void WhatIfPanel::fillInputs()
{
    const QSignalBlocker quiet(m_input);
    const QString before = m_input->currentData().toString();
    m_input->clear();
    for (const std::size_t i : byContribution(m_reported.lines)) {
        const std::string &quantity = m_reported.lines[i].quantity;
        if (m_input->findData(rawText(quantity)) < 0)
            m_input->addItem(inputWords(quantity).name, rawText(quantity));
    }
    const int again = m_input->findData(before);
    m_input->setCurrentIndex(again >= 0 ? again : std::min(0, m_input->count() - 1));
}

const UncertaintyLine *WhatIfPanel::chosen() const
{
    const auto found = std::ranges::find(m_reported.lines,
        m_input->currentData().toString().toStdString(), &UncertaintyLine::quantity);
    return found != m_reported.lines.end() ? &*found : nullptr;
}

void WhatIfPanel::choose(const std::string &quantity)
{
    const int at = m_input->findData(rawText(quantity));
    if (at < 0 || at == m_input->currentIndex())
        return;
    m_input->setCurrentIndex(at);
    showU();
}

void WhatIfPanel::showU()
{
    const UncertaintyLine *line = chosen();
    m_u->setEnabled(line != nullptr);
    m_input->setEnabled(line != nullptr);
    if (line) {
        const ReportedValue tried = withChanges(m_reported, m_tried.changes());
        const auto at = static_cast<std::size_t>(line - m_reported.lines.data());
        m_u->setUnit(unitOfU(*line, m_reported));
        m_u->set(m_tried.has(*line) ? std::optional(tried.lines[at].u) : std::nullopt);
    } else {
        m_u->set(std::nullopt);
    }
    m_now->setText(line ? uText(line->u, *line, m_reported) : QStringLiteral("–"));
    showRecipe();
}

void WhatIfPanel::showRecipe()
{
    const auto &budget = m_session.recipe().uncertainty.budget;
    m_takeOver->setEnabled(m_tried.stated(budget) != budget);
    m_reset->setEnabled(!m_tried.isEmpty());
    m_note->setText(stateText());
}

QString WhatIfPanel::stateText() const
{
    if (m_tried.isEmpty())
        return tr(
            "Type another u, or choose a row of the budget: every U follows, the recipe stays as it is.");
    QStringList names;
    for (const std::string &quantity : m_tried.notStatable())
        names << inputWords(quantity).name;
    return names.isEmpty()
        ? tr("Every U is shown as it would be; the recipe is as before.")
        : tr("Tried only; the budget of the recipe cannot state: %1.").arg(names.join("; "));
}

void WhatIfPanel::tryU(const std::optional<double> &u)
{
    const UncertaintyLine *line = chosen();
    if (!line)
        return;
    m_tried.set(*line, u.value_or(line->u), m_session.recipe().uncertainty.budget);
    showU();
    emit changed();
}

void WhatIfPanel::takeOver()
{
    changeRecipe(m_session, tr("Change the uncertainty budget"),
        [this](Recipe &r) { r.uncertainty.budget = m_tried.stated(r.uncertainty.budget); });
}

void WhatIfPanel::reset()
{
    m_tried.clear();
    showU();
    emit changed();
}

} // namespace dyncal
