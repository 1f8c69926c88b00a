// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/program/secret_pipe.h"
#include "ui/shell/registry/signing_choice.h"

#include <QGroupBox>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace dyncal {

class Preferences;
class Prompts;

/// Who signs the certificate: nobody, a key file, a token or a service; and which authority stamps
/// the time. All is remembered but the passphrase or PIN, which leaves its field by takeSecret(),
/// with another way and when the panel goes out of sight. While it is there, the window's memory
/// gets into no core file.
class SigningPanel : public QGroupBox
{
    Q_OBJECT

public:
    SigningPanel(Preferences &preferences, Prompts &prompts, QWidget *parent);
    ~SigningPanel() override;

    SigningChoice choice() const;
    void remember() const; ///< the choice, for the next certificate
    /// The secret, which is no longer in its field then.
    SecretPipe takeSecret();
    void askAgain(); ///< for a secret that was not the right one

signals:
    void changed(); ///< the choice is another

protected:
    void hideEvent(QHideEvent *event) override;

private:
    void addRows(QFormLayout &form);
    void showWay();
    void askForKey();
    void guardMemory();

    Preferences &m_preferences;
    Prompts &m_prompts;
    QComboBox *m_way;
    QLineEdit *m_keyFile;
    QPushButton *m_choose;
    QLineEdit *m_token;
    QLineEdit *m_service;
    QLabel *m_secretLabel;
    QLineEdit *m_secret;
    QLineEdit *m_authority;
    int m_dumpable; ///< what it was before there was a secret
};

} // namespace dyncal
