// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the samples of a channel lie: whatever is merged, they are those that were appended.

#include "core/capture/formats/tdms/tdms_runs.h"
#include "tests/support/memory_file.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace dyncal;

namespace {

std::string randomBytes(std::size_t count)
{
    std::mt19937_64 random(count);
    std::string bytes(count, '\0');
    for (char &byte : bytes)
        byte = static_cast<char>(random());
    return bytes;
}

/// A channel as one place in the file per sample, beside the runs under test.
struct Truth
{
    Index bytes = 2;
    TdmsRuns runs;
    std::vector<std::pair<std::uint64_t, bool>> samples; ///< offset, big endian

    void append(const TdmsRun &run)
    {
        for (Index chunk = 0; chunk < run.chunks; ++chunk) {
            for (Index i = 0; i < run.perChunk; ++i)
                samples.emplace_back(run.offset
                        + static_cast<std::uint64_t>(chunk) * run.chunkStride
                        + static_cast<std::uint64_t>(i * run.stride),
                    run.bigEndian);
        }
        runs.append(run);
    }

    std::string read(const std::string &file, Index begin, Index count) const
    {
        std::string found;
        for (Index i = begin; i < begin + count; ++i) {
            const auto &[offset, bigEndian] = samples[static_cast<std::size_t>(i)];
            std::string sample = file.substr(offset, static_cast<std::size_t>(bytes));
            if (bigEndian)
                std::ranges::reverse(sample);
            found += sample;
        }
        return found;
    }
};

/// Segments one behind the other as loggers write them: mostly like the one before.
Truth randomChannel(std::mt19937_64 &random, std::uint64_t room)
{
    Truth truth;
    truth.bytes = Index(1) << (random() % 4);
    TdmsRun run;
    run.offset = random() % 50;
    bool same = false;
    for (int segment = 0; segment < 60; ++segment) {
        if (!same) {
            run.stride = truth.bytes * static_cast<Index>(random() % 3 == 0 ? 1 + random() % 9 : 1);
            run.perChunk = static_cast<Index>(random() % 3 == 0 ? random() % 300 : random() % 5);
            run.chunks = static_cast<Index>(random() % 4);
            const Index chunk = run.perChunk * run.stride;
            run.chunkStride = static_cast<std::uint64_t>(chunk) + random() % 3 * 16;
            run.bigEndian = random() % 8 == 0;
        }
        const auto bytes
            = static_cast<std::uint64_t>(std::max<Index>(run.chunks, 1) * run.perChunk * run.stride)
            + static_cast<std::uint64_t>(run.chunks) * run.chunkStride;
        if (run.offset + bytes + 64 > room)
            break;
        truth.append(run);
        run.offset += static_cast<std::uint64_t>(run.chunks) * run.chunkStride
            + (same ? 0 : random() % 2 * 32);
        same = random() % 3 != 0;
    }
    return truth;
}

std::string readOf(const Truth &truth, const SampleFile &file, Index begin, Index count)
{
    std::string target(static_cast<std::size_t>(count * truth.bytes), '?');
    const bool whole = truth.runs.read(
        file, truth.bytes, begin, count, reinterpret_cast<std::byte *>(target.data()));
    return whole ? target : "not read";
}

} // namespace

class TestTdmsRuns : public QObject
{
    Q_OBJECT

private slots:
    void anyStretch_ofAnyChannel_isItsSamples()
    {
        const std::string bytes = randomBytes(400000);
        const testing::MemoryFile memory(bytes.data(), bytes.size());
        const auto file = *SampleFile::open(memory.path());
        std::mt19937_64 random(8);
        for (int trial = 0; trial < 150; ++trial) {
            const Truth truth = randomChannel(random, bytes.size());
            const auto size = static_cast<Index>(truth.samples.size());
            QCOMPARE(truth.runs.size(), size);
            if (size == 0)
                continue;
            QVERIFY(readOf(truth, *file, 0, size) == truth.read(bytes, 0, size));
            for (int stretch = 0; stretch < 20; ++stretch) {
                const auto begin = static_cast<Index>(random() % static_cast<std::uint64_t>(size));
                const auto count
                    = 1 + static_cast<Index>(random() % static_cast<std::uint64_t>(size - begin));
                QVERIFY(readOf(truth, *file, begin, count) == truth.read(bytes, begin, count));
            }
        }
    }

    void pieces_largeAndFarApart_areRead()
    {
        // Chunks wider than what is read at once, and pieces that are read on their own.
        const std::string bytes = randomBytes(3000000);
        const testing::MemoryFile memory(bytes.data(), bytes.size());
        const auto file = *SampleFile::open(memory.path());
        for (const TdmsRun &run :
            {TdmsRun{3, 5000, 4, 700000, 2, false}, TdmsRun{0, 200, 9, 300000, 1000, false},
                TdmsRun{1, 3, 40, 70000, 2, true}, TdmsRun{5, 2, 9, 300000, 290000, false}}) {
            Truth truth;
            truth.append(run);
            QVERIFY(readOf(truth, *file, 0, run.size()) == truth.read(bytes, 0, run.size()));
            QVERIFY(
                readOf(truth, *file, 1, run.size() - 2) == truth.read(bytes, 1, run.size() - 2));
        }
    }

    void equalSegments_areOneRun()
    {
        TdmsRuns behindEachOther;
        TdmsRuns withGaps;
        TdmsRuns turned;
        for (std::uint64_t segment = 0; segment < 100000; ++segment) {
            behindEachOther.append({segment * 20, 10, 1, 0, 2, false});
            withGaps.append({segment * 100, 10, 2, 50, 2, false});
            turned.append({segment * 20, 10, 1, 0, 2, segment % 2 == 0});
        }
        QCOMPARE(behindEachOther.runs().size(), std::size_t(1));
        QCOMPARE(withGaps.runs().size(), std::size_t(1));
        QCOMPARE(turned.runs().size(), std::size_t(100000)); // the byte order is the run's
        QCOMPARE(behindEachOther.size(), Index(1000000));
        QCOMPARE(withGaps.size(), Index(2000000));
    }

    void nothing_isLeftOut()
    {
        TdmsRuns runs;
        for (const TdmsRun &run : {TdmsRun{5, 0, 3, 10, 2, false}, TdmsRun{5, 3, 0, 10, 2, false},
                 TdmsRun{5, -1, 1, 0, 2}})
            runs.append(run);
        QCOMPARE(runs.size(), Index(0));
        QVERIFY(runs.runs().empty());
    }

    void fileThatEndsBefore_isNotRead()
    {
        const std::string bytes = randomBytes(1000);
        const testing::MemoryFile memory(bytes.data(), bytes.size());
        const auto file = *SampleFile::open(memory.path());
        Truth truth;
        truth.append({0, 10, 30, 40, 2, false});
        QVERIFY(readOf(truth, *file, 0, 240) == truth.read(bytes, 0, 240));
        QCOMPARE(readOf(truth, *file, 0, 300), std::string("not read"));
        QCOMPARE(readOf(truth, *file, 299, 1), std::string("not read"));
    }
};

DYNCAL_TEST(TestTdmsRuns)
#include "tst_tdms_runs.moc"
