// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QWidget>

#include <vector>

class QPushButton;

namespace dyncal {

/// Buttons in lines, as many in one as there is room for: no word of them is cut.
class ButtonFlow : public QWidget
{
    Q_OBJECT

public:
    explicit ButtonFlow(int indent, QWidget *parent = nullptr);

    QPushButton *add(const QString &objectName, const QString &text);
    bool isEmpty() const { return m_buttons.empty(); }
    /// Puts the buttons where they stand at this width; returns the height that they take.
    int arrange(int width);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    int m_indent;
    std::vector<QPushButton *> m_buttons;
};

} // namespace dyncal
