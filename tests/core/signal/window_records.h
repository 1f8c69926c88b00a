// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signal/response_window.h"
#include "core/signal/window_cutting.h"
#include "tests/support/signals.h"

#include <QTest>

#include <limits>

// What tests of the window cut from: records whose levels are known.
namespace dyncal::testing {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// 40 000 samples at 10 MS/s, arrival at sample 4000, 300 kHz, level 0.2 to 2.7.
inline StepRecord stepRecord(double noise = 0.001)
{
    StepRecord record;
    record.sensor = {300e3, 0.1};
    record.baseline = 0.2;
    record.step = 2.5;
    record.noiseSd = 2.5 * noise;
    return record;
}

inline Channel stepChannel(double noise = 0.001)
{
    return doubleChannel(stepRecord(noise).values(), 10e6, -4e-4);
}

inline Result<WindowResult> cut(
    const Channel &channel, const WindowSettings &settings = {}, const WindowContext &context = {})
{
    return cutWindows(captureSetOf({channel}), settings, context);
}

/// Unpacks a result that must be there, with one response.
inline const WindowedResponse &only(const Result<WindowResult> &result)
{
    static const WindowedResponse none;
    if (!result)
        qWarning("%s", english(result.error().message).c_str());
    return result && result->responses.size() == 1 ? result->responses[0] : none;
}

inline void compareError(const Result<WindowResult> &result, const char *id, const char *words)
{
    QVERIFY(!result);
    QCOMPARE(result.error().findingId, std::string(id));
    const std::string text = english(result.error().message);
    QVERIFY2(text.find(words) != std::string::npos, text.c_str());
    QVERIFY2(
        text.find("%1") == std::string::npos && text.find("%3") == std::string::npos, text.c_str());
}

inline const Finding *findingOf(const Result<WindowResult> &result, const std::string &id)
{
    for (const Finding &finding : result->findings) {
        if (finding.id == id)
            return &finding;
    }
    return nullptr;
}

inline WindowContext impulseContext()
{
    WindowContext context;
    context.treatment = ResponseTreatment::Impulse;
    return context;
}

} // namespace dyncal::testing
