// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

class QWidget;

namespace dyncal {

/// Says below a field why what was typed was not taken, until something else is typed there or the
/// operator has had time to read it. One note a window: the last refusal.
void showRefusal(QWidget *field, const QString &sentence);

/// Takes the note of this field away.
void hideRefusal(QWidget *field);

/// The note on show in this field's window; empty if there is none.
QString refusalOnShow(const QWidget *field);

} // namespace dyncal
