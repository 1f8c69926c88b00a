// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/candidates/candidate_text.h"
#include "ui/stages/frame/value_table.h"

namespace dyncal {

/// The pinned orders beside each other; a click on a heading sorts by that column, by value.
class CandidateTable : public ValueTable
{
    Q_OBJECT

public:
    explicit CandidateTable(QWidget *parent = nullptr);

    /// With `reference`, numbers are differences to that row (its own stay as they are).
    void setRows(const std::vector<CandidateRow> &rows, const CandidateRow *reference = nullptr);

signals:
    void chosen(dyncal::Index order); ///< by double click or Enter on a row
};

} // namespace dyncal
