// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/widget/plot_widget.h"
#include "ui/shell/registry/registry_caller.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTabWidget;

namespace dyncal {

class CardsTab;
class CertificatesTab;
class HistoryTab;
class Preferences;
class Prompts;
class TrailTab;
class VerifyTab;

/// File > Registry: the certificates of the laboratory, their audit trail, the cards that fill
/// certificates, the verification of what was issued, and the history of a sensor. A window of its
/// own, beside which work goes on.
class RegistryWindow : public QDialog
{
    Q_OBJECT

public:
    RegistryWindow(Prompts &prompts, Preferences &preferences, QWidget *parent);

    /// What reads and changes the registry: this very program, unless it is told otherwise.
    void setProgram(const QString &program) { m_caller.setProgram(program); }
    bool isBusy() const { return m_caller.isBusy(); }
    void refresh();

signals:
    void plotExport(const dyncal::PlotWidget *plot); ///< the operator wants it as a file

protected:
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void connectTabs();
    void showWords();
    void useAddress();
    void askForFile();

    Prompts &m_prompts;
    Preferences &m_preferences;
    RegistryCaller m_caller;
    QLabel *m_addressLabel;
    QLineEdit *m_address;
    QPushButton *m_choose;
    QPushButton *m_refresh;
    QTabWidget *m_tabs;
    CertificatesTab *m_certificates;
    TrailTab *m_trail;
    CardsTab *m_cards;
    VerifyTab *m_verify;
    HistoryTab *m_history;
    QProgressBar *m_progress;
    QLabel *m_outcome;
};

} // namespace dyncal
