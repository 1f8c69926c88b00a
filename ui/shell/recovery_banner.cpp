// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/recovery_banner.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <array>
#include <utility>

namespace dyncal {

namespace {

/// In the order in which they stand.
constexpr std::array<std::pair<RecoveryAction, const char *>, 6> kButtons{{
    {RecoveryAction::Restore, "restoreWork"},
    {RecoveryAction::Locate, "locateRecordings"},
    {RecoveryAction::Undo, "undoDiscard"},
    {RecoveryAction::Discard, "discardWork"},
    {RecoveryAction::NotNow, "postponeWork"},
    {RecoveryAction::Close, "closeBanner"},
}};

} // namespace

RecoveryBanner::RecoveryBanner(QWidget *parent)
    : QFrame(parent)
    , m_sentence(new QLabel(this))
{
    setObjectName("recoveryBanner");
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_sentence->setObjectName("recoverySentence");
    m_sentence->setForegroundRole(QPalette::ToolTipText);
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *line = new QHBoxLayout(this);
    line->addWidget(m_sentence, 1);
    for (const auto &[action, name] : kButtons) {
        auto *button = new QPushButton(this);
        button->setObjectName(name);
        connect(button, &QPushButton::clicked, this, [this, a = action] { emit chosen(a); });
        line->addWidget(button);
        m_buttons[action] = button;
    }
    hide();
    showWords();
}

void RecoveryBanner::showWords()
{
    m_buttons[RecoveryAction::Restore]->setText(tr("&Restore"));
    m_buttons[RecoveryAction::Locate]->setText(tr("L&ocate recordings..."));
    m_buttons[RecoveryAction::Undo]->setText(tr("&Undo"));
    m_buttons[RecoveryAction::Discard]->setText(tr("&Discard"));
    m_buttons[RecoveryAction::NotNow]->setText(tr("&Not now"));
    m_buttons[RecoveryAction::NotNow]->setToolTip(tr("It is offered again at the next start"));
    m_buttons[RecoveryAction::Close]->setText(tr("&Close"));
}

void RecoveryBanner::present(const QString &sentence, const std::vector<RecoveryAction> &actions)
{
    m_sentence->setText(sentence);
    setAccessibleName(sentence);
    for (const auto &[action, button] : m_buttons)
        button->setVisible(std::ranges::find(actions, action) != actions.end());
    show();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

} // namespace dyncal
