// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/widget/plot_widget.h"
#include "ui/stages/frame/wrapped_controls.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QToolButton>

namespace dyncal::test {

/// What of a window cannot be read: words that do not fit where they stand, plots too low to read,
/// texts of a plot on each other. Collects sentences that name the widget.
class LayoutFaults
{
public:
    explicit LayoutFaults(const QWidget &window)
    {
        if (window.minimumSizeHint().width() > window.width() + kSlack_px)
            m_found << QString("The window needs %1 px of %2")
                           .arg(window.minimumSizeHint().width())
                           .arg(window.width());
        for (const QWidget *widget : window.findChildren<QWidget *>())
            if (widget->isVisible() && widget->width() > 0)
                look(*widget);
    }
    const QStringList &found() const { return m_found; }

private:
    static constexpr int kLeastPlot_px = 120;
    static constexpr int kSlack_px = 1; ///< of rounding

    void look(const QWidget &widget)
    {
        if (qobject_cast<const WrappedCheckBox *>(&widget)
            || qobject_cast<const WrappedButton *>(&widget)
            || qobject_cast<const WrappedComboBox *>(&widget)) {
            lookAtWrapped(widget);
            return;
        }
        if (const auto *label = qobject_cast<const QLabel *>(&widget))
            lookAt(*label);
        else if (const auto *button = qobject_cast<const QAbstractButton *>(&widget))
            lookAt(*button);
        else if (const auto *combo = qobject_cast<const QComboBox *>(&widget))
            lookAt(*combo);
        else if (const auto *edit = qobject_cast<const QLineEdit *>(&widget))
            lookAt(*edit);
        else if (const auto *tabs = qobject_cast<const QTabBar *>(&widget))
            lookAt(*tabs);
        else if (const auto *header = qobject_cast<const QHeaderView *>(&widget))
            lookAt(*header);
        else if (const auto *group = qobject_cast<const QGroupBox *>(&widget))
            needs(*group, group->title(), group->width());
        else if (const auto *area = qobject_cast<const QScrollArea *>(&widget))
            lookAt(*area);
        else if (const auto *list = qobject_cast<const QListWidget *>(&widget))
            lookAt(*list);
        else if (const auto *plot = qobject_cast<const PlotWidget *>(&widget))
            lookAt(*plot);
    }

    void say(const QWidget &widget, const QString &what)
    {
        QString name = widget.objectName();
        for (const QWidget *up = widget.parentWidget(); name.isEmpty() && up;
             up = up->parentWidget())
            name = up->objectName();
        m_found << QString("%1 %2: %3").arg(widget.metaObject()->className(), name, what);
    }
    void needs(const QWidget &widget, const QString &text, int room)
    {
        const int width = widget.fontMetrics().size(Qt::TextShowMnemonic, text).width();
        if (width > room + kSlack_px)
            say(widget, QString("\"%1\" needs %2 of %3").arg(text).arg(width).arg(room));
    }

