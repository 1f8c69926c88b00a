// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/work_status.h"

#include "ui/text/progress_format.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStatusBar>

namespace dyncal {

namespace {

/// Work shorter than this shows no progress bar: it would only flicker.
constexpr int kSlow_ms = 300;
constexpr int kProgressWidth_px = 180;

} // namespace

WorkStatus::WorkStatus(QStatusBar &bar, Session &session, FileActions &files, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_files(files)
    , m_message(new QLabel(&bar))
    , m_progress(new QProgressBar(&bar))
    , m_cancel(new QPushButton(&bar))
{
    m_progress->setObjectName("progressBar");
    m_progress->setRange(0, 100);
    m_progress->setFormat(progressFormat());
    m_progress->setFixedWidth(kProgressWidth_px);
    m_cancel->setObjectName("cancelButton");
    m_message->setObjectName("statusMessage");
    for (QWidget *widget : std::initializer_list<QWidget *>{m_message, m_progress, m_cancel})
        bar.addPermanentWidget(widget);
    m_slow.setSingleShot(true);
    m_slow.setInterval(kSlow_ms);
    const auto showFraction
        = [this](double done) { m_progress->setValue(static_cast<int>(100.0 * done)); };
    connect(&files, &FileActions::busy, this, &WorkStatus::showBusy);
    connect(&files, &FileActions::progress, this, showFraction);
    connect(&files, &FileActions::idle, this, &WorkStatus::showIdle);
    connect(&session, &Session::progress, this, showFraction);
    connect(&session, &Session::stageStatusChanged, this, &WorkStatus::showComputing);
    connect(&m_slow, &QTimer::timeout, this, [this] {
        if (m_session.isComputing())
            showBusy(tr("Computing"));
    });
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_files.isBusy())
            m_files.cancel();
        else
            m_session.cancelComputation();
    });
}

void WorkStatus::showWords()
{
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAccessibleName(tr("Cancel the work under way"));
    m_progress->setAccessibleName(tr("Progress"));
    showIdle({});
}

void WorkStatus::showBusy(const QString &what)
{
    m_message->setText(what);
    m_progress->setValue(0);
    m_progress->show();
    m_cancel->show();
}

void WorkStatus::showIdle(const QString &outcome)
{
    m_message->setText(outcome);
    m_progress->hide();
    m_cancel->hide();
}

void WorkStatus::showComputing()
{
    if (m_session.isComputing()) {
        if (!m_slow.isActive() && !m_progress->isVisible())
            m_slow.start();
        return;
    }
    m_slow.stop();
    if (!m_files.isBusy() && m_progress->isVisible())
        showIdle({});
}

} // namespace dyncal
