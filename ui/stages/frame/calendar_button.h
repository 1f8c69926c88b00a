// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QToolButton>

class QDate;
class QHBoxLayout;
class QLineEdit;

namespace dyncal {

/// Opens a calendar for the date of a field. The field holds it as text, 2026-01-31 (ISO 8601), or
/// nothing, and is typed in as before: what is no date may stand there until it is corrected.
class CalendarButton : public QToolButton
{
    Q_OBJECT

public:
    explicit CalendarButton(QLineEdit &field, QWidget *parent = nullptr);

    void openCalendar(); ///< at the date of the field, else at today's

private:
    void take(const QString &text); ///< as if it had been typed

    QLineEdit &m_field;
};

/// A row of the field and its calendar, whose button gets this object name.
QHBoxLayout *rowWithCalendar(QLineEdit &field, const QString &buttonName);

} // namespace dyncal
