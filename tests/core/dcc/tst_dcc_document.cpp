// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a certificate says stands in its DCC: read back as XML, against the certificate itself.

#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_document.h"
#include "core/dcc/dcc_fields.h"
#include "core/dcc/dcc_ref_types.h"
#include "core/dcc/dcc_tree.h"
#include "core/dcc/printed_value.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace dyncal;
using testing::dccOfRecipe;
using testing::exampleDccRecipe;
using testing::exampleIssue;

namespace {

/// Texts of all elements of a name.
QStringList texts(const std::string &xml, const char *name)
{
    const Result<DccTree> tree = DccTree::read(xml);
    QStringList list;
    if (tree)
        for (const DccNode &node : tree->all(name))
            list << QString::fromStdString(node.text());
    return list;
}

std::vector<DccNode> withRefTypes(const DccTree &tree, const std::string &refType)
{
    std::vector<DccNode> found;
    for (const DccNode &node : tree.all()) {
        const std::vector<std::string> types = wordsIn(node.attribute("refType"));
        if (std::ranges::find(types, refType) != types.end())
            found.push_back(node);
    }
    return found;
}

QStringList below(const DccNode &node, const char *name)
{
    QStringList list;
    for (const DccNode &child : node.children()) {
        if (child.name() == name)
            list << QString::fromStdString(child.text());
        list << below(child, name);
    }
    return list;
}

} // namespace

class TestDccDocument : public QObject
{
    Q_OBJECT

private:
    CalibrationResults m_results;
    std::string m_xml;

private slots:
    void initTestCase()
    {
        m_results = example::calibration();
        m_xml = dccOfRecipe(m_results, exampleDccRecipe());
    }

    void sameSource_givesTheSameBytes()
    {
        QVERIFY(dccOfRecipe(m_results, exampleDccRecipe()) == m_xml);
    }

    void administration_isWhatWasTyped()
    {
        QCOMPARE(texts(m_xml, "uniqueIdentifier"), QStringList("draft"));
        QCOMPARE(texts(m_xml, "receiptDate"), QStringList("2026-11-02"));
        QCOMPARE(texts(m_xml, "beginPerformanceDate"), QStringList("2026-11-20"));
        QCOMPARE(texts(m_xml, "endPerformanceDate"), QStringList("2026-11-20"));
        QCOMPARE(texts(m_xml, "issueDate"), QStringList("2026-11-21"));
        QCOMPARE(texts(m_xml, "countryCode"), QStringList({"SE", "SE"}));
        QCOMPARE(texts(m_xml, "usedLangCodeISO639_1"), QStringList("en"));
        QCOMPARE(texts(m_xml, "role"), QStringList("calibrated by"));
        const QStringList contents = texts(m_xml, "content");
        for (const auto &[field, value] : example::certificateFields())
            if (!field.starts_with("date_") && field != "certificate_number")
                QVERIFY2(contents.contains(QString::fromStdString(value)), field.c_str());
    }

    void draft_saysSo_andAnIssuedOneDoesNot()
    {
        const std::string draft = "dyncal_draft\"";
        QVERIFY(m_xml.find(draft) != m_xml.npos);
        const std::string issued = dccOfRecipe(m_results, exampleDccRecipe(), exampleIssue());
        QVERIFY(issued.find(draft) == issued.npos);
        QCOMPARE(texts(issued, "uniqueIdentifier"), QStringList("17"));
        const QStringList contents = texts(issued, "content");
        QVERIFY(contents.contains(QString(64, 'a'))); // head of the audit trail
        QVERIFY(contents.contains(QString(64, 'b'))); // of results.json
        QVERIFY(texts(issued, "traceable").contains("true"));
        QVERIFY(!texts(m_xml, "traceable").contains("true"));
    }

    void amendment_namesWhatItReplaces()
    {
        CertificateIssue issue = exampleIssue();
        issue.amends = "16";
        issue.reason = "address corrected";
        const std::string xml = dccOfRecipe(m_results, exampleDccRecipe(), issue);
        QCOMPARE(texts(xml, "typeOfChange"), QStringList("amended"));
        QCOMPARE(texts(xml, "replacedUniqueIdentifier"), QStringList("16"));
        QVERIFY(texts(xml, "content").join('\n').contains("address corrected"));
    }

