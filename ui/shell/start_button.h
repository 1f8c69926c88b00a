// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QPushButton>

namespace dyncal {

/// A large button with a line below its text that says what comes. In the letters that the user
/// chose: QCommandLinkButton has 9 points whatever these are.
class StartButton : public QPushButton
{
    Q_OBJECT

public:
    StartButton(const QString &text, QString hint, QWidget *parent);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QFont headingFont() const;

    QString m_hint;
};

} // namespace dyncal
