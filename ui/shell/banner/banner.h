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
enum class BannerAction { Restore, ReadAgain, Locate, Undo, Discard, NotNow, Close };

/// A line above the pages that says what has happened and what can be done about it. It waits as
/// long as the operator likes; work goes on below it.
class Banner : public QFrame
{
    Q_OBJECT

public:
    /// "recovery" makes a "recoveryBanner" with a "recoverySentence".
    explicit Banner(const QString &subject, QWidget *parent = nullptr);

    void present(const QString &sentence, const std::vector<BannerAction> &actions);
    void showWords(); ///< in the language of the moment

signals:
    void chosen(dyncal::BannerAction action);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void paintEvent(QPaintEvent *event) override; ///< follows the palette (light, dark)

private:
    void standFor(int width); ///< buttons beside the sentence, or under it
    QBoxLayout *m_layout;
    QLabel *m_sentence;
    std::map<BannerAction, QPushButton *> m_buttons;
};

} // namespace dyncal
