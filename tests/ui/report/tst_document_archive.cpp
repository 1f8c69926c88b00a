// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The structure of PDF/A-3 of what is drawn: every template, every language, drafts and issued
// certificates, by our lint and by other programs.

#include "core/certificate/certificate_attachments.h"
#include "core/pdf/pdf_lint.h"
#include "core/project/built_in_templates.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/tool_answer.h"
#include "ui/report/document_archive.h"
#include "ui/report/report_drawing.h"

#include <QColorSpace>
#include <QtTest>

#include <time.h>

#include <algorithm>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr const char *kCreated = "2026-11-21T03:04:05Z";
const std::map<std::string, std::string> kFiles{{"dcc.xml", "<dcc/>"},
    {"results.json", "{\"a\": 1}"}, {"recipe.json", "{}"}, {"project.dyncal", "{}"}};

std::string pdfOf(
    const std::vector<std::string> &languages, const ChosenTemplate &chosen, bool isIssued)
{
    Recipe recipe;
    recipe.certificate.fields = example::certificateFields();
    recipe.certificate.languages = languages;
    std::optional<CertificateIssue> issue;
    if (isIssued)
        issue = CertificateIssue{"17", {}, {}, "abc", "def", "123", certificateAttachments(kFiles)};
    ReportDrawing drawing(
        example::calibration(), recipe, kCreated, ReportParts::Certificate, chosen, issue);
    drawing.draw(std::chrono::hours(24));
    const auto drawn = drawing.take();
    return drawn ? drawn->front().bytes : std::string();
}

const std::string &issued()
{
    static const std::string pdf = pdfOf({"sv"}, {}, true);
    return pdf;
}

QString faultsOf(const std::string &pdf)
{
    const auto faults = lintPdf(pdf);
    if (!faults)
        return QString::fromStdString(english(faults.error().message));
    QStringList rules;
    for (const PdfFault &fault : *faults)
        rules += QString::fromStdString(fault.rule + ' ' + fault.where);
    return rules.join(", ");
}

} // namespace

