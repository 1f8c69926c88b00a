// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/tips/control_tips.h"

#include "ui/shell/tips/tip_texts.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct Tips
{
    Q_DECLARE_TR_FUNCTIONS(ControlTips)
};

/// Of every list of entries in the recipe (EntryList), whose controls share a beginning.
constexpr const char *kEntryLists[]{"known", "correlation", "capability", "stated"};
constexpr TipText kEntryTips[]{
    {"List",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Entries of the recipe; the selected one stands in the fields below")},
    {"Add",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Put what stands in the fields into the recipe, as a further entry")},
    {"Replace",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Put what stands in the fields in the place of the selected entry")},
    {"Remove", QT_TRANSLATE_NOOP("ControlTips", "Take the selected entry out of the recipe")},
};

const char *sentenceOfEntries(const QString &name)
{
    for (const char *list : kEntryLists)
        for (const auto &[part, sentence] : kEntryTips)
            if (name == QLatin1String(list) + QLatin1String(part))
                return sentence;
    return nullptr;
}

/// The longest entry that the name is, or, for one that ends in '_' or a digit, begins with.
const char *sentenceFor(const QString &name)
{
    const char *best = nullptr;
    qsizetype length = 0;
    for (const auto &[key, sentence] : tipTexts()) {
        const QLatin1String begin(key);
        const bool isOpen
            = begin.endsWith(QLatin1Char('_')) || begin == QLatin1String("levelOfShot");
        const bool fits = isOpen ? name.startsWith(begin) : name == begin;
        if (fits && begin.size() > length) {
            best = sentence;
            length = begin.size();
        }
    }
    return best;
}

bool isControl(const QWidget &widget)
{
    return qobject_cast<const QAbstractButton *>(&widget)
        || qobject_cast<const QLineEdit *>(&widget)
        || qobject_cast<const QAbstractSpinBox *>(&widget)
        || qobject_cast<const QComboBox *>(&widget)
        || qobject_cast<const QPlainTextEdit *>(&widget);
}

QString keysOf(const QWidget &widget)
{
    const auto *button = qobject_cast<const QAbstractButton *>(&widget);
    return button && !button->shortcut().isEmpty()
        ? " (" + button->shortcut().toString(QKeySequence::NativeText) + ")"
        : QString();
}

void giveTip(QWidget &widget)
{
    // The line of a spin box or a list of choices speaks for the whole.
    const QWidget *owner = widget.parentWidget();
    const bool isPart = owner && isControl(*owner);
    const QWidget &named = isPart ? *owner : widget;
    QString tip = tipFor(named.objectName());
    if (tip.isEmpty())
        tip = named.accessibleName();
    if (const auto *button = qobject_cast<const QAbstractButton *>(&named); tip.isEmpty() && button)
        tip = button->text().remove('&');
    if (!tip.isEmpty())
        widget.setToolTip(tip + keysOf(named));
}

} // namespace

ControlTips::ControlTips(QObject *parent)
    : QObject(parent)
{
    qApp->installEventFilter(this);
}

/// When a control is shown for the first time it has its names; a tip that is taken away later
/// gives way to the control's own.
bool ControlTips::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::Polish && event->type() != QEvent::ToolTipChange)
        return false;
    auto *widget = qobject_cast<QWidget *>(watched);
    if (widget && widget->toolTip().isEmpty() && isControl(*widget))
        giveTip(*widget);
    return false;
}

QString tipFor(const QString &objectName)
{
    for (const auto find : {sentenceFor, sentenceOfEntries})
        if (const char *sentence = find(objectName))
            return Tips::tr(sentence);
    if (objectName.endsWith(QLatin1String("Auto")))
        return Tips::tr("Ticked, the program decides, and the field shows what it took");
    for (const char *part : {"Value", "Begin", "End"})
        if (objectName.endsWith(QLatin1String(part)))
            if (const char *sentence = sentenceFor(objectName.chopped(
                    static_cast<qsizetype>(std::char_traits<char>::length(part)))))
                return Tips::tr(sentence);
    return {};
}

} // namespace dyncal
