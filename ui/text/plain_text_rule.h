// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>

namespace dyncal {

/// While it lives, no label of the application guesses whether its text is HTML: labels, tooltips
/// and message boxes show what they are given as it stands. Foreign text that looks like HTML could
/// otherwise open the files that it names. A label with rich text of the program itself sets
/// Qt::RichText; cmake/check_foreign_text.cmake knows where that may be.
class PlainTextRule : public QObject
{
public:
    explicit PlainTextRule(QObject *parent);

private:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace dyncal
