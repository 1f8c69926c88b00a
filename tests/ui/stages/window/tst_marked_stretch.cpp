// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/stages/window/marked_stretch.h"
#include "ui/stages/window/window_starts.h"

#include <QTest>

using namespace dyncal;

namespace {

/// Windows of 1 ms and 2 ms at 1 MHz; shot 3 is not used.
std::vector<WindowedResponse> twoWindows()
{
    std::vector<WindowedResponse> responses(2);
    for (std::size_t i = 0; i < 2; ++i) {
        responses[i].shot = static_cast<Index>(i) + 1;
        responses[i].sampleRate_Hz = 1e6;
        responses[i].length = 1000 * (static_cast<Index>(i) + 1);
        responses[i].start_s = 0.5 + 1e-3 * static_cast<double>(i);
    }
    return responses;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-12;
}

} // namespace

class TestMarkedStretch : public QObject
{
    Q_OBJECT

private slots:
    void entriesOfTheSameSpanAndReason_areOne()
    {
        const std::vector<ExcludedStretch> entries{
            {2, 1e-5, 2e-5, "knock"}, {1, 5e-5, 6e-5, "x"}, {1, 1e-5, 2e-5, "knock"}};
        const std::vector<MarkedStretch> marked = markedStretches(entries);
        const std::vector<MarkedStretch> expected{
            {{1e-5, 2e-5}, {1, 2}, "knock"}, {{5e-5, 6e-5}, {1}, "x"}};
        QVERIFY(marked == expected);
        // And back: the same entries, together.
        QCOMPARE(excludedStretches(marked).size(), entries.size());
        QVERIFY(markedStretches(excludedStretches(marked)) == marked);
    }

    void anotherReasonOrTheSameShotTwice_isAnother()
    {
        const std::vector<ExcludedStretch> entries{
            {1, 1e-5, 2e-5, "a"}, {2, 1e-5, 2e-5, "b"}, {1, 1e-5, 2e-5, "a"}};
        QCOMPARE(markedStretches(entries).size(), std::size_t(3));
    }

    void fault_isWhatTheCoreWouldRefuse_data()
    {
        QTest::addColumn<double>("begin_s");
        QTest::addColumn<double>("end_s");
        QTest::addColumn<int>("shot");
        QTest::addColumn<QString>("reason");
        QTest::addColumn<int>("fault");
        const auto row = [](const char *name, double begin_s, double end_s, int shot,
                             const char *reason, StretchFault fault) {
            QTest::newRow(name) << begin_s << end_s << shot << QString(reason)
                                << static_cast<int>(fault);
        };
        row("fine", 1e-4, 2e-4, 1, "x", StretchFault::None);
        row("reaches out", 9e-4, 2e-3, 1, "x", StretchFault::None);
        row("no reason", 1e-4, 2e-4, 1, "", StretchFault::NoReason);
        row("reversed", 2e-4, 1e-4, 1, "x", StretchFault::EndBeforeBegin);
        row("empty", 2e-4, 2e-4, 1, "x", StretchFault::EndBeforeBegin);
        row("behind the window", 1e-3, 2e-3, 1, "x", StretchFault::OutsideWindow);
        row("in the longer window", 1e-3, 2e-3, 2, "x", StretchFault::None);
        row("before the start", -2e-4, 0.0, 1, "x", StretchFault::OutsideWindow);
        row("shot not used", 5.0, 6.0, 3, "x", StretchFault::None);
    }
    void fault_isWhatTheCoreWouldRefuse()
    {
        QFETCH(double, begin_s);
        QFETCH(double, end_s);
        QFETCH(int, shot);
        QFETCH(QString, reason);
        QFETCH(int, fault);
        const MarkedStretch stretch{{begin_s, end_s}, {shot}, reason.toStdString()};
        QCOMPARE(static_cast<int>(faultOf(stretch, twoWindows())), fault);
    }

    void markedBeyondTheWindow_isCutToIt()
    {
        const auto responses = twoWindows();
        QCOMPARE(withinWindows({-1e-5, 4e-5}, {1}, responses), (Interval{0.0, 4e-5}));
        QCOMPARE(withinWindows({9e-4, 1.5e-3}, {1}, responses), (Interval{9e-4, 1e-3}));
        QCOMPARE(withinWindows({9e-4, 1.5e-3}, {1, 2}, responses), (Interval{9e-4, 1.5e-3}));
        QCOMPARE(withinWindows({5e-3, 6e-3}, {1}, responses), (Interval{5e-3, 6e-3}));
    }

    void startMoved_stretchStaysInTheRecord()
    {
        WindowResult window;
        window.responses = twoWindows();
        WindowSettings settings;
        settings.excludeStretches = {{1, 1e-4, 2e-4, "x"}, {2, 1e-4, 2e-4, "x"}};
        // Shot 1 begins 3.4 samples later: its start is the third sample; shot 2 stays.
        typeStarts(settings, {0.5 + 3.4e-6, 0.501, 0.5}, window);
        QCOMPARE(settings.start_s.size(), std::size_t(3));
        QVERIFY(isNear(settings.excludeStretches[0].from_s, 1e-4 - 3e-6));
        QVERIFY(isNear(settings.excludeStretches[0].to_s, 2e-4 - 3e-6));
        QVERIFY(isNear(settings.excludeStretches[1].from_s, 1e-4));
    }
};

DYNCAL_TEST(TestMarkedStretch)
#include "tst_marked_stretch.moc"
