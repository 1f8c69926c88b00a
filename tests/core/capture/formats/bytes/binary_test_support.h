// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/opening/capture_open.h"

#include "tests/core/capture/capture_test_support.h"

#include <QDirIterator>
#include <QElapsedTimer>
#include <QTemporaryDir>

#include <bit>
#include <cstring>
#include <random>

namespace dyncal::testing {

/// Puts the bytes of a binary file together, in either byte order.
class ByteWriter
{
public:
    explicit ByteWriter(std::endian order = std::endian::little)
        : m_order(order)
    {
    }

    template <typename T>
    ByteWriter &put(T value)
    {
        QByteArray raw(reinterpret_cast<const char *>(&value), sizeof value);
        if (m_order != std::endian::native)
            std::reverse(raw.begin(), raw.end());
        m_bytes += raw;
        return *this;
    }
    template <typename T>
    ByteWriter &putAll(const std::vector<T> &values)
    {
        for (const T value : values)
            put(value);
        return *this;
    }
    ByteWriter &text(const QByteArray &text, qsizetype width)
    {
        m_bytes += text.leftJustified(width, '\0', true);
        return *this;
    }
    ByteWriter &text(const QByteArray &text) { return raw(text); }
    ByteWriter &raw(const QByteArray &bytes)
    {
        m_bytes += bytes;
        return *this;
    }
    ByteWriter &zeros(qsizetype count) { return raw(QByteArray(count, '\0')); }

    qsizetype size() const { return m_bytes.size(); }
    const QByteArray &bytes() const { return m_bytes; }

private:
    std::endian m_order;
    QByteArray m_bytes;
};

/// Overwrites a number inside bytes.
template <typename T>
QByteArray patched(QByteArray bytes, qsizetype at, T value)
{
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return bytes;
}

using Reader
    = Result<CaptureSet> (*)(const std::string &, const ImportSettings &, const JobControl &);

/// One way a reader may end: anything else is a bug.
enum class Outcome { Read, Refused, Wrong };

/// Reads a (possibly damaged) file and looks at every sample of what comes back. Wrong: a refusal
/// that names no finding, a channel without samples or with an impossible rate, a set without
/// shots.
inline Outcome outcomeOf(Reader reader, const std::string &path)
{
    const Result<CaptureSet> set = reader(path, {}, {});
    if (!set) {
        const bool named = set.error().findingId == "CAP-001" || set.error().findingId == "CAP-018"
            || set.error().findingId == "CAP-016" || set.error().findingId == "CAP-003";
        return named && !english(set.error().message).empty() ? Outcome::Refused : Outcome::Wrong;
    }
    if (set->shots.empty())
        return Outcome::Wrong;
    for (const Shot &shot : set->shots) {
        for (const Channel &channel : shot.channels) {
            if (channel.samples.size() == 0 || !std::isfinite(channel.sampleRate_Hz)
                || channel.sampleRate_Hz < 0.0 || !std::isfinite(channel.t0_s))
                return Outcome::Wrong;
            const Eigen::VectorXd values = physicalValues(channel, 0, channel.samples.size());
            if (values.size() != channel.samples.size())
                return Outcome::Wrong;
        }
    }
    return Outcome::Read;
}

/// Writes a file anew. Writing over an old one waits for the disk on some file systems.
inline std::string rewrite(const QString &path, const QByteArray &bytes)
{
    QFile::remove(path);
    return write(path, bytes);
}

/// Puts bytes into files of its own and reads them as any file is read.
class BytesReader
{
public:
    explicit BytesReader(QString ending)
        : m_ending(std::move(ending))
    {
    }

    Result<CaptureSet> operator()(const QByteArray &bytes, const ImportSettings &settings = {})
    {
        const QString path = m_folder.filePath(QString("f%1.%2").arg(++m_files).arg(m_ending));
        return readCapture(write(path, bytes), settings);
    }

private:
    QString m_ending;
    QTemporaryDir m_folder;
    int m_files = 0;
};

/// The test of a row "bytes", "id", "says": they are refused with this finding and these words.
inline void checkRefusal(BytesReader &readBytes)
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, id);
    QFETCH(QString, says);
    const auto set = readBytes(bytes);
    QCOMPARE(findingId(set), id.toStdString());
    QVERIFY2(contains(sentence(set), says.toStdString()), sentence(set).c_str());
}

/// What a storm of damaged files came to.
struct Storm
{
    int read = 0;
    int refused = 0;
    int wrong = 0;
    qint64 slowest_ms = 0;
};

