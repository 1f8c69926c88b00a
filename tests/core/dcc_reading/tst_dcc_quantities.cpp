// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Results as lists and single quantities: nothing is lost without a sentence, nothing is read
// twice.

#include "core/dcc_reading/dcc_quantities.h"
#include "tests/support/made_dcc.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <string>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Of a result with this in its data, and before it.
DccContents contentsOf(
    const std::string &data, const std::string &before = "", const std::string &attributes = "")
{
    const auto result = readXml("<dcc:result" + attributes + ">" + before + "<dcc:data>" + data
        + "</dcc:data></dcc:result>");
    DccContents contents;
    readResult(result.value(), contents);
    return contents;
}

std::string named(const std::string &name)
{
    return "<dcc:name><dcc:content>" + name + "</dcc:content></dcc:name>";
}

std::string quantity(const std::string &content)
{
    return "<dcc:quantity>" + content + "</dcc:quantity>";
}

const std::string kVolt = "<si:real><si:value>5</si:value><si:unit>\\volt</si:unit></si:real>";
const std::string kWords = "<dcc:noQuantity><dcc:content>passed</dcc:content></dcc:noQuantity>";

} // namespace

class TestDccQuantities : public QObject
{
    Q_OBJECT

private slots:
    void quantities_haveIdNameRefTypesAndLine()
    {
        const DccContents contents = contentsOf(
            "\n\n<dcc:quantity id='q' refType='a  b'>" + named("Gain") + kVolt + "</dcc:quantity>");
        QCOMPARE(contents.single.size(), std::size_t(1));
        const StatedQuantity &one = contents.single.front();
        QCOMPARE(one.id + ' ' + one.name, std::string("q Gain"));
        QCOMPARE(one.refTypes, (std::vector<std::string>{"a", "b"}));
        QVERIFY(one.hasRefType("b") && !one.hasRefType("a  b") && !one.hasRefType(""));
        QCOMPARE(one.line, Index(3));
        QVERIFY(!one.isComplex());
        QCOMPARE(one.stated.values.values, std::vector<double>{5});
    }

    void valuesAreFound_whereverTheyStandInTheQuantity()
    {
        for (const std::string &content : {kVolt, named("x") + kVolt, kVolt + kWords,
                 kWords + kVolt, "<dcc:description/><dcc:usedMethods/>" + kVolt}) {
            const DccContents contents = contentsOf(quantity(content));
            QVERIFY2(contents.single.size() == 1, content.c_str());
            QVERIFY2(contents.notUnderstood.empty(), content.c_str());
        }
    }

    /// Words are no values that are not understood; anything else without values is.
    void quantitiesWithoutValues_haveASentenceUnlessTheyAreWords()
    {
        for (const std::string &content :
            {kWords, named("x") + kWords, std::string("<si:charsXMLList>a b</si:charsXMLList>")}) {
            const DccContents contents = contentsOf(quantity(content));
            QVERIFY2(contents.single.empty() && contents.notUnderstood.empty(), content.c_str());
        }
        for (const std::string &content : {std::string(), named("x"), std::string("<si:list/>"),
                 std::string("<si:reel/>"), "<si:list>" + kVolt + "</si:list>"}) {
            const DccContents contents = contentsOf(quantity(content));
            QVERIFY2(contents.single.empty(), content.c_str());
            QVERIFY2(contents.notUnderstood.size() == 1, content.c_str());
            QVERIFY(english(contents.notUnderstood[0]).starts_with("Line 1, "));
        }
    }

    /// As many quantities as sentences and values together, in lists and beside them.
    void everyQuantity_isReadOrNamed()
    {
        std::string data;
        std::size_t good = 0;
        constexpr std::size_t kAll = 60;
        for (std::size_t i = 0; i < kAll; ++i) {
            const bool isGood = i % 3 != 1;
            good += isGood ? 1 : 0;
            data += dccQuantity(std::to_string(i), isGood ? "\\volt" : "\\furlong");
        }
        const DccContents beside = contentsOf(data), inside = contentsOf(dccList(data));
        QCOMPARE(beside.single.size(), good);
        QCOMPARE(beside.notUnderstood.size(), kAll - good);
        QVERIFY(beside.tables.empty());
        QVERIFY(inside.single.empty() && inside.notUnderstood.empty());
        QCOMPARE(inside.tables.at(0).columns.size(), good);
        QCOMPARE(inside.tables[0].notUnderstood.size(), kAll - good);
        for (std::size_t i = 0; i < good; ++i) // in their order
            QCOMPARE(inside.tables[0].columns[i].stated.values.values,
                beside.single[i].stated.values.values);
    }

