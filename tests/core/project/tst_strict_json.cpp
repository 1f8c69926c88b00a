// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/strict_json.h"
#include "tests/support/test_program.h"

#include <QTest>

using dyncal::ErrorKind;
using dyncal::parseStrictJson;

class TestStrictJson : public QObject
{
    Q_OBJECT

private:
    static std::string sentence(const std::string &text)
    {
        const auto parsed = parseStrictJson(text, "The recipe");
        if (parsed)
            return "(accepted)";
        return parsed.error().kind == ErrorKind::Usage ? dyncal::english(parsed.error().message)
                                                       : "(wrong kind)";
    }

private slots:
    void wellFormed_isRead()
    {
        const auto parsed = parseStrictJson(" {\"a\": [1, 2.5, null, true, \"x\"]}\n", "x");
        QVERIFY(parsed.has_value());
        QCOMPARE(parsed->at("a").size(), std::size_t(5));
        QCOMPARE(parsed->at("a").at(1).get<double>(), 2.5);
    }

    void sameKeyInDifferentObjects_isRead()
    {
        QCOMPARE(sentence(R"({"a": {"x": 1}, "b": {"x": 1}, "c": [{"x": 1}, {"x": 1}]})"),
            std::string("(accepted)"));
    }

    void duplicateKey_isNamed()
    {
        QCOMPARE(sentence(R"({"a": {"x": 1, "y": 2, "x": 3}})"),
            std::string("The recipe holds the key \"x\" twice; remove one of them."));
    }

    void malformed_givesLineAndColumn_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("place");
        // Columns count bytes of the line from 1, as editors do for plain text.
        QTest::newRow("stray comma")
            << QByteArray("{\n  \"a\": 1,\n}") << QByteArray("line 3, column 1,");
        QTest::newRow("bare word")
            << QByteArray("{\"a\": nope}") << QByteArray("line 1, column 8,");
        QTest::newRow("behind the end") << QByteArray("{}\n{}") << QByteArray("line 2, column 1,");
        QTest::newRow("cut off") << QByteArray("{\"a\":") << QByteArray("near the end");
        QTest::newRow("empty") << QByteArray() << QByteArray("near the end");
        QTest::newRow("comment") << QByteArray("{ // no\n}") << QByteArray("line 1, column 3,");
        QTest::newRow("not a number") << QByteArray("[NaN]") << QByteArray("line 1, column 2,");
        QTest::newRow("single quotes") << QByteArray("{'a': 1}") << QByteArray("line 1, column 2,");
    }

    void malformed_givesLineAndColumn()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, place);
        const std::string found = sentence(text.toStdString());
        QVERIFY2(found.find(place.toStdString()) != std::string::npos, found.c_str());
        QVERIFY2(found.starts_with("The recipe is not valid JSON"), found.c_str());
    }

    void numberBeyondDouble_isRefused()
    {
        QVERIFY(sentence("{\"a\": 1e999}").starts_with("The recipe is not valid JSON"));
    }

    void invalidUtf8_isRefused()
    {
        QVERIFY(sentence("{\"a\": \"\xff\xfe\"}").starts_with("The recipe is not valid JSON"));
    }

    void deepNesting_isRefusedWithoutOverflow()
    {
        const std::string bomb(5000000, '[');
        QVERIFY(sentence(bomb).find("deeper than the 16 levels") != std::string::npos);
        std::string objects;
        for (int i = 0; i < 100000; ++i)
            objects += "{\"a\":";
        QVERIFY(sentence(objects).find("deeper than the 16 levels") != std::string::npos);
    }

    void deepestAllowed_isRead()
    {
        const auto depth = static_cast<std::size_t>(dyncal::kDeepestJson);
        QCOMPARE(
            sentence(std::string(depth, '[') + std::string(depth, ']')), std::string("(accepted)"));
    }
};

DYNCAL_TEST(TestStrictJson)
#include "tst_strict_json.moc"
