// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/start_page.h"

#include "ui/shell/start_button.h"
#include "ui/stages/frame/wrapped_controls.h"

#include <QFrame>
#include <QIcon>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace dyncal {

StartPage::StartPage(QWidget *parent)
    : QWidget(parent)
{
    setObjectName("startPage");
    auto *inside = new QWidget;
    auto *column = new QVBoxLayout;
    auto *logo = new QLabel(this);
    logo->setPixmap(QIcon(":/icons/dyncal.svg").pixmap(72, 72));
    auto *title = new FormLabel(tr("Dynamic calibration of pressure sensors"), this);
    title->setAlignment(Qt::AlignCenter);
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * 1.8);
    title->setFont(font);
    column->addWidget(logo, 0, Qt::AlignHCenter);
    column->addWidget(title);
    column->addSpacing(18);

    const auto addButton = [&](const QString &name, const QString &text, const QString &hint,
                               void (StartPage::*signal)()) {
        auto *button = new StartButton(text, hint, this);
        button->setObjectName(name);
        button->setAccessibleName(text);
        button->setAccessibleDescription(hint);
        button->setMinimumWidth(480);
        connect(button, &QPushButton::clicked, this, signal);
        column->addWidget(button);
    };
    addButton("startOpenCaptures", tr("Open captures..."),
        tr("The recordings of one sensor: one or more shots from a shock tube"),
        &StartPage::openCapturesRequested);
    addButton("startOpenExample", tr("Open example (3 shots)"),
        tr("A simulated sensor with a resonance at 2.33 MHz, to try every stage on"),
        &StartPage::openExampleRequested);
    addButton("startOpenProject", tr("Open project..."),
        tr("Go on with a calibration saved earlier"), &StartPage::openProjectRequested);

    column->addSpacing(12);
    auto *zone = new FormLabel(tr("Or drop recordings, a folder or a project here."), this);
    zone->setObjectName("dropZone");
    zone->setAlignment(Qt::AlignCenter);
    zone->setMinimumHeight(110);
    zone->setFrameStyle(QFrame::StyledPanel | QFrame::Sunken);
    column->addWidget(zone);

    auto *layout = new QGridLayout(inside);
    layout->addLayout(column, 1, 1);
    layout->setRowStretch(0, 1);
    layout->setRowStretch(2, 2);
    layout->setColumnStretch(0, 1);
    layout->setColumnStretch(2, 1);
    auto *area = new QScrollArea(this); // large letters on a small screen
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidgetResizable(true);
    area->setWidget(inside);
    auto *whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(area);
}

} // namespace dyncal
