// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/opening/capture_open.h"
#include "core/capture/opening/format_registry.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "tests/core/capture/capture_test_support.h"

#include <QTemporaryDir>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// A capture whose samples, label and tube tell the files apart.
std::string writeCapture(const QString &path, std::int16_t mark, const std::string &tube = {})
{
    CaptureSet set;
    set.shots = {shotOf(std::vector<std::int16_t>{mark, 2, 3})};
    set.shots[0].label = "mark " + std::to_string(mark);
    if (!tube.empty())
        set.tube = {{"name", tube}};
    set.sensors["s"] = {{"serial", tube}};
    if (!writeHdf5Capture(set, {path.toStdString()}, "2026-01-02T03:04:05Z", "t"))
        qFatal("cannot write the capture");
    return path.toStdString();
}

} // namespace

class TestFormatRegistry : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString file(const QString &name) const { return m_folder.filePath(name); }

private slots:
    void readCapture_hdf5UnderAnyName_isRecognisedByContent()
    {
        const std::string path = writeCapture(file("capture.dat"), 7);
        const Result<CaptureSet> set = readCapture(path, {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->inputs.size(), std::size_t(1));
        QCOMPARE(set->inputs[0].path, path);
        QCOMPARE(set->inputs[0].file, std::string("capture.dat"));
        QCOMPARE(set->inputs[0].format, std::string("dyncal-capture"));
        QCOMPARE(set->inputs[0].sha256, sha256OfFile(path));
        QCOMPARE(set->shots.at(0).input, Index(0));
    }

    void readCapture_foreignFile_saysWhatItLooksLike_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("words");
        QTest::newRow("pdf") << QByteArray("%PDF-1.4\n1 2 3") << "PDF document";
        QTest::newRow("zip") << QByteArray("PK\x03\x04rest") << "ZIP archive or an office document";
        QTest::newRow("png") << QByteArray("\x89PNG\r\n\x1a\n") << "PNG picture";
        QTest::newRow("empty") << QByteArray() << "is empty";
        QTest::newRow("prose") << QByteArray("Dear reader,\nno samples here.\n")
                               << "text without rows of numbers";
        QTest::newRow("binary") << QByteArray("\x01\x02\x00\x03", 4) << "binary file of unknown";
    }
    void readCapture_foreignFile_saysWhatItLooksLike()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, words);
        const std::string path = write(file("foreign.h5"), bytes);
        const Result<CaptureSet> set = readCapture(path, {});
        QCOMPARE(findingId(set), std::string("CAP-001"));
        QCOMPARE(set.error().kind, ErrorKind::FileUnreadable);
        QVERIFY2(contains(sentence(set), words.toStdString()), sentence(set).c_str());
        QVERIFY(contains(sentence(set), path));
        QVERIFY(contains(sentence(set), readableFormatsText()));
    }

    void readCapture_missingFileOrFolder_saysSo()
    {
        QVERIFY(contains(sentence(readCapture("/no/such.h5", {})), "does not exist"));
        QVERIFY(contains(sentence(readCapture(m_folder.path().toStdString(), {})), "is a folder"));
    }

    void readCapture_unknownFormatName_listsTheFormats()
    {
        ImportSettings settings;
        settings.format = "wfm";
        const std::string path = writeCapture(file("f.h5"), 1);
        QCOMPARE(readCaptures({path}, settings).error().kind, ErrorKind::Usage);
        QVERIFY(contains(sentence(readCapture(path, settings)), "auto, dyncal-capture"));
    }

    void captureFormats_titles_areInTheTextForPeople()
    {
        for (const CaptureFormat &format : captureFormats()) {
            QVERIFY(contains(readableFormatsText(), format.title));
            QVERIFY(!format.extensions.empty());
        }
    }

    void readCaptures_folder_countsLikePeopleAndSkipsTheRest()
    {
        QTemporaryDir folder;
        writeCapture(folder.filePath("shot 10.h5"), 10, "late");
        writeCapture(folder.filePath("shot 9.h5"), 9, "early");
        writeCapture(folder.filePath("shot 2.h5"), 2);
        write(folder.filePath("notes.pdf"), "%PDF");
        write(folder.filePath(".hidden"), "%PDF");
        const QByteArray whole = bytesOf(folder.filePath("shot 9.h5"));
        write(folder.filePath("shot 11.h5"), whole.left(whole.size() / 2));

        const Result<CaptureSet> set = readCaptures({folder.path().toStdString()}, {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots.size(), std::size_t(3));
        const std::vector<double> marks{2, 9, 10};
        for (std::size_t i = 0; i < marks.size(); ++i) {
            QCOMPARE(set->shots[i].channels[0].samples.at(0), marks[i]);
            QCOMPARE(set->shots[i].input, static_cast<Index>(i));
        }
        QCOMPARE(set->tube.at("name"), std::string("early"));
        QCOMPARE(set->sensors.at("s").count("serial"), std::size_t(1));
        QCOMPARE(std::count_if(set->findings.begin(), set->findings.end(),
                     [](const Finding &finding) { return finding.id == "CAP-024"; }),
            std::ptrdiff_t(2));
        QCOMPARE(worstSeverity(set->findings), Severity::Caution); // the torn capture
    }

    void readCaptures_severalBadFiles_areAllInOneError()
    {
        const std::string good = writeCapture(file("good.h5"), 1);
        const std::string pdf = write(file("a.pdf"), "%PDF");
        const std::string picture = write(file("b.png"), "\x89PNG");
        const Result<CaptureSet> set = readCaptures({pdf, good, picture, "/none.h5"}, {});
        QCOMPARE(set.error().kind, ErrorKind::FileUnreadable);
        for (const std::string &part : {pdf, picture, std::string("/none.h5"), std::string("3 of")})
            QVERIFY2(contains(sentence(set), part), part.c_str());
        QVERIFY(!contains(sentence(set), good));
    }

    void readCaptures_equalFiles_areACaution()
    {
        const std::string a = writeCapture(file("a.h5"), 1);
        const std::string b = write(file("b.h5"), bytesOf(file("a.h5")));
        const std::string c = writeCapture(file("c.h5"), 3);
        const Result<CaptureSet> set = readCaptures({a, c, b}, {});
        QVERIFY(set.has_value());
        QCOMPARE(set->findings.size(), std::size_t(1));
        QCOMPARE(set->findings[0].id, std::string("CAP-011"));
        QCOMPARE(set->findings[0].severity, Severity::Caution);
        QVERIFY(contains(english(set->findings[0].message), b));
    }

    void readCaptures_nothingThere_isAnError()
    {
        QTemporaryDir empty;
        QCOMPARE(findingId(readCaptures({}, {})), std::string("CAP-001"));
        QCOMPARE(findingId(readCaptures({empty.path().toStdString()}, {})), std::string("CAP-001"));
        write(empty.filePath("notes.pdf"), "%PDF");
        QVERIFY(contains(sentence(readCaptures({empty.path().toStdString()}, {})), "PDF document"));
    }

    void readCaptures_stopRequested_isCancelled()
    {
        std::stop_source source;
        source.request_stop();
        const std::string path = writeCapture(file("stop.h5"), 1);
        const Result<CaptureSet> set = readCaptures({path}, {}, {source.get_token(), {}});
        QCOMPARE(set.error().kind, ErrorKind::Cancelled);
    }

    void readCaptures_progress_neverFallsAndEndsWithinOne()
    {
        std::vector<std::string> paths;
        for (int i = 0; i < 3; ++i)
            paths.push_back(
                writeCapture(file(QString("p%1.h5").arg(i)), static_cast<std::int16_t>(i)));
        double last = 0.0;
        bool falls = false;
        JobControl control;
        control.progress = [&](double fraction) {
            falls = falls || fraction < last;
            last = fraction;
        };
        QVERIFY(readCaptures(paths, {}, control).has_value());
        QVERIFY(!falls);
        QVERIFY(last > 0.5 && last <= 1.0);
    }
};

DYNCAL_TEST(TestFormatRegistry)
#include "tst_format_registry.moc"
