// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/xml_scope.h"
#include "core/xml/xml_limits.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

/// What an XML document may have, counted by its tags.
class TestXmlScope : public QObject
{
    Q_OBJECT

private:
    static std::string names(std::size_t count, const std::string &word)
    {
        std::string text;
        for (std::size_t i = 0; i < count; ++i)
            text += ' ' + word + std::to_string(i) + "='u'";
        return text;
    }
    static std::string repeated(std::size_t count, const std::string &text)
    {
        std::string all;
        for (std::size_t i = 0; i < count; ++i)
            all += text;
        return all;
    }

private slots:
    void namesOfAnElement_areCounted()
    {
        for (const char *word : {"a", "xmlns:a"}) {
            QVERIFY(keepsXmlLimits("<r" + names(kMostXmlNames, word) + "/>"));
            QVERIFY(!keepsXmlLimits("<r" + names(kMostXmlNames + 1, word) + "/>"));
        }
        // What only looks like one.
        QVERIFY(keepsXmlLimits("<r a='" + names(1000, "xmlns:a").substr(0, 1)
            + std::string(1000, '=') + " xmlns xmlns'>" + std::string(1000, '=') + "</r>"));
        for (const auto &[first, last] :
            {std::pair{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?x ", "?>"}})
            QVERIFY(keepsXmlLimits(
                "<r>" + (first + ("<a" + names(1000, "xmlns:a")) + ">") + last + "</r>"));
    }

    void namespacesAround_countToo()
    {
        const std::string half = "<r" + names(kMostXmlNames / 2, "xmlns:a") + ">";
        QVERIFY(keepsXmlLimits(half + half + "</r></r>"));
        QVERIFY(!keepsXmlLimits(half + half + "<a xmlns='u'/></r></r>"));
        // Beside each other they are of no weight.
        QVERIFY(keepsXmlLimits("<r>" + repeated(1000, half + "</r>") + "</r>"));
        QVERIFY(keepsXmlLimits(
            "<r>" + repeated(1000, "<a" + names(kMostXmlNames, "xmlns:a") + "/>") + "</r>"));
    }

    void elementsAndLevels_areCounted()
    {
        const auto deepest = std::size_t(kDeepestXml);
        QVERIFY(keepsXmlLimits(repeated(deepest, "<a>") + repeated(deepest, "</a>")));
        QVERIFY(!keepsXmlLimits(repeated(deepest + 1, "<a>") + repeated(deepest + 1, "</a>")));
        QVERIFY(keepsXmlLimits("<r>" + repeated(kMostXmlElements - 1, "<a/>") + "</r>"));
        QVERIFY(!keepsXmlLimits("<r>" + repeated(kMostXmlElements, "<a/>") + "</r>"));
    }

    void whatIsNoXml_isForTheParser()
    {
        for (const char *text : {"", "text", "<", "<a", "<a b='", "<!--", "<![CDATA[", "<?", "</a>",
                 "</a></b>", "<a/", ">", "=", "<>"})
            QVERIFY2(keepsXmlLimits(text), text);
    }
};

DYNCAL_TEST(TestXmlScope)
#include "tst_xml_scope.moc"
