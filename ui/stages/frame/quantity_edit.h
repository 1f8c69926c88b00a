// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/auto_value.h"
#include "ui/text/typed_quantity.h"

#include <QCheckBox>
#include <QDoubleSpinBox>

namespace dyncal {

inline const ShownUnit kMetre{"m", 1.0};
inline const ShownUnit kMillimetre{"mm", 1e-3};
inline const ShownUnit kMicroseconds{"µs", 1e-6};

/// A number, typed with its unit or in the field's own (typedQuantity), or stepped. What is typed
/// and cannot be taken is said below the field, and the last value comes back. Values in and out
/// are SI.
class QuantityEdit : public QDoubleSpinBox
{
    Q_OBJECT

public:
    /// Range in SI units. With `decimals` 0 only whole numbers.
    QuantityEdit(const ShownUnit &unit, double lowest, double highest, int decimals,
        QWidget *parent = nullptr);

    void setSi(double value); ///< without a signal
    /// Makes it a read-out (or an editor again): to be read and copied, without arrows.
    void setShownOnly(bool shownOnly);
    /// Room for most numbers with their unit, not for the extremes of its range.
    QSize minimumSizeHint() const override;
    double si() const { return value() * m_unit.si; }

    double valueFromText(const QString &text) const override;
    QString textFromValue(double value) const override;
    QValidator::State validate(QString &text, int &position) const override;
    /// Qt's would read "1,2,3" as 123. Called with what was left in the field and is refused.
    void fixup(QString &text) const override;

signals:
    void edited(double si); ///< by the operator: committed or stepped
    void typingBegan();
    /// Behind edited(); `taken`: what was typed is a value, be it the one that stood there.
    void typingEnded(bool taken);

protected:
    bool event(QEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    QString bare(QString text) const;
    QString faultOf(const QString &text) const;
    void endTyping();
    void abandonTyping();
    bool isTyping() const;
    ShownUnit m_unit;
    bool m_typing = false;
    mutable bool m_refused = false;
};

/// The box "auto" of one field or several: ticked, the program's rule decides. Typing in a field
/// unticks it.
class AutoBox : public QCheckBox
{
    Q_OBJECT

public:
    explicit AutoBox(QWidget *parent = nullptr);

    void setNames(const QString &objectName, const QString &accessibleName);
    void follow(QuantityEdit *field);
    /// As the recipe has it; not while something is being typed.
    void set(bool isAuto);

signals:
    void ticked();
    void unticked(); ///< by hand, or because the value that stands there was typed

private:
    bool m_isAuto = false;
    bool m_typing = false;
};

/// A QuantityEdit with the box "auto": ticked, the value shows what the program's rule decided.
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
    AutoBox *m_auto;
    QuantityEdit *m_value;
};

} // namespace dyncal
