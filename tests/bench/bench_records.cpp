// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How fast long records open and are drawn. tests/bench/run makes the files, runs this beside its
// peers and prints the table of docs/benchmarks.md.
//   bench_records --make FILE CHANNELS SAMPLES    writes a capture
//   bench_records --peak FILE                     opens it, draws it, prints the peak memory in kB
//   bench_records --benchmark_filter=...          files in the folder $DYNCAL_BENCH_DATA

#include "core/capture/channel_envelope.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/capture/opening/capture_open.h"
#include "tests/bench/recording.h"
#include "ui/plot/curves/signal_curves.h"
#include "ui/plot/values/plot_theme.h"
#include "ui/plot/values/theme.h"
#include "ui/plot/widget/plot_widget.h"

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <random>

using namespace dyncal;
using bench::recording;

namespace {

constexpr int kFrames = 200;
constexpr QSize kPlotSize(1600, 900);

std::string dataFile(const std::string &name)
{
    const char *folder = std::getenv("DYNCAL_BENCH_DATA");
    return (folder ? std::string(folder) : std::string(".")) + "/" + name;
}

CaptureSet opened(const std::string &path)
{
    Result<CaptureSet> set = openCapture(path, {});
    if (!set) {
        std::cerr << set.error().message.text << '\n';
        std::exit(1);
    }
    return std::move(*set);
}

using Envelopes = std::vector<std::shared_ptr<const ChannelEnvelope>>;

Envelopes envelopesOf(const CaptureSet &set)
{
    Envelopes envelopes;
    for (const Channel &channel : set.shots.front().channels) {
        auto built = ChannelEnvelope::build(channel);
        if (!built)
            std::exit(1);
        envelopes.push_back(std::make_shared<const ChannelEnvelope>(std::move(*built)));
    }
    return envelopes;
}

/// All channels in one plot.
PlotContent contentOf(const CaptureSet &set, const Envelopes &envelopes)
{
    PlotContent all;
    for (std::size_t i = 0; i < envelopes.size(); ++i) {
        PlotContent one = rawCurves(
            set, set.shots.front().channels[i].role, [&](const Channel &) { return envelopes[i]; });
        if (i == 0)
            all = one;
        else
            all.curves.push_back(one.curves.front());
        all.curves.back().role = static_cast<CurveRole>(i);
        all.curves.back().name = QString("channel %1").arg(i + 1);
    }
    return all;
}

/// Of one frame, milliseconds: by the clock, and of the processor (which other programs on a busy
/// machine do not lengthen; the work of the X server is not in it).
struct FrameTime
{
    double wall;
    double cpu;
};

double processTime_ms()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// Drawn, and on the screen.
FrameTime frame_ms(PlotWidget &plot, Interval x)
{
    bool drawn = false;
    const auto connection = QObject::connect(&plot, &PlotWidget::replotted, [&] { drawn = true; });
    QElapsedTimer clock;
    clock.start();
    const double before_ms = processTime_ms();
    plot.setXRange(x);
    while (!drawn)
        QCoreApplication::processEvents();
    QCoreApplication::processEvents(); // the paint that follows
    const FrameTime time{
        static_cast<double>(clock.nsecsElapsed()) * 1e-6, processTime_ms() - before_ms};
    QObject::disconnect(connection);
    return time;
}

double quantile(std::vector<FrameTime> times, double FrameTime::*which, double share)
{
    std::ranges::sort(times, {}, which);
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))].*which;
}

void report(benchmark::State &state, const std::vector<FrameTime> &times)
{
    for (const auto &[name, which] :
        {std::pair{"wall_", &FrameTime::wall}, {"cpu_", &FrameTime::cpu}}) {
        state.counters[std::string(name) + "median"] = quantile(times, which, 0.5);
        state.counters[std::string(name) + "p95"] = quantile(times, which, 0.95);
    }
}

/// Views of all scales at random places, each followed by a pan of a third of it.
std::vector<FrameTime> frames_ms(PlotWidget &plot, int count)
{
    const Interval whole = plot.xRange();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform;
    std::vector<FrameTime> times;
    while (static_cast<int>(times.size()) < count) {
        const double smallest = 500.0 / 1e8 / whole.length(); // 500 samples
        const double length = whole.length() * std::pow(smallest, uniform(random));
        const double begin = whole.begin + uniform(random) * (whole.length() - length);
        times.push_back(frame_ms(plot, {begin, begin + length}));
        times.push_back(frame_ms(plot, {begin + length / 3, begin + length * 4 / 3}));
    }
    return times;
}

void shown(PlotWidget &plot, const PlotContent &content)
{
    plot.resize(kPlotSize);
    plot.setContent(content);
    plot.show();
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 300)
        QCoreApplication::processEvents();
}

