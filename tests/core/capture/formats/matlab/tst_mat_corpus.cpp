// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/matlab/mat.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/formats/bytes/binary_test_support.h"

using namespace dyncal;
using namespace dyncal::testing;

/// MATLAB files of other programs: of scipy, of a corpus, of a laboratory.
class TestMatCorpus : public QObject
{
    Q_OBJECT

private slots:
    void scipy_writesWhatIsRead();
    void corpus_isReadOrRefused();
    void dropTower_timesInMilliseconds_areAQuestion();
    void derived_shotsAreThoseOfTheMatrix();

private:
    QTemporaryDir m_folder;
};

/// An independent writer: every format and compression of scipy.
void TestMatCorpus::scipy_writesWhatIsRead()
{
    const QString script = R"(
import sys, numpy as np, scipy.io as sio
n = 1000
y = np.sin(np.arange(n) * 0.01).reshape(-1, 1)
d = {'y': y, 'counts': np.arange(-500, 500, dtype='<i2').reshape(1, -1), 'fs': 2e6,
     'M': np.column_stack([y, y * y])}
sio.savemat(sys.argv[1], d, format='5')
sio.savemat(sys.argv[2], d, format='5', do_compression=True)
sio.savemat(sys.argv[3], d, format='4')
)";
    const QStringList paths{m_folder.filePath("scipy5.mat"), m_folder.filePath("scipy5z.mat"),
        m_folder.filePath("scipy4.mat")};
    if (!runPython(script, paths))
        QSKIP("no python3 with scipy here");
    for (const QString &path : paths) {
        const auto set = readCapture(path.toStdString(), {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QVERIFY(set->findings.empty());
        const Shot &shot = set->shots[0];
        QCOMPARE(shot.channels.size(), std::size_t(4));
        for (const Channel &channel : shot.channels) {
            QCOMPARE(channel.sampleRate_Hz, 2e6);
            QCOMPARE(channel.samples.size(), Index(1000));
        }
        for (Index k = 0; k < 1000; ++k) {
            const double y = channelNamed(shot, "y")->samples.at(k);
            QVERIFY(std::abs(y - std::sin(static_cast<double>(k) * 0.01)) < 1e-15); // numpy's sin
            QCOMPARE(channelNamed(shot, "counts")->samples.at(k), double(k - 500));
            QCOMPARE(channelNamed(shot, "M 2")->samples.at(k), y * y);
        }
    }
}

void TestMatCorpus::corpus_isReadOrRefused()
{
    const QStringList files = corpusFiles("mat_corpus", {".mat"});
    if (files.isEmpty())
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no folder mat_corpus: 0 files covered");
    int read = 0, refused = 0, otherReader = 0;
    for (const QString &path : files) {
        const QByteArray bytes = bytesOf(path);
        if (recogniseMat({}, std::string_view(bytes.constData(), std::size_t(bytes.size()))) == 0) {
            ++otherReader; // 7.3 is HDF5
            continue;
        }
        const auto set = readMat(path.toStdString(), {}, {});
        if (!set) {
            QVERIFY2(
                findingId(set) == "CAP-018" || findingId(set) == "CAP-001", sentence(set).c_str());
            ++refused;
            qInfo("refused (%s): %s", findingId(set).c_str(), sentence(set).c_str());
            continue;
        }
        ++read;
        if (path.contains("testdouble_")) { // 0, pi/4, ..., 2 pi by the corpus' own tests
            const Channel &channel = set->shots[0].channels.at(0);
            QCOMPARE(channel.name, std::string("testdouble"));
            QCOMPARE(channel.samples.size(), Index(9));
            for (Index k = 0; k < 9; ++k)
                QVERIFY(std::abs(channel.samples.at(k) - static_cast<double>(k) * M_PI / 4.0)
                    < 1e-15 * 8.0);
        }
        if (path.contains("testmatrix_")) { // rows 1..5, first column 2 and 3
            const Shot &shot = set->shots[0];
            QCOMPARE(shot.channels.size(), std::size_t(3));
            for (Index k = 0; k < 5; ++k)
                QCOMPARE(shot.channels[0].samples.at(k), double(k + 1));
            QCOMPARE(shot.channels[1].samples.at(0), 2.0);
            QCOMPARE(shot.channels[2].samples.at(0), 3.0);
        }
    }
    qInfo("MAT: %d files, %d read, %d refused, %d for another reader", int(files.size()), read,
        refused, otherReader);
    QCOMPARE(read + refused + otherReader, int(files.size()));
    QVERIFY(read >= 6);
}

/// The last column holds milliseconds, which nothing in the file says.
void TestMatCorpus::dropTower_timesInMilliseconds_areAQuestion()
{
    const QStringList files = corpusFiles("highrate_ds1_droptower", {".mat"});
    if (files.isEmpty())
        DYNCAL_SKIP_WITHOUT_DATA(
            "DYNCAL_DATA has no folder highrate_ds1_droptower: 0 files covered");
    int covered = 0;
    for (const QString &path : files) {
        if (!path.contains("Unit105"))
            continue;
        ++covered;
        const auto asked = readCapture(path.toStdString(), {});
        QVERIFY2(asked.has_value(), sentence(asked).c_str());
        QCOMPARE(asked->shots[0].channels.size(), std::size_t(6));
        QCOMPARE(asked->shots[0].channels[0].sampleRate_Hz, 0.0);
        QVERIFY(hasFinding(asked->findings, "CAP-016"));
        QVERIFY(contains(english(asked->findings[0].message), "1 MHz if milliseconds"));
        ImportSettings settings;
        settings.sampleRate_Hz = 1e6;
        const auto told = readCapture(path.toStdString(), settings);
        QVERIFY(told && told->findings.empty());
        for (const Channel &channel : told->shots[0].channels) {
            QCOMPARE(channel.samples.size(), Index(100000));
            QCOMPARE(channel.sampleRate_Hz, 1e6);
            QCOMPARE(channel.t0_s, 0.0);
        }
    }
    qInfo("drop tower: %d files covered", covered);
    QVERIFY(covered > 0);
}

void TestMatCorpus::derived_shotsAreThoseOfTheMatrix()
{
    const QStringList files = corpusFiles("derived", {"_v5.mat"});
    if (files.isEmpty())
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no folder derived: 0 files covered");
    const QString script = R"(
import sys, numpy as np, scipy.io as sio
sio.loadmat(sys.argv[1])['Y'].T.astype('<f8').tofile(sys.argv[2])
)";
    for (const QString &path : files) {
        const auto set = readCapture(path.toStdString(), {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const Shot &shot = set->shots[0];
        QCOMPARE(shot.channels.size(), std::size_t(3));
        QCOMPARE(set->findings.size(), std::size_t(1)); // the struct "meta"
        QCOMPARE(set->findings[0].id, std::string("CAP-026"));
        const QString out = m_folder.filePath("Y.f64");
        const bool compare = runPython(script, {path, out});
        const QByteArray bytes = bytesOf(out);
        for (std::size_t c = 0; c < 3; ++c) {
            const Channel &channel = shot.channels[c];
            QCOMPARE(channel.name, "Y " + std::to_string(c + 1));
            QCOMPARE(channel.sampleRate_Hz, 1e6);
            QCOMPARE(channel.samples.size(), Index(20000));
            for (Index k = 0; compare && k < 20000; ++k) {
                double expected = 0.0;
                std::memcpy(&expected, bytes.constData() + 8 * (20000 * qsizetype(c) + k), 8);
                QVERIFY(channel.samples.at(k) == expected);
            }
        }
    }
    qInfo("derived: %d files covered", int(files.size()));
}

DYNCAL_TEST(TestMatCorpus)
#include "tst_mat_corpus.moc"
