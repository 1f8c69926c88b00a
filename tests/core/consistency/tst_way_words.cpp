// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/way_words.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cctype>
#include <functional>
#include <set>
#include <vector>

using namespace dyncal;

namespace {

std::vector<std::string> quantities()
{
    std::vector<std::string> list;
    for (int i = 0; i <= static_cast<int>(Compared::Levels); ++i)
        list.push_back(english(comparedText(static_cast<Compared>(i))));
    return list;
}

std::vector<std::string> ways()
{
    std::vector<std::string> list;
    for (int i = 0; i <= static_cast<int>(Way::Steps); ++i)
        list.push_back(english(wayText(static_cast<Way>(i))));
    return list;
}

bool isCapital(const std::string &text)
{
    return std::isupper(static_cast<unsigned char>(text.front())) != 0;
}

} // namespace

class TestWayWords : public QObject
{
    Q_OBJECT

private slots:
    void everyQuantity_hasATextOfItsOwn();
    void everyWay_hasATextOfItsOwn();
    void beyondTheList_isNothing();
};

void TestWayWords::everyQuantity_hasATextOfItsOwn()
{
    const auto texts = quantities();
    QCOMPARE(std::set<std::string>(texts.begin(), texts.end()).size(), std::size_t(10));
    for (const std::string &text : texts) {
        QVERIFY(!text.empty() && text.find('%') == std::string::npos);
        QVERIFY(isCapital(text) || text.front() == 'p'); // begins a row; p2, p5 are symbols
    }
}

void TestWayWords::everyWay_hasATextOfItsOwn()
{
    const auto texts = ways();
    QCOMPARE(std::set<std::string>(texts.begin(), texts.end()).size(), std::size_t(17));
    for (const std::string &text : texts) {
        QVERIFY(!text.empty() && text.find('%') == std::string::npos);
        QVERIFY(!isCapital(text)); // stands within a row
    }
}

void TestWayWords::beyondTheList_isNothing()
{
    QVERIFY(english(comparedText(static_cast<Compared>(10))).empty());
    QVERIFY(english(wayText(static_cast<Way>(17))).empty());
}

DYNCAL_TEST(TestWayWords)
#include "tst_way_words.moc"
