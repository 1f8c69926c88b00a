// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/order/first_triplets_bar.h"

#include "ui/session/session.h"
#include "ui/text/progress_format.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace dyncal {

namespace {

constexpr int kSlow_ms = 300; ///< as the window waits before it shows that it computes
constexpr int kProgressWidth = 160;

} // namespace

FirstTripletsBar::FirstTripletsBar(Session &session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_text(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_cancel(new QPushButton(tr("Cancel"), this))
    , m_compute(new QPushButton(tr("Compute the rest (F9)"), this))
{
    setObjectName("firstTripletsBar");
    m_text->setObjectName("firstTripletsText");
    m_text->setWordWrap(true);
    m_progress->setObjectName("firstTripletsProgress");
    m_progress->setAccessibleName(tr("Singular values computed"));
    m_progress->setRange(0, 100);
    m_progress->setFormat(progressFormat());
    m_progress->setFixedWidth(kProgressWidth);
    m_cancel->setObjectName("cancelWholeSet");
    m_cancel->setToolTip(tr("Stop computing; the first singular values stay"));
    m_compute->setObjectName("computeWholeSet");
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_text, 1);
    for (QWidget *control : std::initializer_list<QWidget *>{m_progress, m_cancel, m_compute})
        row->addWidget(control);
    m_slow.setSingleShot(true);
    m_slow.setInterval(kSlow_ms);
    connect(&m_slow, &QTimer::timeout, this, &FirstTripletsBar::refresh);
    connect(m_cancel, &QPushButton::clicked, &session, &Session::cancelComputation);
    connect(m_compute, &QPushButton::clicked, &session, &Session::recompute);
    connect(&session, &Session::stageStatusChanged, this, &FirstTripletsBar::refresh);
    connect(&session, &Session::progress, this,
        [this](double done) { m_progress->setValue(static_cast<int>(100.0 * done)); });
    refresh();
}

void FirstTripletsBar::refresh()
{
    if (!m_session.showsFirstTriplets() || !m_session.results().decomposition) {
        m_slow.stop();
        hide();
        return;
    }
    const bool computing = m_session.isComputing();
    m_text->setText(sentence());
    m_progress->setVisible(computing);
    m_cancel->setVisible(computing);
    m_compute->setVisible(!computing);
    if (isVisibleTo(parentWidget()) || m_slow.isActive())
        return;
    if (!computing || sender() == &m_slow) {
        m_progress->setValue(0);
        show();
    } else {
        m_slow.start();
    }
}

QString FirstTripletsBar::sentence() const
{
    const HankelDecomposition &first = m_session.results().decomposition->hankel;
    const RealizationSettings &settings = m_session.recipe().realization;
    const Index all = wholeSetSize(first, settings);
    if (m_session.needsWholeSet())
        return m_session.isComputing()
            ? tr("Order %1 needs all %2 singular values, which are being computed.")
                  .arg(settings.order.value.value_or(0))
                  .arg(all)
            : tr("Order %1 needs all %2 singular values, whose computation was cancelled.")
                  .arg(settings.order.value.value_or(0))
                  .arg(all);
    const QString shown
        = tr("First %1 of %2 singular values.").arg(first.singularValues.size()).arg(all);
    return shown + QLatin1Char(' ')
        + (m_session.isComputing() ? tr("The rest follows; everything here is of the first ones.")
                                   : tr("The rest was cancelled; reports and exports need it."));
}

} // namespace dyncal
