// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/quantity_edit.h"

#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

namespace dyncal {

namespace {

constexpr int kShownDigits = 10;
const QString kWidestRecorded = QStringLiteral("294.15");
constexpr int kFrame_px = 12; ///< of a line edit, with its margins

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
    connect(this, &QDoubleSpinBox::valueChanged, this, [this] { emit edited(si()); });
}

void QuantityEdit::setSi(double value)
{
    // Never while the operator is typing: results that arrive meanwhile would eat the text.
    if (hasFocus() && lineEdit()->isModified())
        return;
    const QSignalBlocker quiet(this);
    setValue(value / m_unit.si);
}

void QuantityEdit::setShownOnly(bool shownOnly)
{
    setReadOnly(shownOnly);
    setButtonSymbols(shownOnly ? NoButtons : UpDownArrows);
}

QString QuantityEdit::bare(QString text) const
{
    text = text.trimmed();
    const QString unit = suffix().trimmed();
    // Twice, when a number with unit is pasted over the number before the unit.
    while (!unit.isEmpty() && text.endsWith(unit)) {
        text.chop(unit.size());
        text = text.trimmed();
    }
    return text;
}

double QuantityEdit::valueFromText(const QString &text) const
{
    return typedNumber(bare(text)).value_or(value());
}

QString QuantityEdit::textFromValue(double value) const
{
    return shownNumber(value, kShownDigits);
}

QValidator::State QuantityEdit::validate(QString &text, int &) const
{
    const std::optional<double> number = typedNumber(bare(text));
    if (!number)
        return QValidator::Intermediate;
    return *number >= minimum() && *number <= maximum() ? QValidator::Acceptable
                                                        : QValidator::Intermediate;
}

AutoEdit::AutoEdit(
    const ShownUnit &unit, double lowest, double highest, int decimals, QWidget *parent)
    : QWidget(parent)
    , m_auto(new QCheckBox(tr("auto"), this))
    , m_value(new QuantityEdit(unit, lowest, highest, decimals, this))
{
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_value, 1);
    layout->addWidget(m_auto);
    setFocusProxy(m_value);
    connect(m_auto, &QCheckBox::clicked, this, [this](bool checked) {
        emit edited(checked ? Auto<double>() : Auto<double>(m_value->si()));
    });
    connect(
        m_value, &QuantityEdit::edited, this, [this](double si) { emit edited(Auto<double>(si)); });
}

void AutoEdit::setNames(const QString &objectName, const QString &accessibleName)
{
    setObjectName(objectName);
    m_value->setObjectName(objectName + "Value");
    m_value->setAccessibleName(accessibleName);
    m_auto->setObjectName(objectName + "Auto");
    m_auto->setAccessibleName(tr("%1: automatic").arg(accessibleName));
    m_auto->setToolTip(tr("Ticked: the program's rule decides"));
}

void AutoEdit::set(const Auto<double> &setting, std::optional<double> used)
{
    m_auto->setChecked(setting.isAuto());
    m_value->setShownOnly(setting.isAuto());
    if (setting.value)
        m_value->setSi(*setting.value);
    else if (used)
        m_value->setSi(*used);
}

OptionalEdit::OptionalEdit(const ShownUnit &unit, double lowest, double highest, QWidget *parent)
    : QWidget(parent)
    , m_text(new QLineEdit(this))
    , m_unit(unit)
    , m_emptyText(tr("not known"))
    , m_lowest(lowest)
    , m_highest(highest)
{
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_text, 1);
    if (!unit.text.isEmpty())
        layout->addWidget(new QLabel(unit.text, this));
    m_text->setMinimumWidth(
        m_text->fontMetrics().horizontalAdvance(tr("%1 (recorded)").arg(kWidestRecorded))
        + kFrame_px);
    setFocusProxy(m_text);
    connect(m_text, &QLineEdit::editingFinished, this, &OptionalEdit::commit);
}

void OptionalEdit::setNames(const QString &objectName, const QString &accessibleName)
{
    setObjectName(objectName);
    m_text->setObjectName(objectName + "Value");
    m_text->setAccessibleName(accessibleName);
}

void OptionalEdit::set(const std::optional<double> &value, const std::optional<double> &fallback)
{
    m_value = value;
    m_fallback = fallback;
    if (m_text->hasFocus() && m_text->isModified())
        return;
    m_text->setText(value ? shownNumber(*value / m_unit.si, kShownDigits) : QString());
    m_text->setPlaceholderText(
        fallback ? tr("%1 (recorded)").arg(shownNumber(*fallback / m_unit.si, 6)) : m_emptyText);
}

/// What cannot be read, or lies outside the range, is not taken: the last good value comes back.
void OptionalEdit::commit()
{
    if (!m_text->isModified())
        return;
    m_text->setModified(false);
    std::optional<double> next;
    if (!m_text->text().trimmed().isEmpty()) {
        const std::optional<double> number = typedNumber(m_text->text());
        next = number ? std::optional(*number * m_unit.si) : m_value;
        if (next && (*next < m_lowest || *next > m_highest))
            next = m_value;
    }
    const bool changed = next != m_value;
    set(next, m_fallback);
    if (changed)
        emit edited(next);
}

} // namespace dyncal
