// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/auto_value.h"

#include <QDoubleSpinBox>

class QCheckBox;

namespace dyncal {

/// A unit as shown beside a number: SI value = shown value * si.
struct ShownUnit
{
    QString text;
    double si = 1.0;
};
inline const ShownUnit kMetre{"m", 1.0};
inline const ShownUnit kMillimetre{"mm", 1e-3};
inline const ShownUnit kMicroseconds{"µs", 1e-6};

/// A number with unit, typed with ',' or '.' as decimal mark, or stepped. Values in and out are SI.
class QuantityEdit : public QDoubleSpinBox
{
    Q_OBJECT

public:
    /// Range in SI units. With `decimals` 0 only whole numbers.
    QuantityEdit(const ShownUnit &unit, double lowest, double highest, int decimals,
        QWidget *parent = nullptr);

    void setSi(double value); ///< without a signal
    /// A value that is shown, not asked for: readable and to be copied, without arrows.
    void setShownOnly(bool shownOnly);
    double si() const { return value() * m_unit.si; }

    double valueFromText(const QString &text) const override;
    QString textFromValue(double value) const override;
    QValidator::State validate(QString &text, int &position) const override;
    void fixup(QString &) const override { } ///< Qt's would read "1,2,3" as 123

signals:
    void edited(double si); ///< by the operator: committed or stepped

private:
    QString bare(QString text) const;
    ShownUnit m_unit;
};

/// A QuantityEdit with the box "auto": ticked, the program's rule decides and the value shows what
/// it decided.
class AutoEdit : public QWidget
{
    Q_OBJECT

public:
    AutoEdit(const ShownUnit &unit, double lowest, double highest, int decimals,
        QWidget *parent = nullptr);

    void setNames(const QString &objectName, const QString &accessibleName);
    /// `used` is what the last run used; shown while `setting` is auto.
    void set(const Auto<double> &setting, std::optional<double> used);

signals:
    void edited(const dyncal::Auto<double> &setting);

private:
    QCheckBox *m_auto;
    QuantityEdit *m_value;
};

/// A number that may be left out: empty text means "not known".
class OptionalEdit : public QWidget
{
    Q_OBJECT

public:
    OptionalEdit(const ShownUnit &unit, double lowest, double highest, QWidget *parent = nullptr);

    void setNames(const QString &objectName, const QString &accessibleName);
    /// What stands there while nothing is known or typed.
    void setEmptyText(const QString &text) { m_emptyText = text; }
    /// `fallback` is shown greyed while nothing is typed: what the recording says.
    void set(const std::optional<double> &value, const std::optional<double> &fallback = {});

signals:
    void edited(const std::optional<double> &si);

private:
    void commit();
    class QLineEdit *m_text;
    ShownUnit m_unit;
    QString m_emptyText;
    double m_lowest;
    double m_highest;
    std::optional<double> m_value;
    std::optional<double> m_fallback;
};

} // namespace dyncal
