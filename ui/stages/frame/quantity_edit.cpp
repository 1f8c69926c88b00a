// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/quantity_edit.h"

#include "ui/stages/frame/refusal_note.h"
#include "ui/text/quantity_format.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kLettersOfNumbers = 15; ///< "2330.121235 kHz"
constexpr int kReadOutDigits = 5; ///< a result has no more to say; tables show as many
constexpr int kBesideNumber_px = 30; ///< frame and arrows

} // namespace

QuantityEdit::QuantityEdit(
    const ShownUnit &unit, double lowest, double highest, int decimals, QWidget *parent)
    : QDoubleSpinBox(parent)
    , m_unit(unit)
{
    setDecimals(decimals);
    setRange(lowest / unit.si, highest / unit.si);
    if (!unit.text.isEmpty())
        setSuffix(" " + unit.text);
    setKeyboardTracking(false);
    setStepType(AdaptiveDecimalStepType);
    setAccelerated(true);
    setFocusPolicy(Qt::StrongFocus);
    lineEdit()->setMaxLength(kMostLettersOfNumber);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this] { emit edited(si()); });
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
        hideRefusal(this);
        m_refused = false;
        m_typing = true;
        emit typingBegan();
    });
    connect(this, &QDoubleSpinBox::editingFinished, this, &QuantityEdit::endTyping);
}

bool QuantityEdit::isTyping() const
{
    return m_typing || (hasFocus() && lineEdit()->isModified());
}

QSize QuantityEdit::minimumSizeHint() const
{
    const QSize least = QDoubleSpinBox::minimumSizeHint();
    const int mostly = fontMetrics().horizontalAdvance(QString(kLettersOfNumbers, QChar('0')))
        + kBesideNumber_px;
    return {std::min(least.width(), mostly), least.height()};
}

void QuantityEdit::setSi(double value)
{
    // Never while the operator is typing: results that arrive meanwhile would eat the text.
    if (isTyping())
        return;
    const QSignalBlocker quiet(this);
    setValue(value / m_unit.si);
}

void QuantityEdit::setShownOnly(bool shownOnly)
{
    setReadOnly(shownOnly);
    setButtonSymbols(shownOnly ? NoButtons : UpDownArrows);
    if (!isTyping())
        lineEdit()->setText(textFromValue(value()) + suffix());
}

void QuantityEdit::endTyping()
{
    if (!m_typing)
        return;
    m_typing = false;
    emit typingEnded(!m_refused);
}

void QuantityEdit::abandonTyping()
{
    lineEdit()->setText(textFromValue(value()) + suffix());
    hideRefusal(this);
    m_refused = true;
    endTyping();
}

/// Escape takes back what was typed, before the window makes anything else of the key.
bool QuantityEdit::event(QEvent *event)
{
    const bool isKey
        = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (isKey && m_typing && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape) {
        if (event->type() == QEvent::KeyPress)
            abandonTyping();
        event->accept();
        return true;
    }
    return QDoubleSpinBox::event(event);
}

/// A wheel that scrolls the page past a field changes nothing in it.
void QuantityEdit::wheelEvent(QWheelEvent *event)
{
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

/// Without the field's unit, which stands behind the number unless it was typed over. Twice, when a
/// number with unit is pasted over the number before the unit.
QString QuantityEdit::bare(QString text) const
{
    text = text.trimmed();
    const QString unit = suffix().trimmed();
    const auto endsNumber = [&](qsizetype end) {
        return end > 0 && !text[end - 1].isLetter() && text[end - 1] != '/';
    };
    while (!unit.isEmpty() && text.endsWith(unit) && endsNumber(text.size() - unit.size())) {
        text.chop(unit.size());
        text = text.trimmed();
    }
    return text;
}

double QuantityEdit::valueFromText(const QString &text) const
{
    return typedQuantity(bare(text), m_unit).value.value_or(value());
}

QString QuantityEdit::textFromValue(double value) const
{
    return shownNumber(value, isReadOnly() ? kReadOutDigits : kFieldDigits);
}

/// Why this is not taken; empty if it is.
QString QuantityEdit::faultOf(const QString &text) const
{
    const TypedQuantity typed = typedQuantity(bare(text), m_unit);
    if (!typed.value)
        return typed.fault;
    if (*typed.value >= minimum() && *typed.value <= maximum())
        return {};
    return tr("%1 is outside %2 to %3.")
        .arg(textFromValue(*typed.value) + suffix(), textFromValue(minimum()),
            textFromValue(maximum()) + suffix());
}

QValidator::State QuantityEdit::validate(QString &text, int &) const
{
    return faultOf(text).isEmpty() ? QValidator::Acceptable : QValidator::Intermediate;
}

void QuantityEdit::fixup(QString &text) const
{
    m_refused = true;
    if (m_typing && isVisible()) // a window that closes takes no more children
        showRefusal(const_cast<QuantityEdit *>(this), faultOf(text));
}

AutoBox::AutoBox(QWidget *parent)
    : QCheckBox(tr("auto"), parent)
{
    setToolTip(tr("Ticked: the program's rule decides. Typing a value unticks it."));
    connect(this, &QCheckBox::clicked, this, [this](bool checked) {
        m_isAuto = checked;
        if (checked)
            emit ticked();
        else
            emit unticked();
    });
}

void AutoBox::setNames(const QString &objectName, const QString &accessibleName)
{
    setObjectName(objectName + "Auto");
    setAccessibleName(tr("%1: automatic").arg(accessibleName));
}

void AutoBox::follow(QuantityEdit *field)
{
    connect(field, &QuantityEdit::typingBegan, this, [this] {
        m_typing = true;
        setChecked(false);
    });
    connect(field, &QuantityEdit::edited, this, [this] {
        m_isAuto = false;
        setChecked(false);
    });
    connect(field, &QuantityEdit::typingEnded, this, [this](bool taken) {
        m_typing = false;
        if (taken && m_isAuto) {
            m_isAuto = false;
            emit unticked();
        }
        setChecked(m_isAuto);
    });
}

void AutoBox::set(bool isAuto)
{
    m_isAuto = isAuto;
    if (!m_typing)
        setChecked(isAuto);
}

AutoEdit::AutoEdit(
    const ShownUnit &unit, double lowest, double highest, int decimals, QWidget *parent)
    : QWidget(parent)
    , m_auto(new AutoBox(this))
    , m_value(new QuantityEdit(unit, lowest, highest, decimals, this))
{
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_value, 1);
    layout->addWidget(m_auto);
    setFocusProxy(m_value);
    m_auto->follow(m_value);
    connect(m_auto, &AutoBox::ticked, this, [this] { emit edited(Auto<double>()); });
    connect(m_auto, &AutoBox::unticked, this, [this] { emit edited(Auto<double>(m_value->si())); });
    connect(
        m_value, &QuantityEdit::edited, this, [this](double si) { emit edited(Auto<double>(si)); });
}

void AutoEdit::setNames(const QString &objectName, const QString &accessibleName)
{
    setObjectName(objectName);
    m_value->setObjectName(objectName + "Value");
    m_value->setAccessibleName(accessibleName);
    m_auto->setNames(objectName, accessibleName);
}

void AutoEdit::set(const Auto<double> &setting, std::optional<double> used)
{
    m_auto->set(setting.isAuto());
    if (setting.value)
        m_value->setSi(*setting.value);
    else if (used)
        m_value->setSi(*used);
}

} // namespace dyncal
