// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/file_kind.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

std::string sentence(const Error &error)
{
    return english(error.message);
}

bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class TestFileKind : public QObject
{
    Q_OBJECT

private slots:
    void unknownFile_saysWhatItIs_data();
    void unknownFile_saysWhatItIs();
    void isPlainText_controlCharacters_areNone();
    void isForeignFile_needsTheWholeSignature();
};

void TestFileKind::unknownFile_saysWhatItIs_data()
{
    QTest::addColumn<QByteArray>("head");
    QTest::addColumn<QString>("words");
    QTest::addColumn<bool>("foreign");
    const auto row = [](const char *name, const QByteArray &head, const char *words, bool foreign) {
        QTest::newRow(name) << head << words << foreign;
    };
    row("pdf", "%PDF-1.7", "a PDF document", true);
    row("zip", "PK\x03\x04", "a ZIP archive or an office document", true);
    row("doc", "\xD0\xCF\x11\xE0", "an old office document", true);
    row("png", "\x89PNG\r\n", "a PNG picture", true);
    row("jpeg", "\xFF\xD8\xFF\xE0", "a JPEG picture", true);
    row("gif", "GIF89a", "a GIF picture", true);
    row("gzip", "\x1F\x8B\x08", "compressed file (gzip)", true);
    row("7z", "7z\xBC\xAF", "a 7-Zip archive", true);
    row("matlab 5", "MATLAB 5.0 MAT-file, Platform", "like a MATLAB file", true);
    row("matlab 7.3", "MATLAB 7.3 MAT-file, Platform", "a MATLAB file", true);
    row("riff", "RIFF....AVI ", "a RIFF file", true);
    row("elf", QByteArray("\x7F\x45LF\x02"), "a program", true);
    row("empty", "", "is empty", false);
    row("prose", "Dear reader,", "a text without rows of numbers", false);
    row("latin",
        "sm\xF8rebr\xF8"
        "d",
        "a text without rows of numbers", false);
    row("binary", QByteArray("\0\1\2", 3), "a binary file of unknown kind", false);
}

void TestFileKind::unknownFile_saysWhatItIs()
{
    QFETCH(QByteArray, head);
    QFETCH(QString, words);
    QFETCH(bool, foreign);
    const std::string bytes = head.toStdString();
    const Error error = unknownFile("a/b.dat", bytes, "HDF5 and CSV").value();
    QCOMPARE(error.kind, ErrorKind::FileUnreadable);
    QCOMPARE(error.findingId, std::string("CAP-001"));
    QVERIFY2(contains(sentence(error), words.toStdString()), sentence(error).c_str());
    QVERIFY(contains(sentence(error), "a/b.dat"));
    QVERIFY(contains(sentence(error), "Readable are: HDF5 and CSV."));
    QCOMPARE(isForeignFile(bytes), foreign);
}

void TestFileKind::isPlainText_controlCharacters_areNone()
{
    QVERIFY(isPlainText(""));
    QVERIFY(isPlainText("1;2\r\n\t3\f"));
    QVERIFY(isPlainText("\xC2\xB5s"));
    QVERIFY(!isPlainText(std::string_view("1\0", 2)));
    QVERIFY(!isPlainText("\x1B[0m"));
}

void TestFileKind::isForeignFile_needsTheWholeSignature()
{
    for (const char *head : {"%PD", "PK", "GIF", "MATLAB 5", " %PDF", "0.1;0.2"})
        QVERIFY2(!isForeignFile(head), head);
}

DYNCAL_TEST(TestFileKind)
#include "tst_file_kind.moc"
