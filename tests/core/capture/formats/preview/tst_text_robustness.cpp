// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Texts that were cut, changed or made to hurt: never a crash, never a number that is not in the
// file, never more memory than the file's size justifies.

#include "core/capture/formats/preview/text_preview.h"
#include "core/capture/opening/capture_open.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/capture_test_support.h"

#include <QElapsedTimer>
#include <QTemporaryDir>

#include <sys/resource.h>

#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Whole files take milliseconds; this is for a machine busy with other things.
constexpr qint64 kHang_ms = 5000;
constexpr double kBombHang_s = 20.0; ///< of processor time, for 100 MB
/// A rate from fewer rows differs by the rounding of the times; from a wrong row by far more.
constexpr double kRateTolerance = 1e-6;
constexpr Index kFewRows = 8; ///< of which times cannot be told from samples
constexpr unsigned kSeed = 20261121;
constexpr int kMutants = 2000;

struct Sample
{
    QByteArray name;
    QByteArray text;
};

QByteArray rows(int count, const QByteArray &separator, char decimal, const QByteArray &quote)
{
    QByteArray text;
    for (int k = 0; k < count; ++k) {
        const QList<QByteArray> cells{QByteArray::number(k * 1e-6, 'e', 6),
            QByteArray::number(std::sin(0.7 * k), 'f', 6), QByteArray::number(3.25 - k, 'f', 2)};
        QByteArray line;
        for (const QByteArray &cell : cells)
            line += (line.isEmpty() ? QByteArray() : separator) + quote + cell + quote;
        text += line.replace('.', decimal) + "\n";
    }
    return text;
}

QByteArray counted(int count)
{
    QByteArray text = QByteArray::number(count) + "\r\n2.e-09\r\n3\r\n.485382\r\n";
    for (int k = 0; k < count; ++k)
        text += QByteArray::number(0.001 * std::cos(k), 'f', 9) + "\r\n";
    return text;
}

QByteArray utf16(const QByteArray &text)
{
    QByteArray wide("\xFF\xFE");
    for (const char c : text) {
        wide += c;
        wide += '\0';
    }
    return wide;
}

QByteArray lvm(const QByteArray &xColumns, char decimal, int segments)
{
    const bool multi = xColumns == "Multi";
    const QByteArray gap = multi ? "\t\t" : "\t";
    QByteArray text
        = "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t";
    text += QByteArray(1, decimal) + "\nMulti_Headings\tYes\nX_Columns\t" + xColumns
        + "\n***End_of_Header***\t\n\t\n";
    for (int s = 0; s < segments; ++s) {
        text += "Channels\t2\nSamples\t6" + gap + "6\nY_Unit_Label\tV" + gap + "bar\nX0\t0" + gap
            + "0\nDelta_X\t1.000000E-6" + gap + "1.000000E-6\n***End_of_Header***\t\nX_Value\tp\t"
            + (multi ? "X_Value\t" : "") + "q\tComment\n";
        for (int k = 0; k < 6; ++k) {
            const QByteArray x = xColumns == "No" ? QByteArray() : QByteArray::number(k) + "E-6";
            text += x + "\t" + QByteArray::number(std::sin(k + s), 'f', 6) + "\t"
                + (multi ? x + "\t" : QByteArray()) + QByteArray::number(0.5 * k, 'f', 6) + "\n";
        }
        text += "\n";
    }
    return decimal == ',' ? text.replace('.', ',') : text;
}

QList<Sample> samples()
{
    const QByteArray header = "time (s),p (bar),q\n";
    return {{"comma", header + rows(12, ",", '.', "")},
        {"semicolon", "Zeit [s];p [bar];q\n" + rows(12, ";", ',', "")},
        {"tab", "# made today\n" + QByteArray(header).replace(',', '\t') + rows(12, "\t", '.', "")},
        {"blanks", rows(12, "  ", '.', "")}, {"quoted", header + rows(12, ",", '.', "\"")},
        {"quoted commas", header + rows(12, ",", ',', "\"")}, {"counted", counted(12)},
        {"utf-16", utf16(header + rows(12, ",", '.', ""))},
        {"CR LF", QByteArray(header + rows(12, ",", '.', "")).replace("\n", "\r\n")},
        {"header rate",
            "Sample rate;1 MHz\np;q\n" + rows(12, ";", '.', "").replace("e-06;", "e6;")},
        {"comments behind", header + rows(12, ",", '.', "") + "# end\n"},
        {"lvm no", lvm("No", '.', 2)}, {"lvm one", lvm("One", ',', 2)},
        {"lvm multi", lvm("Multi", '.', 2)}};
}

