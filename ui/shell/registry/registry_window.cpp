// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/registry_window.h"

#include "ui/shell/preferences/preferences.h"
#include "ui/shell/registry/cards_tab.h"
#include "ui/shell/registry/certificates_tab.h"
#include "ui/shell/registry/history_tab.h"
#include "ui/shell/registry/trail_tab.h"
#include "ui/shell/registry/verify_tab.h"
#include "ui/stages/frame/prompts.h"
#include "ui/text/progress_format.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

namespace dyncal {

namespace {

constexpr QSize kFirstSizeOfWindow(1200, 700);

} // namespace

RegistryWindow::RegistryWindow(Prompts &prompts, Preferences &preferences, QWidget *parent)
    : QDialog(parent, Qt::Window)
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_caller(preferences, this)
    , m_addressLabel(new QLabel(this))
    , m_address(new QLineEdit(this))
    , m_choose(new QPushButton(this))
    , m_refresh(new QPushButton(this))
    , m_tabs(new QTabWidget(this))
    , m_certificates(new CertificatesTab(m_caller, prompts, this))
    , m_trail(new TrailTab(m_caller, this))
    , m_cards(new CardsTab(m_caller, prompts, preferences, this))
    , m_verify(new VerifyTab(m_caller, prompts, preferences, this))
    , m_history(new HistoryTab(m_caller, prompts, preferences, this))
    , m_progress(new QProgressBar(this))
    , m_outcome(new QLabel(this))
{
    setObjectName("registryWindow");
    m_address->setObjectName("registryAddress");
    m_address->setText(m_caller.address());
    m_addressLabel->setBuddy(m_address);
    m_choose->setObjectName("registryChoose");
    m_refresh->setObjectName("registryRefresh");
    m_tabs->setObjectName("registryTabs");
    m_progress->setObjectName("registryProgress");
    m_progress->setRange(0, 0);
    m_progress->setFormat(progressFormat());
    m_progress->hide();
    m_outcome->setObjectName("registryOutcome");
    m_outcome->setWordWrap(true);
    for (QWidget *tab :
        std::initializer_list<QWidget *>{m_certificates, m_trail, m_cards, m_verify, m_history})
        m_tabs->addTab(tab, {});
    auto *line = new QHBoxLayout;
    line->addWidget(m_addressLabel);
    line->addWidget(m_address, 1);
    line->addWidget(m_choose);
    line->addWidget(m_refresh);
    auto *column = new QVBoxLayout(this);
    column->addLayout(line);
    column->addWidget(m_tabs, 1);
    column->addWidget(m_progress);
    column->addWidget(m_outcome);
    for (QPushButton *button : {m_choose, m_refresh})
        button->setAutoDefault(false); // Return ends the typing of the address
    connect(m_address, &QLineEdit::editingFinished, this, &RegistryWindow::useAddress);
    connect(m_choose, &QPushButton::clicked, this, &RegistryWindow::askForFile);
    connect(m_refresh, &QPushButton::clicked, this, &RegistryWindow::refresh);
    connect(&m_caller, &RegistryCaller::busyChanged, this,
        [this] { m_progress->setVisible(m_caller.isBusy()); });
    connectTabs();
    resize(kFirstSizeOfWindow);
    showWords();
}

void RegistryWindow::connectTabs()
{
    connect(&m_caller, &RegistryCaller::failed, m_outcome, &QLabel::setText);
    const auto follow = [this](const QString &sentence) {
        refresh();
        m_outcome->setText(sentence);
    };
    connect(m_certificates, &CertificatesTab::changed, this, follow);
    connect(m_cards, &CardsTab::changed, this, follow);
    connect(m_history, &HistoryTab::written, m_outcome, &QLabel::setText);
    connect(m_history, &HistoryTab::plotExport, this, &RegistryWindow::plotExport);
}

void RegistryWindow::showWords()
{
    setWindowTitle(tr("Registry"));
    m_addressLabel->setText(tr("&Registry"));
    m_address->setPlaceholderText(tr("that of this user"));
    m_address->setToolTip(
        tr("A file, or postgresql://USER@HOST:PORT/DATABASE of the laboratory's server"));
    m_choose->setText(tr("&Choose..."));
    m_refresh->setText(tr("Re&fresh"));
    m_progress->setAccessibleName(tr("The registry is being read or changed"));
    const QStringList titles{
        tr("Certificates"), tr("Audit trail"), tr("Cards"), tr("Verify"), tr("History")};
    for (int tab = 0; tab < titles.size(); ++tab)
        m_tabs->setTabText(tab, titles[tab]);
    m_certificates->showWords();
    m_trail->showWords();
    m_cards->showWords();
    m_verify->showWords();
    m_history->showWords();
}

void RegistryWindow::refresh()
{
    m_outcome->clear();
    m_certificates->refresh();
    m_trail->refresh();
    m_cards->refresh();
    m_history->refresh();
}

void RegistryWindow::useAddress()
{
    if (m_caller.useAddress(m_address->text()))
        refresh();
}

void RegistryWindow::askForFile()
{
    const QString path = m_prompts.openFile(this, tr("Registry"),
        tr("Registries (*.sqlite);;All files (*)"), m_preferences.lastFolder());
    if (path.isEmpty())
        return;
    m_address->setText(path);
    useAddress();
}

void RegistryWindow::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showWords();
}

void RegistryWindow::showEvent(QShowEvent *event)
{
    QDialog::showEvent(event);
    refresh();
}

} // namespace dyncal