    /// What goes on in further lines is as high and as wide as it says it must be.
    void lookAtWrapped(const QWidget &widget)
    {
        const QSize least(widget.minimumSizeHint().width(), widget.heightForWidth(widget.width()));
        if (least.width() > widget.width() || least.height() > widget.height())
            say(widget,
                QString("needs %1x%2 of %3x%4")
                    .arg(least.width())
                    .arg(least.height())
                    .arg(widget.width())
                    .arg(widget.height()));
    }
    void lookAt(const QLabel &label)
    {
        if (label.text().isEmpty())
            return;
        if (!label.wordWrap()) {
            const QSize hint = label.sizeHint();
            if (hint.width() > label.width() + kSlack_px
                || hint.height() > label.height() + kSlack_px)
                say(label,
                    QString("\"%1\" needs %2x%3 of %4x%5")
                        .arg(label.text())
                        .arg(hint.width())
                        .arg(hint.height())
                        .arg(label.width())
                        .arg(label.height()));
            return;
        }
        if (label.heightForWidth(label.width()) > label.height() + kSlack_px)
            say(label,
                QString("\"%1\" needs the height %2 of %3")
                    .arg(label.text())
                    .arg(label.heightForWidth(label.width()))
                    .arg(label.height()));
        for (const QString &word : label.text().split(QRegularExpression("[\\s\\-/\\x{200B}]+")))
            needs(label, word, label.contentsRect().width());
    }
    void lookAt(const QAbstractButton &button)
    {
        if (button.text().isEmpty() || qobject_cast<const QTabBar *>(button.parentWidget()))
            return;
        const auto *tool = qobject_cast<const QToolButton *>(&button);
        if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull())
            return; // its text is in the tool tip
        // Besides the text: the box or the frame, and an icon.
        const bool isBox = button.inherits("QCheckBox") || button.inherits("QRadioButton");
        int room = button.width()
            - (isBox ? button.style()->pixelMetric(QStyle::PM_IndicatorWidth)
                        + button.style()->pixelMetric(QStyle::PM_CheckBoxLabelSpacing)
                     : 6);
        if (!button.icon().isNull())
            room -= button.iconSize().width() + 4;
        for (const QString &line :
            button.inherits("QCommandLinkButton") ? QStringList() : button.text().split('\n'))
            needs(button, line, room);
    }
    void lookAt(const QComboBox &combo)
    {
        QStyleOptionComboBox option;
        option.initFrom(&combo);
        option.editable = combo.isEditable();
        const QRect field = combo.style()->subControlRect(
            QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &combo);
        if (!combo.isEditable())
            needs(combo, combo.currentText(), field.width());
    }
    void lookAt(const QLineEdit &edit)
    {
        // What is typed scrolls; what stands there by itself must be seen whole.
        const bool isSpin = qobject_cast<const QAbstractSpinBox *>(edit.parentWidget());
        constexpr int kMargins_px = 4;
        needs(edit,
            edit.text().isEmpty() ? edit.placeholderText()
                : isSpin          ? edit.text()
                                  : QString(),
            edit.width() - kMargins_px);
    }
    void lookAt(const QTabBar &tabs)
    {
        for (int i = 0; i < tabs.count(); ++i)
            if (tabs.isTabVisible(i))
                needs(tabs, tabs.tabText(i), tabs.tabRect(i).width() - 4);
    }
    void lookAt(const QHeaderView &header)
    {
        if (header.orientation() != Qt::Horizontal)
            return;
        for (int i = 0; i < header.count(); ++i)
            if (!header.isSectionHidden(i))
                for (const QString &line :
                    header.model()->headerData(i, Qt::Horizontal).toString().split('\n'))
                    needs(header, line, header.sectionSize(i) - 4);
    }
    /// What cannot be scrolled to; pages are scrolled up and down only.
    void lookAt(const QScrollArea &area)
    {
        const bool isUpAndDown = area.horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff
            || area.objectName() == "pageScroll";
        if (area.widget() && isUpAndDown
            && area.widget()->width() > area.viewport()->width() + kSlack_px)
            say(area,
                QString("%1 wide in %2").arg(area.widget()->width()).arg(area.viewport()->width()));
    }
    void lookAt(const QListWidget &list)
    {
        for (int row = 0; row < list.count(); ++row) {
            const QRect room = list.visualItemRect(list.item(row));
            if (list.itemWidget(list.item(row)))
                continue;
            const int width = room.width() - 6;
            const QRect text = list.fontMetrics().boundingRect(QRect(0, 0, width, 100000),
                list.wordWrap() ? Qt::TextWordWrap : 0, list.item(row)->text());
            if (text.width() > width + 4 || text.height() > room.height() + kSlack_px)
                say(list,
                    QString("\"%1\" needs %2x%3 of %4x%5")
                        .arg(list.item(row)->text())
                        .arg(text.width())
                        .arg(text.height())
                        .arg(width)
                        .arg(room.height()));
        }
    }
    void lookAt(const PlotWidget &plot)
    {
        if (plot.height() < kLeastPlot_px)
            say(plot, QString("%1 px high").arg(plot.height()));
        const std::vector<PlotText> texts = plot.texts();
        for (std::size_t i = 0; i < texts.size(); ++i) {
            if (!texts[i].isWhole)
                say(plot, QString("\"%1\" is cut").arg(texts[i].text));
            for (std::size_t j = 0; j < i; ++j) {
                const QRectF common = texts[i].rect & texts[j].rect;
                if (common.width() > 2.0 && common.height() > 2.0)
                    say(plot, QString("\"%1\" on \"%2\"").arg(texts[i].text, texts[j].text));
            }
        }
    }

    QStringList m_found;
};

} // namespace dyncal::test
