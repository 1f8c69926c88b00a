// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// XML 1.0 as libxml2 judges it, without building anything.

#include "core/xml/well_formed.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QTest>

using namespace dyncal;

class TestWellFormed : public QObject
{
    Q_OBJECT

private slots:
    void soundDocuments_haveNoFault()
    {
        for (const char *text : {"<a/>", "\xEF\xBB\xBF<a>\xC3\xA5</a>", "<p:a>&#65;&lt;</p:a>",
                 "<?xml version='1.0' encoding='ISO-8859-1'?><a>\xC3\xA5</a>",
                 "<a x:b='1' b='2'><![CDATA[<]]><!-- c --><?d e?></a>"})
            QVERIFY2(!faultOfXml(text), text);
    }

    void faults_haveTheirLine()
    {
        for (const char *text : {"<a>\n&#0;</a>", "<a>\n&#xFFFF;</a>", "<a>\n&e;</a>", "<a>\n</b>",
                 "<a>\n<b c='1' c='1'/></a>", "<a>\n"}) {
            const auto fault = faultOfXml(text);
            QVERIFY2(fault && fault->line == 2 && !fault->what.empty(), text);
        }
        QVERIFY(faultOfXml("").has_value());
    }

    /// A document that was cut off anywhere is none; one that is put behind another neither.
    void everyPart_isAFault()
    {
        const std::string whole
            = "<?xml version='1.0'?><a b='1'>x<c/>&#65;<![CDATA[<]]><!-- d --><?e f?>\xC3\xA5</a>";
        QVERIFY(!faultOfXml(whole));
        for (std::size_t size = 0; size < whole.size(); ++size)
            QVERIFY2(faultOfXml(std::string_view(whole).substr(0, size)),
                qPrintable(QString::number(size)));
        QVERIFY(faultOfXml(whole + "<a/>").has_value());
        QVERIFY(faultOfXml("x" + whole).has_value());
        QVERIFY(!faultOfXml(whole + "\n<!-- behind -->\n"));
    }

    /// XML 1.0, 2.2: no control characters but tab and line ends, neither as such nor as a number.
    void controlCharacters_areFaults()
    {
        for (int code = 0; code < 0x20; ++code) {
            const bool isBlank = code == '\t' || code == '\n' || code == '\r';
            std::string text = "<a>x</a>";
            text[3] = static_cast<char>(code);
            QCOMPARE(faultOfXml(text).has_value(), !isBlank);
            text = "<a>&#" + std::to_string(code) + ";</a>";
            QCOMPARE(faultOfXml(text).has_value(), !isBlank);
        }
    }

    /// Linear in the bytes, however long one text is.
    void largeTexts_takeTheirTime()
    {
        constexpr std::size_t kBytes = 20000000;
        constexpr int kAmple_ms = 15000;
        QElapsedTimer timer;
        timer.start();
        QVERIFY(!faultOfXml("<a>" + std::string(kBytes, 'x') + "</a>"));
        QVERIFY(timer.elapsed() < kAmple_ms);
    }
};

DYNCAL_TEST(TestWellFormed)
#include "tst_well_formed.moc"
