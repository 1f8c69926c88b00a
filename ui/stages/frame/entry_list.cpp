// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/entry_list.h"

#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/wrapped_controls.h"

#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kListHeight_px = 90;

} // namespace

EntryList::EntryList(
    InspectorForm &form, const QString &prefix, const QString &accessibleName, QObject *parent)
    : QObject(parent)
    , m_prefix(prefix)
    , m_list(new QListWidget)
{
    m_list->setObjectName(prefix + "List");
    m_list->setAccessibleName(accessibleName);
    m_list->setMaximumHeight(kListHeight_px);
    m_list->setWordWrap(true);
    form.addWide(m_list);
    connect(m_list, &QListWidget::currentRowChanged, this, &EntryList::selected);
}

void EntryList::addButtons(InspectorForm &form)
{
    m_add = addButton(form, tr("Add this entry"), "Add");
    m_replace = addButton(form, tr("Replace the selected entry"), "Replace");
    m_remove = addButton(form, tr("Remove the selected entry"), "Remove");
    connect(m_add, &QPushButton::clicked, this, &EntryList::addAsked);
    connect(m_replace, &QPushButton::clicked, this, &EntryList::replaceAsked);
    connect(m_remove, &QPushButton::clicked, this, &EntryList::removeAsked);
}

QPushButton *EntryList::addButton(InspectorForm &form, const QString &text, const QString &name)
{
    auto *button = new WrappedButton(text);
    button->setObjectName(m_prefix + name);
    form.addWide(button);
    return button;
}

void EntryList::show(const QStringList &entries)
{
    const QSignalBlocker quiet(m_list);
    const int row = m_list->currentRow();
    m_list->clear();
    m_list->addItems(entries);
    m_list->setCurrentRow(std::min(row, m_list->count() - 1));
}

void EntryList::select(int row)
{
    m_list->setCurrentRow(row);
}

void EntryList::selectLast()
{
    select(m_list->count() - 1);
}

int EntryList::row() const
{
    return m_list->currentRow();
}

void EntryList::allow(bool complete)
{
    const bool isSelected = row() >= 0;
    m_add->setEnabled(complete);
    m_replace->setEnabled(isSelected && complete);
    m_remove->setEnabled(isSelected);
}

} // namespace dyncal
