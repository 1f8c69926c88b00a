// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_attachments.h"

#include "core/pdf/pdf_archive.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>

using namespace dyncal;

/// Which files lie inside the PDF of an issued certificate.
class TestCertificateAttachments : public QObject
{
    Q_OBJECT

private slots:
    void filesForMachines_areInside_othersBeside()
    {
        const auto inside = certificateAttachments({{"results.json", "r"}, {"recipe.json", "s"},
            {"dcc.xml", "d"}, {"project.dyncal", "p"}, {"sources/a.csv", "a"}});
        QCOMPARE(inside.size(), std::size_t(3));
        QCOMPARE(inside[0].name + inside[0].bytes, std::string("dcc.xmld"));
        QCOMPARE(inside[1].name + inside[1].bytes, std::string("results.jsonr"));
        QCOMPARE(inside[2].name + inside[2].bytes, std::string("recipe.jsons"));
        for (const CertificateAttachment &one : inside) {
            QVERIFY(
                std::ranges::find(kPdfRelationships, one.relationship) != kPdfRelationships.end());
            QVERIFY(!english(one.description).empty() && one.mime.starts_with("application/"));
        }
    }
    void whatIsNotThere_isNotInside()
    {
        QVERIFY(certificateAttachments({}).empty());
        QCOMPARE(certificateAttachments({{"recipe.json", "s"}}).size(), std::size_t(1));
    }
};

DYNCAL_TEST(TestCertificateAttachments)
#include "tst_certificate_attachments.moc"
