// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/inspector_form.h"

#include "ui/stages/frame/layout_scale.h"

#include <QComboBox>
#include <QFormLayout>

namespace dyncal {

InspectorForm::InspectorForm(QWidget *parent)
    : QWidget(parent)
    , m_layout(new QFormLayout(this))
{
    m_layout->setContentsMargins(scale::kMedium, scale::kMedium, scale::kMedium, scale::kMedium);
    m_layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_layout->setVerticalSpacing(scale::kSmall);
}

void InspectorForm::addSection(const QString &title)
{
    auto *label = new FormLabel(title, this);
    label->setFont(scale::heading(label->font()));
    if (m_layout->rowCount() > 0)
        label->setContentsMargins(0, scale::kMedium, 0, 0);
    m_layout->addRow(label);
}

void InspectorForm::addRow(const QString &label, QWidget *control)
{
    addWrappedRow(*m_layout, label, control);
}

QComboBox *InspectorForm::addChoice(
    const QString &label, const QString &objectName, const QStringList &choices)
{
    auto *box = new WrappedComboBox(this);
    box->addItems(choices);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(10);
    return add(label, objectName, box);
}

QLabel *InspectorForm::addReadout(const QString &label, const QString &objectName)
{
    auto *value = new FormLabel({}, this);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_readouts.push_back(value);
    return add(label, objectName, value);
}

QLabel *InspectorForm::addNote(const QString &objectName)
{
    auto *note = new FormLabel({}, this);
    note->setObjectName(objectName);
    note->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_layout->addRow(note);
    return note;
}

void InspectorForm::follow(std::function<void(const Recipe &)> show)
{
    m_followers.push_back(std::move(show));
}

void InspectorForm::showRecipe(const Recipe &recipe)
{
    for (const auto &show : m_followers)
        show(recipe);
}

void InspectorForm::setReadoutsEnabled(bool enabled)
{
    for (QLabel *readout : m_readouts)
        readout->setEnabled(enabled);
}

void InspectorForm::addWide(QWidget *control)
{
    m_layout->addRow(control);
}

} // namespace dyncal
