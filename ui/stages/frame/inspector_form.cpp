// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/inspector_form.h"

#include <QComboBox>
#include <QFormLayout>

namespace dyncal {

InspectorForm::InspectorForm(QWidget *parent)
    : QWidget(parent)
    , m_layout(new QFormLayout(this))
{
    m_layout->setContentsMargins(8, 8, 8, 8);
    m_layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_layout->setVerticalSpacing(5);
}

void InspectorForm::addSection(const QString &title)
{
    auto *label = new QLabel(title, this);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    if (m_layout->rowCount() > 0)
        label->setContentsMargins(0, 8, 0, 0);
    m_layout->addRow(label);
}

void InspectorForm::addRow(const QString &label, QWidget *control)
{
    m_layout->addRow(label, control);
}

QComboBox *InspectorForm::addChoice(
    const QString &label, const QString &objectName, const QStringList &choices)
{
    auto *box = new QComboBox(this);
    box->addItems(choices);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(10);
    return add(label, objectName, box);
}

QLabel *InspectorForm::addReadout(const QString &label, const QString &objectName)
{
    auto *value = new QLabel(this);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setWordWrap(true);
    m_readouts.push_back(value);
    return add(label, objectName, value);
}

QLabel *InspectorForm::addNote(const QString &objectName)
{
    auto *note = new QLabel(this);
    note->setObjectName(objectName);
    note->setWordWrap(true);
    note->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_layout->addRow(note);
    return note;
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
