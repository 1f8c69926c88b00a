// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tables and sections of a certificate as lists and results.

#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_sections.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

Message heading(const char *text)
{
    return {text, {}};
}

CertificateTable poleTable()
{
    CertificateTable table;
    table.id = "poles";
    table.caption = heading("Poles");
    table.columns = {{heading("Class"), false}, {heading("z-plane"), true},
        {heading("Damping ratio"), true}, {heading("U (k = 2)"), true}};
    table.rows = {{heading("sensor"), inNumbers("0.9 \xC2\xB1 j 0.1"), inNumbers("0.0200"),
                      inNumbers("0.0012")},
        {heading("other"), inNumbers("0.5"), dash(), dash()},
        {heading("other"), inNumbers("-0.5"), inNumbers("0.400"), inNumbers("0.030 (k = 4.30)")}};
    return table;
}

/// The first element of a name, in the order of the document; null without one.
const XmlElement *find(const XmlElement &element, const std::string &name)
{
    if (element.name == name)
        return &element;
    for (const XmlElement &child : element.children)
        if (const XmlElement *found = find(child, name))
            return found;
    return nullptr;
}

QString textOf(const XmlElement &element, const std::string &name)
{
    const XmlElement *found = find(element, name);
    return found ? QString::fromStdString(found->text) : QString("none");
}

QString refTypeIn(const XmlElement &element)
{
    for (const auto &[name, value] : element.attributes)
        if (name == "refType")
            return QString::fromStdString(value);
    return {};
}

/// The quantities of a list with that refType.
std::vector<XmlElement> quantities(const XmlElement &list, const QString &refType)
{
    std::vector<XmlElement> found;
    for (const XmlElement &child : list.children)
        if (child.name == "dcc:quantity" && refTypeIn(child) == refType)
            found.push_back(child);
    return found;
}

QStringList contents(const XmlElement &quantity)
{
    QStringList list;
    if (const XmlElement *words = find(quantity, "dcc:noQuantity"))
        for (const XmlElement &content : words->children)
            list << QString::fromStdString(content.text);
    return list;
}

} // namespace

class TestDccSections : public QObject
{
    Q_OBJECT

private slots:
    void column_hasValuesWithTheirU()
    {
        const XmlElement list = dccListOf({}, poleTable());
        QCOMPARE(refTypeIn(list), QString("dyncal_poles"));
        const auto damping = quantities(list, "dyncal_dampingRatio");
        QCOMPARE(damping.size(), std::size_t(1));
        QCOMPARE(textOf(damping[0], "si:valueXMLList"), QString("0.0200 NaN 0.400"));
        QCOMPARE(textOf(damping[0], "si:unitXMLList"), QString("\\one"));
        QCOMPARE(textOf(damping[0], "si:valueExpandedMUXMLList"), QString("0.0012 NaN 0.030"));
        QCOMPARE(textOf(damping[0], "si:coverageFactorXMLList"), QString("2 NaN 4.30"));
        QCOMPARE(textOf(damping[0], "si:coverageProbabilityXMLList"), QString("0.95"));
    }

    void wordsAmongNumbers_standBesideThem()
    {
        const XmlElement list = dccListOf({}, poleTable());
        const auto numbers = quantities(list, "dyncal_poleZ");
        QCOMPARE(numbers.size(), std::size_t(1));
        QCOMPARE(textOf(numbers[0], "si:valueXMLList"), QString("NaN 0.5 -0.5"));
        QVERIFY(!find(numbers[0], "si:measurementUncertaintyUnivariateXMLList"));
        const auto words = quantities(list, "dyncal_remarks");
        QCOMPARE(words.size(), std::size_t(1));
        QCOMPARE(contents(words[0]), QStringList({"0.9 \u00b1 j 0.1", "\u2013", "\u2013"}));
    }

    void columnOfWords_hasAContentForEachRow()
    {
        const auto classes = quantities(dccListOf({}, poleTable()), "dyncal_poleClass");
        QCOMPARE(classes.size(), std::size_t(1));
        QCOMPARE(contents(classes[0]), QStringList({"sensor", "other", "other"}));
    }

    /// A unit for each value where they differ; that of the others where there is no value.
    void units_areThoseOfTheCells()
    {
        CertificateTable table;
        table.id = "shots";
        table.columns = {{heading("Rise time"), true}, {heading("Sample rate"), true}};
        table.rows = {{inNumbers("40.0 ns"), inNumbers("1 MHz")}, {dash(), inNumbers("100 kHz")}};
        const XmlElement list = dccListOf({}, table);
        QCOMPARE(textOf(quantities(list, "dyncal_riseTime")[0], "si:unitXMLList"),
            QString("\\nano\\second"));
        QCOMPARE(textOf(quantities(list, "dyncal_sampleRate")[0], "si:unitXMLList"),
            QString("\\mega\\hertz \\kilo\\hertz"));
    }

