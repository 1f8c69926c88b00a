// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace dyncal {

/// A line above the pages that says what a stopped program left behind and what can be done with
/// it. It waits as long as the operator likes; work goes on below it.
class RecoveryBanner : public QFrame
{
    Q_OBJECT

public:
    explicit RecoveryBanner(QWidget *parent = nullptr);

    void offer(const QString &sentence); ///< with Restore, Discard, Not now
    void tell(const QString &sentence); ///< with Close

signals:
    void restoreRequested();
    void discardRequested();
    void dismissed(); ///< Not now, or Close

protected:
    void changeEvent(
        QEvent *event) override; ///< its colours follow the palette, its words the language

private:
    void present(const QString &sentence, bool isOffer);
    void showWords();

    QLabel *m_sentence;
    QPushButton *m_restore;
    QPushButton *m_discard;
    QPushButton *m_dismiss;
    bool m_isOffer = false;
};

} // namespace dyncal
