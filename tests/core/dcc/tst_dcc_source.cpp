// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_source.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <set>

using namespace dyncal;

namespace {

/// A certificate of one section "item" with the fields, and "other" with one.
struct Made
{
    CertificateData certificate;
    CalibrationResults results = {};
    Recipe recipe = {};

    explicit Made(std::vector<CertificateField> fields)
    {
        CertificateSection item, other;
        item.id = "item";
        item.fields = std::move(fields);
        other.id = "other";
        other.fields = {{"model", {"Model", {}}, {"%1", {"of the other"}}}};
        certificate.sections = {item, other};
    }
    DccSource source() const { return {certificate, results, recipe}; }
};

QString typedOf(Message value, bool isMissing = false)
{
    const Made made({{"model", {"Model", {}}, std::move(value), isMissing}});
    return QString::fromStdString(made.source().typed("item", "model"));
}

} // namespace

class TestDccSource : public QObject
{
    Q_OBJECT

private slots:
    void field_isFoundInItsSection()
    {
        const Made made({{"maker", {"Maker", {}}, {"%1", {"a"}}},
            {"model", {"Model", {}}, {"%1", {"b"}}}, {"model", {"Model", {}}, {"%1", {"c"}}}});
        const DccSource source = made.source();
        QCOMPARE(source.field("item", "maker"), &made.certificate.sections[0].fields[0]);
        QCOMPARE(source.field("item", "model"), &made.certificate.sections[0].fields[1]);
        QCOMPARE(source.field("other", "model"), &made.certificate.sections[1].fields[0]);
        QVERIFY(!source.field("other", "maker"));
        QVERIFY(!source.field("item", "mode"));
        QVERIFY(!source.field("item", ""));
        QVERIFY(!source.field("", "model"));
        QVERIFY(!source.field("Item", "model"));
        QCOMPARE(source.typed("other", "model"), std::string("of the other"));
        QCOMPARE(source.typed("third", "model"), std::string());
    }

    void source_isADraftInEnglish()
    {
        const Made made({});
        QVERIFY(!made.source().issue);
        QCOMPARE(made.source().words.languages, std::vector<std::string>{"en"});
        QVERIFY(!made.source().field("item", "model"));
    }

    void typed_isOneLineOfWhatIsTyped_data()
    {
        QTest::addColumn<QString>("argument");
        QTest::addColumn<QString>("line");
        QTest::newRow("as it is") << "Bor\u00e5s 1"
                                  << "Bor\u00e5s 1";
        QTest::newRow("blanks") << "  a \n\t b  "
                                << "a b";
        QTest::newRow("place") << "%1"
                               << "%1";
        QTest::newRow("zero") << "0"
                              << "0";
        QTest::newRow("minus") << "-"
                               << "-";
        QTest::newRow("dash inside") << "a \u2013 b"
                                     << "a \u2013 b";
        QTest::newRow("nothing") << ""
                                 << "";
        QTest::newRow("only blanks") << " \n "
                                     << "";
        QTest::newRow("dash") << "\u2013"
                              << "";
        QTest::newRow("dash between blanks") << " \u2013\n"
                                             << "";
        const QString longer = QString("0123456789 ").repeated(500).trimmed();
        QTest::newRow("long") << longer << longer;
    }
    void typed_isOneLineOfWhatIsTyped()
    {
        QFETCH(QString, argument);
        QFETCH(QString, line);
        QCOMPARE(typedOf({"%1", {argument.toStdString()}}), line);
    }

    /// What is ours, or is missing, is not typed.
    void ours_isNotTyped()
    {
        QCOMPARE(typedOf({"%1", {"a"}}), QString("a"));
        QCOMPARE(typedOf({"%1", {"a"}}, true), QString());
        QCOMPARE(typedOf({"%1 V", {"a"}}), QString());
        QCOMPARE(typedOf({"of %1", {"a"}}), QString());
        QCOMPARE(typedOf({"not stated", {}}), QString());
        QCOMPARE(typedOf({"%1", {}}), QString());
        QCOMPARE(typedOf({}), QString());
    }

    /// Of the certificate that is made from a recipe, what was typed into it comes back.
    void recipe_comesBack()
    {
        testing::ExampleSource example;
        std::set<std::string> typed;
        const DccSource source = example.source();
        for (const CertificateSection &section : source.certificate.sections)
            for (const CertificateField &field : section.fields) {
                QVERIFY(source.field(section.id, field.id));
                typed.insert(source.typed(section.id, field.id));
            }
        for (const char *id : {"laboratory", "customer", "sensor_description", "place", "operator"})
            QVERIFY2(typed.contains(example.field(id)), id);
        QVERIFY(typed.size() > 5);
    }

    void hostileText_isFitToShow()
    {
        for (const std::string &text : test::hostileTexts()) {
            const std::string line = typedOf({"%1", {text}}).toStdString();
            QVERIFY2(test::isFitToShow(line), line.c_str());
            QCOMPARE(inOneLine(line), line);
        }
    }
};

DYNCAL_TEST(TestDccSource)
#include "tst_dcc_source.moc"
