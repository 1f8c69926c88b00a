// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QWidget>

namespace dyncal {

/// What is shown before anything is open: three ways to begin, and where to drop files.
class StartPage : public QWidget
{
    Q_OBJECT

public:
    explicit StartPage(QWidget *parent = nullptr);

signals:
    void openCapturesRequested();
    void openExampleRequested();
    void openProjectRequested();
};

} // namespace dyncal
