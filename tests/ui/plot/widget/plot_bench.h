// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/file_bytes.h"
#include "ui/plot/curves/signal_curves.h"
#include "ui/plot/widget/plot_widget.h"

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QWheelEvent>
#include <QtTest>

#include <cmath>
#include <limits>

namespace dyncal::test {

using testing::bytesOf;

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

inline PlotCurve ringing(const QString &name, CurveRole role, Index count, double duration_s)
{
    PlotCurve curve{name, role, CurveStyle::Line, {}, {}, true};
    for (Index i = 0; i < count; ++i) {
        const double t = duration_s * static_cast<double>(i) / static_cast<double>(count - 1);
        curve.x.push_back(t);
        curve.y.push_back(
            1.0 - std::exp(-t / (0.2 * duration_s)) * std::cos(60.0 * t / duration_s));
    }
    return curve;
}

inline PlotContent timeContent(Index count = 500)
{
    PlotContent content;
    content.title = "Response";
    content.summary = "One response that settles at 1.";
    content.xAxis = {"Time", "s"};
    content.yAxis = {"Signal", "V"};
    content.curves.push_back(ringing("Shot 1", CurveRole::ShotLow, count, 1e-3));
    return content;
}

inline PlotContent singularValues()
{
    PlotContent content;
    content.title = "Singular values";
    content.xAxis = {"Order", "", false, true};
    content.yAxis = {"Singular value", "", true};
    content.curves.push_back({"values", CurveRole::Measured, CurveStyle::Markers,
        {1, 2, 3, 4, 5, 6, 7, 8}, {100, 90, 10, 0.5, 0.4, 0.3, 0.0, -1.0}, true});
    return content;
}

inline constexpr Index kSpike = 1'234'567;

/// Three million zeros at 1 MS/s with one sample of 1 V, drawn through its envelope.
inline PlotContent longRecord()
{
    std::vector<std::int16_t> counts(3'000'000);
    counts[kSpike] = 1;
    Channel channel;
    channel.role = ChannelRole::Dut;
    channel.samples = RawSamples(std::move(counts));
    channel.sampleRate_Hz = 1e6;
    CaptureSet set;
    set.shots.emplace_back().channels.push_back(channel);
    return rawCurves(set, ChannelRole::Dut, [](const Channel &each) {
        return std::make_shared<const ChannelEnvelope>(*ChannelEnvelope::build(each));
    });
}

inline void show(PlotWidget &plot)
{
    plot.resize(640, 400);
    plot.show();
    QVERIFY(QTest::qWaitForWindowExposed(&plot));
    QApplication::processEvents();
}

inline void wheel(PlotWidget &plot, QPoint at, int notches, Qt::KeyboardModifiers modifiers = {})
{
    QWheelEvent event(at, plot.mapToGlobal(at), {}, QPoint(0, 120 * notches), Qt::NoButton,
        modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&plot, &event);
}

/// Number of pixels of an image that are far from white.
inline int inkedPixels(const QImage &image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += qGray(image.pixel(x, y)) < 128;
    return count;
}

/// Half a pixel of the axes, in x.
inline double pixelWidth(const PlotWidget &plot)
{
    const double span
        = plot.pixelOf(plot.xRange().end, 0).x() - plot.pixelOf(plot.xRange().begin, 0).x();
    return plot.xRange().length() / span;
}

} // namespace dyncal::test
