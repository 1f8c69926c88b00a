// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QJsonArray>
#include <QWidget>

class QPushButton;

namespace dyncal {

class Preferences;
class Prompts;
class RegistryCaller;
class RowsView;

/// Issued folders, registries, projects, recordings and single files held against what they state.
class VerifyTab : public QWidget
{
    Q_OBJECT

public:
    VerifyTab(RegistryCaller &caller, Prompts &prompts, Preferences &preferences, QWidget *parent);

    void showWords();

private:
    void askForFolder();
    void askForFiles();
    void verify(const QStringList &paths);

    RegistryCaller &m_caller;
    Prompts &m_prompts;
    Preferences &m_preferences;
    QJsonArray m_verified;
    RowsView *m_table;
    QPushButton *m_folder;
    QPushButton *m_files;
};

} // namespace dyncal