/// Every whole row of `part` stands in `all` at the same place; the last one may lack digits if the
/// reader says that it may.
bool isBeginning(const CaptureSet &part, const CaptureSet &all)
{
    if (part.shots.size() > all.shots.size())
        return false;
    for (std::size_t s = 0; s < part.shots.size(); ++s) {
        for (const Channel &channel : part.shots[s].channels) {
            const Channel *whole = channelNamed(all.shots[s], channel.name);
            if (whole == nullptr || channel.samples.size() > whole->samples.size())
                return false;
            const bool said = hasFinding(part.findings, "CAP-018");
            const Index certain = channel.samples.size() - (said ? 1 : 0);
            for (Index k = 0; k < certain; ++k) {
                if (channel.samples.at(k) != whole->samples.at(k))
                    return false;
            }
            const double rate_Hz = channel.sampleRate_Hz;
            if (rate_Hz != 0.0 && std::abs(rate_Hz / whole->sampleRate_Hz - 1.0) > kRateTolerance)
                return false;
        }
    }
    return true;
}

/// What must hold of anything that was read.
bool isSane(const CaptureSet &set)
{
    bool sane = !set.shots.empty();
    for (const Shot &shot : set.shots) {
        sane = sane && !shot.channels.empty();
        for (const Channel &channel : shot.channels)
            sane = sane && std::isfinite(channel.sampleRate_Hz) && channel.sampleRate_Hz >= 0.0
                && std::isfinite(channel.t0_s) && !channel.name.empty();
    }
    return sane;
}

class Mutator
{
public:
    QByteArray changed(QByteArray text)
    {
        for (int edits = below(3) + 1; edits > 0 && !text.isEmpty(); --edits)
            edit(text);
        return text;
    }

private:
    int below(qsizetype limit)
    {
        return static_cast<int>(m_random() % static_cast<std::uint64_t>(limit));
    }

    void edit(QByteArray &text)
    {
        static const QByteArray kBytes(",;\t .-+eE0919\n\r\"#%\0\xFF\xB5nNx|/", 27);
        const int at = below(text.size());
        const int length = below(std::min<qsizetype>(40, text.size() - at)) + 1;
        switch (below(6)) {
        case 0:
            text[at] = kBytes[below(kBytes.size())];
            break;
        case 1:
            text.remove(at, length);
            break;
        case 2:
            text.insert(at, text.mid(below(text.size()), length));
            break;
        case 3:
            text.insert(at, QByteArray(below(200) + 1, kBytes[below(kBytes.size())]));
            break;
        case 4:
            text.truncate(at);
            break;
        default:
            text.insert(at, QByteArray::number(static_cast<qulonglong>(m_random())));
        }
    }

    std::mt19937_64 m_random{kSeed};
};

/// Peak of the resident memory since the last call with `reset`; 0 where that cannot be told.
qint64 peakMemory_bytes(bool reset)
{
    QFile status("/proc/self/status");
    QFile clear("/proc/self/clear_refs");
    if (reset && (!clear.open(QIODevice::WriteOnly) || clear.write("5") != 1))
        return 0;
    clear.close();
    if (!status.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray &line : status.readAll().split('\n')) {
        if (line.startsWith("VmHWM:"))
            return line.mid(6).trimmed().split(' ').first().toLongLong() * 1024;
    }
    return 0;
}

double processorTime_s()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec)
        + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

} // namespace

class TestTextRobustness : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder{quickTemplate()};

    std::string file(const QByteArray &bytes) { return write(m_folder.filePath("t.txt"), bytes); }

