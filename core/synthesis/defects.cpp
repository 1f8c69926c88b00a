// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/defects.h"

#include "core/base/number_text.h"
#include "core/base/portable_random.h"
#include "core/capture/channel.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kPascalPerPsi = 6894.757293168361;
constexpr double kMountFrequencyRatio = 1.0 / 25.0;
constexpr double kMountDamping = 1e-4;
constexpr double kMountWeight = 0.9;
constexpr Index kInvalidSamples = 3;
constexpr double kTubeMode_Hz = 6.8e3; ///< thesis, chapter 5
constexpr double kTubeModeSoundSpeed_m_s = 444.4; ///< its High shot
constexpr double kTubeModeAmplitude = 0.03;
constexpr Index kTubeModeStream = 4; ///< after those of scene and channels

constexpr std::array<std::pair<const char *, DefectKind>, 10> kKinds{
    {{"clip", DefectKind::Clip}, {"nan", DefectKind::Nan}, {"swap", DefectKind::Swap},
        {"nostep", DefectKind::NoStep}, {"short", DefectKind::Short}, {"fs50", DefectKind::Fs50},
        {"drift", DefectKind::Drift}, {"psi", DefectKind::Psi}, {"ringvar", DefectKind::RingVar},
        {"tubemode", DefectKind::TubeMode}}};

std::string kindNames()
{
    std::string names;
    for (const auto &[name, kind] : kKinds)
        names.append(names.empty() ? "" : ", ").append(name);
    return names;
}

std::optional<Index> wholeNumberFromOne(std::string_view text)
{
    Index number = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size() || number < 1)
        return std::nullopt;
    return number;
}

} // namespace

Result<Defect> parseDefect(const std::string &text)
{
    const std::string_view whole(text);
    const std::size_t at = whole.find('@');
    const std::string_view word = whole.substr(0, at);
    const auto known = std::find_if(
        kKinds.begin(), kKinds.end(), [&](const auto &entry) { return entry.first == word; });
    if (known == kKinds.end())
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT("core", "There is no defect '%1'; choose one of %2."),
                {std::string(word), kindNames()}});
    if (at == std::string_view::npos)
        return Defect{known->second, 0};
    const auto shot = wholeNumberFromOne(whole.substr(at + 1));
    if (!shot)
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT("core",
                        "Defect '%1': what follows '@' must be the number of a shot, from 1."),
                {text}});
    return Defect{known->second, *shot};
}

bool hasDefect(const SimulationSettings &settings, DefectKind kind, Index shot)
{
    const Index middle = (std::ssize(settings.shots) + 1) / 2;
    return std::any_of(settings.defects.begin(), settings.defects.end(), [&](const Defect &defect) {
        const bool concernsAll = defect.shot == 0 && kind != DefectKind::RingVar;
        const Index concerned = defect.shot == 0 ? middle : defect.shot;
        return defect.kind == kind && (concernsAll || concerned == shot);
    });
}

Result<void> checkDefects(const SimulationSettings &settings)
{
    for (const Defect &defect : settings.defects) {
        if (defect.shot < 0 || defect.shot > std::ssize(settings.shots))
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "A defect is asked for in shot %1, but the shots to simulate are 1 to %2."),
                    {std::to_string(defect.shot), std::to_string(settings.shots.size())}});
    }
    return {};
}

SensorSpec looselyMounted(const SensorSpec &sensor)
{
    SensorSpec loose = sensor;
    for (SensorMode &mode : loose.modes)
        mode.weight *= 1.0 - kMountWeight;
    SensorMode &first = loose.modes.front();
    loose.modes.push_back({first.f0_Hz * kMountFrequencyRatio, kMountDamping, kMountWeight});
    loose.modes.front().zeta *= 2.0;
    return loose;
}

TubeModeOfShot drawTubeMode(std::uint64_t seed, Index shot, double a5_m_s)
{
    RandomStream random(seed, shot, kTubeModeStream);
    TubeModeOfShot mode;
    mode.oscillation.frequency_Hz = kTubeMode_Hz * a5_m_s / kTubeModeSoundSpeed_m_s;
    mode.oscillation.zeta = 0.005 + 0.015 * random.nextUniform();
    mode.oscillation.phase_rad = std::numbers::pi * (2.0 * random.nextUniform() - 1.0);
    mode.amplitude = kTubeModeAmplitude * (0.7 + 0.6 * random.nextUniform());
    return mode;
}

void spoilWithInvalidSamples(Channel &channel, double time_s)
{
    const Index count = channel.samples.size();
    const Eigen::VectorXd volts = physicalValues(channel, 0, count);
    std::vector<double> values(volts.begin(), volts.end());
    const double position = std::ceil((time_s - channel.t0_s) * channel.sampleRate_Hz);
    const Index first = std::clamp<Index>(
        static_cast<Index>(position), 0, std::max<Index>(count - kInvalidSamples, 0));
    for (Index i = first; i < std::min(count, first + kInvalidSamples); ++i)
        values[static_cast<std::size_t>(i)] = std::numeric_limits<double>::quiet_NaN();
    channel.adcMin = physicalValue(channel, *channel.adcMin);
    channel.adcMax = physicalValue(channel, *channel.adcMax);
    channel.polynomial = {0.0, 1.0};
    channel.samples = RawSamples(std::move(values));
}

void mislabelAsBar(Channel &channel, double sensitivity_V_Pa)
{
    for (double &coefficient : channel.polynomial)
        coefficient /= sensitivity_V_Pa * kPascalPerPsi;
    channel.unit = "bar";
    channel.quantity = "pressure";
    channel.reference = PressureReference::Gauge;
}

void swapRoles(Shot &shot)
{
    for (Channel &channel : shot.channels) {
        if (channel.role == ChannelRole::Dut)
            channel.role = ChannelRole::DrivenSide;
        else if (channel.role == ChannelRole::DrivenSide)
            channel.role = ChannelRole::Dut;
    }
}

} // namespace dyncal
