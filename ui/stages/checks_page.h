// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/stage_page.h"

namespace dyncal {

class ValueTable;

/// Stage 9: every quantity that is known in two independent ways, both beside each other.
class ChecksPage : public StagePage
{
    Q_OBJECT

public:
    explicit ChecksPage(Session &session);

protected:
    void showRecipe() override { }
    void showResults() override;

private:
    ValueTable *m_table;
    QLabel *m_summary;
};

} // namespace dyncal
