// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/certificates_tab.h"

#include "ui/shell/registry/registry_caller.h"
#include "ui/shell/registry/registry_rows.h"
#include "ui/shell/registry/rows_view.h"
#include "ui/stages/frame/prompts.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace dyncal {

CertificatesTab::CertificatesTab(RegistryCaller &caller, Prompts &prompts, QWidget *parent)
    : QWidget(parent)
    , m_caller(caller)
    , m_prompts(prompts)
    , m_table(new RowsView("certificateTable", this))
    , m_withdraw(new QPushButton(this))
    , m_giveUp(new QPushButton(this))
{
    m_withdraw->setObjectName("registryWithdraw");
    m_giveUp->setObjectName("registryGiveUp");
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_withdraw);
    buttons->addWidget(m_giveUp);
    buttons->addStretch();
    auto *column = new QVBoxLayout(this);
    column->addWidget(m_table, 1);
    column->addLayout(buttons);
    connect(m_table, &RowsView::selectionChanged, this, &CertificatesTab::showButtons);
    connect(m_withdraw, &QPushButton::clicked, this, &CertificatesTab::withdraw);
    connect(m_giveUp, &QPushButton::clicked, this, &CertificatesTab::giveUp);
    connect(&m_caller, &RegistryCaller::busyChanged, this, &CertificatesTab::showButtons);
    showButtons();
}

void CertificatesTab::showWords()
{
    m_table->setTitles(
        {tr("Number"), tr("State"), tr("Sensor"), tr("Customer"), tr("Issued (UTC)"),
            tr("Issued by"), tr("Reviewed by"), tr("Amends"), tr("Replaced by"), tr("Reason")},
        tr("Certificates"));
    m_withdraw->setText(tr("&Withdraw..."));
    m_withdraw->setToolTip(
        tr("The laboratory does not stand by this certificate any more; its files stay"));
    m_giveUp->setText(tr("&Give up number..."));
    m_giveUp->setToolTip(tr("A reserved number that will not be issued; it is never given again"));
    m_table->setRows(certificateRows(m_records));
}

void CertificatesTab::refresh()
{
    m_caller.read(*this, {"registry", "list", "--json"}, [this](const ProgramAnswer &answer) {
        m_records = listOf(answer.out);
        m_table->setRows(certificateRows(m_records));
    });
}

QString CertificatesTab::selectedState() const
{
    const int row = m_table->selected();
    return row < 0 ? QString() : m_records[row]["state"].toString();
}

void CertificatesTab::showButtons()
{
    const QString state = selectedState();
    const bool isFree = !m_caller.isBusy();
    m_withdraw->setEnabled(isFree && isInForce(state));
    m_giveUp->setEnabled(isFree && state == "reserved");
}

void CertificatesTab::withdraw()
{
    changeWithReason(
        {"withdraw"}, tr("Withdraw certificate %1"), tr("Certificate %1 is withdrawn."));
}

void CertificatesTab::giveUp()
{
    changeWithReason({"registry", "void"}, tr("Give up number %1"), tr("Number %1 is void."));
}

void CertificatesTab::changeWithReason(
    const QStringList &command, const QString &title, const QString &done)
{
    const QString number = QString::number(m_records.at(m_table->selected())["number"].toInteger());
    const auto reason
        = m_prompts.sentence(this, title.arg(number), tr("Why, for the audit trail:"));
    if (!reason)
        return;
    m_caller.call(command + QStringList{number, "--reason=" + *reason},
        [this, done, number](const ProgramAnswer &) { emit changed(done.arg(number)); });
}

} // namespace dyncal
