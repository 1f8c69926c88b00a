// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/window/interval_edit.h"

#include "ui/stages/frame/refusal_note.h"

#include <QGridLayout>

namespace dyncal {

namespace {

constexpr int kIntervalDecimals = 4;

} // namespace

IntervalEdit::IntervalEdit(const ShownUnit &unit, double lowest, double highest, QWidget *parent)
    : QWidget(parent)
    , m_begin(new QuantityEdit(unit, lowest, highest, kIntervalDecimals, this))
    , m_end(new QuantityEdit(unit, lowest, highest, kIntervalDecimals, this))
    , m_auto(new AutoBox(this))
{
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_begin, 0, 0);
    layout->addWidget(m_end, 1, 0);
    layout->addWidget(m_auto, 0, 1, 2, 1);
    layout->setColumnStretch(0, 1);
    setFocusProxy(m_begin);
    connect(m_begin, &QuantityEdit::edited, this, &IntervalEdit::commit);
    connect(m_end, &QuantityEdit::edited, this, &IntervalEdit::commit);
    for (QuantityEdit *edge : {m_begin, m_end})
        m_auto->follow(edge);
    connect(m_auto, &AutoBox::ticked, this, [this] { emit edited({}); });
    connect(m_auto, &AutoBox::unticked, this, &IntervalEdit::commit);
}

void IntervalEdit::setNames(const QString &objectName, const QString &accessibleName)
{
    setObjectName(objectName);
    m_begin->setObjectName(objectName + "Begin");
    m_begin->setAccessibleName(tr("%1: begin").arg(accessibleName));
    m_end->setObjectName(objectName + "End");
    m_end->setAccessibleName(tr("%1: end").arg(accessibleName));
    m_auto->setNames(objectName, accessibleName);
}

void IntervalEdit::set(const Auto<Interval> &setting, const std::optional<Interval> &used)
{
    m_auto->set(setting.isAuto());
    const std::optional<Interval> shown = setting.value ? setting.value : used;
    if (!shown)
        return;
    m_begin->setSi(shown->begin);
    m_end->setSi(shown->end);
}

void IntervalEdit::commit()
{
    const Interval band{m_begin->si(), m_end->si()};
    if (band.begin < band.end)
        emit edited(band);
    else
        showRefusal(this, tr("Not taken yet: the begin (above) must lie before the end (below)."));
}

} // namespace dyncal
