// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/window/stretch_list.h"

#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/wrapped_controls.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace dyncal {

namespace {

constexpr double kLongestStretch_s = 100.0;
constexpr int kDecimals = 4; ///< of microseconds
constexpr int kListHeight_px = 84;

QString shotsText(const std::vector<Index> &shots)
{
    QStringList numbers;
    for (const Index shot : shots)
        numbers << QString::number(shot);
    return shots.size() == 1 ? StretchList::tr("Shot %1").arg(numbers.join(", "))
                             : StretchList::tr("Shots %1").arg(numbers.join(", "));
}

QString rowText(const StretchRow &row)
{
    const MarkedStretch &stretch = row.stretch;
    QString text = StretchList::tr("%1: %2 to %3")
                       .arg(shotsText(stretch.shots), shownQuantity(stretch.span_s.begin, "s"),
                           shownQuantity(stretch.span_s.end, "s"));
    if (!stretch.reason.empty())
        text += "\n" + shownText(stretch.reason);
    if (!row.remark.isEmpty())
        text += "\n" + row.remark;
    return text;
}

} // namespace

StretchList::StretchList(QWidget *parent)
    : QWidget(parent)
    , m_mark(new WrappedButton(tr("Exclude a stretch"), this))
    , m_list(new QListWidget(this))
    , m_begin(
          new QuantityEdit({"µs", 1e-6}, -kLongestStretch_s, kLongestStretch_s, kDecimals, this))
    , m_end(new QuantityEdit({"µs", 1e-6}, -kLongestStretch_s, kLongestStretch_s, kDecimals, this))
    , m_shot(new WrappedComboBox(this))
    , m_reason(new QLineEdit(this))
    , m_note(new QLabel(this))
    , m_remove(new WrappedButton(tr("Leave in again"), this))
{
    build();
    connectControls();
    showFields();
}

void StretchList::build()
{
    const auto name = [](QWidget *control, const char *objectName, const QString &accessibleName) {
        control->setObjectName(objectName);
        control->setAccessibleName(accessibleName);
    };
    name(m_mark, "stretchMark", tr("Mark a stretch to be left out of the fit"));
    name(m_list, "stretches", tr("Stretches left out of the fit"));
    name(m_begin, "stretchBegin", tr("Begin of the stretch"));
    name(m_end, "stretchEnd", tr("End of the stretch"));
    name(m_shot, "stretchShot", tr("Shots of the stretch"));
    name(m_reason, "stretchReason", tr("Reason for leaving the stretch out"));
    name(m_note, "stretchNote", tr("What the stretch selected needs"));
    name(m_remove, "stretchRemove", tr("Leave the selected stretch in again"));
    m_mark->setCheckable(true);
    m_mark->setToolTip(tr("Then drag over it in a plot; Shift and drag do the same at any time"));
    m_list->setMaximumHeight(kListHeight_px);
    m_list->setWordWrap(true);
    m_list->setTextElideMode(Qt::ElideNone);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWholePlaceholder(*m_reason, tr("needed, is printed"));
    m_note->setWordWrap(true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_mark);
    layout->addWidget(m_list);
    auto *form = new QFormLayout;
    addWrappedRow(*form, tr("Begin"), m_begin);
    addWrappedRow(*form, tr("End"), m_end);
    addWrappedRow(*form, tr("In"), m_shot);
    addWrappedRow(*form, tr("Reason"), m_reason);
    layout->addLayout(form);
    layout->addWidget(m_note);
    layout->addWidget(m_remove);
}

