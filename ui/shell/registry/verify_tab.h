// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QJsonArray>
#include <QWidget>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace dyncal {

class Preferences;
class Prompts;
class RegistryCaller;
class RowsView;

/// Issued folders, registries, projects, recordings and single files held against what they state,
/// and their signatures: whose they are, and whether the certificates of --trust stand behind them.
class VerifyTab : public QWidget
{
    Q_OBJECT

public:
    VerifyTab(RegistryCaller &caller, Prompts &prompts, Preferences &preferences, QWidget *parent);

    void showWords();

private:
    QHBoxLayout *trustLine();
    void askForTrust();
    void askForFolder();
    void askForFiles();
    void verify(const QStringList &paths);
    QStringList command() const;
    void showVerdicts();

    RegistryCaller &m_caller;
    Prompts &m_prompts;
    Preferences &m_preferences;
    QJsonArray m_verified;
    RowsView *m_table;
    QPushButton *m_folder;
    QPushButton *m_files;
    QLabel *m_trustLabel;
    QLineEdit *m_trust;
    QPushButton *m_chooseTrust;
    QLabel *m_momentLabel;
    QLineEdit *m_moment;
    QLabel *m_summary;
};

} // namespace dyncal
