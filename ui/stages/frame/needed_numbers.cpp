// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/needed_numbers.h"

#include "ui/stages/frame/refusal_note.h"

#include <algorithm>

namespace dyncal {

NeededNumbers::NeededNumbers(InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_form(form)
{
}

OptionalEdit *NeededNumbers::add(
    const QString &label, const QString &objectName, OptionalEdit *edit)
{
    m_form.add(label, objectName, edit);
    edit->setEmptyText(tr("needed"));
    const std::size_t at = m_numbers.size();
    m_numbers.push_back({label, edit});
    connect(edit, &OptionalEdit::edited, this,
        [this, at](const std::optional<double> &value) { take(at, value); });
    return edit;
}

void NeededNumbers::addNote(const QString &objectName)
{
    m_note = m_form.addNote(objectName);
}

void NeededNumbers::take(std::size_t at, const std::optional<double> &value)
{
    Number &number = m_numbers[at];
    if (m_isKnown && !value) {
        showAll();
        showRefusal(number.edit,
            tr("This value is needed as long as the others stand; it stays as it was."));
        return;
    }
    const std::optional<double> before = std::exchange(number.value, value);
    std::vector<double> values;
    for (const Number &one : m_numbers)
        if (one.value)
            values.push_back(*one.value);
    if (values.size() == m_numbers.size()) {
        number.value = before; // unless the recipe takes it, and show() is called with it
        emit completed(values, number.edit);
    }
    showAll();
}

void NeededNumbers::show(const std::optional<std::vector<double>> &known)
{
    if (!known && m_isKnown)
        forget();
    m_isKnown = known.has_value();
    for (std::size_t i = 0; known && i < m_numbers.size(); ++i)
        m_numbers[i].value = known->at(i);
    showAll();
}

void NeededNumbers::forget()
{
    for (Number &number : m_numbers)
        number.value.reset();
    showAll();
}

std::size_t NeededNumbers::typed() const
{
    return static_cast<std::size_t>(
        std::ranges::count_if(m_numbers, [](const Number &one) { return one.value.has_value(); }));
}

void NeededNumbers::showAll()
{
    QStringList missing;
    for (const Number &number : m_numbers) {
        number.edit->set(number.value);
        if (!number.value)
            missing << number.label;
    }
    const bool isBegun = missing.size() < static_cast<qsizetype>(m_numbers.size());
    if (!m_note)
        return;
    m_note->setText(isBegun && !missing.isEmpty()
            ? tr("Not used yet; still needed: %1.").arg(missing.join(QStringLiteral(", ")))
            : QString());
}

} // namespace dyncal
