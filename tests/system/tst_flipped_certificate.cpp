// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bits flipped in the DCC and the PDF of a signed certificate: the built program never calls it
// valid, and says which file and why.

#include "tests/support/test_program.h"
#include "tests/support/tool_answer.h"
#include "tests/support/trial_count.h"
#include "tests/system/signed_job.h"

#include <QtTest>

#include <filesystem>
#include <random>

using namespace dyncal::testing;

namespace {

/// As xmllint writes a document canonically; empty where it is none.
QByteArray canonical(const QByteArray &xml)
{
    const ToolAnswer answer
        = askTool("xmllint", {"--nonet", "--exc-c14n", "FILE"}, xml.toStdString());
    return answer.exitCode == 0 ? answer.out : QByteArray();
}

/// What no signature covers: the place in the PDF where it stands itself.
bool isInPlaceOfSignature(const QByteArray &pdf, qsizetype at)
{
    const qsizetype begin = pdf.lastIndexOf("/Contents<");
    return begin >= 0 && at > begin && at < pdf.indexOf('>', begin);
}

} // namespace

class TestFlippedCertificate : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;
    MadeKeys m_keys;
    IssuedJob m_job;

    QString issued() const { return m_job.output() + "/1"; }
    QString trust() const { return m_keys.path("root.pem"); }

    /// A copy of the folder, by links, in which one file has these bytes.
    bool copyWith(const QString &copy, const QString &file, const QByteArray &bytes) const
    {
        std::error_code error;
        std::filesystem::copy(issued().toStdString(), copy.toStdString(),
            std::filesystem::copy_options::recursive
                | std::filesystem::copy_options::create_hard_links,
            error);
        return !error && QFile::remove(copy + '/' + file) && writeBytes(copy + '/' + file, bytes);
    }

    /// What the program says of a file by itself whose bit was flipped is right.
    static bool isRightOfFile(const QJsonObject &row, const QString &file, const QByteArray &whole,
        const QByteArray &flipped, qsizetype at)
    {
        const QString status = row["status"].toString();
        if (status == "changed" || status == "unreadable")
            return !row["first_difference"].toString().isEmpty();
        // Not covered by a signature of its own; manifest.json covers it.
        return file == "dcc.xml"
            ? canonical(withoutXmlSignature(flipped)) == canonical(withoutXmlSignature(whole))
            : isInPlaceOfSignature(whole, at);
    }

private slots:
    void initTestCase()
    {
        QVERIFY(simulateShortCapture(m_recordings.filePath("shot.h5"), 7));
        QVERIFY(m_keys.make("lab", "Example Laboratory"));
        QVERIFY(m_job.begin(m_recordings.filePath("shot.h5")));
        const Answer answer = m_job.issue({"--key", m_keys.path("lab.all.pem")});
        QVERIFY2(answer.exitCode == 0, answer.err);
        const QJsonArray rows
            = verifyRows({issued(), issued() + "/dcc.xml", issued() + "/certificate.pdf"}, trust());
        QCOMPARE(rows.size(), 3);
        for (const QJsonValue row : rows)
            QCOMPARE(row["status"].toString(), QString("valid"));
    }

    void flippedBit_isNeverValid_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("DCC") << "dcc.xml";
        QTest::newRow("PDF") << "certificate.pdf";
    }
    void flippedBit_isNeverValid()
    {
        QFETCH(QString, file);
        const QByteArray whole = bytesOf(issued() + '/' + file);
        std::mt19937_64 random(static_cast<std::uint64_t>(whole.size()));
        constexpr int kTogether = 50; // by one process, whose start would take longest
        int notCovered = 0;
        for (int done = 0; done < dyncal::trials::count(50, 1000); done += kTogether) {
            const QTemporaryDir copies;
            QStringList folders, files;
            QList<QByteArray> flipped;
            QList<qsizetype> places;
            for (int i = 0; i < kTogether; ++i) {
                places << static_cast<qsizetype>(
                    random() % static_cast<std::uint64_t>(whole.size()));
                flipped << whole;
                flipped[i][places[i]] = static_cast<char>(whole[places[i]] ^ (1 << (random() % 8)));
                folders << copies.filePath(QString::number(i));
                files << folders[i] + '/' + file;
                QVERIFY(copyWith(folders[i], file, flipped[i]));
            }
            const QJsonArray rows = verifyRows(folders + files, trust());
            QCOMPARE(rows.size(), 2 * kTogether);
            for (int i = 0; i < kTogether; ++i) {
                const QByteArray said = QByteArray::number(places[i]) + ": "
                    + QJsonDocument(QJsonArray{rows[i], rows[kTogether + i]}).toJson();
                QVERIFY2(rows[i]["status"].toString() == "changed", said);
                QVERIFY2(rows[i]["first_difference"].toString().contains(file), said);
                const QJsonObject alone = rows[kTogether + i].toObject();
                QVERIFY2(isRightOfFile(alone, file, whole, flipped[i], places[i]), said);
                notCovered
                    += alone["status"] == "changed" || alone["status"] == "unreadable" ? 0 : 1;
            }
        }
        qInfo("%s: %d flips that no signature covers, found by manifest.json", qPrintable(file),
            notCovered);
    }
};

DYNCAL_TEST(TestFlippedCertificate)
#include "tst_flipped_certificate.moc"