    void missingFields_haveAPlaceholderAndAreNamed()
    {
        Recipe bare;
        const std::string xml = dccOfRecipe(m_results, bare);
        QCOMPARE(texts(xml, "beginPerformanceDate"), QStringList("2026-11-21")); // of computation
        QCOMPARE(texts(xml, "countryCode"), QStringList({"ZZ", "ZZ"}));
        QVERIFY(texts(xml, "issueDate").isEmpty());
        const QString said = texts(xml, "content").join('\n');
        for (const char *label : {"Laboratory", "Date of calibration", "Method"})
            QVERIFY2(said.contains(QString("says nothing:\n") + label), label);
    }

    /// Each row of the first page: value, U, k digit by digit.
    void keyResults_areThePrintedOnes()
    {
        const CertificateData data
            = makeCertificate(m_results, exampleDccRecipe(), testing::kExampleCreated);
        const Result<DccTree> tree = DccTree::read(m_xml);
        QVERIFY(tree.has_value());
        int compared = 0;
        for (const CertificateTable &table : data.section("key-results")->tables) {
            if (table.id != "key-results")
                continue;
            for (const std::vector<Message> &row : table.rows) {
                const std::string refType
                    = wordsIn(refTypeOf(std::string("key-results/").append(row[0].text))).front();
                const auto found = withRefTypes(*tree, refType);
                QVERIFY2(!found.empty(), row[0].text);
                const DccNode &quantity = found.front();
                QCOMPARE(below(quantity, "value"),
                    QStringList(QString::fromStdString(printedValue(row[1])->value)));
                QCOMPARE(below(quantity, "unit"),
                    QStringList(QString::fromStdString(printedValue(row[1])->unit)));
                QCOMPARE(below(quantity, "valueExpandedMU"),
                    QStringList(QString::fromStdString(printedValue(row[2])->value)));
                QCOMPARE(below(quantity, "coverageFactor"),
                    QStringList(QString::fromStdString(printedValue(row[3])->value)));
                ++compared;
            }
        }
        QVERIFY(compared > 0);
    }

    /// Nothing that the certificate says in a table or field is without a name for machines.
    void everyPlace_hasARefType()
    {
        const CertificateData data
            = makeCertificate(m_results, exampleDccRecipe(), testing::kExampleCreated);
        const std::set<std::string> elsewhere{"administrative", "item", "statements", "figures"};
        for (const CertificateSection &section : data.sections) {
            if (elsewhere.contains(section.id))
                continue;
            for (const CertificateField &field : section.fields)
                if (!field.id.starts_with("reference_") && field.id != "method_id")
                    QVERIFY2(!refTypeOf(section.id + "." + field.id).empty(), field.id.c_str());
            for (const CertificateTable &table : section.tables)
                for (const CertificateColumn &column : table.columns) {
                    const std::string heading = column.heading.text;
                    if (table.id != "key-results" && table.id != "not-reported"
                        && !heading.starts_with("U") && heading != "k")
                        QVERIFY2(!refTypeOf(table.id + "/" + heading).empty(),
                            (table.id + "/" + heading).c_str());
                }
        }
    }

    void everyOwnRefType_isKnownAndHasAMeaning()
    {
        std::set<std::string> known;
        for (const DccRefType &one : dccRefTypes()) {
            QVERIFY2(known.insert(one.refType).second, one.refType);
            QVERIFY2(std::string_view(one.meaning).size() > 5, one.refType);
        }
        for (const DccField &field : dccFields())
            for (const std::string &one : wordsIn(field.refType))
                QVERIFY2(one.starts_with("basic_") || known.contains(one), one.c_str());
    }

