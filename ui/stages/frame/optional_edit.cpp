// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/optional_edit.h"

#include "ui/stages/frame/refusal_note.h"
#include "ui/text/quantity_format.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kRecordedDigits = 6;
const QString kWidest = QStringLiteral("0000.00000");
constexpr int kFrame_px = 12; ///< of a line edit, with its margins

} // namespace

OptionalEdit::OptionalEdit(const ShownUnit &unit, double lowest, double highest, QWidget *parent)
    : QWidget(parent)
    , m_text(new QLineEdit(this))
    , m_unitLabel(new QLabel(this))
    , m_origin(new QLabel(tr("recorded"), this))
    , m_useRecorded(new QToolButton(this))
    , m_unit(unit)
    , m_lowest(lowest)
    , m_highest(highest)
{
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_unitLabel);
    setUnit(unit);
    layout->addWidget(m_origin);
    layout->addWidget(m_useRecorded);
    m_text->installEventFilter(this);
    m_text->setMaxLength(kMostLettersOfNumber);
    m_origin->setToolTip(tr("This value is the recording's"));
    m_useRecorded->setText(QStringLiteral("↺"));
    m_origin->hide();
    m_useRecorded->hide();
    setEmptyText(tr("not known"));
    setFocusProxy(m_text);
    connect(m_text, &QLineEdit::editingFinished, this, &OptionalEdit::commit);
    connect(m_text, &QLineEdit::textEdited, this, [this] { hideRefusal(this); });
    connect(m_useRecorded, &QToolButton::clicked, this, [this] {
        set(std::nullopt, m_recorded);
        emit edited(std::nullopt);
    });
}

void OptionalEdit::setNames(const QString &objectName, const QString &accessibleName)
{
    setObjectName(objectName);
    m_text->setObjectName(objectName + "Value");
    m_text->setAccessibleName(accessibleName);
    m_origin->setObjectName(objectName + "Origin");
    m_useRecorded->setObjectName(objectName + "UseRecorded");
    m_useRecorded->setAccessibleName(tr("%1: use recorded").arg(accessibleName));
}

void OptionalEdit::setUnit(const ShownUnit &unit)
{
    m_unit = unit;
    m_unitLabel->setText(unit.text);
    m_unitLabel->setVisible(!unit.text.isEmpty());
}

void OptionalEdit::setEmptyText(const QString &text)
{
    m_text->setPlaceholderText(text);
    const QFontMetrics metrics = m_text->fontMetrics();
    m_text->setMinimumWidth(
        std::max(metrics.horizontalAdvance(kWidest), metrics.horizontalAdvance(text)) + kFrame_px);
}

void OptionalEdit::set(const std::optional<double> &value, const std::optional<double> &recorded)
{
    m_value = value;
    m_recorded = recorded;
    if (!m_text->hasFocus() || !m_text->isModified())
        showValue();
}

void OptionalEdit::showValue()
{
    const auto text = [this](double si, int digits) { return shownNumber(si / m_unit.si, digits); };
    m_text->setText(m_value ? text(*m_value, kFieldDigits)
            : m_recorded    ? text(*m_recorded, kRecordedDigits)
                            : QString());
    m_origin->setVisible(!m_value && m_recorded);
    m_useRecorded->setVisible(m_value && m_recorded);
    if (m_recorded)
        m_useRecorded->setToolTip(
            tr("Use recorded: %1").arg(text(*m_recorded, kRecordedDigits) + " " + m_unit.text));
}

/// Escape takes back what was typed, before the window makes anything else of the key.
bool OptionalEdit::eventFilter(QObject *watched, QEvent *event)
{
    const bool isKey
        = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (!isKey || !m_text->isModified() || static_cast<QKeyEvent *>(event)->key() != Qt::Key_Escape)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress)
        showValue();
    event->accept();
    return true;
}

QString OptionalEdit::faultOf(double si) const
{
    if (si >= m_lowest && si <= m_highest)
        return {};
    const auto text = [this](double value) {
        return (shownNumber(value / m_unit.si, kFieldDigits) + " " + m_unit.text).trimmed();
    };
    return tr("%1 is outside %2 to %3.").arg(text(si), text(m_lowest), text(m_highest));
}

/// What cannot be read, or lies outside the range, is not taken: the last good value comes back.
void OptionalEdit::commit()
{
    if (!m_text->isModified())
        return;
    m_text->setModified(false);
    std::optional<double> next;
    if (!m_text->text().trimmed().isEmpty()) {
        const TypedQuantity typed = typedQuantity(m_text->text(), m_unit);
        next = typed.value ? std::optional(*typed.value * m_unit.si) : std::nullopt;
        const QString fault = next ? faultOf(*next) : typed.fault;
        showRefusal(this, fault);
        if (!fault.isEmpty())
            next = m_value;
    }
    const bool changed = next != m_value;
    set(next, m_recorded);
    if (changed)
        emit edited(next);
}

} // namespace dyncal
