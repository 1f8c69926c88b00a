// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

class QMainWindow;
class QWidget;

namespace dyncal {

void showShortcuts(QMainWindow &window); ///< made of its actions
void showAbout(QWidget *parent); ///< version, build id, licence

} // namespace dyncal
