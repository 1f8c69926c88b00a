// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>

namespace dyncal {

/// While it lives, no label of the application guesses whether its text is HTML: labels, tooltips
/// and message boxes show what they are given as it stands. Text of files that looks like HTML
/// would otherwise open whatever it names. A label whose text is the program's own says
/// Qt::RichText itself; cmake/check_foreign_text.cmake knows where that may be.
class PlainTextRule : public QObject
{
public:
    explicit PlainTextRule(QObject *parent);

private:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace dyncal
