// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/xml_element.h"
#include "tests/support/test_program.h"

#include <pugixml.hpp>

#include <QTest>

using namespace dyncal;

class TestXmlElement : public QObject
{
    Q_OBJECT

private slots:
    void document_isWrittenLineByLine()
    {
        XmlElement root{"a", {{"b", "c\"<"}}};
        root.add({"d", {}, "1 < 2 & 3"});
        root.add({"e"});
        QCOMPARE(QString::fromStdString(xmlText(root)),
            QString("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a b=\"c&quot;&lt;\">\n"
                    " <d>1 &lt; 2 &amp; 3</d>\n <e />\n</a>\n"));
    }

    /// Anything that anybody types comes out well-formed.
    void everyByte_makesAReadableDocument()
    {
        std::string all;
        for (int byte = 0; byte < 256; ++byte)
            all.push_back(static_cast<char>(byte));
        XmlElement root{"a", {{"b", all}}, all};
        pugi::xml_document read;
        QVERIFY(read.load_string(xmlText(root).c_str()));
        const QByteArray text = read.document_element().child_value();
        for (const char c : text)
            QVERIFY(static_cast<unsigned char>(c) >= 32 || c == '\n' || c == '\t' || c == '\r');
        QVERIFY(QString::fromUtf8(text).toUtf8() == text);
    }

    void add_givesTheChild()
    {
        XmlElement root{"a"};
        root.add({"b"}).add({"c", {}, "x"});
        QCOMPARE(root.children.front().children.front().text, std::string("x"));
    }

    void inOneLine_hasSingleBlanks_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("line");
        QTest::newRow("as it is") << "a b"
                                  << "a b";
        QTest::newRow("ends") << "  a b\n"
                              << "a b";
        QTest::newRow("between") << "a \n  b"
                                 << "a b";
        QTest::newRow("nothing") << " \n "
                                 << "";
        QTest::newRow("letters") << "Bor\u00e5s"
                                 << "Bor\u00e5s";
    }
    void inOneLine_hasSingleBlanks()
    {
        QFETCH(QString, text);
        QFETCH(QString, line);
        QCOMPARE(QString::fromStdString(inOneLine(text.toStdString())), line);
    }
};

DYNCAL_TEST(TestXmlElement)
#include "tst_xml_element.moc"
