// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/signing_panel.h"

#include "ui/shell/preferences/preferences.h"
#include "ui/stages/frame/prompts.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <sys/prctl.h>

namespace dyncal {

namespace {

using Issuing = Preferences::Issuing;

} // namespace

SigningPanel::SigningPanel(Preferences &preferences, Prompts &prompts, QWidget *parent)
    : QGroupBox(tr("Signature"), parent)
    , m_preferences(preferences)
    , m_prompts(prompts)
    , m_way(new QComboBox(this))
    , m_keyFile(new QLineEdit(preferences.issuing(Issuing::KeyFile), this))
    , m_choose(new QPushButton(tr("C&hoose..."), this))
    , m_token(new QLineEdit(preferences.issuing(Issuing::Token), this))
    , m_service(new QLineEdit(preferences.issuing(Issuing::Service), this))
    , m_secretLabel(new QLabel(this))
    , m_secret(new QLineEdit(this))
    , m_authority(new QLineEdit(preferences.issuing(Issuing::Authority), this))
    , m_dumpable(::prctl(PR_GET_DUMPABLE))
{
    const std::initializer_list<std::pair<QLineEdit *, const char *>> named{
        {m_keyFile, "signingKeyFile"}, {m_token, "signingToken"}, {m_service, "signingService"},
        {m_secret, "signingSecret"}, {m_authority, "signingAuthority"}};
    for (const auto &[field, name] : named)
        field->setObjectName(QLatin1String(name));
    m_way->setObjectName("signingWay");
    m_way->addItem(tr("None"), signingWayName(SigningWay::Unsigned));
    m_way->addItem(tr("Key file (PKCS#12 or PEM)"), signingWayName(SigningWay::KeyFile));
    m_way->addItem(tr("Token (PKCS#11)"), signingWayName(SigningWay::Token));
    m_way->addItem(tr("Seal service (a command)"), signingWayName(SigningWay::Service));
    m_way->setCurrentIndex(
        m_way->findData(signingWayName(signingWayOf(preferences.issuing(Issuing::Way)))));
    m_choose->setObjectName("signingChoose");
    m_choose->setAutoDefault(false);
    m_secret->setEchoMode(QLineEdit::Password);
    m_secret->setMaxLength(SecretPipe::kMostLetters);
    m_secretLabel->setBuddy(m_secret);
    addRows(*new QFormLayout(this));
    connect(m_way, &QComboBox::activated, this, &SigningPanel::showWay);
    connect(m_choose, &QPushButton::clicked, this, &SigningPanel::askForKey);
    connect(m_secret, &QLineEdit::textChanged, this, &SigningPanel::guardMemory);
    for (QLineEdit *edit : {m_keyFile, m_token, m_service, m_authority})
        connect(edit, &QLineEdit::textChanged, this, &SigningPanel::changed);
    showWay();
}

SigningPanel::~SigningPanel()
{
    wipe(*m_secret);
    guardMemory();
}

void SigningPanel::addRows(QFormLayout &form)
{
    auto *file = new QWidget(this);
    file->setFocusProxy(m_keyFile);
    auto *row = new QHBoxLayout(file);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_keyFile, 1);
    row->addWidget(m_choose);
    form.addRow(tr("&Signed by"), m_way);
    form.addRow(tr("&Key file"), file);
    form.addRow(tr("Key of the &token"), m_token);
    form.addRow(tr("Co&mmand"), m_service);
    form.addRow(m_secretLabel, m_secret);
    form.addRow(tr("Time stamp &authority"), m_authority);
    m_way->setToolTip(
        tr("Who signs PDF and DCC, so that others can tell whose they are, unchanged"));
    m_keyFile->setToolTip(tr("The private key together with its certificate"));
    m_token->setPlaceholderText(QStringLiteral("pkcs11:token=NAME;object=LABEL"));
    m_token->setToolTip(
        tr("RFC 7512; the token's library by module-path=FILE in it, else by PKCS11_MODULE_PATH"));
    m_service->setToolTip(
        tr("It gets the SHA-256 to be signed and answers with a CMS (docs/signatures.md)"));
    m_secret->setToolTip(tr("Goes to the program that signs, and is kept nowhere"));
    m_authority->setPlaceholderText(tr("none"));
    m_authority->setToolTip(
        tr("http://HOST/PATH of an authority that stamps the time of the signature (RFC 3161)"));
}

SigningChoice SigningPanel::choice() const
{
    return {signingWayOf(m_way->currentData().toString()), m_keyFile->text().trimmed(),
        m_token->text().trimmed(), m_service->text().trimmed(), m_authority->text().trimmed()};
}

void SigningPanel::remember() const
{
    const SigningChoice chosen = choice();
    m_preferences.setIssuing(Issuing::Way, signingWayName(chosen.way));
    m_preferences.setIssuing(Issuing::KeyFile, chosen.keyFile);
    m_preferences.setIssuing(Issuing::Service, chosen.service);
    m_preferences.setIssuing(Issuing::Authority, chosen.authority);
    if (chosen.way == SigningWay::Token) // looked at: it holds no PIN
        m_preferences.setIssuing(Issuing::Token, chosen.token);
}

SecretPipe SigningPanel::takeSecret()
{
    return SecretPipe::takenFrom(*m_secret);
}

void SigningPanel::askAgain()
{
    if (m_secret->isVisible())
        m_secret->setFocus();
}

/// Only the fields that the way has; a secret belongs to the way that it was typed for.
void SigningPanel::showWay()
{
    const SigningChoice chosen = choice();
    auto *form = static_cast<QFormLayout *>(layout());
    wipe(*m_secret);
    form->setRowVisible(m_keyFile->parentWidget(), chosen.way == SigningWay::KeyFile);
    form->setRowVisible(m_token, chosen.way == SigningWay::Token);
    form->setRowVisible(m_service, chosen.way == SigningWay::Service);
    form->setRowVisible(m_secret, chosen.hasSecret());
    form->setRowVisible(m_authority, chosen.isSigned());
    m_secretLabel->setText(chosen.way == SigningWay::Token ? tr("&PIN") : tr("&Passphrase"));
    emit changed();
}

void SigningPanel::askForKey()
{
    const QString path = m_prompts.openFile(this, tr("Key that signs"),
        tr("Keys (*.p12 *.pfx *.pem);;All files (*)"), m_preferences.lastFolder());
    if (!path.isEmpty())
        m_keyFile->setText(path);
}

void SigningPanel::guardMemory()
{
    ::prctl(PR_SET_DUMPABLE, m_secret->text().isEmpty() ? m_dumpable : 0);
}

void SigningPanel::hideEvent(QHideEvent *event)
{
    QGroupBox::hideEvent(event);
    if (!event->spontaneous()) // by the desktop, which shows it again
        wipe(*m_secret);
}

} // namespace dyncal
