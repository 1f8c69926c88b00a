// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A signed certificate issued again from copies of project, recording and registry that were taken
// before: the same number and, as far as the kind of key allows, the same bytes.

#include "tests/support/test_program.h"
#include "tests/support/tool_answer.h"
#include "tests/system/signed_job.h"

#include <QCryptographicHash>
#include <QRegularExpression>
#include <QtTest>

using namespace dyncal::testing;

namespace {

QByteArray sha256(const QByteArray &bytes)
{
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
}

/// The PDF before its update as qpdf writes it with every stream unpacked, without the signature of
/// the DCC in it and what follows from that: checksum, place in the file, identifier.
QByteArray pdfWithoutSignatures(const QByteArray &pdf)
{
    const ToolAnswer plain = askTool("qpdf", {"--qdf", "--object-streams=disable", "FILE", "plain"},
        firstRevision(pdf).toStdString(), "plain");
    QString text = QString::fromLatin1(withoutXmlSignature(plain.out));
    static const QRegularExpression checksum("/CheckSum <[0-9a-f]*>");
    static const QRegularExpression identifier("/ID \\[[^\\]]*\\]");
    const qsizetype before = text.size();
    text.remove(checksum);
    return text.size() < before ? text.remove(identifier).toLatin1() : "no attachments";
}

/// Every file of an issued folder without its signatures; hashes of the files named by their names.
QMap<QString, QByteArray> withoutSignatures(const QString &folder)
{
    QMap<QString, QByteArray> files = bytesBelow(folder);
    QByteArray &manifest = files["manifest.json"], &written = files["written.json"];
    const QByteArray stated = manifest;
    for (const char *name : {"dcc.xml", "certificate.pdf"})
        for (QByteArray *list : {&manifest, &written})
            list->replace(sha256(files[name]), name);
    written.replace(sha256(stated), "manifest.json");
    files["dcc.xml"] = withoutXmlSignature(files["dcc.xml"]);
    files["certificate.pdf"] = pdfWithoutSignatures(files["certificate.pdf"]);
    return files;
}

} // namespace

class TestSignedAgain : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;
    MadeKeys m_keys;
    QString recording(const QString &name) const { return m_recordings.filePath(name); }
    QStringList by(const QString &key) const { return {"--key", m_keys.path(key + ".all.pem")}; }

    /// A first certificate is issued; then the project of the second, its recording and the
    /// registry are copied.
    bool prepare(const IssuedJob &one, const IssuedJob &copy, const QString &key) const
    {
        return one.begin(recording("other.h5")) && one.issue(by(key)).exitCode == 0
            && QFile::remove(one.path("shot.h5")) && one.begin(recording("shot.h5"))
            && std::ranges::all_of(QStringList{"shot.h5", "job.dyncal", "registry.sqlite"},
                [&](const QString &name) { return QFile::copy(one.path(name), copy.path(name)); });
    }

private slots:
    void initTestCase()
    {
        QVERIFY(simulateShortCapture(recording("shot.h5"), 7));
        QVERIFY(simulateShortCapture(recording("other.h5"), 8));
        QVERIFY(m_keys.make("rsa", "Example Laboratory"));
        QVERIFY(m_keys.make("curve", "Example Laboratory", "signer",
            {"-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1"}));
    }

    void rsa_makesTheSameBytes()
    {
        const IssuedJob one, copy;
        QVERIFY(prepare(one, copy, "rsa"));
        const Answer first = one.issue(by("rsa"));
        const Answer again = copy.issue(by("rsa"));
        QVERIFY2(first.exitCode == 0 && again.exitCode == 0, first.err + again.err);
        QCOMPARE(first.json()["number"].toInt(), 2);
        QCOMPARE(again.json()["number"].toInt(), 2);
        QCOMPARE(again.json()["head"], first.json()["head"]);
        const auto files = bytesBelow(one.output() + "/2");
        const auto same = bytesBelow(copy.output() + "/2");
        QCOMPARE(same.keys(), files.keys());
        QVERIFY(files.contains("dcc.xml") && files.contains("certificate.pdf"));
        for (auto file = files.begin(); file != files.end(); ++file)
            QVERIFY2(same[file.key()] == *file, qPrintable(file.key()));
        QCOMPARE(bytesOf(copy.registry()), bytesOf(one.registry()));
        for (const IssuedJob *job : {&one, &copy}) {
            const QJsonArray rows = verifyRows({job->output() + "/2"}, m_keys.path("root.pem"));
            QCOMPARE(rows[0].toObject()["status"].toString(), QString("valid"));
        }
    }

    /// A signature by a curve has a random number in it.
    void curve_makesTheSameButForTheSignatures()
    {
        const IssuedJob one, copy;
        QVERIFY(prepare(one, copy, "curve"));
        QCOMPARE(one.issue(by("curve")).json()["number"].toInt(), 2);
        QCOMPARE(copy.issue(by("curve")).json()["number"].toInt(), 2);
        const QString folder = one.output() + "/2", other = copy.output() + "/2";
        for (const char *name : {"/dcc.xml", "/certificate.pdf"})
            QVERIFY(bytesOf(folder + name) != bytesOf(other + name));
        QVERIFY(bytesOf(folder + "/dcc.xml").contains("<ds:Signature"));
        const auto files = withoutSignatures(folder);
        const auto same = withoutSignatures(other);
        QCOMPARE(same.keys(), files.keys());
        QVERIFY(files["certificate.pdf"].size() > files["dcc.xml"].size()); // it is in there
        QVERIFY(!files["certificate.pdf"].contains("<ds:Signature"));
        for (auto file = files.begin(); file != files.end(); ++file)
            QVERIFY2(same[file.key()] == *file, qPrintable(file.key()));
    }
};

DYNCAL_TEST(TestSignedAgain)
#include "tst_signed_again.moc"
