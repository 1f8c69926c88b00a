// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A file that a section of the recipe names: found, unchanged, and in either of its two forms.

#include "core/base/content_hash.h"
#include "core/reference/certified_source.h"
#include "tests/support/made_dcc.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::dccList;
using testing::dccOf;
using testing::dccQuantity;
using testing::isNear;

namespace {

constexpr const char *kTable = "frequency_hz,magnitude,u_magnitude\n1e3,0.2,0.004\n";

CertifiedSource sourceOf(const std::string &content, const char *unit = "V/Pa")
{
    return {"comparison", "ref.file", {}, {}, unit,
        std::make_shared<const ReferenceSource>(ReferenceSource{sha256Hex(content), content})};
}

std::string faultOf(const CertifiedSource &source, ErrorKind kind)
{
    const auto read = readCertifiedSource(source);
    return read || read.error().kind != kind ? "" : english(read.error().message);
}

std::string ratios()
{
    return dccOf(dccList(dccQuantity("1 10 100", "\\kilo\\hertz")
        + dccQuantity("1 0.9 0.5", "\\one", "0.01 0.02 0.04")));
}

} // namespace

class TestCertifiedSource : public QObject
{
    Q_OBJECT

private slots:
    void form_isToldByItsFirstCharacter_data()
    {
        QTest::addColumn<QByteArray>("before");
        for (const char *before : {"", " \n\t", "\xEF\xBB\xBF", "\xEF\xBB\xBF\r\n "})
            QTest::addRow("%d bytes", int(std::string_view(before).size())) << QByteArray(before);
    }
    void form_isToldByItsFirstCharacter()
    {
        QFETCH(QByteArray, before);
        const auto read = readCertifiedSource(sourceOf(before.toStdString() + ratios(), "1"));
        if (before.contains('\n') || before.contains('\t')) // XML allows nothing before itself
            return;
        QVERIFY(read.has_value());
        QCOMPARE(read->certificate, "K-17");
    }

    void certificate_ofARatio()
    {
        const auto read = readCertifiedSource(sourceOf(ratios(), "1"));
        const ReferencePoint point = read->sensitivity.at(1e4).value();
        QVERIFY(isNear(point.magnitude, 0.9, 1e-12) && isNear(point.u_magnitude, 0.01, 1e-12));
        QVERIFY(!faultOf(sourceOf(ratios()), ErrorKind::Usage).empty()); // no V/Pa in it
    }

    void table_hasNoCertificate()
    {
        const auto read = readCertifiedSource(sourceOf(kTable));
        QVERIFY(read->certificate.empty());
        QVERIFY(isNear(read->sensitivity.at(1e3)->magnitude, 0.2));
        QVERIFY(std::isnan(read->sensitivity.at(1e3)->phase_rad));
    }

    void missingFile_namesSectionAndPath()
    {
        CertifiedSource source = sourceOf(kTable);
        source.loaded.reset();
        const std::string said = faultOf(source, ErrorKind::FileUnreadable);
        QVERIFY(said.find("ref.file") != said.npos && said.find("comparison.source") != said.npos);
    }

    void hash_mustBeTheStatedOne()
    {
        CertifiedSource source = sourceOf(kTable);
        source.sha256 = source.loaded->sha256;
        QVERIFY(readCertifiedSource(source));
        source.sha256.back() = source.sha256.back() == '0' ? '1' : '0';
        const std::string said = faultOf(source, ErrorKind::DataBlocked);
        QVERIFY(said.find(source.sha256) != said.npos);
        QVERIFY(said.find(source.loaded->sha256) != said.npos);
    }

    void list_isNamed()
    {
        CertifiedSource source = sourceOf(ratios(), "1");
        source.quantityId = "elsewhere";
        QVERIFY(faultOf(source, ErrorKind::Usage).find("elsewhere") != std::string::npos);
    }

    void emptyFile_isNoTable() { QVERIFY(!faultOf(sourceOf(""), ErrorKind::Usage).empty()); }

    /// An uncertainty of 0 is none; of a ratio the first row's is 0 by its nature.
    void uncertaintyOf0_countsAsUnknown()
    {
        const std::string head = "frequency_hz,magnitude,u_magnitude,phase_rad,u_phase_rad\n";
        for (const char *row :
            {"1e3,0.2,0,0,0.1\n", "1e3,0.2,1e-14,0,0.1\n", "1e3,0.2,1e-3,0,0\n"}) {
            CertifiedSource source = sourceOf(head + "1e2,0.2,1e-3,0,0.1\n" + row);
            const std::string fault = faultOf(source, ErrorKind::Usage);
            QVERIFY2(fault.find("at 1000 Hz is 0, which counts as unknown") != fault.npos, row);
            source.isRatio = true;
            QVERIFY(readCertifiedSource(source).has_value());
        }
        QVERIFY(readCertifiedSource(sourceOf(head + "1e3,0.2,1e-11,0,1e-9\n")).has_value());
    }
};

DYNCAL_TEST(TestCertifiedSource)
#include "tst_certified_source.moc"
