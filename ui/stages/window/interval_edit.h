// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/interval.h"
#include "ui/stages/frame/quantity_edit.h"

namespace dyncal {

/// Begin and end of a band, with the box "auto". A begin that is typed behind the end waits for a
/// new end.
class IntervalEdit : public QWidget
{
    Q_OBJECT

public:
    IntervalEdit(const ShownUnit &unit, double lowest, double highest, QWidget *parent = nullptr);

    void setNames(const QString &objectName, const QString &accessibleName);
    void set(const Auto<Interval> &setting, const std::optional<Interval> &used);

signals:
    /// Only bands with begin < end are handed on.
    void edited(const dyncal::Auto<dyncal::Interval> &setting);

private:
    void commit();
    QuantityEdit *m_begin;
    QuantityEdit *m_end;
    AutoBox *m_auto;
};

} // namespace dyncal
