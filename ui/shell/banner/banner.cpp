// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/banner/banner.h"

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
constexpr std::array<std::pair<BannerAction, const char *>, 7> kButtons{{
    {BannerAction::Restore, "restoreWork"},
    {BannerAction::ReadAgain, "readAgain"},
    {BannerAction::Locate, "locateRecordings"},
    {BannerAction::Undo, "undoDiscard"},
    {BannerAction::Discard, "discardWork"},
    {BannerAction::NotNow, "postponeWork"},
    {BannerAction::Close, "closeBanner"},
}};

} // namespace

Banner::Banner(const QString &subject, QWidget *parent)
    : QFrame(parent)
    , m_layout(new QBoxLayout(QBoxLayout::LeftToRight, this))
    , m_sentence(new QLabel(this))
{
    setObjectName(subject + "Banner");
    setFrameShape(QFrame::StyledPanel);
    m_sentence->setObjectName(subject + "Sentence");
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

void Banner::showWords()
{
    m_buttons[BannerAction::Restore]->setText(tr("&Restore"));
    m_buttons[BannerAction::ReadAgain]->setText(tr("Read a&gain"));
    m_buttons[BannerAction::Locate]->setText(tr("L&ocate recordings..."));
    m_buttons[BannerAction::Undo]->setText(tr("&Undo"));
    m_buttons[BannerAction::Discard]->setText(tr("&Discard"));
    m_buttons[BannerAction::NotNow]->setText(tr("&Not now"));
    m_buttons[BannerAction::NotNow]->setToolTip(tr("It is offered again at the next start"));
    m_buttons[BannerAction::Close]->setText(tr("&Close"));
}

void Banner::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    standFor(width());
}

void Banner::standFor(int width)
{
    m_layout->setDirection(width < kNarrow_px ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void Banner::paintEvent(QPaintEvent *event)
{
    QPainter(this).fillRect(
        rect(), mixed(palette().window().color(), palette().highlight().color(), kTint));
    QFrame::paintEvent(event);
}

void Banner::present(const QString &sentence, const std::vector<BannerAction> &actions)
{
    m_sentence->setText(sentence);
    setAccessibleName(sentence);
    for (const auto &[action, button] : m_buttons)
        button->setVisible(std::ranges::find(actions, action) != actions.end());
    // What is hidden has no width yet, so that it would come up as high as for another one, and all
    // below it would jump: it is laid out before it is first seen.
    if (parentWidget() && isHidden())
        standFor(parentWidget()->width());
    show();
    m_layout->activate();
    if (parentWidget() && parentWidget()->layout())
        parentWidget()->layout()->activate();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

} // namespace dyncal
