// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/per_shot.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

class TestPerShot : public QObject
{
    Q_OBJECT

private slots:
    void common_servesEveryShot()
    {
        const PerShot typed = 4.5;
        QVERIFY(typed.isTyped());
        QCOMPARE(typed.of(1), std::optional(4.5));
        QCOMPARE(typed.of(9), std::optional(4.5));
    }

    void list_servesItsShotAlone()
    {
        const PerShot typed({1.0, std::nullopt, 3.0});
        QCOMPARE(typed.of(1), std::optional(1.0));
        QCOMPARE(typed.of(2), std::optional<double>());
        QCOMPARE(typed.of(3), std::optional(3.0));
        QCOMPARE(typed.of(4), std::optional<double>());
        QVERIFY(typed.isTyped());
        QVERIFY(!PerShot(std::vector<std::optional<double>>(3)).isTyped());
        QVERIFY(!PerShot().isTyped());
    }

    void changed_forOneShot_keepsTheOthers()
    {
        QCOMPARE(PerShot().with(2, 3, 7.0), PerShot({std::nullopt, 7.0, std::nullopt}));
        QCOMPARE(PerShot(5.0).with(2, 3, 7.0), PerShot({5.0, 7.0, 5.0})); // as they were
        QCOMPARE(PerShot({1.0, 2.0, 3.0}).with(2, 3, {}), PerShot({1.0, std::nullopt, 3.0}));
        QCOMPARE(PerShot({std::nullopt, 2.0}).with(2, 2, {}), PerShot()); // nothing is left
        QCOMPARE(PerShot(std::vector<std::optional<double>>{1.0}).with(3, 3, 2.0),
            PerShot({1.0, std::nullopt, 2.0}));
    }

    void singleShot_hasACommonValue()
    {
        QCOMPARE(PerShot().with(1, 1, 7.0), PerShot(7.0));
        QCOMPARE(PerShot(7.0).with(1, 1, {}), PerShot());
    }
};

DYNCAL_TEST(TestPerShot)
#include "tst_per_shot.moc"
