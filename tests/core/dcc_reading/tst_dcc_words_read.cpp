// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Words of certificates: one language of several, and attributes that are lists of words.

#include "core/dcc_reading/dcc_words_read.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <string>

using namespace dyncal;

namespace {

ParsedElement element(const std::string &text)
{
    return readXml(text).value();
}

std::string wordsOf(const std::string &contents)
{
    const ParsedElement name = element("<dcc:name>" + contents + "</dcc:name>");
    return wordsOfText(&name);
}

} // namespace

class TestDccWordsRead : public QObject
{
    Q_OBJECT

private slots:
    /// English wherever it stands; of two in English the first.
    void english_goesFirst()
    {
        const std::string sv = "<dcc:content lang='sv'>givare</dcc:content>",
                          en = "<dcc:content lang='en'>sensor</dcc:content>",
                          de = "<dcc:content lang='de'>Aufnehmer</dcc:content>",
                          none = "<dcc:content>P-7</dcc:content>";
        for (const std::string &contents : {en, en + sv, sv + en, sv + de + en, none + en,
                 en + "<dcc:content lang='en'>b</dcc:content>"})
            QCOMPARE(wordsOf(contents), std::string("sensor"));
        QCOMPARE(wordsOf(sv + de), std::string("givare"));
        QCOMPARE(wordsOf(de + sv + none), std::string("Aufnehmer"));
        QCOMPARE(wordsOf(none + de), std::string("P-7"));
    }

    /// The language may be of the namespace of XML itself.
    void languages_mayHaveAPrefix()
    {
        QCOMPARE(
            wordsOf("<a:content xml:lang='sv'>x</a:content><a:content xml:lang='en'>y</a:content>"),
            std::string("y"));
    }

    void wordsThatAreNone_areEmpty()
    {
        QCOMPARE(wordsOfText(nullptr), std::string());
        for (const char *contents : {"", "text of its own", "<dcc:file>x</dcc:file>",
                 "<dcc:richContent><dcc:content>deep</dcc:content></dcc:richContent>",
                 "<dcc:content/>", "<dcc:content lang='en'> \n </dcc:content>"})
            QCOMPARE(wordsOf(contents), std::string());
    }

    /// Characters beyond ASCII and those that XML writes by a name stay what they are.
    void characters_areKept()
    {
        QCOMPARE(
            wordsOf(
                "<dcc:content>\n  St\xC3\xB6tr\xC3\xB6r &lt;A &amp; B&gt; &#xB5; \n</dcc:content>"),
            std::string("St\xC3\xB6tr\xC3\xB6r <A & B> \xC2\xB5"));
        QCOMPARE(wordsOf("<dcc:content><![CDATA[a < b]]></dcc:content>"), std::string("a < b"));
    }

    void attributes_areListsOfWords()
    {
        using Words = std::vector<std::string>;
        const auto words = [](const std::string &value) {
            return wordsOfAttribute(element("<a refType=\"" + value + "\"/>"), "refType");
        };
        QCOMPARE(words("one"), Words{"one"});
        QCOMPARE(words("two words"), (Words{"two", "words"}));
        QCOMPARE(words("\n\t two \r\n  words\t"), (Words{"two", "words"}));
        QCOMPARE(words("a a"), (Words{"a", "a"}));
        QCOMPARE(words("a,b;c"), Words{"a,b;c"}); // blanks only part them
        QVERIFY(words("").empty() && words("   ").empty());
        QVERIFY(wordsOfAttribute(element("<a reftype='x'/>"), "refType").empty());
        QCOMPARE(wordsOfAttribute(element("<a x:refType='y'/>"), "refType"), Words{"y"});
    }
};

DYNCAL_TEST(TestDccWordsRead)
#include "tst_dcc_words_read.moc"
