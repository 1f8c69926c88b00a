// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>

class QWidget;

namespace dyncal {

/// While it lives, every control that is shown says what it does when the pointer rests on it: its
/// own tool tip where it has one, else the sentence for its object name, else its accessible name;
/// behind it the keys, where a button has some.
class ControlTips : public QObject
{
public:
    explicit ControlTips(QObject *parent);

private:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

/// The sentence for a control by its object name; empty where there is none.
QString tipFor(const QString &objectName);

} // namespace dyncal
