// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/verify_tab.h"

#include "ui/shell/preferences/preferences.h"
#include "ui/shell/registry/registry_caller.h"
#include "ui/shell/registry/registry_rows.h"
#include "ui/shell/registry/rows_view.h"
#include "ui/stages/frame/prompts.h"

#include <QHBoxLayout>
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
{
    m_folder->setObjectName("verifyFolder");
    m_files->setObjectName("verifyFiles");
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_folder);
    buttons->addWidget(m_files);
    buttons->addStretch();
    auto *column = new QVBoxLayout(this);
    column->addLayout(buttons);
    column->addWidget(m_table, 1);
    connect(m_folder, &QPushButton::clicked, this, &VerifyTab::askForFolder);
    connect(m_files, &QPushButton::clicked, this, &VerifyTab::askForFiles);
    connect(&m_caller, &RegistryCaller::busyChanged, this, [this] {
        for (QPushButton *button : {m_folder, m_files})
            button->setEnabled(!m_caller.isBusy());
    });
}

void VerifyTab::showWords()
{
    m_table->setTitles({tr("File"), tr("Kind"), tr("Verdict"), tr("Number"), tr("State"),
                           tr("First difference, or remarks")},
        tr("What was verified"));
    m_folder->setText(tr("&Folder..."));
    m_folder->setToolTip(tr("The folder of a certificate, or one above several"));
    m_files->setText(tr("F&iles..."));
    m_files->setToolTip(tr("Certificates, results, projects, recordings or a registry"));
    m_table->setRows(verifiedRows(m_verified));
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

/// The list is there also where it says that something is changed.
void VerifyTab::verify(const QStringList &paths)
{
    if (paths.isEmpty())
        return;
    m_caller.call(QStringList{"verify", "--json"} + paths, [this](const ProgramAnswer &answer) {
        m_verified = listOf(answer.out);
        m_table->setRows(verifiedRows(m_verified));
    });
}

} // namespace dyncal
