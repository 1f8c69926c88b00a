// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/issue_dialog.h"

#include "core/dcc/dcc_country.h"
#include "core/issue/issue_obstacles.h"
#include "ui/session/session.h"
#include "ui/shell/files/file_actions.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/shell/registry/registry_rows.h"
#include "ui/shell/registry/signing_panel.h"
#include "ui/stages/frame/prompts.h"
#include "ui/text/finding_text.h"
#include "ui/text/progress_format.h"
#include "ui/text/shown_text.h"

#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace dyncal {

namespace {

constexpr QSize kFirstSize(720, 680);
constexpr int kBlocked = 2; ///< exit code

QLineEdit *line(const char *name, const QString &text, QWidget *parent)
{
    auto *edit = new QLineEdit(text, parent);
    edit->setObjectName(name);
    return edit;
}

QPushButton *button(const char *name, QWidget *parent)
{
    auto *made = new QPushButton(parent);
    made->setObjectName(name);
    made->setAutoDefault(false); // Return ends the typing of a field
    return made;
}

QString findingsText(const QJsonObject &said)
{
    QStringList lines;
    for (const QJsonValue finding : said["findings"].toArray())
        lines << shownText(finding["id"].toString() + ": " + finding["message"].toString());
    return lines.join(' ');
}

/// "A certificate is issued": its number, who signed it, and where it is.
QString issuedSentence(const QJsonObject &said)
{
    const QString number = QString::number(said["number"].toInteger());
    const QString folder = shownText(QDir::toNativeSeparators(said["folder"].toString()));
    if (!said["signed"].toBool())
        return IssueDialog::tr("Certificate %1 is issued, not signed: %2").arg(number, folder);
    const QString signer = shownText(said["signer"].toString());
    const QString authority = shownText(said["time_stamp_authority"].toString());
    return authority.isEmpty()
        ? IssueDialog::tr("Certificate %1 is issued and signed by %2: %3")
              .arg(number, signer, folder)
        : IssueDialog::tr("Certificate %1 is issued, signed by %2 and time stamped by %3: %4")
              .arg(number, signer, authority, folder);
}

} // namespace

using Issuing = Preferences::Issuing;

IssueDialog::IssueDialog(Session &session, CurrentUtc currentUtc, FileActions &files,
    Prompts &prompts, Preferences &preferences, QWidget *parent)
    : QDialog(parent)
    , m_session(session)
    , m_currentUtc(std::move(currentUtc))
    , m_files(files)
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_caller(preferences, this)
    , m_state(new QLabel(this))
    , m_folder(line("issueFolder", preferences.issuing(Issuing::Folder), this))
    , m_choose(button("issueChoose", this))
    , m_registry(line("issueRegistry", m_caller.address(), this))
    , m_by(line("issueBy", preferences.issuing(Issuing::By), this))
    , m_reviewedBy(line("issueReviewedBy", {}, this))
    , m_reason(line("issueReason", {}, this))
    , m_reasonLabel(new QLabel(this))
    , m_signing(new SigningPanel(preferences, prompts, this))
    , m_obstacles(new QListWidget(this))
    , m_progress(new QProgressBar(this))
    , m_outcome(new QLabel(this))
    , m_issue(button("issueNow", this))
    , m_close(button("issueClose", this))
{
    setObjectName("issueDialog");
    m_state->setObjectName("issueState");
    m_obstacles->setObjectName("issueObstacles");
    m_obstacles->setWordWrap(true);
    m_progress->setObjectName("issueProgress");
    m_progress->setRange(0, 0);
    m_progress->setFormat(progressFormat());
    m_progress->hide();
    m_outcome->setObjectName("issueOutcome");
    for (QLabel *label : {m_state, m_outcome})
        label->setWordWrap(true);
    auto *form = new QFormLayout;
    buildForm(*form);
    auto *buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(m_issue);
    buttons->addWidget(m_close);
    auto *column = new QVBoxLayout(this);
    column->addWidget(m_state);
    column->addLayout(form);
    column->addWidget(m_signing);
    column->addWidget(m_obstacles, 1);
    column->addWidget(m_progress);
    column->addWidget(m_outcome);
    column->addLayout(buttons);
    followChanges();
    resize(kFirstSize);
    showCertificate();
}

void IssueDialog::followChanges()
{
    connect(m_choose, &QPushButton::clicked, this, &IssueDialog::askForFolder);
    connect(m_issue, &QPushButton::clicked, this, &IssueDialog::issue);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_registry, &QLineEdit::editingFinished, this, &IssueDialog::useAddress);
    for (QLineEdit *edit : {m_folder, m_by, m_reviewedBy, m_reason})
        connect(edit, &QLineEdit::textChanged, this, &IssueDialog::showObstacles);
    connect(m_signing, &SigningPanel::changed, this, &IssueDialog::showObstacles);
    for (const auto signal : {&Session::resultsChanged, &Session::recipeChanged,
             &Session::capturesChanged, &Session::sourcesChanged, &Session::stageStatusChanged})
        connect(&m_session, signal, this, &IssueDialog::showObstacles);
    connect(&m_caller, &RegistryCaller::busyChanged, this, &IssueDialog::showWork);
    connect(&m_caller, &RegistryCaller::failed, this, [this](const QString &sentence) {
        m_outcome->setText(sentence);
        m_signing->askAgain();
    });
}

