// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/text_encoding.h"
#include "tests/support/test_program.h"

#include "core/base/ascii_text.h"

#include <QTest>

using namespace dyncal;

class TestTextEncoding : public QObject
{
    Q_OBJECT

private slots:
    void utf8Text_foreignBytes_areWindows1252();
};

void TestTextEncoding::utf8Text_foreignBytes_areWindows1252()
{
    QCOMPARE(utf8Text("\xC2\xB5s"), std::string("\xC2\xB5s"));
    QCOMPARE(utf8Text("\xB5s"), std::string("\xC2\xB5s"));
    QCOMPARE(utf8Text("plain"), std::string("plain"));
    QCOMPARE(lowerCase("\xC3\x85 Time"), std::string("\xC3\x85 time"));
}

DYNCAL_TEST(TestTextEncoding)
#include "tst_text_encoding.moc"
