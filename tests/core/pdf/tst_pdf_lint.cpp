// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_lint.h"

#include "tests/support/made_pdf.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const std::string &sound()
{
    static const std::string pdf = *withArchiveStructure(madePages(), madeArchive());
    return pdf;
}

/// `from` behind the last `after` replaced by as many bytes, so that every offset stays.
std::string changed(
    std::string pdf, const std::string &after, const std::string &from, std::string to)
{
    to.resize(from.size(), ' ');
    const std::size_t begin = after.empty() ? 0 : pdf.rfind(after);
    const std::size_t at = pdf.find(from, begin);
    if (begin == pdf.npos || at == pdf.npos)
        qFatal("nothing to change: %s", from.c_str());
    return pdf.replace(at, from.size(), to);
}

std::string rulesOf(const std::string &pdf)
{
    const auto faults = lintPdf(pdf);
    if (!faults)
        return "unreadable: " + english(faults.error().message);
    std::string rules;
    for (const PdfFault &fault : *faults)
        rules += (rules.empty() ? "" : " ") + fault.rule;
    return rules;
}

void row(const char *name, const char *after, const char *from, const char *to, const char *rules)
{
    QTest::newRow(name) << QString(after) << QString(from) << QString(to) << QString(rules);
}

} // namespace

/// Each single fault of a PDF's structure, made and found.
class TestPdfLint : public QObject
{
    Q_OBJECT

private slots:
    void soundOne_hasNoFault() { QCOMPARE(rulesOf(sound()), std::string()); }

    void eachMadeFault_isFound_andNoOther_data()
    {
        QTest::addColumn<QString>("after");
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("rules");
        row("version", "", "%PDF-1.7", "%PDF-2.0", "header");
        row("no identifier", "trailer", "/ID", "/IX", "identifier");
        row("no language", "", "/Lang", "/Lung", "language");
        row("title not shown", "", "/DisplayDocTitle true", "/DisplayDocTitle 1", "title-shown");
        row("no binary mark", "", "\n%", "\n ", "binary-mark");
        row("no metadata", "", "/Metadata ", "/Metabata ", "xmp");
        row("broken metadata", "", "</x:xmpmeta>", "</x:xmpmett>", "xmp");
        row("part 2", "", "<pdfaid:part>3", "<pdfaid:part>2", "claim");
        row("level A", "", "conformance>B", "conformance>A", "claim");
        row("second part", "", "<dc:format>application/pdf</dc:format>",
            "<pdfaid:part>3</pdfaid:part>", "claim");
        row("no claim", "", "pdfaid:part>3</pdfaid:part", "pdfaid:pert>3</pdfaid:pert", "claim");
        row("creator", "", "<xmp:CreatorTool>Dyncal", "<xmp:CreatorTool>Dincal", "information");
        row("producer", "", "/Producer (Qt 6)", "/Producer (Qt 5)", "information");
        row("created", "", "/CreationDate (D:2026", "/CreationDate (D:2025", "information");
        row("local time", "", "120000Z)", "120000+)", "information");
        row("modified", "", "<xmp:ModifyDate>2026", "<xmp:ModifyDate>2025", "information");
        row("author", "", "<rdf:li>Lab", "<rdf:li>Lob", "information");
        row("no intent", "", "/GTS_PDFA1", "/GTS_PDFX1", "output-intent");
        row("no profile", "", "/DestOutputProfile", "/DestOutputPrafile", "output-intent");
        row("no bookmarks", "", "/First", "/Forst", "bookmarks");
        row("no font", "", "/FontFile2", "/FontFile7", "font");
        row("no descendant", "", "/DescendantFonts", "/DascendantFonts", "font");
        row("no Unicode name", "", "/UF (recipe.json)", "/UX (recipe.json)", "file-name");
        row("other plain name", "", "/F (recipe.json)", "/F (recept.json)", "file-name");
        row("no description", "", "/Desc (every", "/Dusc (every", "description");
        row("relationship none", "", "/AFRelationship", "/AFRelationshap", "relationship");
        row("relationship unknown", "", "/Supplement /D", "/Supplemint /D", "relationship");
        row("no type", "", "/application#2fjson", "/application#20json", "mime");
        row("date", "/Params", "/ModDate", "/MotDate", "date");
        row("size", "/Params", "/Size 2", "/Size 3", "size");
        row("no size", "/Params", "/Size 2", "/Sizu 2", "size");
        row("no checksum", "/Params", "/CheckSum", "/ChockSum", "checksum");
        row("not to be unpacked", "/EmbeddedFile ", "/FlateDecode", "/Other", "file");
        row("other filter", "/EmbeddedFile ", "/FlateDecode", "/LZWDecode", "forbidden file");
        row("not associated", "", "/AF ", "/AX ", "associated associated");
        row("not named", "", "/EmbeddedFiles", "/EmbaddedFiles", "named named");
    }

