// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/text/typed_quantity.h"

#include <QWidget>

#include <optional>

class QLabel;
class QLineEdit;
class QToolButton;

namespace dyncal {

/// A number that may be left out: empty text means "not known". What the recording says stands in
/// the field as a value, with its origin beside it; once another is typed, a button goes back.
class OptionalEdit : public QWidget
{
    Q_OBJECT

public:
    OptionalEdit(const ShownUnit &unit, double lowest, double highest, QWidget *parent = nullptr);

    void setNames(const QString &objectName, const QString &accessibleName);
    /// Another unit for what stands there from now on; set() follows.
    void setUnit(const ShownUnit &unit);
    /// What stands there while nothing is known or typed.
    void setEmptyText(const QString &text);
    /// `recorded` is what the recording says, and holds while nothing is typed.
    void set(const std::optional<double> &value, const std::optional<double> &recorded = {});

signals:
    void edited(const std::optional<double> &si);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void commit();
    void showValue();
    QString faultOf(double si) const;
    QLineEdit *m_text;
    QLabel *m_unitLabel;
    QLabel *m_origin;
    QToolButton *m_useRecorded;
    ShownUnit m_unit;
    double m_lowest;
    double m_highest;
    std::optional<double> m_value;
    std::optional<double> m_recorded;
};

} // namespace dyncal
