// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QFrame>

#include <map>
#include <vector>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace dyncal {

/// What the operator can answer.
enum class RecoveryAction { Restore, Locate, Discard, Undo, NotNow, Close };

/// A line above the pages that says what a stopped program left behind and what can be done with
/// it. It waits as long as the operator likes; work goes on below it.
class RecoveryBanner : public QFrame
{
    Q_OBJECT

public:
    explicit RecoveryBanner(QWidget *parent = nullptr);

    void present(const QString &sentence, const std::vector<RecoveryAction> &actions);
    void showWords(); ///< in the language of the moment

signals:
    void chosen(dyncal::RecoveryAction action);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void paintEvent(QPaintEvent *event) override; ///< follows the palette (light, dark)

private:
    QBoxLayout *m_layout;
    QLabel *m_sentence;
    std::map<RecoveryAction, QPushButton *> m_buttons;
};

} // namespace dyncal
