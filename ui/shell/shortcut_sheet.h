// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

#include <utility>
#include <vector>

class QAction;
class QMainWindow;

namespace dyncal {

/// The words of an action without the mark of its mnemonic and without dots.
QString plainText(const QAction &action);

/// What the keys do: keys and words of every action in the menus that has keys, in their order.
std::vector<std::pair<QString, QString>> shortcutsOf(const QMainWindow &window);

/// The same for plots, which have no actions, and for the mouse.
std::vector<std::pair<QString, QString>> plotShortcuts();

} // namespace dyncal