    /// Each list is a table of its own, the outer before the inner; none has the other's columns.
    void listsInLists_areTablesOfTheirOwn()
    {
        const std::string inner = dccList(dccQuantity("3", "\\volt"), "inner"),
                          middle = dccList(dccQuantity("2", "\\volt") + inner, "middle"),
                          outer = dccList(middle + dccQuantity("1", "\\volt"), "outer");
        const DccContents contents = contentsOf(outer + dccList("", "last"));
        QCOMPARE(contents.tables.size(), std::size_t(4));
        const std::vector<std::string> ids{"outer", "middle", "inner", "last"};
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(contents.tables[i].id, ids[i]);
            QCOMPARE(contents.tables[i].columns.size(), std::size_t(1));
            QCOMPARE(contents.tables[i].columns[0].stated.values.values[0], double(i + 1));
        }
        QVERIFY(contents.tables[3].id == ids[3] && contents.tables[3].columns.empty());
    }

    /// The nearest name and the nearest refTypes count, each for itself.
    void namesAndRefTypes_comeFromTheNearest()
    {
        const std::string inner
            = "<dcc:list refType='c'>" + dccQuantity("1", "\\volt") + "</dcc:list>",
            outer = "<dcc:list>" + named("Outer") + inner + "</dcc:list>";
        const DccContents contents
            = contentsOf(outer + dccList(""), named("Result"), " refType='r'");
        QCOMPARE(contents.tables[0].name, std::string("Outer"));
        QCOMPARE(contents.tables[0].refTypes, std::vector<std::string>{"r"});
        QCOMPARE(contents.tables[1].name, std::string("Outer"));
        QCOMPARE(contents.tables[1].refTypes, std::vector<std::string>{"c"});
        QCOMPARE(contents.tables[2].name, std::string("Result"));
        QVERIFY(contents.tables[1].columns[0].refTypes.empty()); // a column has its own only
    }

    /// Entries in English, and those of no language: translations of an entry are not entries.
    void words_ofAList_areInOneLanguage()
    {
        const DccContents contents = contentsOf(dccList(
            "<dcc:quantity refType='state'><dcc:noQuantity><dcc:content lang='sv'>bra</dcc:content>"
            "<dcc:content lang='en'>good</dcc:content><dcc:content>7</dcc:content></dcc:noQuantity>"
            "</dcc:quantity>"
            + dccWords("empty", {})));
        QCOMPARE(contents.tables.at(0).words.size(), std::size_t(2));
        QCOMPARE(contents.tables[0].words[0].refTypes, std::vector<std::string>{"state"});
        QCOMPARE(contents.tables[0].words[0].entries, (std::vector<std::string>{"good", "7"}));
        QVERIFY(contents.tables[0].words[1].entries.empty());
    }

    /// Where the quantity has an uncertainty of its own, a relative one beside it says no more.
    void relativeUncertainties_areNamedOnlyWhereNothingElseIsStated()
    {
        const std::string relative = "<dcc:relativeUncertainty/>";
        const std::string stated
            = "<si:real><si:value>5</si:value><si:unit>\\volt</si:unit><si:expandedUnc>"
              "<si:uncertainty>1</si:uncertainty><si:coverageFactor>4</si:coverageFactor>"
              "</si:expandedUnc></si:real>";
        QCOMPARE(contentsOf(quantity(kVolt + relative)).notUnderstood.size(), std::size_t(1));
        const DccContents both = contentsOf(quantity(stated + relative));
        QVERIFY(both.notUnderstood.empty());
        QCOMPARE(both.single.at(0).stated.values.u, std::vector<double>{0.25});
        const DccContents list = contentsOf(dccList(quantity(kVolt + relative)));
        QVERIFY(list.notUnderstood.empty() && list.tables.at(0).notUnderstood.size() == 1);
    }

    /// Texts, formulas, images: neither read nor reported.
    void otherData_isNoQuantity()
    {
        const DccContents contents
            = contentsOf("<dcc:text><dcc:content>5 V</dcc:content></dcc:text>"
                         "<dcc:formula/><dcc:byteData/><dcc:xml>"
                + quantity(kVolt) + "</dcc:xml>");
        QVERIFY(contents.single.empty() && contents.tables.empty());
        QVERIFY(contents.notUnderstood.empty());
        DccContents none;
        readResult(readXml("<dcc:result/>").value(), none);
        QVERIFY(none.single.empty() && none.tables.empty());
    }

    void results_areAddedToThoseBefore()
    {
        DccContents contents = contentsOf(quantity(kVolt) + dccList("", "first"));
        readResult(readXml("<dcc:result><dcc:data>" + dccList("", "second") + quantity(kVolt)
                       + "</dcc:data></dcc:result>")
                       .value(),
            contents);
        QCOMPARE(contents.single.size(), std::size_t(2));
        QCOMPARE(
            contents.tables.at(0).id + ' ' + contents.tables.at(1).id, std::string("first second"));
    }
};

DYNCAL_TEST(TestDccQuantities)
#include "tst_dcc_quantities.moc"
