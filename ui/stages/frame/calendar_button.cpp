// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/calendar_button.h"

#include "ui/stages/frame/layout_scale.h"

#include <QCalendarWidget>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>

namespace dyncal {

namespace {

/// Below the field, or above it where the screen ends.
QPoint placeFor(const QWidget &popup, const QWidget &field)
{
    const QRect screen = field.screen()->availableGeometry();
    const QSize size = popup.sizeHint();
    QPoint place = field.mapToGlobal(QPoint(0, field.height()));
    if (place.y() + size.height() > screen.bottom())
        place.setY(field.mapToGlobal(QPoint(0, 0)).y() - size.height());
    place.setX(std::clamp(
        place.x(), screen.left(), std::max(screen.left(), screen.right() - size.width())));
    return place;
}

QPushButton *addButton(QHBoxLayout &row, const QString &words, const char *name)
{
    auto *button = new QPushButton(words);
    button->setObjectName(name);
    button->setAutoDefault(false);
    row.addWidget(button);
    return button;
}

} // namespace

CalendarButton::CalendarButton(QLineEdit &field, QWidget *parent)
    : QToolButton(parent)
    , m_field(field)
{
    setArrowType(Qt::DownArrow);
    setToolTip(tr("Choose the day in a calendar"));
    setAccessibleName(toolTip());
    connect(this, &QToolButton::clicked, this, &CalendarButton::openCalendar);
}

void CalendarButton::openCalendar()
{
    auto *popup = new QFrame(this, Qt::Popup);
    popup->setObjectName("calendarPopup");
    popup->setAttribute(Qt::WA_DeleteOnClose);
    popup->setFrameShape(QFrame::StyledPanel);
    auto *column = new QVBoxLayout(popup);
    column->setContentsMargins(scale::kSmall, scale::kSmall, scale::kSmall, scale::kSmall);
    auto *calendar = new QCalendarWidget;
    calendar->setLocale(QLocale());
    calendar->setFirstDayOfWeek(Qt::Monday); // as weeks of ISO 8601 begin
    calendar->setAccessibleName(toolTip());
    const QDate typed = QDate::fromString(m_field.text().trimmed(), Qt::ISODate);
    calendar->setSelectedDate(typed.isValid() ? typed : QDate::currentDate());
    column->addWidget(calendar);
    auto *row = new QHBoxLayout;
    auto *today = addButton(*row, tr("Today"), "calendarToday");
    auto *none = addButton(*row, tr("No date"), "calendarNone");
    column->addLayout(row);
    const auto choose = [this, popup](const QString &text) {
        popup->close();
        take(text);
    };
    const auto chooseDay = [choose](QDate day) { choose(day.toString(Qt::ISODate)); };
    connect(calendar, &QCalendarWidget::clicked, popup, chooseDay);
    connect(calendar, &QCalendarWidget::activated, popup, chooseDay); // Return
    connect(today, &QPushButton::clicked, popup, [chooseDay] { chooseDay(QDate::currentDate()); });
    connect(none, &QPushButton::clicked, popup, [choose] { choose({}); });
    popup->move(placeFor(*popup, m_field));
    popup->show();
    calendar->setFocus();
}

void CalendarButton::take(const QString &text)
{
    m_field.setText(text);
    emit m_field.editingFinished();
}

QHBoxLayout *rowWithCalendar(QLineEdit &field, const QString &buttonName)
{
    auto *row = new QHBoxLayout;
    row->addWidget(&field);
    auto *calendar = new CalendarButton(field);
    calendar->setObjectName(buttonName);
    row->addWidget(calendar);
    return row;
}

} // namespace dyncal