private slots:
    void read_cutAtEveryByte_isABeginningOrAnError_data()
    {
        QTest::addColumn<QByteArray>("text");
        for (const Sample &sample : samples())
            QTest::newRow(sample.name) << sample.text;
    }
    void read_cutAtEveryByte_isABeginningOrAnError()
    {
        QFETCH(QByteArray, text);
        const Result<CaptureSet> all = readCapture(file(text), {});
        QVERIFY2(all.has_value(), sentence(all).c_str());
        QVERIFY(isSane(*all));
        int readable = 0;
        for (qsizetype size = 0; size < text.size(); ++size) {
            const std::string path = file(text.left(size));
            const Result<CaptureSet> set = readCapture(path, {});
            const Result<TextPreview> preview = previewText(path, {});
            QVERIFY(preview.has_value() || !sentence(preview).empty());
            if (!set) {
                QVERIFY(!sentence(set).empty() && !findingId(set).empty());
                continue;
            }
            ++readable;
            // A few rows are not yet recognised as what they begin, but then ask for a rate or say
            // that they may be cut.
            const Channel &first = set->shots.at(0).channels.at(0);
            if (first.samples.size() <= kFewRows
                && (first.sampleRate_Hz == 0.0 || hasFinding(set->findings, "CAP-018")))
                continue;
            QVERIFY2(isBeginning(*set, *all), text.left(size).constData());
        }
        qInfo("%d of %d beginnings can be read", readable, int(text.size()));
    }

    void read_mutants_neverCrashOrHang()
    {
        const QList<Sample> all = samples();
        Mutator mutator;
        int readable = 0;
        qint64 longest_ms = 0;
        for (int i = 0; i < kMutants; ++i) {
            const QByteArray text = mutator.changed(all[i % all.size()].text);
            const std::string path = file(text);
            QElapsedTimer timer;
            timer.start();
            const Result<CaptureSet> set = readCapture(path, {});
            const Result<TextPreview> preview = previewText(path, {});
            longest_ms = std::max(longest_ms, timer.elapsed());
            QVERIFY2(set ? isSane(*set) : !sentence(set).empty(), text.constData());
            QVERIFY(preview.has_value() || !sentence(preview).empty());
            readable += set ? 1 : 0;
        }
        qInfo("%d of %d mutants can be read, the slowest took %lld ms", readable, kMutants,
            static_cast<long long>(longest_ms));
        QVERIFY(longest_ms < kHang_ms);
    }

    void read_fewRows_areReadOrRefusedWithASentence()
    {
        for (const char *text : {"", "\n", "time,p\n", "time (s),p\n", "# only a comment\n", "1\n",
                 "1.5", "1.5,2.5\n", "time (s),p\n0,1.5\n", "time (s),p\n0,1.5", "\xEF\xBB\xBF",
                 "\xFF\xFE", "\"", "\"\"\n", "\"1,5\"", "time (s),p\n0,1.5\n1e-6,2.5\n",
                 "LabVIEW Measurement", "LabVIEW Measurement\t\n",
                 "LabVIEW Measurement\t\n***End_of_Header***\n***End_of_Header***\nX_Value\ta\n"}) {
            const std::string path = file(text);
            const Result<CaptureSet> set = readCapture(path, {});
            QVERIFY2(set ? isSane(*set) : !sentence(set).empty(), text);
            const Result<TextPreview> preview = previewText(path, {});
            QVERIFY(preview.has_value() || !sentence(preview).empty());
        }
    }

    void read_bombs_areRefusedWithoutTheMemoryTheyClaim_data()
    {
        QTest::addColumn<QByteArray>("head");
        QTest::addColumn<QByteArray>("unit");
        QTest::addColumn<QByteArray>("tail");
        QTest::addColumn<bool>("readable");
        const auto row = [](const char *name, const QByteArray &head, const QByteArray &unit,
                             const QByteArray &tail, bool readable) {
            QTest::newRow(name) << head << unit << tail << readable;
        };
        const QByteArray wide = QByteArray("1,").repeated(1000) + "1\n";
        row("one line of cells", "", "1,", "", false);
        row("one line of digits", "", "1", "", false);
        row("one line of blanks", "", " ", "1", false);
        row("one line of quotes", "", "\"", "", false);
        row("one line behind rows", "1,2\n3,4\n5,6\n", "7,", "\n", false);
        row("one cell behind rows", "1,2\n3,4\n5,6\n", "7", "\n", false);
        row("blank lines in a wide table", wide.repeated(4), "\n", wide, false);
        row("separators in a table", "1,2\n3,4\n5,6\n", ",,,,,,,,,,,,\n", "7,8\n", true);
        const QByteArray first = "LabVIEW Measurement\t\nSeparator\tTab\n";
        row("lvm header of tabs", first, "\t", "\n", false);
        row("lvm header of lines", first, "a\n", "", false);
        const QByteArray head = first + "***End_of_Header***\t\n\n";
        const QByteArray names
            = "***End_of_Header***\nX_Value" + QByteArray("\ta").repeated(2000) + "\tComment\n";
        row("lvm short rows", head + names + "0" + QByteArray("\t1").repeated(2000) + "\n", "1\n",
            "1" + QByteArray("\t1").repeated(2000) + "\n", false);
        row("lvm short segments", head + names, "1\t1\n\n", "", false);
        row("lvm empty segments", head + names + "0\t1\n\n", "1\n\n", "", false);
    }
    void read_bombs_areRefusedWithoutTheMemoryTheyClaim()
    {
        QFETCH(QByteArray, head);
        QFETCH(QByteArray, unit);
        QFETCH(QByteArray, tail);
        QFETCH(bool, readable);
        constexpr qsizetype kBytes = 100'000'000;
        constexpr qsizetype kBlock = 1'000'000;
        const std::string path = file(head);
        QFile bomb(QString::fromStdString(path));
        QVERIFY(bomb.open(QIODevice::Append));
        const QByteArray block = unit.repeated(kBlock / unit.size());
        for (qsizetype bytes = 0; bytes < kBytes; bytes += block.size())
            QCOMPARE(bomb.write(block), block.size());
        bomb.write(tail);
        bomb.close();
        const qint64 before = peakMemory_bytes(true);
        const double start_s = processorTime_s();
        const Result<CaptureSet> set = readCapture(path, {});
        const Result<TextPreview> preview = previewText(path, {});
        const double used_s = processorTime_s() - start_s;
        const qint64 grown = peakMemory_bytes(false) - before;
        qInfo("%.2f s, %.1f MB more: %s", used_s, 1e-6 * static_cast<double>(grown),
            sentence(set).substr(0, 200).c_str());
        QCOMPARE(set.has_value(), readable);
        QVERIFY(preview.has_value() || !sentence(preview).empty());
        QVERIFY(used_s < kBombHang_s);
        // The text once, eight bytes for each value of two bytes, and as much again for the invalid
        // samples that may stand before a value.
        QVERIFY(grown < 10 * kBytes);
    }

    void readLvm_hugeClaims_areOnlyCompared()
    {
        QByteArray text = lvm("One", '.', 1);
        text.replace("Samples\t6\t6", "Samples\t1000000000000000000\t6");
        const qint64 before = peakMemory_bytes(true);
        QVERIFY(readCapture(file(text), {}).has_value());
        text.replace("Channels\t2", "Channels\t1000000000");
        QCOMPARE(findingId(readCapture(file(text), {})), std::string("CAP-018"));
        QVERIFY(peakMemory_bytes(false) - before < 16'000'000);
    }

    void read_sparseFileOfManyGigabytes_isRefusedAtOnce()
    {
        const std::string path = file("1,2\n3,4\n5,6\n");
        QFile sparse(QString::fromStdString(path));
        if (!sparse.resize(qint64(64) << 30))
            QSKIP("the file system has no sparse files of 64 GiB");
        const Result<CaptureSet> set = readCapture(path, {});
        QVERIFY(!set.has_value() && !sentence(set).empty());
    }
};

DYNCAL_TEST(TestTextRobustness)
#include "tst_text_robustness.moc"
