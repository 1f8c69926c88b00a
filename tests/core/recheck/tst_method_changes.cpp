// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/method_changes.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;
using MethodJson = nlohmann::json;

class TestMethodChanges : public QObject
{
    Q_OBJECT

private slots:
    void sameVersions_areNoChange()
    {
        QVERIFY(methodChanges(methodVersions(), methodVersions()).empty());
    }

    void everyChangedStep_isNamed()
    {
        const MethodVersions issued{{"gone", 2}, {"model", 1}, {"shock", 1}, {"window", 4}};
        const MethodVersions now{{"checks", 4}, {"model", 6}, {"shock", 1}, {"window", 3}};
        const std::vector<MethodChange> needed{{"checks", std::nullopt, 4},
            {"gone", 2, std::nullopt}, {"model", 1, 6}, {"window", 4, 3}};
        QCOMPARE(methodChanges(issued, now), needed);
    }

    void laterVersion_isKnown()
    {
        QVERIFY(MethodChange({"a", 4, 3}).isOfLaterVersion());
        QVERIFY(MethodChange({"a", 4, std::nullopt}).isOfLaterVersion());
        QVERIFY(!MethodChange({"a", 3, 4}).isOfLaterVersion());
        QVERIFY(!MethodChange({"a", std::nullopt, 4}).isOfLaterVersion());
    }

    void text_namesBothVersions()
    {
        QCOMPARE(MethodChange({"shock", 1, 6}).text(), std::string("shock 1 -> 6"));
        QCOMPARE(MethodChange({"shock", std::nullopt, 6}).text(), std::string("shock 6 (new)"));
        QCOMPARE(MethodChange({"shock", 2, std::nullopt}).text(),
            std::string("shock 2 -> no longer a step"));
    }

    void unrecordedVersions_nameAllAboveTheFirst()
    {
        const std::vector<MethodChange> needed{{"b", std::nullopt, 2}, {"c", std::nullopt, 9}};
        QCOMPARE(methodChanges(std::nullopt, {{"a", 1}, {"b", 2}, {"c", 9}}), needed);
        const auto today = methodChanges(std::nullopt, methodVersions());
        QCOMPARE(std::ssize(today), std::ranges::count_if(methodVersions(), [](const auto &one) {
            return one.second > 1;
        }));
    }

    void versions_areReadFromResults()
    {
        const MethodJson results{{"software", {{"method", {{"model", 6}, {"shock", 2}}}}}};
        const MethodVersions needed{{"model", 6}, {"shock", 2}};
        QVERIFY(statedMethods(results) == needed);
        const MethodJson odd{{"software", {{"method", {{"model", "six"}, {"shock", 1.5}}}}}};
        QVERIFY(statedMethods(odd) == MethodVersions());
    }

    void resultsFromBefore_haveNone()
    {
        QVERIFY(!statedMethods(MethodJson{{"software", {{"version", "0.1.0"}}}}));
        QVERIFY(!statedMethods(MethodJson{{"software", {{"method", nullptr}}}}));
        QVERIFY(!statedMethods(MethodJson::array()));
    }
};

DYNCAL_TEST(TestMethodChanges)
#include "tst_method_changes.moc"
