// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

class QWidget;

namespace dyncal {

void showShortcuts(QWidget *parent);
void showAbout(QWidget *parent); ///< version, build id, licence

} // namespace dyncal
