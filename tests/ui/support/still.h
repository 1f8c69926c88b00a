// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QElapsedTimer>
#include <QTest>

#include <optional>
#include <utility>

namespace dyncal::test {

/// Handles events until `look` (anything that compares) has given the same three times in a row,
/// as on a busy machine something may be laid out or drawn again after one look; or until patience
/// ends.
template <typename Look>
void waitUntilStill(const Look &look, int patience_ms)
{
    constexpr int kBetween_ms = 40;
    constexpr int kTheSame = 2; // times after the first
    std::optional<decltype(look())> before;
    int same = 0;
    QElapsedTimer waited;
    for (waited.start(); same < kTheSame && waited.elapsed() < patience_ms;) {
        QTest::qWait(kBetween_ms);
        auto now = look();
        same = before == now ? same + 1 : 0;
        before = std::move(now);
    }
}

} // namespace dyncal::test
