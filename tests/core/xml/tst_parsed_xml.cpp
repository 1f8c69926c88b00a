// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// An XML document as values, and what is refused before anything is made of it.

#include "core/xml/parsed_xml.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <string>

using namespace dyncal;

namespace {

std::string faultOf(const std::string &bytes)
{
    const Result<ParsedElement> root = readXml(bytes);
    return root ? std::string() : english(root.error().message);
}

/// ASCII as UTF-16.
std::string wide(const std::string &text, bool bigEndian)
{
    std::string bytes = bigEndian ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : text)
        bytes += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
}

} // namespace

class TestParsedXml : public QObject
{
    Q_OBJECT

private slots:
    void elements_haveNameTextLineAndAttributes()
    {
        const auto root
            = readXml("<?xml version=\"1.0\"?>\n<p:a xmlns:p=\"n\" id=\"x\">\n  <q:b>1 2"
                      "<!-- and -->\n 3 </q:b><b/>\n</p:a>\n");
        QVERIFY(root.has_value());
        QCOMPARE(root->name, std::string("a"));
        QCOMPARE(root->line, Index(2));
        QCOMPARE(root->attribute("id"), std::string("x"));
        QCOMPARE(root->attribute("none"), std::string());
        QCOMPARE(root->all("b").size(), std::size_t(2));
        QCOMPARE(root->child("b")->text, std::string("1 2\n 3 "));
        QCOMPARE(root->child("b")->trimmedText(), std::string("1 2\n 3"));
        QCOMPARE(root->textAt({"b"}), std::string("1 2\n 3")); // around the comment
        QCOMPARE(root->child("b")->line, Index(3));
        QCOMPARE(root->all("b")[1]->line, Index(4));
    }

    void paths_endWhereSomethingIsMissing()
    {
        const auto root = readXml("<a><b><c>7</c></b></a>");
        QCOMPARE(root->textAt({"b", "c"}), std::string("7"));
        QVERIFY(!root->at({"b", "d"}) && !root->at({"x", "c"}));
        QCOMPARE(root->textAt({"x", "c"}), std::string());
    }

    void encodings_areKnown()
    {
        const std::string text = "<a>7</a>";
        for (const bool bigEndian : {true, false})
            QCOMPARE(readXml(wide(text, bigEndian))->text, std::string("7"));
        QCOMPARE(readXml("\xEF\xBB\xBF<a>\xC3\xA5</a>")->text, std::string("\xC3\xA5"));
        QCOMPARE(readXml("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><a>\xE5</a>")->text,
            std::string("\xC3\xA5"));
        QVERIFY(faultOf("<a>\xE5</a>").find("UTF-8") != std::string::npos);
    }

    void malformedOnes_areRefused_withTheirLine()
    {
        QVERIFY(faultOf("<a>\n<b>\n</a>").find("Line 3") != std::string::npos);
        for (const char *text :
            {"", "text", "<a>", "<a></b>", "<a/><b/>", "<a b=c/>", "<a><!-- </a>"})
            QVERIFY2(!faultOf(text).empty(), text);
    }

    /// External files, growing entities: both need a document type.
    void documentTypes_areRefused()
    {
        for (const char *text : {"<!DOCTYPE a><a/>", "<!DOCTYPE a SYSTEM 'http://x/y.dtd'><a/>",
                 "<!DOCTYPE a [<!ENTITY e SYSTEM 'file:///etc/passwd'>]><a>&e;</a>"})
            QVERIFY2(faultOf(text).find("DOCTYPE") != std::string::npos, text);
        QCOMPARE(readXml("<a>&amp;&lt;</a>")->text, std::string("&<"));
    }

    /// What pugixml passes over: entities that nobody declares, characters that are none, an
    /// attribute twice.
    void malformedText_isRefused_withItsLine()
    {
        for (const char *text : {"<a>\n5.2&#0;e-6</a>", "<a>\n&e;</a>", "<a>\n5&#12;6</a>",
                 "<a>\n5\x01</a>", "<a>\n<b c='1' c='2'/></a>", "<a>\n]]></a>", "<a>\n&</a>",
                 "<a>\n<b c='<'/></a>", "<a>\n<!-- -- --></a>"})
            QVERIFY2(faultOf(text).find("Line 2 of the XML file is malformed") == 0,
                (text + (": " + faultOf(text))).c_str());
        QVERIFY(faultOf("<?xml version='1.0' encoding='UTF-16'?><a/>").empty()); // it is UTF-8
        QVERIFY(faultOf("\xEF\xBB\xBF \n<?xml version='1.0'?><a/>").empty());
        QVERIFY(faultOf(" \n<?xml version='1.0'?><a>\n&#0;</a>").find("Line 3 ") == 0);
    }

    /// Blanks part words, though only between comments, instructions or empty sections.
    void blanksBetweenComments_partWords()
    {
        for (const char *between : {"<!----> <!---->", "<?a?> <?a?>", "<![CDATA[]]> <![CDATA[]]>",
                 "<!-- -->\n<?a b?>", "<![CDATA[ ]]>"})
            QCOMPARE(wordsIn(readXml("<a>5" + std::string(between) + "6</a>")->text),
                (std::vector<std::string>{"5", "6"}));
        QCOMPARE(readXml("<a>5<!-- -->6</a>")->text, std::string("56"));
        QCOMPARE(readXml("<a> <b/> \n <!-- --> <c/> </a>")->text, std::string());
    }

