// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_list_rules.h"
#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

using Rule = void (*)(const DccTree &, std::vector<DccFinding> &);

std::vector<DccFinding> findingsOf(Rule rule, const std::string &body)
{
    const Result<DccTree> tree = DccTree::read(
        "<digitalCalibrationCertificate>" + body + "</digitalCalibrationCertificate>");
    std::vector<DccFinding> findings;
    if (tree)
        rule(*tree, findings);
    else
        findings.push_back({"unreadable", {}, {}, {}});
    return findings;
}

/// "rule where found" of each.
QString toldBy(Rule rule, const std::string &body)
{
    QStringList told;
    for (const DccFinding &finding : findingsOf(rule, body))
        told << QString::fromStdString(finding.rule + " " + finding.where + " " + finding.found);
    return told.join("; ");
}

std::string element(const std::string &name, const std::string &inner)
{
    return std::string("<si:").append(name).append(">") + inner + "</si:" + name + ">";
}

std::string words(int count, const std::string &word)
{
    std::string list;
    for (int i = 0; i < count; ++i)
        list += (i > 0 ? " " : "") + word;
    return list;
}

std::string realList(int values, const std::string &rest = {})
{
    return element("realListXMLList", element("valueXMLList", words(values, "1.5")) + rest);
}

std::string table(const std::vector<int> &columns)
{
    std::string quantities;
    for (const int values : columns)
        quantities += element("quantity", realList(values));
    return element("list", quantities);
}

} // namespace

