// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/stage_status.h"

#include <QListWidget>

namespace dyncal {

/// The list of stages: the only navigation. Number, title, status as glyph and word.
class StageList : public QListWidget
{
    Q_OBJECT

public:
    explicit StageList(QWidget *parent = nullptr);

    void addStage(const QString &title);
    void setStatus(int row, StageStatus status);

private:
    QStringList m_titles;
};

} // namespace dyncal