    void namespacesThatAreNotKnown_areInTheNames()
    {
        const auto isKnown = [](std::string_view address) { return address == "known"; };
        const auto root = readXml("<p:a xmlns:p='known'><p:b xmlns:p='evil'><p:c/></p:b><p:d/>"
                                  "<q:e/><f xmlns='evil'><g xmlns=''/></f><h/></p:a>",
            isKnown);
        QCOMPARE(root->name, std::string("a"));
        QVERIFY(root->at({"{evil}b", "{evil}c"}) && root->at({"{evil}f", "g"}));
        QVERIFY(root->child("d") && root->child("{q:}e") && root->child("h"));
        QCOMPARE(readXml("<p:a xmlns:p='evil'/>")->name, std::string("a"));
    }

    void limits_areHeld()
    {
        const auto nested = [](int depth) {
            std::string text;
            for (int i = 0; i < depth; ++i)
                text += "<a>";
            for (int i = 0; i < depth; ++i)
                text += "</a>";
            return text;
        };
        QVERIFY(faultOf(nested(kDeepestXml)).empty());
        QVERIFY(faultOf(nested(kDeepestXml + 1)).find("nested") != std::string::npos);
        QVERIFY(faultOf(nested(400000)).find("nested") != std::string::npos);
        std::string many = "<a>";
        for (std::size_t i = 0; i + 1 < kMostXmlElements; ++i)
            many += "<b/>";
        QVERIFY(faultOf(many + "</a>").empty());
        for (std::size_t i = 0; i <= kMostXmlElements; ++i)
            many += "<b/>";
        QVERIFY(faultOf(many + "</a>").find("tags") != std::string::npos);
        QVERIFY(faultOf("<a>" + std::string(kMostXmlBytes, ' ') + "</a>").find("bytes")
            != std::string::npos);
        const std::size_t left = kMostXmlBytes - std::string_view("<a></a>").size();
        QCOMPARE(readXml("<a>" + std::string(left, 'x') + "</a>")->text.size(), left);
    }

    /// A transfer may end anywhere: what is left is refused, or is no other document.
    void cutAnywhere_isRefused()
    {
        const std::string whole = "<?xml version=\"1.0\"?>\n<p:a b='c'>1 &lt; <d/>\xC3\xA5</p:a>";
        for (std::size_t size = 0; size < whole.size(); ++size)
            QVERIFY2(!readXml(whole.substr(0, size)), std::to_string(size).c_str());
        QCOMPARE(readXml(whole)->text, std::string("1 < \xC3\xA5"));
    }

    /// Each byte replaced by each of those that mean something: read or refused, and nothing else.
    void anyByteChanged_isReadOrRefused()
    {
        const std::string whole = "<?xml version=\"1.0\"?><p:a b='c'>1&amp;<d/><!-- e --></p:a>";
        int read = 0, refused = 0;
        for (std::size_t at = 0; at < whole.size(); ++at)
            for (const char byte : {'<', '>', '&', '!', '?', '/', '\'', ' ', '\xFF', '\0'}) {
                std::string mutant = whole;
                mutant[at] = byte;
                const Result<ParsedElement> root = readXml(mutant);
                ++(root ? read : refused);
                QVERIFY(root || root.error().kind == ErrorKind::FileUnreadable);
            }
        QVERIFY2(read > 50 && refused > 200, std::to_string(read).c_str());
    }

    void attributes_areWithoutPrefix_theFirstOfANameCounts()
    {
        const auto root = readXml("<a x:b='1' b='2' c='&#65;&amp;'/>");
        QCOMPARE(root->attributes.size(), std::size_t(3));
        QCOMPARE(root->attribute("b"), std::string("1"));
        QCOMPARE(root->attribute("c"), std::string("A&"));
        QCOMPARE(root->attribute("x:b"), std::string());
    }

    void textInParts_isOne()
    {
        const auto root = readXml("<a> 1<b>9</b><![CDATA[<2>]]><?p q?>3 </a>");
        QCOMPARE(root->text, std::string(" 1<2>3 "));
        QCOMPARE(root->trimmedText(), std::string("1<2>3"));
        QCOMPARE(root->child("b")->text, std::string("9"));
        QVERIFY(!root->child("c") && root->all("c").empty());
    }

    void emptyPath_isTheElementItself()
    {
        const auto root = readXml("<a> 7 <b/></a>");
        QCOMPARE(root->at({}), &*root);
        QCOMPARE(root->textAt({}), std::string("7"));
        QCOMPARE(root->at({"b"}), root->child("b"));
    }

    void blanksAlone_areNoText()
    {
        const auto root = readXml("<a> \n <b>\t</b> <!-- c -->\r\n</a>");
        QCOMPARE(root->text, std::string());
        QCOMPARE(root->child("b")->text, std::string());
        QCOMPARE(root->child("b")->trimmedText(), std::string());
    }

    void wordsIn_areBetweenBlanks()
    {
        using Words = std::vector<std::string>;
        QCOMPARE(wordsIn(""), Words());
        QCOMPARE(wordsIn(" \t\r\n"), Words());
        QCOMPARE(wordsIn("a"), Words{"a"});
        QCOMPARE(wordsIn("\n a\tb\r\nc  "), (Words{"a", "b", "c"}));
        QCOMPARE(wordsIn("a\xC2\xA0"
                         "b"),
            (Words{"a\xC2\xA0"
                   "b"}));
    }
};

DYNCAL_TEST(TestParsedXml)
#include "tst_parsed_xml.moc"
