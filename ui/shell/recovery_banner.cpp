// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/recovery_banner.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace dyncal {

RecoveryBanner::RecoveryBanner(QWidget *parent)
    : QFrame(parent)
    , m_sentence(new QLabel(this))
{
    setObjectName("recoveryBanner");
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    setForegroundRole(QPalette::ToolTipText);
    m_sentence->setObjectName("recoverySentence");
    m_sentence->setForegroundRole(QPalette::ToolTipText);
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *line = new QHBoxLayout(this);
    line->addWidget(m_sentence, 1);
    const auto addButton = [&](const QString &name, void (RecoveryBanner::*signal)()) {
        auto *button = new QPushButton(this);
        button->setObjectName(name);
        connect(button, &QPushButton::clicked, this, signal);
        line->addWidget(button);
        return button;
    };
    m_restore = addButton("restoreWork", &RecoveryBanner::restoreRequested);
    m_discard = addButton("discardWork", &RecoveryBanner::discardRequested);
    m_dismiss = addButton("dismissWork", &RecoveryBanner::dismissed);
    hide();
    showWords();
}

void RecoveryBanner::showWords()
{
    m_restore->setText(tr("&Restore"));
    m_discard->setText(tr("&Discard"));
    m_dismiss->setText(m_isOffer ? tr("&Not now") : tr("&Close"));
    m_dismiss->setToolTip(m_isOffer ? tr("It is offered again at the next start") : QString());
}

void RecoveryBanner::offer(const QString &sentence)
{
    present(sentence, true);
}

void RecoveryBanner::tell(const QString &sentence)
{
    present(sentence, false);
}

void RecoveryBanner::present(const QString &sentence, bool isOffer)
{
    m_isOffer = isOffer;
    m_sentence->setText(sentence);
    setAccessibleName(sentence);
    m_restore->setVisible(isOffer);
    m_discard->setVisible(isOffer);
    showWords();
    show();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void RecoveryBanner::changeEvent(QEvent *event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showWords();
}

} // namespace dyncal
