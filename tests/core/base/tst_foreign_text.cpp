// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "core/base/message.h"
#include "core/results/csv_table.h"
#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

using namespace dyncal;
using namespace dyncal::test;

class TestForeignText : public QObject
{
    Q_OBJECT

private slots:
    void presentable_showsWhatActs_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("shown");
        const auto row = [](const char *name, const QByteArray &bytes, const QByteArray &shown) {
            QTest::newRow(name) << bytes << shown;
        };
        row("empty", "", "");
        row("escape", "\x1b]0;x\x07", "\\x1b]0;x\\x07");
        row("nul", QByteArray("a\0b", 3), "a\\x00b");
        row("delete", "a\x7f", "a\\x7f");
        row("line", "a\r\nb\tc", "a\\r\\nb\\tc");
        row("control of 8 bits",
            "\xc2\x9b"
            "2J",
            "<U+009B>2J");
        row("override", "a\u202eb", "a<U+202E>b");
        row("isolates", "\u2066\u2069\u200e\u061c", "<U+2066><U+2069><U+200E><U+061C>");
        row("separators", "a\u2028b\u2029c", "a<U+2028>b<U+2029>c");
        row("no width", "p\u200bq\ufeff\u00ad", "p<U+200B>q<U+FEFF><U+00AD>");
        row("joiner in Latin", "a\u200db", "a<U+200D>b");
        row("tags", "x\U000e0041", "x<U+E0041>");
        row("no character", "\xef\xbf\xbf \xee\x80\x80", "<U+FFFF> <U+E000>");
        row("no UTF-8", "a\xff\x80z", "a\uFFFD\uFFFDz");
        row("cut short", "\xe2\x82", "\uFFFD");
        row("cut short within", "\xe2\x82q", "\uFFFDq");
        row("too long a form", "\xc0\xaf", "\uFFFD\uFFFD");
        row("surrogate", "\xed\xa0\x80", "\uFFFD\uFFFD\uFFFD");
        row("beyond", "\xf4\x90\x80\x80", "\uFFFD\uFFFD\uFFFD\uFFFD");
    }
    void presentable_showsWhatActs()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QByteArray, shown);
        QCOMPARE(QByteArray::fromStdString(presentable(bytes.toStdString())), shown);
    }

    void presentable_ordinaryText_isUnchanged()
    {
        for (const char *text : {"p1 (V)", "Tr\u00f6sk\u00e4nslighet f\u00f6r \u00b5V/kPa",
                 "\u5727\u529b\u30bb\u30f3\u30b5\u30fc", "e\u0301 n\u0303",
                 "\u0645\u06cc\u200c\u062e",
                 "\U0001F468\u200d\U0001F469\u200d\U0001F467 \u2764\ufe0f", "10\u00a0%", "\uFFFD",
                 "<b>%1 &amp; \\x1b\\n</b>", "/tmp/a b/c.csv"})
            QCOMPARE(presentable(text), std::string(text));
    }

    void presentable_keepsLinesWhereAsked()
    {
        QCOMPARE(
            presentable("a\r\nb\n\tc\rd\x1b", LineBreaks::Keep), std::string("a\nb\n\tc\\rd\\x1b"));
    }

    /// Valid UTF-8 without controls whatever comes in, and nothing changes a second time.
    void presentable_randomBytes_areFitAndStay()
    {
        std::mt19937 random(12);
        for (int i = 0; i < 20000; ++i) {
            std::string bytes(random() % 12, '\0');
            for (char &byte : bytes)
                byte = static_cast<char>(random() % 3 ? 0x80 + random() % 128 : random() % 128);
            const std::string shown = presentable(bytes);
            QVERIFY2(isFitToShow(shown), QByteArray::fromStdString(bytes).toHex());
            QCOMPARE(presentable(shown), shown);
        }
    }

    void hostileTexts_areFitInEveryForm()
    {
        QVERIFY(hostileTexts().size() >= 40);
        for (const std::string &text : hostileTexts()) {
            QVERIFY2(isFitToShow(presentable(text)), text.c_str());
            QVERIFY2(isFitToShow(presentableInBrief(text)), text.c_str());
            QVERIFY(QString::fromStdString(presentableInBrief(text)).toUcs4().size()
                <= qsizetype(kLongestInSentence));
            QVERIFY2(isFitToShow(spreadsheetText(text)), text.c_str());
            QVERIFY2(isFitToShow(csvCell(text)), text.c_str());
        }
    }

    void brief_keepsHeadAndTail()
    {
        QCOMPARE(presentableInBrief("abcdefghij", 10), std::string("abcdefghij"));
        QCOMPARE(presentableInBrief("abcdefghijk", 10), std::string("abcdef\u2026ijk"));
        const std::string wide = presentableInBrief(std::string(1000000, '\x01') + "end", 12);
        QVERIFY(wide.starts_with("\\x01") && wide.ends_with("end"));
    }

    void arguments_areNotExpandedAgain()
    {
        const Message message{"%1 and %2", {"%2 %1 %n", "x"}};
        QCOMPARE(english(message), std::string("%2 %1 %n and x"));
    }

    void arguments_comeOutFit()
    {
        for (const std::string &text : hostileTexts())
            QVERIFY2(isFitToShow(english({"It holds %1.", {text}})), text.c_str());
        QCOMPARE(english({"It holds %1.", {"a\nDone."}}), std::string("It holds a\\nDone.."));
    }

    void sentencesBelow_standOnLinesOfTheirOwn()
    {
        const Message message{"%1 files:", {"2"}, {{"%1 is none.", {"a\nb"}}, {"c", {}}}};
        QCOMPARE(english(message), std::string("2 files:\na\\nb is none.\nc"));
    }

    void spreadsheet_formulasAreText_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("cell");
        const auto row = [](const char *text, const char *cell) {
            QTest::newRow(text) << QByteArray(text) << QByteArray(cell);
        };
        row("=cmd|' /C calc'!A0", "'=cmd|' /C calc'!A0");
        row("+1+1", "'+1+1");
        row("-2+3", "'-2+3");
        row("@SUM(A1)", "'@SUM(A1)");
        row("-A1", "'-A1");
        row("  =1+1", "'  =1+1");
        row("x;=1+1", "x;'=1+1");
        row("\uff1d1+1", "'\uff1d1+1");
        for (const char *number : {"-1.5e-3", "+2", "-2,33 MHz", "-1.2 \u00d710^-7 1/Pa", "-0.5 %",
                 "-1.5 \u00b1 0.2 mV", "-", "12", "\u2013", "a=b", "f0 (Hz)", "1e-3", "-.5"})
            row(number, number);
        row("\t=1", "\\t=1");
        row("-1 =cmd", "'-1 =cmd");
        row("-1e", "'-1e");
    }
    void spreadsheet_formulasAreText()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, cell);
        QCOMPARE(QByteArray::fromStdString(spreadsheetText(text.toStdString())), cell);
    }

    void json_readsBackAsTheSame()
    {
        for (const std::string &text : hostileTexts()) {
            const nlohmann::json json{{"text", text}};
            const std::string written = jsonText(json);
            QVERIFY2(isFitToShow(written, LineBreaks::Keep), text.c_str());
            const auto replaced = nlohmann::json::parse(
                json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
            QVERIFY2(nlohmann::json::parse(written) == replaced, text.c_str());
        }
        const nlohmann::json usual{{"unit", "\u00b5V/Pa \u2013 \u5727"}};
        QCOMPARE(jsonText(usual), usual.dump(2) + "\n");
    }
};

DYNCAL_TEST(TestForeignText)
#include "tst_foreign_text.moc"
