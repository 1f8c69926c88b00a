// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/ascii_text.h"

#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

class TestAsciiText : public QObject
{
    Q_OBJECT

private slots:
    void commaList_namesAllOrTheFirst()
    {
        QCOMPARE(commaList({}), std::string());
        QCOMPARE(commaList({"a"}), std::string("a"));
        QCOMPARE(commaList({"a", "b", "c"}), std::string("a, b, c"));
        QCOMPARE(commaList({"a", "b", "c"}, 3), std::string("a, b, c"));
        QCOMPARE(commaList({"a", "b", "c"}, 2), std::string("a, b, ..."));
    }

    void trimmed_keepsWhatIsBetween()
    {
        QCOMPARE(trimmed(" \ta b\t "), std::string_view("a b"));
        QCOMPARE(trimmed(" \t"), std::string_view());
        QCOMPARE(trimmed("\na"), std::string_view("\na")); // a line break is no blank
    }

    void lowerCase_changesAsciiLettersOnly()
    {
        QCOMPARE(lowerCase("AbZ[@\xc3\x84"), std::string("abz[@\xc3\x84"));
    }
};

DYNCAL_TEST(TestAsciiText)
#include "tst_ascii_text.moc"