void IssueDialog::buildForm(QFormLayout &form)
{
    auto *folder = new QWidget(this);
    folder->setFocusProxy(m_folder);
    auto *row = new QHBoxLayout(folder);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_folder, 1);
    row->addWidget(m_choose);
    form.addRow(tr("&Folder of certificates"), folder);
    form.addRow(tr("&Registry"), m_registry);
    form.addRow(tr("Issued &by"), m_by);
    form.addRow(tr("Re&viewed by"), m_reviewedBy);
    form.addRow(m_reasonLabel, m_reason);
    m_reasonLabel->setBuddy(m_reason);
    setWindowTitle(tr("Issue certificate"));
    m_folder->setToolTip(tr("It gets a folder with the certificate's number"));
    m_registry->setPlaceholderText(tr("that of this user"));
    m_reasonLabel->setText(tr("&What changed"));
    m_reason->setToolTip(tr("Printed on the amendment, beside the number that it replaces"));
    m_obstacles->setAccessibleName(tr("What keeps it from being issued"));
    m_progress->setAccessibleName(tr("The certificate is being issued"));
    m_choose->setText(tr("&Choose..."));
    m_issue->setText(tr("&Issue"));
    m_close->setText(tr("Close"));
}

IssueNames IssueDialog::names() const
{
    const Result<std::string> now = m_currentUtc();
    return {m_by->text().trimmed().toStdString(), m_reviewedBy->text().trimmed().toStdString(),
        now ? *now : std::string()};
}

void IssueDialog::showObstacles()
{
    const IssueNames given = names();
    Findings obstacles;
    if (!m_session.isUpToDate() && !m_session.error())
        obstacles.push_back(staleResults());
    else
        obstacles
            = issueObstacles({m_session.results(), m_session.error(), m_session.failedStage()},
                issuedRecipe(m_session.recipe(), "1", given), given);
    m_obstacles->clear();
    for (const Finding &obstacle : obstacles)
        m_obstacles->addItem(findingLine(obstacle));
    if (m_folder->text().isEmpty())
        m_obstacles->addItem(tr("Name the folder of certificates."));
    if (m_inForce > 0 && m_reason->text().trimmed().isEmpty())
        m_obstacles->addItem(tr("Say what changed, for the amendment."));
    m_obstacles->addItems(m_signing->choice().obstacles());
    m_isFree = m_obstacles->count() == 0;
    if (m_isFree)
        m_obstacles->addItem(tr("Nothing keeps it from being issued."));
    for (const Finding &caution : countryCautions(m_session.recipe()))
        m_obstacles->addItem(findingLine(caution));
    m_by->setPlaceholderText(shownText(issuerOf(m_session.recipe(), given)));
    showWork();
}

void IssueDialog::showWork()
{
    m_issue->setEnabled(m_isFree && !isBusy());
    m_signing->setEnabled(!isBusy());
    m_progress->setVisible(isBusy());
}

void IssueDialog::lookUp()
{
    m_inForce = 0;
    showCertificate();
    if (!m_session.state().hasShots() || !m_session.isSealed())
        return;
    const QString job = rawText(jobOf(*m_session.state().captures));
    m_caller.read(*this, {"registry", "list", "--json"}, [this, job](const ProgramAnswer &answer) {
        for (const QJsonValue record : listOf(answer.out)) {
            if (record["job"].toString() == job && isInForce(record["state"].toString()))
                m_inForce = record["number"].toInteger();
        }
        showCertificate();
    });
}

void IssueDialog::showCertificate()
{
    m_state->setText(m_inForce == 0
            ? tr("This job is a draft: it has no certificate in this registry.")
            : tr(
                "These recordings have certificate %1. It is not changed any more: issue an amendment, which has a number of its own and says what it replaces and why.")
                  .arg(m_inForce));
    m_reason->setVisible(m_inForce > 0);
    m_reasonLabel->setVisible(m_inForce > 0);
    showObstacles();
}

void IssueDialog::useAddress()
{
    if (m_caller.useAddress(m_registry->text()))
        lookUp();
}

void IssueDialog::askForFolder()
{
    const QString path
        = m_prompts.folder(this, tr("Folder of certificates"), m_preferences.lastFolder());
    if (!path.isEmpty())
        m_folder->setText(path);
}

QStringList IssueDialog::command(bool isSecretGiven) const
{
    QStringList words{"issue", m_files.projectPath(), "-o", m_folder->text(), "--json"};
    words += m_signing->choice().words(isSecretGiven);
    const auto add = [&](const char *option, const QString &text) {
        if (!text.trimmed().isEmpty())
            words << QLatin1String(option) + text.trimmed();
    };
    add("--by=", m_by->text());
    add("--reviewed-by=", m_reviewedBy->text());
    if (m_inForce > 0) {
        words << "--amends" << QString::number(m_inForce);
        add("--reason=", m_reason->text());
    }
    return words;
}

/// The command issues what is saved, so everything is.
void IssueDialog::issue()
{
    useAddress();
    if ((m_files.projectPath().isEmpty() || m_files.isModified()) && !m_files.save())
        return;
    m_preferences.setIssuing(Issuing::By, m_by->text().trimmed());
    m_preferences.setIssuing(Issuing::Folder, m_folder->text());
    m_outcome->setText(tr("The project is computed once more and its certificate written."));
    m_signing->remember();
    SecretPipe secret = m_signing->takeSecret();
    const QStringList words = command(secret.isGiven());
    m_caller.call(
        words, [this](const ProgramAnswer &answer) { take(answer); }, std::move(secret));
}

void IssueDialog::take(const ProgramAnswer &answer)
{
    const QJsonObject said = QJsonDocument::fromJson(answer.out).object();
    if (answer.exitCode == kBlocked) {
        m_outcome->setText(tr("No certificate was issued. %1").arg(findingsText(said)));
        return;
    }
    m_outcome->setText((issuedSentence(said) + ' ' + findingsText(said)).trimmed());
    m_reason->clear();
    lookUp();
}

} // namespace dyncal
