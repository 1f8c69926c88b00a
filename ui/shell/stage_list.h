// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/page_standing.h"

#include <QListWidget>

namespace dyncal {

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

    QStringList m_titles;
};

} // namespace dyncal
