// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <QString>

class QWidget;

namespace dyncal {

/// By object name; one that ends in '*' is the first that begins so. Null where there is none.
QWidget *controlIn(QWidget &root, const QString &name);

/// Gives the focus to a control of a page or of its inspector, out of the tab or the scrolled area
/// where it may be hidden; to the page where there is no such control.
void bringIntoView(QWidget &page, QWidget &inspector, const QString &name);

/// From now on what gets the focus by Tab or by a key, and is hardly in view, is scrolled into
/// view. What is clicked is in view already, and stays where it is.
void keepFocusInView(QWidget &window);

/// Where the focus went to the table of the shots: the row of a shot, from 1; 0 = none.
void selectShot(QWidget &page, Index shot);

} // namespace dyncal