void StretchList::connectControls()
{
    connect(m_mark, &QPushButton::clicked, this, &StretchList::markingRequested);
    connect(m_list, &QListWidget::currentRowChanged, this, &StretchList::showFields);
    connect(m_begin, &QuantityEdit::edited, this, [this](double begin_s) {
        MarkedStretch next = typed();
        next.span_s.begin = begin_s;
        hand(next);
    });
    connect(m_end, &QuantityEdit::edited, this, [this](double end_s) {
        MarkedStretch next = typed();
        next.span_s.end = end_s;
        hand(next);
    });
    connect(m_shot, &QComboBox::activated, this, [this] {
        MarkedStretch next = typed();
        next.shots = chosenShots();
        if (selected() >= 0)
            hand(next);
    });
    connect(m_reason, &QLineEdit::editingFinished, this, [this] {
        MarkedStretch next = typed();
        next.reason = m_reason->text().trimmed().toStdString();
        if (selected() >= 0 && m_reason->isModified())
            hand(next);
    });
    connect(m_remove, &QPushButton::clicked, this, [this] { emit removeRequested(selected()); });
}

void StretchList::show(const std::vector<StretchRow> &rows, const std::vector<ShotChoice> &shots)
{
    const int row = std::min(selected(), static_cast<int>(rows.size()) - 1);
    m_rows = rows;
    m_shots = shots;
    {
        const QSignalBlocker quiet(m_list);
        m_list->clear();
        for (const StretchRow &one : rows)
            m_list->addItem(rowText(one));
        m_list->setCurrentRow(row);
    }
    showFields();
}

void StretchList::select(int row)
{
    m_list->setCurrentRow(row);
}

int StretchList::selected() const
{
    return m_list->currentRow();
}

std::vector<Index> StretchList::chosenShots() const
{
    const auto at = static_cast<std::size_t>(std::max(m_shot->currentIndex(), 0));
    return at < m_offered.size() ? m_offered[at].shots : std::vector<Index>();
}

void StretchList::chooseShots(const std::vector<Index> &shots)
{
    select(-1);
    offerShots(shots);
}

void StretchList::askForReason()
{
    emit reasonWanted();
    m_reason->setFocus();
    for (QWidget *above = parentWidget(); above; above = above->parentWidget())
        if (auto *area = qobject_cast<QScrollArea *>(above))
            area->ensureWidgetVisible(m_remove); // all of it, in an inspector that scrolls
}

void StretchList::setMarking(bool on)
{
    m_mark->setChecked(on);
}

/// The choices, and the shots of the selected stretch where a recipe names others.
void StretchList::offerShots(const std::vector<Index> &needed)
{
    const std::vector<Index> before = needed.empty() ? chosenShots() : needed;
    std::vector<ShotChoice> offered = m_shots;
    const auto hasShots = [&](const ShotChoice &choice) { return choice.shots == before; };
    if (!needed.empty() && std::ranges::none_of(offered, hasShots))
        offered.push_back({shotsText(needed), needed});
    if (offered != m_offered) {
        m_offered = offered;
        m_shot->clear();
        for (const ShotChoice &choice : m_offered)
            m_shot->addItem(choice.text);
    }
    const auto at = std::ranges::find_if(m_offered, hasShots);
    m_shot->setCurrentIndex(at == m_offered.end() ? 0 : static_cast<int>(at - m_offered.begin()));
}

void StretchList::showFields()
{
    const int row = selected();
    m_remove->setEnabled(row >= 0);
    m_reason->setEnabled(row >= 0);
    if (row < 0) {
        offerShots({});
        m_reason->clear();
        m_note->setText(m_rows.empty() ? tr("Everything in the window is fitted.") : QString());
        return;
    }
    const StretchRow &shown = m_rows[static_cast<std::size_t>(row)];
    m_begin->setSi(shown.stretch.span_s.begin);
    m_end->setSi(shown.stretch.span_s.end);
    offerShots(shown.stretch.shots);
    if (!(m_reason->hasFocus() && m_reason->isModified()))
        m_reason->setText(rawText(shown.stretch.reason));
    m_note->setText(shown.remark);
}

MarkedStretch StretchList::typed() const
{
    if (selected() >= 0)
        return m_rows[static_cast<std::size_t>(selected())].stretch;
    return {{m_begin->si(), m_end->si()}, chosenShots(), {}};
}

void StretchList::hand(const MarkedStretch &stretch)
{
    m_reason->setModified(false);
    emit edited(selected(), stretch);
}

} // namespace dyncal
