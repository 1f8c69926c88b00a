// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

class QString;

namespace dyncal {

class MainWindow;

/// Opens the example in `window`, shows every page in turn and writes each as a PNG into `folder`
/// (made if needed), the certificate once it is drawn: for the documentation and for inspection.
/// `--screenshot-tour FOLDER [en|sv|de [light|dark|high-contrast]]`. False when something failed;
/// stderr says what.
bool runScreenshotTour(MainWindow &window, const QString &folder);

} // namespace dyncal
