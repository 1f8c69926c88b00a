// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_words.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::exampleWordsInTwo;
using testing::ReadXml;

namespace {

const Message kOurs{"Shot %1 has no step.", {"3"}};

/// "en=text; sv=text", "=text" without a language.
QString told(const std::vector<XmlElement> &contents)
{
    QStringList list;
    for (const XmlElement &content : contents) {
        const std::string lang
            = content.attributes.empty() ? std::string() : content.attributes.front().second;
        list << QString::fromStdString(lang + "=" + content.text);
    }
    return list.join("; ");
}

} // namespace

class TestDccWords : public QObject
{
    Q_OBJECT

private slots:
    void withoutTranslation_isEnglish()
    {
        QCOMPARE(told(DccWords().contents(kOurs)), QString("en=Shot 3 has no step."));
        const DccWords swedish{{"sv"}};
        QCOMPARE(told(swedish.contents(kOurs)), QString("sv=Shot 3 has no step."));
    }

    void languages_standInTheirOrder()
    {
        DccWords words = exampleWordsInTwo();
        QCOMPARE(told(words.contents(kOurs)),
            QString("en=Shot 3 has no step.; sv=sv: Shot 3 has no step."));
        std::ranges::reverse(words.languages);
        QCOMPARE(told(words.contents(kOurs)),
            QString("sv=sv: Shot 3 has no step.; en=Shot 3 has no step."));
    }

    /// A name or a number belongs to no language; a sentence of ours does, even where both are
    /// alike.
    void typed_standsOnceWithoutLanguage()
    {
        const DccWords words = exampleWordsInTwo();
        QCOMPARE(told(words.contents({"%1", {"Lab"}})), QString("=Lab"));
        QCOMPARE(told(words.contents({"%1 %2", {"3", "Hz"}})), QString("=3 Hz"));
        const DccWords alike{{"en", "sv"}};
        QCOMPARE(told(alike.contents({"Transient", {}})), QString("en=Transient; sv=Transient"));
        QCOMPARE(told(alike.contents({"of %1", {"Lab"}})), QString("en=of Lab; sv=of Lab"));
    }

    /// A decimal comma is a difference: "1,5 V" is Swedish.
    void number_thatIsWrittenDifferently_hasItsLanguages()
    {
        const DccWords words{{"en", "sv"}, [](const Message &message, const std::string &language) {
                                 return testing::replacedOnce(
                                     english(message), ".", language == "sv" ? "," : ".");
                             }};
        QCOMPARE(told(words.contents({"%1 V", {"1.5"}})), QString("en=1.5 V; sv=1,5 V"));
        QCOMPARE(told(words.contents({"%1 V", {"15"}})), QString("=15 V"));
    }

    void nothing_isADash_data()
    {
        QTest::addColumn<QString>("text");
        for (const char *nothing : {"", " ", "   "})
            QTest::newRow(nothing) << nothing;
    }
    void nothing_isADash()
    {
        QFETCH(QString, text);
        const Message typed{"%1", {text.toStdString()}};
        QCOMPARE(told(DccWords().contents(typed)), QString("=\u2013"));
        const DccWords silent{
            {"en", "sv"}, [&](const Message &, const std::string &) { return text.toStdString(); }};
        QCOMPARE(told(silent.contents(kOurs)), QString("en=\u2013; sv=\u2013"));
    }

    void zero_isNotNothing()
    {
        QCOMPARE(told(DccWords().contents({"%1", {"0"}})), QString("=0"));
        QCOMPARE(told(DccWords().contents({"%1", {"-"}})), QString("=-"));
    }

    /// An argument is never taken for a place or for a sentence of ours.
    void argument_isNotExpanded()
    {
        const DccWords words = exampleWordsInTwo();
        QCOMPARE(told(words.contents({"%1", {"%1 %2"}})), QString("=%1 %2"));
        QCOMPARE(told(words.contents({"%1", {"Shot %1 has no step."}})),
            QString("=Shot %1 has no step."));
    }

    void element_hasEverySentenceInEveryLanguage()
    {
        const DccWords words = exampleWordsInTwo();
        const ReadXml xml(words.element("dcc:name", {kOurs, {"%1", {"Lab"}}, {"End.", {}}}));
        QCOMPARE(QString::fromUtf8(xml.root().name()), QString("dcc:name"));
        QCOMPARE(
            xml.texts("//dcc:content[@lang='en']"), QStringList({"Shot 3 has no step.", "End."}));
        QCOMPARE(xml.texts("//dcc:content[@lang='sv']"),
            QStringList({"sv: Shot 3 has no step.", "sv: End."}));
        QCOMPARE(xml.texts("//dcc:content[not(@lang)]"), QStringList("Lab"));
        QCOMPARE(xml.count("/dcc:name/dcc:content"), 5);
    }

    void element_withoutSentences_isEmpty()
    {
        const ReadXml xml(DccWords().element("dcc:description", {}));
        QCOMPARE(xml.count("/dcc:description/*"), 0);
    }

    void sentencesBelow_stayWithTheFirst()
    {
        const Message both{"Above.", {}, {{"Below %1.", {"x"}}}};
        QCOMPARE(told(DccWords().contents(both)), QString("en=Above.\nBelow x."));
    }

    /// Whatever is typed comes back as one text that can be read, and is not empty.
    void hostileText_comesBackAsText()
    {
        for (const std::string &text : test::hostileTexts()) {
            const ReadXml xml(exampleWordsInTwo().element("dcc:name", {{"%1", {text}}}));
            QVERIFY(xml.isWellFormed());
            QCOMPARE(xml.count("//*"), 2);
            const std::string back = xml.text("/dcc:name/dcc:content").toStdString();
            QVERIFY2(test::isFitToShow(back), back.c_str());
            QCOMPARE(back, english({"%1", {text}}));
            QVERIFY(!inOneLine(back).empty());
        }
    }
};

DYNCAL_TEST(TestDccWords)
#include "tst_dcc_words.moc"
