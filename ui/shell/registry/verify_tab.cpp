// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/verify_tab.h"

#include "ui/shell/preferences/preferences.h"
#include "ui/shell/registry/registry_caller.h"
#include "ui/shell/registry/registry_rows.h"
#include "ui/shell/registry/rows_view.h"
#include "ui/stages/frame/prompts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace dyncal {

VerifyTab::VerifyTab(
    RegistryCaller &caller, Prompts &prompts, Preferences &preferences, QWidget *parent)
    : QWidget(parent)
    , m_caller(caller)
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_table(new RowsView("verifyTable", this))
    , m_folder(new QPushButton(this))
    , m_files(new QPushButton(this))
    , m_trustLabel(new QLabel(this))
    , m_trust(new QLineEdit(preferences.issuing(Preferences::Issuing::Trust), this))
    , m_chooseTrust(new QPushButton(this))
    , m_momentLabel(new QLabel(this))
    , m_moment(new QLineEdit(this))
    , m_summary(new QLabel(this))
{
    m_folder->setObjectName("verifyFolder");
    m_files->setObjectName("verifyFiles");
    m_summary->setObjectName("verifySummary");
    m_summary->setWordWrap(true);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_folder);
    buttons->addWidget(m_files);
    buttons->addStretch();
    auto *column = new QVBoxLayout(this);
    column->addLayout(trustLine());
    column->addLayout(buttons);
    column->addWidget(m_summary);
    column->addWidget(m_table, 1);
    connect(m_folder, &QPushButton::clicked, this, &VerifyTab::askForFolder);
    connect(m_files, &QPushButton::clicked, this, &VerifyTab::askForFiles);
    connect(&m_caller, &RegistryCaller::busyChanged, this, [this] {
        for (QPushButton *button : {m_folder, m_files})
            button->setEnabled(!m_caller.isBusy());
    });
}

QHBoxLayout *VerifyTab::trustLine()
{
    m_trust->setObjectName("verifyTrust");
    m_trustLabel->setBuddy(m_trust);
    m_chooseTrust->setObjectName("verifyChooseTrust");
    m_chooseTrust->setAutoDefault(false);
    m_moment->setObjectName("verifyMoment");
    m_momentLabel->setBuddy(m_moment);
    auto *line = new QHBoxLayout;
    line->addWidget(m_trustLabel);
    line->addWidget(m_trust, 3);
    line->addWidget(m_chooseTrust);
    line->addWidget(m_momentLabel);
    line->addWidget(m_moment, 1);
    connect(m_chooseTrust, &QPushButton::clicked, this, &VerifyTab::askForTrust);
    return line;
}

void VerifyTab::showWords()
{
    m_table->setTitles(
        {tr("File"), tr("Kind"), tr("Verdict"), tr("Number"), tr("State"), tr("Signed by"),
            tr("Signed at"), tr("Time stamp"), tr("First difference, or remarks")},
        tr("What was verified"));
    m_trustLabel->setText(tr("&Trusted certificates"));
    m_trust->setPlaceholderText(tr("none: every signer is unknown"));
    m_trust->setToolTip(
        tr("A PEM file with certificates of authorities or signers that you know to be genuine"));
    m_chooseTrust->setText(tr("C&hoose..."));
    m_momentLabel->setText(tr("Valid &on"));
    m_moment->setPlaceholderText(tr("today"));
    m_moment->setToolTip(tr(
        "The day on which the signer's certificate must be valid, as 2026-01-31; a time stamp stands for an earlier one"));
    m_folder->setText(tr("&Folder..."));
    m_folder->setToolTip(tr("The folder of a certificate, or one above several"));
    m_files->setText(tr("F&iles..."));
    m_files->setToolTip(tr("Certificates, results, projects, recordings or a registry"));
    showVerdicts();
}

void VerifyTab::askForTrust()
{
    const QString path = m_prompts.openFile(this, tr("Trusted certificates"),
        tr("Certificates (*.pem *.crt *.cer);;All files (*)"), m_preferences.lastFolder());
    if (!path.isEmpty())
        m_trust->setText(path);
}

void VerifyTab::askForFolder()
{
    const QString path = m_prompts.folder(this, tr("Folder to verify"), m_preferences.lastFolder());
    if (!path.isEmpty())
        verify({path});
}

void VerifyTab::askForFiles()
{
    verify(m_prompts.openFiles(
        this, tr("Files to verify"), tr("All files (*)"), m_preferences.lastFolder()));
}

QStringList VerifyTab::command() const
{
    QStringList words{"verify", "--json"};
    if (const QString trust = m_trust->text().trimmed(); !trust.isEmpty())
        words << "--trust=" + trust;
    if (const QString moment = m_moment->text().trimmed(); !moment.isEmpty())
        words << "--at=" + moment;
    return words;
}

/// The list is there also where it says that something is changed.
void VerifyTab::verify(const QStringList &paths)
{
    if (paths.isEmpty())
        return;
    m_preferences.setIssuing(Preferences::Issuing::Trust, m_trust->text().trimmed());
    m_verified = {}; // what cannot be looked at leaves no older verdict behind
    showVerdicts();
    m_caller.call(command() + paths, [this](const ProgramAnswer &answer) {
        m_verified = listOf(answer.out);
        showVerdicts();
    });
}

/// What is bad comes first, with its sign: it may stand far down in the table.
void VerifyTab::showVerdicts()
{
    m_table->setRows(verifiedRows(m_verified));
    const VerifiedCounts counts = countsOf(m_verified);
    QStringList said;
    if (counts.bad > 0)
        said << tr("■ %n changed, missing or unreadable", nullptr, counts.bad);
    if (counts.doubtful > 0)
        said << tr("▲ %n unchanged, but not signed, or by a signer that is not known or expired",
            nullptr, counts.doubtful);
    if (counts.valid > 0)
        said << tr("● %n valid", nullptr, counts.valid);
    m_summary->setText(said.join(QStringLiteral("   ")));
    m_summary->setVisible(!said.isEmpty());
    QFont font = this->font();
    font.setBold(counts.bad > 0);
    m_summary->setFont(font);
}

} // namespace dyncal
