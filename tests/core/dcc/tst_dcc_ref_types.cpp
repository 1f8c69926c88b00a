// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What we declare is what we write: no more and no less.

#include "core/dcc/dcc_fields.h"
#include "core/dcc/dcc_ref_types.h"
#include "core/dcc/dcc_tree.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QRegularExpression>
#include <QTest>

#include <set>

using namespace dyncal;

namespace {

using Names = std::set<QString>;

Names declared()
{
    Names names;
    for (const DccRefType &one : dccRefTypes())
        names.insert(one.refType);
    return names;
}

/// "dyncal_..." of every source of core/dcc but that of the declarations.
Names ofTheSources()
{
    Names names;
    const QDir folder(qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/core/dcc");
    for (const QString &name : folder.entryList({"*.cpp"})) {
        QFile file(folder.filePath(name));
        if (name == "dcc_ref_types.cpp" || !file.open(QFile::ReadOnly))
            continue;
        const QString text = QString::fromUtf8(file.readAll());
        const QRegularExpression own("\\bdyncal_\\w+");
        for (auto found = own.globalMatch(text); found.hasNext();)
            names.insert(found.next().captured());
    }
    return names;
}

QString missingOf(const Names &wanted, const Names &there)
{
    QStringList missing;
    for (const QString &one : wanted)
        if (!there.contains(one))
            missing << one;
    return missing.join(' ');
}

/// Own ones that elements of a document have, and those that it declares.
std::pair<Names, Names> usedAndDeclared(const std::string &xml)
{
    std::pair<Names, Names> both;
    const Result<DccTree> tree = DccTree::read(xml);
    if (!tree)
        return both;
    for (const DccNode &node : tree->all())
        for (const std::string &one : wordsIn(node.attribute("refType")))
            if (one.starts_with("dyncal_"))
                both.first.insert(QString::fromStdString(one));
    for (const DccNode &node : tree->all("refTypeDefinition"))
        both.second.insert(QString::fromStdString(node.childText("value")));
    return both;
}

} // namespace

class TestDccRefTypes : public QObject
{
    Q_OBJECT

private slots:
    void names_areOursAndUnique()
    {
        const QRegularExpression own("^dyncal_[a-z][A-Za-z0-9]*$");
        for (const DccRefType &one : dccRefTypes())
            QVERIFY2(own.match(QString::fromLatin1(one.refType)).hasMatch(), one.refType);
        QCOMPARE(declared().size(), dccRefTypes().size());
        QVERIFY(declared().size() > 100);
    }

    /// A machine's writer reads them to tell two apart.
    void meanings_areSentencesThatDiffer()
    {
        std::set<QString> meanings;
        for (const DccRefType &one : dccRefTypes()) {
            const QString meaning = QString::fromUtf8(one.meaning);
            QVERIFY2(meaning.size() > 5 && meaning.front().isUpper(), one.refType);
            QVERIFY2(meaning == meaning.simplified(), one.refType);
            QVERIFY2(!meaning.endsWith('.'), one.refType);
            QVERIFY2(meanings.insert(meaning.toLower()).second, one.refType);
        }
    }

    void sources_writeWhatIsDeclared()
    {
        const Names written = ofTheSources();
        QVERIFY(written.size() > 100);
        QCOMPARE(missingOf(written, declared()), QString());
        QCOMPARE(missingOf(declared(), written), QString());
    }

    void fields_haveDeclaredOnes()
    {
        for (const DccField &field : dccFields())
            for (const QString &one : QString::fromLatin1(field.refType).split(' '))
                QVERIFY2(!one.startsWith("dyncal_") || declared().contains(one), field.place);
    }

    /// A document declares each that it uses, and no other.
    void document_declaresWhatItUses_data()
    {
        QTest::addColumn<QByteArray>("xml");
        const auto row = [](const char *name, const std::string &xml) {
            QTest::newRow(name) << QByteArray::fromStdString(xml);
        };
        row("draft", testing::exampleDcc());
        row("issued",
            testing::dccOfRecipe(
                example::calibration(), testing::exampleDccRecipe(), testing::exampleIssue()));
        row("two languages",
            testing::dccOfRecipe(example::calibration(), testing::exampleDccRecipe({"en", "sv"}),
                {}, testing::exampleWordsInTwo().translate));
        row("without results",
            testing::dccOfRecipe(CalibrationResults(), testing::exampleDccRecipe()));
        row("without anything", testing::dccOfRecipe(CalibrationResults(), Recipe()));
    }
    void document_declaresWhatItUses()
    {
        QFETCH(QByteArray, xml);
        const auto [used, defined] = usedAndDeclared(xml.toStdString());
        QVERIFY(!used.empty());
        QCOMPARE(missingOf(used, defined), QString());
        QCOMPARE(missingOf(defined, used), QString());
        QCOMPARE(missingOf(used, declared()), QString());
    }

    void draftAndIssued_differInWhatTheySay()
    {
        const Names draft = usedAndDeclared(testing::exampleDcc()).first;
        const Names issued
            = usedAndDeclared(testing::dccOfRecipe(example::calibration(),
                                  testing::exampleDccRecipe(), testing::exampleIssue()))
                  .first;
        QVERIFY(draft.contains("dyncal_draft") && !issued.contains("dyncal_draft"));
        QVERIFY(!draft.contains("dyncal_issue") && issued.contains("dyncal_issue"));
    }

    /// The meaning stands with the name, in the document as in the table.
    void definitions_haveTheirMeanings()
    {
        const Result<DccTree> tree = DccTree::read(testing::exampleDcc());
        QVERIFY(tree.has_value());
        std::set<std::string> told;
        for (const DccNode &definition : tree->all("refTypeDefinition")) {
            const std::string name = definition.childText("value");
            const auto known = std::ranges::find_if(
                dccRefTypes(), [&](const DccRefType &one) { return name == one.refType; });
            QVERIFY2(known != dccRefTypes().end(), name.c_str());
            QVERIFY2(told.insert(name).second, name.c_str());
            const bool isThere = std::ranges::any_of(definition.children(),
                [&](const DccNode &part) { return part.childText("content") == known->meaning; });
            QVERIFY2(isThere, name.c_str());
        }
    }
};

DYNCAL_TEST(TestDccRefTypes)
#include "tst_dcc_ref_types.moc"
