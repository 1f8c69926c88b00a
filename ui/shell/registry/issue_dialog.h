// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/issue/issued_recipe.h"
#include "ui/session/current_utc.h"
#include "ui/shell/registry/registry_caller.h"

#include <QDialog>

class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace dyncal {

class FileActions;
class Preferences;
class Prompts;
class Session;
class SigningPanel;

/// File > Issue certificate: what keeps the certificate of this job from being issued, live; then
/// the number, the registry's entry and the frozen folder, as `dyncal issue` makes them. A job that
/// has a certificate in force is offered an amendment, never an edit.
class IssueDialog : public QDialog
{
    Q_OBJECT

public:
    IssueDialog(Session &session, CurrentUtc currentUtc, FileActions &files, Prompts &prompts,
        Preferences &preferences, QWidget *parent);

    /// What issues: this very program, unless it is told otherwise.
    void setProgram(const QString &program) { m_caller.setProgram(program); }
    bool isBusy() const { return m_caller.isBusy(); }
    void lookUp(); ///< what the registry has of this job

private:
    void buildForm(QFormLayout &form);
    void followChanges();
    IssueNames names() const;
    void showObstacles();
    void showWork(); ///< what can be done now
    void showCertificate();
    void useAddress();
    void askForFolder();
    void issue();
    QStringList command(bool isSecretGiven) const;
    void take(const ProgramAnswer &answer);

    Session &m_session;
    CurrentUtc m_currentUtc;
    FileActions &m_files;
    Prompts &m_prompts;
    Preferences &m_preferences;
    RegistryCaller m_caller;
    bool m_isFree = false; ///< of obstacles
    qint64 m_inForce = 0; ///< number of the job's certificate; 0: it has none
    QLabel *m_state;
    QLineEdit *m_folder;
    QPushButton *m_choose;
    QLineEdit *m_registry;
    QLineEdit *m_by;
    QLineEdit *m_reviewedBy;
    QLineEdit *m_reason;
    QLabel *m_reasonLabel;
    SigningPanel *m_signing;
    QListWidget *m_obstacles;
    QProgressBar *m_progress;
    QLabel *m_outcome;
    QPushButton *m_issue;
    QPushButton *m_close;
};

} // namespace dyncal