class TestDocumentArchive : public QObject
{
    Q_OBJECT

private slots:
    void everyTemplateAndLanguage_keepsTheRules_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QStringList>("languages");
        for (const BuiltInTemplate &known : builtInTemplates())
            for (const QStringList &languages :
                {QStringList{"en"}, QStringList{"sv"}, QStringList{"de"}, QStringList{"sv", "en"}})
                QTest::newRow((known.name + ' ' + languages.join('+').toStdString()).c_str())
                    << QString::fromStdString(known.name) << languages;
    }
    void everyTemplateAndLanguage_keepsTheRules()
    {
        QFETCH(QString, name);
        QFETCH(QStringList, languages);
        std::vector<std::string> codes;
        for (const QString &code : languages)
            codes.push_back(code.toStdString());
        const std::string pdf = pdfOf(codes, *chooseTemplate(name.toStdString()), false);
        QCOMPARE(faultsOf(pdf), QString());
        const ToolAnswer check = askTool("qpdf", {"--check", "FILE"}, pdf);
        QVERIFY2(check.exitCode == 0 && check.error.isEmpty(), check.error + check.out);
        const auto structure = readPdfStructure(pdf);
        QCOMPARE(structure->language, codes.front());
        QVERIFY(structure->files.empty()); // of a draft
    }

    void issuedOne_holdsItsFiles_withTheirRelationships()
    {
        QCOMPARE(faultsOf(issued()), QString());
        const auto files = attachmentsOf(issued());
        QCOMPARE(files->size(), std::size_t(3));
        const std::array<const char *, 3> names{"dcc.xml", "results.json", "recipe.json"};
        const std::array<const char *, 3> relationships{"Alternative", "Data", "Supplement"};
        for (std::size_t i = 0; i < 3; ++i) {
            const PdfAttachment &file = (*files)[i];
            QCOMPARE(file.name, std::string(names[i]));
            QCOMPARE(file.relationship, std::string(relationships[i]));
            QCOMPARE(file.bytes, kFiles.at(file.name));
            const QString name = QString::fromStdString(file.name);
            QCOMPARE(askTool("qpdf", {"--show-attachment=" + name, "FILE"}, issued()).out,
                QByteArray::fromStdString(file.bytes));
        }
        QVERIFY2(files->back().description.starts_with("Varje beslut"),
            files->back().description.c_str());
        const auto xmp = readXmp(readPdfStructure(issued())->xmp);
        QVERIFY((xmp->marks
            == std::vector<std::pair<std::string, std::string>>{{"number", "17"}, {"amends", ""},
                {"head", "abc"}, {"results", "def"}, {"files", "123"}}));
    }

    void title_author_andContents_areThoseOfThePages()
    {
        const QByteArray said = askTool("pdfinfo", {"FILE"}, issued()).out;
        QVERIFY2(said.contains("Title:           Bevis över dynamisk kalibrering 17\n"), said);
        QVERIFY2(said.contains("Author:          "), said);
        const QByteArray pages = askTool("pdftotext", {"-layout", "FILE", "-"}, issued()).out;
        const auto structure = readPdfStructure(issued());
        QVERIFY(structure->bookmarks.size() > 8);
        for (const std::string &title : structure->bookmarks)
            QVERIFY2(pages.contains(title.c_str()), title.c_str());
        QCOMPARE(structure->bookmarks.front(), std::string("Bevis över dynamisk kalibrering"));
    }

    void bookmarks_leadToTheirPlace()
    {
        FlowBlock title, text, heading;
        title.bookmark = "One";
        heading.bookmark = QString::fromUtf8("Ab\u00adtast  rate");
        const std::vector<PlacedBlock> placed{
            {0, 0, 0.0, false}, {1, 0, 20.0, false}, {2, 1, 96.0, false}};
        const auto bookmarks = documentBookmarks(
            {title, text, heading}, placed, QRectF(0, 0, 500, 960), QRectF(50, 96, 400, 700), 96.0);
        QCOMPARE(bookmarks.size(), std::size_t(2));
        QCOMPARE(bookmarks[0].page, 0);
        QCOMPARE(bookmarks[0].height_pt, 648.0); // 9 inches
        QCOMPARE(bookmarks[1].title, std::string("Abtast rate"));
        QCOMPARE(bookmarks[1].page, 1);
        QCOMPARE(bookmarks[1].height_pt, 576.0); // 8 inches
    }

    /// Around the blocks that ask for it, as wide as the text; of what another page has, nothing.
    void signature_isSeenOverItsBlocks()
    {
        FlowBlock text, words;
        text.height = words.height = 24.0;
        words.isSignature = true;
        const QRectF page(0, 0, 500, 960), area(50, 96, 400, 700);
        const std::vector<PlacedBlock> placed{
            {0, 0, 0.0, false}, {1, 1, 96.0, false}, {2, 1, 120.0, false}, {3, 2, 0.0, false}};
        const auto place
            = documentSignaturePlace({text, words, words, words}, placed, page, area, 96.0);
        QVERIFY(place.has_value());
        QCOMPARE(place->page, 1);
        QCOMPARE(place->left_pt, 35.25); // 47 pixels
        QCOMPARE(place->right_pt, 339.75);
        QCOMPARE(place->top_pt, 578.25); // 960 - 96 - 96 + 3 pixels
        QCOMPARE(place->bottom_pt, 537.75); // 960 - 96 - 144 - 3
        QVERIFY(!documentSignaturePlace({text}, {{0, 0, 0.0, false}}, page, area, 96.0));
    }

    void pdf_inEveryTimeZone_hasTheSameBytes()
    {
        const QByteArray zoneBefore = qgetenv("TZ");
        const auto written = [](const char *zone) {
            qputenv("TZ", zone);
            ::tzset();
            return pdfOf({"en"}, *chooseTemplate("short"), true);
        };
        const std::string utc = written("UTC0");
        QVERIFY(utc.find("CreationDate (D:20261121030405Z)") != std::string::npos);
        for (const char *zone : {"A-14", "D+3:30"})
            QVERIFY2(written(zone) == utc, zone);
        zoneBefore.isNull() ? qunsetenv("TZ") : qputenv("TZ", zoneBefore);
        ::tzset();
    }

    void fonts_areEmbeddedAsSubsets()
    {
        const auto lines = askTool("pdffonts", {"FILE"}, issued()).out.trimmed().split('\n');
        QVERIFY(lines.size() > 2);
        for (const QByteArray &line : lines.mid(2))
            QVERIFY2(line.contains("+DejaVuSans") && line.contains(" yes yes yes "), line);
    }

    void profile_isThatOfSRgb()
    {
        const QColorSpace read
            = QColorSpace::fromIccProfile(QByteArray::fromStdString(sRgbProfile()));
        QVERIFY(read.isValid());
        QCOMPARE(read.primaries(), QColorSpace::Primaries::SRgb);
        QCOMPARE(QByteArray::fromStdString(sRgbProfile()).mid(8, 1), QByteArray("\x02")); // ICC v2
    }
};

DYNCAL_TEST(TestDocumentArchive)
#include "tst_document_archive.moc"