void copyBuffers(benchmark::State &state)
{
    const std::size_t bytes = 600'000'000;
    std::vector<char> from(bytes, 1);
    std::vector<char> to(bytes, 2);
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), bytes);
        benchmark::ClobberMemory();
    }
}
BENCHMARK(copyBuffers)->Unit(benchmark::kMillisecond)->Iterations(3);

void openWithPyramids(benchmark::State &state)
{
    const std::string path = dataFile("3x100M.h5");
    envelopesOf(opened(path)); // warm
    for (auto _ : state) {
        const CaptureSet set = opened(path);
        benchmark::DoNotOptimize(envelopesOf(set));
    }
}
BENCHMARK(openWithPyramids)->Unit(benchmark::kMillisecond)->Iterations(3);

void extremesInMemory(benchmark::State &state)
{
    const CaptureSet set = recording(1, 100'000'000);
    const RawSamples samples = set.shots[0].channels[0].samples.inMemory();
    for (auto _ : state)
        benchmark::DoNotOptimize(EnvelopePyramid::build(samples));
}
BENCHMARK(extremesInMemory)->Unit(benchmark::kMillisecond)->Iterations(3);

void panAndZoom(benchmark::State &state, const char *file)
{
    const CaptureSet set = opened(dataFile(file));
    const Envelopes envelopes = envelopesOf(set);
    PlotWidget plot;
    shown(plot, contentOf(set, envelopes));
    std::vector<FrameTime> times;
    for (auto _ : state)
        times = frames_ms(plot, kFrames);
    report(state, times);
}
BENCHMARK_CAPTURE(panAndZoom, 3x100M, "3x100M.h5")->Iterations(1);
BENCHMARK_CAPTURE(panAndZoom, 3x100k, "3x100k.h5")->Iterations(1);

void emptyReplot(benchmark::State &state)
{
    PlotWidget plot;
    PlotContent content;
    content.xAxis = {"Time", "s"};
    content.yAxis = {"Signal", "V"};
    shown(plot, content);
    std::vector<FrameTime> times;
    for (auto _ : state)
        times = frames_ms(plot, kFrames);
    report(state, times);
}
BENCHMARK(emptyReplot)->Iterations(1);

/// A noisy curve as drawn for one role of the theme, its pen, dash and marker: as many points as
/// are still handed to QCustomPlot one by one, or a long record.
void replotOfRole(benchmark::State &state, bool record)
{
    PlotContent content;
    if (record) {
        const CaptureSet set = opened(dataFile("3x100M.h5"));
        static const Envelopes envelopes = envelopesOf(set);
        content = contentOf(set, {envelopes.front()});
    } else {
        content.xAxis = {"Time", "s"};
        content.curves.emplace_back();
        for (int i = 0; i < 15000; ++i) {
            content.curves.front().x.push_back(1e-4 * i);
            content.curves.front().y.push_back(std::sin(1.7 * i * i));
        }
    }
    content.curves.front().role = static_cast<CurveRole>(state.range(0));
    PlotWidget plot;
    shown(plot, content);
    const Interval whole = plot.xRange();
    std::vector<FrameTime> times;
    for (auto _ : state)
        for (int i = 0; i < 40; ++i)
            times.push_back(frame_ms(plot, {whole.begin + 1e-4 * i * whole.length(), whole.end}));
    report(state, times);
    state.counters["pen"] = screenTheme(plot.palette(), plot.font())
                                .style(static_cast<CurveRole>(state.range(0)))
                                .width;
}
BENCHMARK_CAPTURE(replotOfRole, record, true)
    ->DenseRange(0, static_cast<int>(CurveRole::Suggestion))
    ->Iterations(1);
BENCHMARK_CAPTURE(replotOfRole, points, false)
    ->DenseRange(0, static_cast<int>(CurveRole::Suggestion))
    ->Iterations(1);

int make(const std::string &path, int channels, Index samples)
{
    const auto written = writeHdf5Capture(
        recording(channels, samples), {path, true}, "2026-01-01T00:00:00Z", "benchmark");
    if (!written)
        std::cerr << written.error().message.text << '\n';
    return written ? 0 : 1;
}

int peak(const std::string &path)
{
    const CaptureSet set = opened(path);
    const Envelopes envelopes = envelopesOf(set);
    PlotWidget plot;
    shown(plot, contentOf(set, envelopes));
    frames_ms(plot, 20);
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM"))
            std::cout << line << '\n';
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.size() == 4 && arguments[0] == "--make")
        return make(arguments[1], std::stoi(arguments[2]), std::stoll(arguments[3]));
    if (arguments.size() == 2 && arguments[0] == "--peak")
        return peak(arguments[1]);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
