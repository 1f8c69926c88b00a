// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/file_descriptor.h"
#include "core/signing/awaited_bytes.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

using namespace dyncal;
using namespace std::chrono_literals;

namespace {

struct Pipe
{
    FileDescriptor out, in;
    Pipe()
    {
        int ends[2] = {-1, -1};
        if (::pipe2(ends, O_CLOEXEC) == 0) {
            out = FileDescriptor(ends[0]);
            in = FileDescriptor(ends[1]);
        }
    }
    bool put(const std::string &bytes) const
    {
        return ::write(in.get(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
    }
    void close() { in = FileDescriptor(); }
};

} // namespace

/// Answers that come late, in drops, endlessly or never.
class TestAwaitedBytes : public QObject
{
    Q_OBJECT

private:
    static Awaited read(int descriptor, std::string &bytes, const AnswerLimits &limits,
        const std::stop_token &stop = {})
    {
        return readToEnd(descriptor, limits, AnswerClock(limits, stop), bytes);
    }

private slots:
    void allBytes_areRead_data()
    {
        QTest::addColumn<int>("size");
        QTest::addColumn<bool>("isWhole");
        for (const int size : {0, 1, 4095, 4096, 4097, 9999, 10000})
            QTest::addRow("%d", size) << size << true;
        for (const int size : {10001, 14096, 60000})
            QTest::addRow("%d", size) << size << false;
    }
    void allBytes_areRead()
    {
        QFETCH(int, size);
        QFETCH(bool, isWhole);
        Pipe pipe;
        std::string sent(static_cast<std::size_t>(size), '\0'), bytes;
        for (std::size_t i = 0; i < sent.size(); ++i)
            sent[i] = static_cast<char>(i * 7 % 251);
        QVERIFY(pipe.put(sent));
        pipe.close();
        const Awaited end = read(pipe.out.get(), bytes, {.time = 5s, .bytes = 10000});
        QVERIFY(end == (isWhole ? Awaited::Whole : Awaited::TooMuch));
        QVERIFY(sent.starts_with(bytes));
        QVERIFY(isWhole ? bytes == sent : bytes.size() <= 10000 + 4096); // no more is taken
    }

    void silence_ends()
    {
        const Pipe pipe;
        std::string bytes;
        QVERIFY(pipe.put("begun"));
        QElapsedTimer timer;
        timer.start();
        QVERIFY(read(pipe.out.get(), bytes, {.time = 250ms}) == Awaited::TooLate);
        QVERIFY(timer.elapsed() >= 240 && timer.elapsed() < 2000);
        QCOMPARE(bytes, std::string("begun"));
    }

    /// The time is for all of it: one who goes on in drops gets no more than one who is silent.
    void drops_end()
    {
        const Pipe pipe;
        const std::jthread dropping([&](const std::stop_token &stop) {
            while (!stop.stop_requested() && pipe.put("."))
                std::this_thread::sleep_for(10ms);
        });
        std::string bytes;
        QElapsedTimer timer;
        timer.start();
        QVERIFY(read(pipe.out.get(), bytes, {.time = 400ms}) == Awaited::TooLate);
        QVERIFY(timer.elapsed() < 2000);
        QVERIFY(!bytes.empty());
    }

    void flood_ends()
    {
        const FileDescriptor zeros(::open("/dev/zero", O_RDONLY | O_CLOEXEC));
        std::string bytes;
        QVERIFY(read(zeros.get(), bytes, {.time = 60s, .bytes = 1000000}) == Awaited::TooMuch);
        QVERIFY(bytes.size() <= 1000000 + 4096);
    }

    void stop_isHeard()
    {
        const Pipe pipe;
        std::stop_source stop;
        const std::jthread later([&] {
            std::this_thread::sleep_for(100ms);
            stop.request_stop();
        });
        std::string bytes;
        QElapsedTimer timer;
        timer.start();
        QVERIFY(read(pipe.out.get(), bytes, {}, stop.get_token()) == Awaited::Stopped);
        QVERIFY(timer.elapsed() < 2000);
        // Also where there would be something to read.
        QVERIFY(pipe.put("x"));
        QVERIFY(read(pipe.out.get(), bytes, {}, stop.get_token()) == Awaited::Stopped);
        QVERIFY(bytes.empty());
    }

    void badDescriptors_areBroken()
    {
        std::string bytes;
        QVERIFY(read(99999, bytes, {.time = 5s}) == Awaited::Broken);
        const FileDescriptor folder(::open("/", O_RDONLY | O_CLOEXEC));
        QVERIFY(read(folder.get(), bytes, {.time = 5s}) == Awaited::Broken);
        QVERIFY(bytes.empty());
    }

    void descriptorThatDoesNotBlock_isAwaited()
    {
        Pipe pipe;
        ::fcntl(pipe.out.get(), F_SETFL, O_NONBLOCK);
        const std::jthread later([&] {
            std::this_thread::sleep_for(100ms);
            static_cast<void>(pipe.put("late"));
            std::this_thread::sleep_for(100ms);
            pipe.close();
        });
        std::string bytes;
        QVERIFY(read(pipe.out.get(), bytes, {.time = 10s}) == Awaited::Whole);
        QCOMPARE(bytes, std::string("late"));
    }

    void fullPipe_cannotBeWritten()
    {
        const Pipe pipe;
        ::fcntl(pipe.in.get(), F_SETFL, O_NONBLOCK);
        while (pipe.put(std::string(4096, 'x'))) { }
        const AnswerClock late({.time = 150ms}, {}), good({.time = 10s}, {});
        QVERIFY(late.ready(pipe.in.get(), POLLOUT) == Awaited::TooLate);
        QVERIFY(late.standing() == Awaited::TooLate);
        QVERIFY(good.standing() == Awaited::Whole);
        std::string room(65536, '\0');
        QVERIFY(::read(pipe.out.get(), room.data(), room.size()) > 0);
        QVERIFY(good.ready(pipe.in.get(), POLLOUT) == Awaited::Whole);
    }
};

DYNCAL_TEST(TestAwaitedBytes)
#include "tst_awaited_bytes.moc"