    /// U and k stand further right than the values they belong to.
    void factorsOfAColumn_areThoseOfItsU()
    {
        CertificateTable table;
        table.id = "shock";
        table.columns = {{heading("Pressure step"), true}, {heading("Step is"), false},
            {heading("U of the step"), true}, {heading("k"), true}, {heading("Plateau"), true}};
        table.rows = {{inNumbers("434.5 kPa"), heading("computed"), inNumbers("3.1 kPa"),
            inNumbers("1.97"), inNumbers("2.0 ms")}};
        const auto steps
            = quantities(dccListOf({}, table), "basic_referenceValue dyncal_pressureStep");
        QCOMPARE(steps.size(), std::size_t(1));
        QCOMPARE(textOf(steps[0], "si:valueExpandedMUXMLList"), QString("3.1"));
        QCOMPARE(textOf(steps[0], "si:coverageFactorXMLList"), QString("1.97"));
    }

    /// In another unit than its value a U would be read wrong by a thousand.
    void expandedInAnotherUnit_isNotTaken()
    {
        CertificateTable table;
        table.id = "poles";
        table.columns = {{heading("Undamped frequency"), true}, {heading("U (k = 2)"), true}};
        table.rows = {{inNumbers("2.33 MHz"), inNumbers("1.2 kHz")}};
        const auto found = quantities(dccListOf({}, table), "dyncal_naturalFrequency");
        QVERIFY(!find(found[0], "si:valueExpandedMUXMLList"));
    }

    void unknownUnit_leavesTheWords()
    {
        CertificateTable table;
        table.id = "shots";
        table.columns = {{heading("Output step"), true}};
        table.rows = {{inNumbers("12.5 mv")}};
        const auto found = quantities(dccListOf({}, table), "dyncal_outputStep");
        QCOMPARE(contents(found[0]), QStringList("12.5 mv"));
    }

    void markedFrequency_isANumberAndHasItsName()
    {
        CertificateTable table;
        table.id = "frequency-response";
        table.columns = {{heading("Frequency"), true}};
        table.rows = {{{"lower limit %L1", {"657.1 Hz"}}}, {inNumbers("1 kHz")}};
        const XmlElement list = dccListOf({}, table);
        QCOMPARE(
            textOf(quantities(list, "basic_tableIndex0 dyncal_frequency")[0], "si:valueXMLList"),
            QString("657.1 1"));
        QCOMPARE(contents(quantities(list, "dyncal_remarks")[0]),
            QStringList({"lower limit 657.1 Hz", "\u2013"}));
        table.id = "shots"; // a bound is no value
        table.columns = {{heading("Rise time"), true}};
        table.rows = {{{"below %L1", {"40 ns"}}}};
        QVERIFY(!find(dccListOf({}, table), "si:valueXMLList"));
    }

    void section_isAResultWithAllItSays()
    {
        CertificateSection section;
        section.id = "model";
        section.title = heading("Model");
        section.paragraphs = {heading("A sentence.")};
        section.fields = {
            {"order", heading("Order"), inNumbers("4")}, {"fit", heading("Fit"), heading("words")}};
        section.tables = {poleTable()};
        section.notes = {heading("A note.")};
        const XmlElement result = dccResultOf({}, section);
        QCOMPARE(refTypeIn(result), QString("dyncal_model"));
        const XmlElement *data = find(result, "dcc:data");
        QVERIFY(data);
        QStringList names;
        for (const XmlElement &child : data->children)
            names << QString::fromStdString(child.name);
        QCOMPARE(names,
            QStringList({"dcc:text", "dcc:quantity", "dcc:quantity", "dcc:list", "dcc:text"}));
        QCOMPARE(textOf(*data, "si:value"), QString("4"));
    }

    /// The schema wants something in it.
    void emptySection_saysItsTitle()
    {
        CertificateSection section;
        section.id = "remarks";
        section.title = heading("Remarks");
        QVERIFY(find(dccResultOf({}, section), "dcc:text"));
    }

    void keyResult_isAQuantity_andWhatIsNone_isWords()
    {
        CertificateSection section;
        section.id = "key-results";
        CertificateTable results, others;
        results.id = "key-results";
        results.rows = {{heading("Damping ratio"), inNumbers("0.0200"), inNumbers("0.0012"),
            inNumbers("4.30")}};
        others.id = "not-reported";
        others.rows = {{heading("Overshoot"), heading("no complete uncertainty")}};
        section.tables = {results, others};
        const XmlElement result = dccKeyResults({}, section);
        const XmlElement &data = *find(result, "dcc:data");
        QCOMPARE(refTypeIn(data.children[0]), QString("dyncal_dampingRatio"));
        QCOMPARE(textOf(data.children[0], "si:value"), QString("0.0200"));
        QCOMPARE(textOf(data.children[0], "si:valueExpandedMU"), QString("0.0012"));
        QCOMPARE(textOf(data.children[0], "si:coverageFactor"), QString("4.30"));
        QCOMPARE(refTypeIn(data.children[1]), QString("dyncal_overshoot dyncal_notReported"));
        QCOMPARE(contents(data.children[1]), QStringList("no complete uncertainty"));
    }
};

DYNCAL_TEST(TestDccSections)
#include "tst_dcc_sections.moc"