    void eachMadeFault_isFound_andNoOther()
    {
        QFETCH(QString, after);
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, rules);
        QCOMPARE(
            rulesOf(changed(sound(), after.toStdString(), from.toStdString(), to.toStdString())),
            rules.toStdString());
    }

    void marks_withoutTheirDescription_areFound()
    {
        const std::string open = "<pdfaExtension:schemas>", close = "</pdfaExtension:schemas>";
        QCOMPARE(rulesOf(changed(changed(sound(), {}, open, "<!--"), {}, close, "-->")),
            std::string("marks"));
    }

    void whatAnArchiveMayNotHold_isNamed_data()
    {
        QTest::addColumn<QString>("catalog");
        QTest::addColumn<QString>("named");
        const auto add = [](const char *catalog, const char *named) {
            QTest::newRow(catalog) << QString(catalog) << QString(named);
        };
        add("/OpenAction << /S /JavaScript /JS (x) >> ", "/JS /JavaScript");
        add("/OpenAction << /S /Launch >> ", "/Launch");
        add("/AA << >> ", "/AA");
        add("/AcroForm << /XFA [ ] >> ", "/XFA");
        add("/Own [ [ << /Own << /Interpolate true >> >> ] ] ", "/Interpolate");
        add("/Own << /Interpolate false /S /GoTo >> ", "");
    }
    void whatAnArchiveMayNotHold_isNamed()
    {
        QFETCH(QString, catalog);
        QFETCH(QString, named);
        const auto pdf = withArchiveStructure(madePages(catalog.toStdString()), madeArchive());
        const auto faults = lintPdf(*pdf);
        QStringList found;
        for (const PdfFault &fault : *faults) {
            QCOMPARE(fault.rule, std::string("forbidden"));
            found += QString::fromStdString(fault.where);
        }
        QCOMPARE(found.join(' '), named);
    }

    void faults_areSentences()
    {
        const auto faults = lintPdf(changed(sound(), {}, "/FontFile2", "/FontFile7"));
        QCOMPARE(english(faults->front().message),
            std::string("The font ABCDEF+Made of the PDF is not embedded."));
        QCOMPARE(faults->front().where, std::string("ABCDEF+Made"));
    }

    // ---- of values, whatever wrote them ----

    void values_areJudgedOneByOne_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("rules");
        const auto add = [](const char *what, const char *rules) {
            QTest::newRow(what) << QString(what) << QString(rules);
        };
        add("nothing", "");
        add("header of 1.8", "header");
        add("header of 1.10", "header");
        add("profile of a printer", "");
        add("profile of four colours", "output-intent");
        add("profile too short", "output-intent");
        add("two intents", "output-intent");
        add("no title", "information information");
        add("packed metadata", "xmp");
        add("two fonts", "font font");
        add("file of no name", "file-name file-name");
        add("type without a part", "mime");
        add("size of another file", "size");
    }
    void values_areJudgedOneByOne()
    {
        QFETCH(QString, what);
        QFETCH(QString, rules);
        PdfStructure pdf = *readPdfStructure(sound());
        std::string &profile = pdf.outputIntents.front();
        if (what.startsWith("header"))
            pdf.header = "%PDF-" + what.section(' ', -1).toStdString();
        if (what == "profile of a printer")
            profile.replace(12, 4, "prtr");
        if (what == "profile of four colours")
            profile.replace(16, 4, "CMYK");
        if (what == "profile too short")
            profile.resize(100);
        if (what == "two intents")
            pdf.outputIntents.push_back(std::string(profile));
        if (what == "no title") {
            PdfMetadata metadata = madeArchive().metadata;
            metadata.title.clear();
            pdf.xmp = xmpOf(metadata);
        }
        if (what == "packed metadata")
            pdf.isXmpPlain = false;
        if (what == "two fonts")
            pdf.fontsNotEmbedded = {"A", "B"};
        if (what == "file of no name")
            for (PdfFile &file : pdf.files)
                file.attachment.name = file.plainName = "";
        if (what == "type without a part")
            pdf.files.front().attachment.mime = "json";
        if (what == "size of another file")
            ++pdf.files.front().statedSize;
        QStringList found;
        for (const PdfFault &fault : structureFaults(pdf))
            found += QString::fromStdString(fault.rule);
        QCOMPARE(found.join(' '), rules);
    }

    void claim_isKnown()
    {
        QVERIFY(claimsArchive(*readPdfStructure(sound())));
        QVERIFY(!claimsArchive(*readPdfStructure(madePages())));
    }
};

DYNCAL_TEST(TestPdfLint)
#include "tst_pdf_lint.moc"
