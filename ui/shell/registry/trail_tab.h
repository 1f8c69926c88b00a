// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QJsonArray>
#include <QWidget>

class QPlainTextEdit;

namespace dyncal {

class RegistryCaller;
class RowsView;

/// The audit trail: who did what when, and why; of the entry that is selected, the whole row before
/// and after.
class TrailTab : public QWidget
{
    Q_OBJECT

public:
    TrailTab(RegistryCaller &caller, QWidget *parent);

    void refresh();
    void showWords();

private:
    void showEntry();

    RegistryCaller &m_caller;
    QJsonArray m_entries;
    RowsView *m_table;
    QPlainTextEdit *m_entry;
};

} // namespace dyncal