/// Reads the file cut at every byte.
inline Storm truncateEverywhere(Reader reader, const QByteArray &whole, const QString &path)
{
    Storm storm;
    for (qsizetype size = 0; size < whole.size(); ++size) {
        const std::string name = rewrite(path, whole.left(size));
        const Outcome outcome = outcomeOf(reader, name);
        storm.read += outcome == Outcome::Read;
        storm.refused += outcome == Outcome::Refused;
        storm.wrong += outcome == Outcome::Wrong;
        if (outcome == Outcome::Wrong)
            qWarning("cut at byte %lld: neither whole nor refused", static_cast<long long>(size));
    }
    return storm;
}

/// One damaged copy: some bits, bytes, extreme numbers, or pieces moved, cut or doubled.
inline QByteArray mutant(QByteArray bytes, std::mt19937 &random)
{
    const auto upTo = [&](qsizetype end) {
        return static_cast<qsizetype>(
            random() % static_cast<std::size_t>(std::max<qsizetype>(end, 1)));
    };
    for (qsizetype change = 1 + upTo(4); change > 0 && !bytes.isEmpty(); --change) {
        const qsizetype at
            = random() % 2 ? upTo(bytes.size()) : upTo(std::min<qsizetype>(bytes.size(), 400));
        switch (random() % 6) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << upTo(8)));
            break;
        case 1:
            bytes[at] = static_cast<char>(random());
            break;
        case 2: {
            constexpr std::uint64_t kExtremes[] = {0, 1, 0x7F, 0xFF, 0x7FFF, 0x7FFFFFFF, 0x80000000,
                0xFFFFFFFF, 1ULL << 46, 1ULL << 63, ~0ULL};
            const std::uint64_t extreme = kExtremes[upTo(std::size(kExtremes))];
            const qsizetype width = std::min<qsizetype>(qsizetype(1) << upTo(4), bytes.size() - at);
            std::memcpy(bytes.data() + at, &extreme, static_cast<std::size_t>(width));
            break;
        }
        case 3:
            bytes.truncate(at);
            break;
        case 4:
            bytes.insert(at, bytes.mid(upTo(bytes.size()), 1 + upTo(16)));
            break;
        default:
            bytes.remove(at, 1 + upTo(16));
        }
    }
    return bytes;
}

/// Reads `count` damaged copies of the seeds.
inline Storm mutate(Reader reader, const QList<QByteArray> &seeds, int count, const QString &path)
{
    Storm storm;
    std::mt19937 random(20261121); // any; the same every time
    QElapsedTimer timer;
    for (int i = 0; i < count; ++i) {
        const QByteArray bytes = mutant(seeds[i % seeds.size()], random);
        const std::string name = rewrite(path, bytes);
        timer.start();
        const Outcome outcome = outcomeOf(reader, name);
        storm.slowest_ms = std::max(storm.slowest_ms, timer.elapsed());
        storm.read += outcome == Outcome::Read;
        storm.refused += outcome == Outcome::Refused;
        storm.wrong += outcome == Outcome::Wrong;
        if (outcome == Outcome::Wrong)
            qWarning("mutant %d: neither a recording nor refused", i);
    }
    return storm;
}

constexpr int kMutants = 3000;
constexpr qint64 kSlow_ms = 1000; ///< performance.md, R3

/// Files below the recordings' folder `sub` whose name ends with one of these.
inline QStringList corpusFiles(const QString &sub, const QStringList &endings)
{
    QStringList files;
    const QString folder = recordingsFolder();
    if (folder.isEmpty())
        return files;
    QDirIterator entries(folder + "/" + sub, QDir::Files, QDirIterator::Subdirectories);
    while (entries.hasNext()) {
        const QString path = entries.next();
        const bool wanted = std::any_of(endings.begin(), endings.end(),
            [&](const QString &end) { return path.endsWith(end, Qt::CaseInsensitive); });
        if (wanted)
            files += path;
    }
    files.sort();
    return files;
}

/// Reads every file: `check(path, set)` looks at what reads; a refusal must be one of these
/// findings and is printed. Returns how many read.
template <typename Check>
int readCorpus(const char *title, const QStringList &files,
    const std::vector<std::string> &refusals, const Check &check)
{
    int read = 0;
    int refused = 0;
    for (const QString &path : files) {
        const auto set = readCapture(path.toStdString(), {});
        if (set) {
            ++read;
            check(path, *set);
            continue;
        }
        ++refused;
        const std::string id = findingId(set);
        if (std::find(refusals.begin(), refusals.end(), id) == refusals.end())
            QTest::qFail((id + ": " + sentence(set)).c_str(), __FILE__, __LINE__);
        qInfo("refused (%s): %s", id.c_str(), sentence(set).c_str());
    }
    qInfo("%s: %d files, %d read, %d refused", title, int(files.size()), read, refused);
    return read;
}

} // namespace dyncal::testing
