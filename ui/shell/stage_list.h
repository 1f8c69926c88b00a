// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/page_standing.h"

#include <QKeySequence>
#include <QListWidget>

namespace dyncal {

/// The keys of a page: Alt+1 to Alt+9 from the first, Alt+0 the last (the certificate), and
/// Alt+Y and Alt+J what stands between them; no menu has these letters in any language.
QKeySequence stageKeys(Page page);

/// The list of stages: number, title, and how it stands as a sign of its own shape and colour and
/// as words.
class StageList : public QListWidget
{
    Q_OBJECT

public:
    explicit StageList(QWidget *parent = nullptr);

    void addStage(const QString &title);
    void setStanding(int row, const PageStanding &standing);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void fitRows(); ///< to their words, in as many lines as they need
    void fitRow(int row);
    void fitWidth(); ///< no word is cut

    QStringList m_titles;
    QList<int> m_widestWords; ///< of each row, in pixels
};

} // namespace dyncal
