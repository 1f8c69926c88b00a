// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

#include <QWidget>

#include <vector>

namespace dyncal {

/// The shots of the job in the status bar: number, level and the line style of their curves.
class ShotChips : public QWidget
{
    Q_OBJECT

public:
    explicit ShotChips(QWidget *parent = nullptr);

    /// `set` with the recipe's import section applied, so that levels and exclusions are those in
    /// use.
    void setShots(const CaptureSet &set);

private:
    struct Chip
    {
        QString text;
        QString meaning;
        bool isStruck = false;

        bool operator==(const Chip &) const = default;
    };
    static Chip chipOf(const Shot &shot, std::size_t number);

    std::vector<Chip> m_chips;
};

} // namespace dyncal
