// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/recovery/recovery_banner.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include <algorithm>
#include <array>
#include <utility>

namespace dyncal {

namespace {

/// Below this width the buttons go under the sentence.
constexpr int kNarrow_px = 900;
/// Share of the highlight colour in the background: noticed at once, and as easy to read as the
/// rest.
constexpr double kTint = 0.2;

QColor mixed(const QColor &a, const QColor &b, double partOfB)
{
    const auto mix = [&](int x, int y) { return qRound(x + partOfB * (y - x)); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

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
    , m_layout(new QBoxLayout(QBoxLayout::LeftToRight, this))
    , m_sentence(new QLabel(this))
{
    setObjectName("recoveryBanner");
    setFrameShape(QFrame::StyledPanel);
    m_sentence->setObjectName("recoverySentence");
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_layout->addWidget(m_sentence, 1);
    auto *line = new QHBoxLayout;
    line->addStretch(1);
    m_layout->addLayout(line);
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

void RecoveryBanner::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    m_layout->setDirection(
        width() < kNarrow_px ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void RecoveryBanner::paintEvent(QPaintEvent *event)
{
    QPainter(this).fillRect(
        rect(), mixed(palette().window().color(), palette().highlight().color(), kTint));
    QFrame::paintEvent(event);
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
