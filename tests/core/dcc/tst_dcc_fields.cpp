// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of places and their refTypes, by what must hold of any such table.

#include "core/dcc/dcc_fields.h"
#include "core/dcc/dcc_tree.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

#include <map>
#include <set>

using namespace dyncal;

namespace {

/// "poles" and "Damping ratio" of "poles/Damping ratio"; "" and the whole of others.
std::pair<std::string, std::string> inTwo(const std::string &place)
{
    const std::size_t slash = place.find('/');
    return slash == place.npos ? std::pair{std::string(), place}
                               : std::pair{place.substr(0, slash), place.substr(slash + 1)};
}

/// The words of a refType that are ours.
QString ours(const DccField &field)
{
    return QString::fromLatin1(field.refType).split(' ').filter("dyncal_").join(' ');
}

QString sourcesOfTheCertificate()
{
    QString all;
    QDirIterator files(qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/core", {"*.cpp", "*.h"},
        QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.fileName().contains("/core/dcc/") && file.open(QFile::ReadOnly))
            all += QString::fromUtf8(file.readAll());
    }
    return all;
}

} // namespace

class TestDccFields : public QObject
{
    Q_OBJECT

private slots:
    void everyPlace_findsItsOwn()
    {
        std::set<std::string> places;
        for (const DccField &field : dccFields()) {
            QVERIFY2(places.insert(field.place).second, field.place);
            QCOMPARE(refTypeOf(field.place), std::string(field.refType));
        }
        QVERIFY(places.size() > 100);
    }

    void otherPlaces_haveNone_data()
    {
        QTest::addColumn<QString>("place");
        for (const char *place : {"", "/", ".", "pole", "poles/", "poles/Damping", "Poles",
                 "poles/damping ratio", "poles.Damping ratio", "Damping ratio", " poles", "poles ",
                 "conditions", "method", "dyncal_poles", "poles/Damping ratio/x"})
            QTest::newRow(place) << place;
    }
    void otherPlaces_haveNone()
    {
        QFETCH(QString, place);
        QCOMPARE(refTypeOf(place.toStdString()), std::string());
    }

    /// A begin of a place is looked up as it is, not as the text behind it goes on.
    void partOfAText_isLookedUp()
    {
        const std::string_view place = "poles/Damping ratio";
        QCOMPARE(refTypeOf(place.substr(0, 5)), std::string("dyncal_poles"));
    }

    void refTypes_areWellFormedWords()
    {
        const QRegularExpression word("^(basic|dyncal)_[a-z][A-Za-z0-9]*$");
        for (const DccField &field : dccFields()) {
            const QStringList words = QString::fromLatin1(field.refType).split(' ');
            for (const QString &one : words)
                QVERIFY2(word.match(one).hasMatch(), field.place);
            QCOMPARE(QSet<QString>(words.begin(), words.end()).size(), words.size());
        }
    }

    /// Those that PTB's lists of refTypes have; another of that begin would be invented.
    void wordsOfPtb_areKnown()
    {
        const QStringList known{"basic_measurementResult", "basic_temperature",
            "basic_humidityRelative", "basic_tableIndex0", "basic_referenceValue",
            "basic_measuredValue"};
        for (const DccField &field : dccFields())
            for (const QString &one : QString::fromLatin1(field.refType).split(' '))
                QVERIFY2(!one.startsWith("basic_") || known.contains(one), field.place);
    }

    void columns_areOfTablesThatHaveOne()
    {
        for (const DccField &field : dccFields())
            if (const std::string table = inTwo(field.place).first;
                !table.empty() && table != "conformity")
                QVERIFY2(!refTypeOf(table).empty(), field.place);
    }

    /// A machine tells the columns of a table apart: but for those that stand in place of each
    /// other, the step of a shot and the deflection of a free decay.
    void columns_areToldApart()
    {
        std::map<std::string, QStringList> columns;
        for (const DccField &field : dccFields()) {
            const auto [table, heading] = inTwo(field.place);
            if (table.empty() || table == "key-results" || heading == "Largest deflection")
                continue;
            QVERIFY2(!columns[table].contains(field.refType), field.place);
            columns[table] << field.refType;
        }
        QVERIFY(columns.size() >= 10);
        for (const auto &[table, types] : columns)
            QVERIFY2(types.filter("basic_tableIndex0").size() <= 1, table.c_str());
    }

    /// One heading is one quantity, in whatever table it stands.
    void sameHeading_isTheSameQuantity()
    {
        std::map<std::string, QString> meanings;
        int again = 0;
        for (const DccField &field : dccFields()) {
            const auto [table, heading] = inTwo(field.place);
            if (table.empty())
                continue;
            const auto [known, isNew] = meanings.try_emplace(heading, ours(field));
            QCOMPARE(known->second, ours(field));
            again += isNew ? 0 : 1;
        }
        QVERIFY(again >= 10);
    }

    void levels_areToldApart()
    {
        std::set<std::string> types;
        for (const char *level : {"low", "medium", "high"}) {
            const std::string type
                = refTypeOf(std::string("key-results/Sensitivity at the onset of the step, ")
                    + level + " level");
            QCOMPARE(type, std::string("dyncal_sensitivity dyncal_") + level + "Level");
            types.insert(type);
        }
        QCOMPARE(types.size(), std::size_t(3));
    }

    /// No place of a certificate that nothing writes any more: its names stand in the source.
    void places_areThoseOfTheCertificate()
    {
        const QString source = sourcesOfTheCertificate();
        QVERIFY(source.size() > 100000);
        for (const DccField &field : dccFields()) {
            const QString place = QString::fromLatin1(field.place);
            const QString own
                = place.contains('/') ? place.section('/', 1) : place.section('.', -1);
            const bool isStatement = place.startsWith("conformity/"); // a number of its own
            QVERIFY2(isStatement || source.contains('"' + own + '"'), field.place);
        }
    }

    /// Those that the written document has.
    void example_hasManyOfThem()
    {
        const Result<DccTree> tree = DccTree::read(testing::exampleDcc());
        QVERIFY(tree.has_value());
        std::set<std::string> written;
        for (const DccNode &node : tree->all())
            if (!node.attribute("refType").empty())
                written.insert(node.attribute("refType"));
        for (const char *place : {"key-results", "key-results/Damping ratio", "frequency-response",
                 "frequency-response/Frequency", "poles", "poles/Class", "shock", "shock/Shot",
                 "shock/Pressure step", "records", "inputs/SHA-256 of the file"})
            QVERIFY2(written.contains(refTypeOf(place)), place);
    }
};

DYNCAL_TEST(TestDccFields)
#include "tst_dcc_fields.moc"
