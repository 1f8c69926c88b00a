// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/wrapped_controls.h"

#include "ui/text/broken_text.h"

#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QTimer>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kTextFlags = Qt::TextShowMnemonic;
constexpr int kAroundComboText_px = 4;
constexpr int kAroundFieldText_px = 14;

/// Qt's own are never higher than one line, and never narrower than all their words in one.
void mayBeHigher(QWidget &control)
{
    QSizePolicy policy = control.sizePolicy();
    policy.setHorizontalPolicy(QSizePolicy::Preferred);
    policy.setVerticalPolicy(QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    control.setSizePolicy(policy);
}

int widestWord(const QFontMetrics &metrics, const QString &text)
{
    int widest = 0;
    for (const QString &word : text.split(QChar(' ')))
        widest = std::max(widest, metrics.size(kTextFlags, word).width());
    return widest;
}

} // namespace

WrappedCheckBox::WrappedCheckBox(const QString &text, QWidget *parent)
    : QCheckBox(text, parent)
{
    mayBeHigher(*this);
}

int WrappedCheckBox::besideText() const
{
    return style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, this)
        + style()->pixelMetric(QStyle::PM_CheckBoxLabelSpacing, nullptr, this) + 2;
}

int WrappedCheckBox::heightForWidth(int width) const
{
    const QString broken = brokenText(fontMetrics(), text(), width - besideText());
    return std::max(sizeHint().height(), fontMetrics().size(kTextFlags, broken).height() + 2);
}

QSize WrappedCheckBox::minimumSizeHint() const
{
    return {besideText() + widestWord(fontMetrics(), text()), sizeHint().height()};
}

void WrappedCheckBox::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text = brokenText(fontMetrics(), text(), width() - besideText());
    painter.drawControl(QStyle::CE_CheckBox, option);
}

WrappedButton::WrappedButton(const QString &text, QWidget *parent)
    : QPushButton(text, parent)
{
    mayBeHigher(*this);
}

/// Frame, margins and icon.
int WrappedButton::besideText() const
{
    return QPushButton::sizeHint().width() - fontMetrics().size(kTextFlags, text()).width();
}

int WrappedButton::heightForWidth(int width) const
{
    const int oneLine = fontMetrics().size(kTextFlags, text()).height();
    const QString broken = brokenText(fontMetrics(), text(), width - besideText());
    return sizeHint().height() + fontMetrics().size(kTextFlags, broken).height() - oneLine;
}

QSize WrappedButton::minimumSizeHint() const
{
    return {besideText() + widestWord(fontMetrics(), text()), sizeHint().height()};
}

void WrappedButton::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text = brokenText(fontMetrics(), text(), width() - besideText());
    painter.drawControl(QStyle::CE_PushButton, option);
}

WrappedComboBox::WrappedComboBox(QWidget *parent)
    : QComboBox(parent)
{
    mayBeHigher(*this);
    connect(this, &QComboBox::currentTextChanged, this, [this] {
        updateGeometry();
        // A form that is just being laid out keeps the height it has asked for before.
        QTimer::singleShot(0, this, [this] { updateGeometry(); });
    });
    // Also where its own signals are blocked while it is filled.
    connect(model(), &QAbstractItemModel::rowsInserted, this, [this] { updateGeometry(); });
    connect(model(), &QAbstractItemModel::dataChanged, this, [this] { updateGeometry(); });
}

QRect WrappedComboBox::textRect(const QRect &all) const
{
    QStyleOptionComboBox option;
    initStyleOption(&option);
    option.rect = all;
    return style()
        ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this)
        .adjusted(kAroundComboText_px, 0, 0, 0);
}

int WrappedComboBox::heightForWidth(int width) const
{
    const QSize hint = QComboBox::sizeHint();
    const int room = textRect({0, 0, width, hint.height()}).width();
    const int oneLine = fontMetrics().height();
    const QString broken = brokenText(fontMetrics(), currentText(), room);
    return hint.height() + std::max(0, fontMetrics().size(0, broken).height() - oneLine);
}

QSize WrappedComboBox::minimumSizeHint() const
{
    int widest = 0;
    for (int i = 0; i < count(); ++i)
        widest = std::max(widest, widestWord(fontMetrics(), itemText(i)));
    const QSize hint = QComboBox::sizeHint();
    return {hint.width() - textRect({QPoint(), hint}).width() + widest, hint.height()};
}

/// Qt's counts letters of an average width.
QSize WrappedComboBox::sizeHint() const
{
    return QComboBox::sizeHint().expandedTo(minimumSizeHint());
}

void WrappedComboBox::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    const QRect room = textRect(rect());
    style()->drawItemText(&painter, room, Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(),
        brokenText(fontMetrics(), currentText(), room.width()), QPalette::ButtonText);
}

FormLabel::FormLabel(const QString &text, QWidget *parent)
    : QLabel(text, parent)
{
    setWordWrap(true);
}

QSize FormLabel::sizeHint() const
{
    return fontMetrics().size(kTextFlags, text()) + QSize(2, 2);
}

QSize FormLabel::minimumSizeHint() const
{
    return {widestWord(fontMetrics(), text()) + 2, sizeHint().height()};
}

void setWholePlaceholder(QLineEdit &field, const QString &text)
{
    field.setPlaceholderText(text);
    field.setMinimumWidth(field.fontMetrics().horizontalAdvance(text) + kAroundFieldText_px);
}

void addWrappedRow(QFormLayout &form, const QString &label, QWidget *field)
{
    auto *words = new FormLabel(label);
    words->setBuddy(field);
    form.setRowWrapPolicy(QFormLayout::WrapLongRows);
    form.addRow(words, field);
}

} // namespace dyncal