class TestDccListRules : public QObject
{
    Q_OBJECT

private slots:
    void blanks_areSingle_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("isRight");
        QTest::newRow("one") << "1" << true;
        QTest::newRow("three") << "1 NaN -3e-7" << true;
        QTest::newRow("comment inside") << "1 <!-- and -->2" << true;
        QTest::newRow("blank behind a comment") << "1 <!-- and --> 2" << false;
        QTest::newRow("none") << "" << false;
        QTest::newRow("before") << " 1" << false;
        QTest::newRow("behind") << "1 " << false;
        QTest::newRow("two") << "1  2" << false;
        QTest::newRow("tab") << "1\t2" << false;
        QTest::newRow("line") << "1\n2" << false;
        QTest::newRow("line written out") << "1&#13;2" << false;
    }
    void blanks_areSingle()
    {
        QFETCH(QString, text);
        QFETCH(bool, isRight);
        const auto told = findingsOf(checkLists, element("valueXMLList", text.toStdString()));
        QCOMPARE(told.size(), std::size_t(isRight ? 0 : 1));
        if (!isRight)
            QCOMPARE(told.front().where, std::string("valueXMLList"));
    }

    /// Only texts are lists: not what holds lists, nor other elements.
    void blanks_ofOthersAreTheirOwn()
    {
        QCOMPARE(toldBy(checkLists, element("realListXMLList", "\n " + element("aXMLList", "1"))),
            QString());
        QCOMPARE(toldBy(checkLists, element("name", " two  blanks ")), QString());
        QCOMPARE(toldBy(checkLists, element("aXMLList", "1") + element("aXMLList", "1 ")),
            QString("list aXMLList[2] 1 "));
    }

    /// A unit, or an uncertainty, is one for each value, or one for all.
    void lengths_areThatOfTheValuesOrOne()
    {
        for (const char *name : {"unitXMLList", "valueStandardMUXMLList", "coverageFactorXMLList"})
            for (int values = 1; values <= 6; ++values)
                for (int count = 0; count <= 7; ++count) {
                    const std::string part = element(name, words(count, "1"));
                    for (const std::string &rest : {part, element("standardMUXMLList", part)}) {
                        const auto told = findingsOf(checkLengths, realList(values, rest));
                        const bool isRight = count == values || count == 1;
                        QCOMPARE(told.size(), std::size_t(isRight ? 0 : 1));
                        if (isRight)
                            continue;
                        QCOMPARE(told.front().rule, std::string("length"));
                        QCOMPARE(told.front().found, std::to_string(count));
                        QCOMPARE(told.front().needed.arguments,
                            std::vector<std::string>{std::to_string(values)});
                        QVERIFY(told.front().where.ends_with(name));
                    }
                }
    }

    /// A value has two parts: neither stands for all.
    void complexValues_havePairs_data()
    {
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("second");
        QTest::newRow("cartesian") << "valueRealXMLList"
                                   << "valueImagXMLList";
        QTest::newRow("polar") << "valueMagnitudeXMLList"
                               << "valuePhaseXMLList";
    }
    void complexValues_havePairs()
    {
        QFETCH(QString, first);
        QFETCH(QString, second);
        for (int values = 0; values <= 4; ++values)
            for (int others = 0; others <= 4; ++others) {
                const QString told = toldBy(checkLengths,
                    element("complexListXMLList",
                        element(first.toStdString(), words(values, "1"))
                            + element(second.toStdString(), words(others, "0"))
                            + element("unitXMLList", "\\one")
                            + element("unitPhaseXMLList", "\\radian")));
                QCOMPARE(told,
                    values == others
                        ? QString()
                        : QString("length complexListXMLList/%1 %2").arg(second).arg(others));
            }
    }

    void listWithoutValues_hasNoLength()
    {
        QCOMPARE(toldBy(checkLengths, element("realListXMLList", element("unitXMLList", "a b"))),
            QString());
        QCOMPARE(toldBy(checkLengths, element("otherXMLList", element("valueXMLList", "1 2"))),
            QString());
    }

    void columns_haveOneNumberOfRows()
    {
        QCOMPARE(toldBy(checkLengths, table({3, 3, 3})), QString());
        QCOMPARE(toldBy(checkLengths, table({3, 1, 3})), QString());
        QCOMPARE(toldBy(checkLengths, table({1, 3, 1})), QString());
        QCOMPARE(toldBy(checkLengths, table({3, 2})), QString("length list/quantity[2] 2"));
        QCOMPARE(toldBy(checkLengths, table({1, 2, 3})), QString("length list/quantity[3] 3"));
        QCOMPARE(toldBy(checkLengths, table({3, 0})), QString("length list/quantity[2] 0"));
        QCOMPARE(toldBy(checkLengths, table({2, 3, 4})),
            QString("length list/quantity[2] 3; length list/quantity[3] 4"));
        QCOMPARE(toldBy(checkLengths, table({2, 2}) + table({5, 5})), QString());
    }

    void units_areThoseOfTheDsi_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<bool>("isRight");
        for (const char *right : {"\\one", "\\volt", "\\volt\\mega\\pascal\\tothe{-1}",
                 "\\metre\\tothe{2}\\second", "\\hertz\\tothe{0.5}", "\\volt\\hertz\\tothe{-0.5}"})
            QTest::newRow(right) << right << true;
        for (const char *wrong :
            {"", "V", "volt", "\\", "\\\\volt", "\\volt\\", "\\volt\\\\pascal", "\\volt/\\pascal",
                "\\volt \\pascal", " \\volt", "\\volt\\tothe{", "\\tothe{}", "\\tothe{-}",
                "\\tothe{--1}", "\\tothe{1-}", "\\tothe{.}", "\\tothe{1.}", "\\tothe{.5}",
                "\\tothe{1.2.3}", "\\tothe{{1}}", "\\tothe{1}}", "\\tothe{1}2", "\\tothe{1}volt",
                "\\tothe{a}", "{1}", "\\{1}", "\\tothe{1}{1}", "\\\u00b5m", "\\m2"})
            QTest::newRow(wrong) << wrong << false;
    }
    void units_areThoseOfTheDsi()
    {
        QFETCH(QString, unit);
        QFETCH(bool, isRight);
        const std::string text = unit.toStdString();
        for (const char *name : {"unit", "unitPhase"}) {
            const auto told = findingsOf(checkUnits, element(name, text));
            QCOMPARE(told.size(), std::size_t(isRight ? 0 : 1));
            if (!isRight)
                QCOMPARE(told.front().found, text);
        }
        if (text.empty() || text.find(' ') != text.npos)
            return; // no word of a list
        const auto told
            = findingsOf(checkUnits, element("unitXMLList", "\\one " + text + " \\one"));
        QCOMPARE(told.size(), std::size_t(isRight ? 0 : 1));
    }

    void firstWrongUnit_ofAListIsTold()
    {
        QCOMPARE(toldBy(checkUnits, element("unitXMLList", "\\volt V A")),
            QString("unit unitXMLList V"));
        QCOMPARE(toldBy(checkUnits, element("quantity", "V")), QString());
    }

    /// What is told of a long text is short, and ends with a whole character.
    void longText_isToldInShort()
    {
        for (int shift = 0; shift < 4; ++shift)
            for (const char *character : {"a", "\u00e5", "\u20ac", "\U0001F600"}) {
                std::string text(static_cast<std::size_t>(shift), 'x');
                for (int i = 0; i < 100; ++i)
                    text += character;
                const auto told = findingsOf(checkUnits, element("unit", text));
                QCOMPARE(told.size(), std::size_t(1));
                const std::string &found = told.front().found;
                QVERIFY(found.ends_with("...") && found.size() <= 63 && found.size() >= 60);
                QVERIFY(text.starts_with(found.substr(0, found.size() - 3)));
                QVERIFY2(test::isFitToShow(found), found.c_str());
            }
    }
};

DYNCAL_TEST(TestDccListRules)
#include "tst_dcc_list_rules.moc"
