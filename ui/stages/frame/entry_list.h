// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>
#include <QStringList>

class QListWidget;
class QPushButton;

namespace dyncal {

class InspectorForm;

/// Entries of a list in the recipe, and buttons that add one from the fields between, replace the
/// selected one by them, or remove it. Object names: `prefix` + "List", "Add", "Replace", "Remove".
class EntryList : public QObject
{
    Q_OBJECT

public:
    EntryList(
        InspectorForm &form, const QString &prefix, const QString &accessibleName, QObject *parent);

    void addButtons(InspectorForm &form); ///< below the fields, once
    /// The selected row stays selected where there still is one.
    void show(const QStringList &entries);
    void select(int row);
    void selectLast();
    int row() const; ///< -1 = none
    /// `complete`: the fields hold an entry.
    void allow(bool complete);

    QPushButton *addingButton() const { return m_add; }
    QPushButton *replacingButton() const { return m_replace; }
    QPushButton *removingButton() const { return m_remove; }

signals:
    void selected(int row);
    void addAsked();
    void replaceAsked();
    void removeAsked();

private:
    QPushButton *addButton(InspectorForm &form, const QString &text, const QString &name);

    QString m_prefix;
    QListWidget *m_list;
    QPushButton *m_add = nullptr;
    QPushButton *m_replace = nullptr;
    QPushButton *m_remove = nullptr;
};

} // namespace dyncal
