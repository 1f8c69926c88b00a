// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/ui/support/page_bench.h"

#include <memory>

namespace dyncal::test {

inline void undoAll(Session &session)
{
    while (session.undoStack().canUndo())
        session.undoStack().undo();
    session.undoStack().clear();
    waitComputed(session);
}

/// One page for all tests of a class, as to open the recordings takes most of the time: what a test
/// did to the recipe is undone before the next.
template <typename Page>
class KeptBench
{
public:
    PageBench<Page> &fresh(const std::shared_ptr<const CaptureSet> &set)
    {
        if (m_bench)
            undoAll(m_bench->session);
        else
            m_bench = std::make_unique<PageBench<Page>>(set);
        return *m_bench;
    }

private:
    std::unique_ptr<PageBench<Page>> m_bench;
};

} // namespace dyncal::test
