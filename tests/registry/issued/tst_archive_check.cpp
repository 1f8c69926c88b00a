// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/archive_check.h"

#include "core/certificate/certificate_attachments.h"
#include "tests/support/made_pdf.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using Files = std::map<std::string, std::string>;

const Files kBeside{{"results.json", "{\"a\": 1}"}, {"recipe.json", "{}"}, {"dcc.xml", "<dcc/>"},
    {"project.dyncal", "{}"}};

std::string pdfWith(std::vector<PdfAttachment> attachments)
{
    PdfArchive archive = madeArchive();
    archive.attachments = std::move(attachments);
    return *withArchiveStructure(madePages(), archive);
}

std::vector<PdfAttachment> insideOf(const Files &files)
{
    std::vector<PdfAttachment> inside;
    for (const CertificateAttachment &one : certificateAttachments(files))
        inside.push_back({one.name, one.mime, one.relationship, "said", one.bytes});
    return inside;
}

std::string faultOf(const std::vector<PdfAttachment> &inside, const Files &beside = kBeside)
{
    const auto fault = checkPdfArchive(pdfWith(inside), beside);
    return fault ? english(*fault) : std::string();
}

bool holds(const std::string &text, const char *part)
{
    return text.find(part) != text.npos;
}

} // namespace

/// What lies inside the PDF of a certificate, held against what lies beside it.
class TestArchiveCheck : public QObject
{
    Q_OBJECT

private slots:
    void sameFiles_fit()
    {
        QCOMPARE(faultOf(insideOf(kBeside)), std::string());
        Files withoutDcc = kBeside;
        withoutDcc.erase("dcc.xml");
        QCOMPARE(faultOf(insideOf(withoutDcc), withoutDcc), std::string());
    }

    void anotherByte_isNamed()
    {
        for (const char *name : {"results.json", "recipe.json", "dcc.xml"}) {
            Files other = kBeside;
            other[name] += ' ';
            const std::string fault = faultOf(insideOf(other));
            QVERIFY2(fault.starts_with(std::string(name) + " inside"), fault.c_str());
        }
    }

    void anotherRelationshipTypeOrName_isNamed()
    {
        for (int change = 0; change < 3; ++change) {
            std::vector<PdfAttachment> inside = insideOf(kBeside);
            if (change == 0)
                inside[0].relationship = "Source";
            if (change == 1)
                inside[1].mime = "text/plain";
            if (change == 2)
                inside[2].name = "recept.json";
            const std::string fault = faultOf(inside);
            QVERIFY2(holds(fault, "belongs, or is said to be"), fault.c_str());
        }
    }

    void missingAndAddedFiles_areNamed()
    {
        std::vector<PdfAttachment> inside = insideOf(kBeside);
        inside.push_back({"more.txt", "text/plain", "Data", "said", "x"});
        QVERIFY(holds(faultOf(inside), "does not belong there: more.txt"));
        inside.resize(2);
        QVERIFY(holds(faultOf(inside), "recipe.json is missing inside"));
        inside.clear();
        QVERIFY(holds(faultOf(inside), "dcc.xml is missing inside"));
    }

    void brokenStructure_isNamed()
    {
        std::string pdf = pdfWith(insideOf(kBeside));
        pdf.replace(pdf.find("/Lang"), 5, "/Lung");
        QVERIFY(holds(english(*checkPdfArchive(pdf, kBeside)), "/Lang"));
        const auto cut = checkPdfArchive(pdf.substr(0, pdf.size() - 100), kBeside);
        QVERIFY(cut && holds(english(*cut), "cannot be read"));
    }

    /// Certificates of programs before this one have neither claim nor files inside.
    void earlierPdfs_arePassed()
    {
        QVERIFY(!checkPdfArchive("%PDF-1.4 <dyncal:number>1</dyncal:number>", kBeside));
        QVERIFY(!checkPdfArchive(madePages(), kBeside));
    }
};

DYNCAL_TEST(TestArchiveCheck)
#include "tst_archive_check.moc"