    /// Of each other number there is no table to forget one in: the response, unrounded.
    void response_isThatOfTheResults()
    {
        const Result<DccTree> tree = DccTree::read(m_xml);
        const auto results = withRefTypes(*tree, "dyncal_complexResponse");
        QCOMPARE(results.size(), std::size_t(1));
        const QStringList re = below(results.front(), "valueRealXMLList").join("").split(' ');
        const QStringList im = below(results.front(), "valueImagXMLList").join("").split(' ');
        const ResponseResult &response = *m_results.response;
        QCOMPARE(re.size(), static_cast<qsizetype>(response.magnitude.size()));
        for (Index i = 0; i < response.magnitude.size(); ++i) {
            const double magnitude = std::hypot(re[i].toDouble(), im[i].toDouble());
            if (std::isfinite(response.magnitude[i]))
                QVERIFY(std::abs(magnitude / response.magnitude[i] - 1.0) < 1e-12);
            else
                QCOMPARE(re[i], QString("NaN"));
        }
        QCOMPARE(below(results.front(), "columnXMLList").size(), 2);
    }

    void withheldRow_isNaN_andSaid()
    {
        CalibrationResults results = m_results;
        auto response = std::make_shared<ResponseResult>(*results.response);
        response->magnitude[1] = response->phase_rad[1] = kUnknown;
        response->withheld.assign(
            static_cast<std::size_t>(response->magnitude.size()), WithheldReason::None);
        response->withheld[1] = WithheldReason::Alias;
        results.response = response;
        const std::string xml = dccOfRecipe(results, exampleDccRecipe());
        const Result<DccTree> tree = DccTree::read(xml);
        const auto found = withRefTypes(*tree, "dyncal_complexResponse");
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(below(found.front(), "valueRealXMLList").join("").split(' ')[1], QString("NaN"));
        QVERIFY(below(found.front(), "content").join('\n').contains("1 are withheld"));
    }

    /// Texts in both languages beside each other, what is the same in both once.
    void twoLanguages_standBesideEachOther()
    {
        const auto inCapitals = [](const Message &message, const std::string &language) {
            const std::string text = english(message);
            return language == "en" ? text : QString::fromStdString(text).toUpper().toStdString();
        };
        const std::string xml
            = dccOfRecipe(m_results, exampleDccRecipe({"en", "sv"}), {}, inCapitals);
        QCOMPARE(texts(xml, "usedLangCodeISO639_1"), QStringList({"en", "sv"}));
        QCOMPARE(texts(xml, "mandatoryLangCodeISO639_1"), QStringList("en"));
        QVERIFY(xml.find("<dcc:content lang=\"sv\">DAMPING RATIO</dcc:content>") != xml.npos);
        QVERIFY(xml.find("<dcc:content lang=\"en\">Damping ratio</dcc:content>") != xml.npos);
    }

    void emptyResults_stillGiveADocument()
    {
        const std::string xml = dccOfRecipe(CalibrationResults(), Recipe());
        QVERIFY(DccTree::read(xml).has_value());
        QCOMPARE(texts(xml, "valueRealXMLList"), QStringList());
    }

    void hostileFields_stayReadable()
    {
        Recipe recipe = exampleDccRecipe();
        for (auto &[field, value] : recipe.certificate.fields)
            value = "\x01]]><a>&\xff\n\t\"%1";
        const std::string xml = dccOfRecipe(m_results, recipe);
        QVERIFY(DccTree::read(xml).has_value());
        QCOMPARE(texts(xml, "a"), QStringList());
    }

    void budget_hasEveryLine()
    {
        const Result<DccTree> tree = DccTree::read(m_xml);
        std::size_t lines = 0;
        for (const ReportedValue &one : m_results.uncertainty->ofModel)
            lines += one.u ? one.lines.size() : 0;
        std::size_t rows = 0;
        for (const DccNode &list : withRefTypes(*tree, "dyncal_uncertaintyBudget"))
            if (list.name() == "list")
                for (const DccNode &quantity : list.children())
                    if (quantity.attribute("refType") == "dyncal_budgetContribution")
                        rows += wordsIn(below(quantity, "valueXMLList").join("").toStdString())
                                    .size();
        QVERIFY(rows >= lines);
    }
};

DYNCAL_TEST(TestDccDocument)
#include "tst_dcc_document.moc"
