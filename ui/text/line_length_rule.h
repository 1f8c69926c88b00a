// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>

namespace dyncal {

/// Letters that a line of text takes: several times an address or a path.
inline constexpr int kMostLettersOfLine = 2000;

/// While it lives, no line of text that is shown takes more letters, unless it says itself how many
/// or holds more already. Else a table that was copied from a plot and pasted by mistake stays in
/// the undo of every line for as long as the window lives, twenty bytes a letter.
class LineLengthRule : public QObject
{
public:
    LineLengthRule();

private:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace dyncal
