// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_fields_measurement.h"

#include "core/project/gas_names.h"
#include "core/project/recipe_limits.h"

namespace dyncal {
namespace {

constexpr Index kMostSamples = 1000000000;

std::vector<std::string> substanceNames()
{
    std::vector<std::string> names{"custom"};
    for (const auto &[name, settings] : namedGases())
        names.push_back(name);
    return names;
}

Codec<GasSettings> gas()
{
    std::string names;
    for (const auto &[name, settings] : namedGases())
        names += "\"" + name + "\", ";
    const std::string needs = "one of " + names + "or an object with gamma and molar_mass_kg_mol";
    const Codec<GasSettings> plain = object<GasSettings>({
        field("gamma", &GasSettings::gamma, number(1.0, 2.0, Bound::Exclusive), true),
        field("molar_mass_kg_mol", &GasSettings::molarMass_kg_mol,
            number(0.0, 1.0, Bound::Exclusive), true),
        field("substance", &GasSettings::substance, oneOf(substanceNames())),
        field("heat_capacity", &GasSettings::heatCapacity,
            oneOf({kConstantHeatCapacity, kVariableHeatCapacity})),
    });
    const auto read = [plain, needs](const JsonAt &at) -> Result<GasSettings> {
        for (const auto &[name, settings] : namedGases()) {
            if (at.value == name)
                return settings;
        }
        if (!at.value.is_object())
            return mismatch(at, needs);
        Result<GasSettings> typed = plain.read(at);
        if (typed && !at.value.contains("substance"))
            typed->substance = "custom";
        return typed;
    };
    return {needs, read, plain.write, plain.paths};
}

/// null = found in the record, one time, or a list with a time or null per shot; two members share
/// the key.
Field<ArrivalSensor> arrival()
{
    const auto one = orNull(anyNumber());
    const auto perShot = list(one, 1);
    const std::string needs = "null, a time in seconds or a list of one time or null per shot";
    return {"arrival_s",
        [=](const JsonAt &at, ArrivalSensor &sensor) -> Result<void> {
            if (!at.value.is_array() && !at.value.is_number() && !at.value.is_null())
                return mismatch(at, needs);
            if (!at.value.is_array()) {
                const auto value = one.read(at);
                if (!value)
                    return tl::unexpected<Error>(value.error());
                sensor.arrival_s = *value;
                return {};
            }
            auto values = perShot.read(at);
            if (!values)
                return tl::unexpected<Error>(values.error());
            sensor.shotArrival_s = std::move(*values);
            return {};
        },
        [=](const ArrivalSensor &sensor) {
            return sensor.shotArrival_s.empty() ? one.write(sensor.arrival_s)
                                                : perShot.write(sensor.shotArrival_s);
        }};
}

Codec<ArrivalSensor> arrivalSensor()
{
    return object<ArrivalSensor>({
        field("channel", &ArrivalSensor::channel, nonEmptyText(), true),
        field(
            "distance_to_end_wall_m", &ArrivalSensor::distanceToEndWall_m, positiveNumber(), true),
        field("u_distance_m", &ArrivalSensor::u_distance_m, nonNegativeNumber()),
        arrival(),
        field("u_arrival_s", &ArrivalSensor::u_arrival_s, nonNegativeNumber()),
        field("delay_s", &ArrivalSensor::delay_s, orNull(anyNumber())),
        field("u_delay_s", &ArrivalSensor::u_delay_s, nonNegativeNumber()),
    });
}

Codec<CounterReading> counterReading()
{
    using C = CounterReading;
    return object<C>({
        field("far_m", &C::far_m, positiveNumber(), true),
        field("near_m", &C::near_m, nonNegativeNumber(), true),
        field("time_s", &C::time_s, positiveNumber(), true),
        field("u_distance_m", &C::u_distance_m, nonNegativeNumber()),
        field("u_time_s", &C::u_time_s, nonNegativeNumber()),
    });
}

Codec<ExcludedStretch> excludedStretch()
{
    using S = ExcludedStretch;
    return object<S>({
        field("shot", &S::shot, whole(1, kMostShots), true),
        field("from_s", &S::from_s, anyNumber(), true),
        field("to_s", &S::to_s, positiveNumber(), true),
        field("reason", &S::reason, nonEmptyText(), true),
    });
}

/// "auto" (nothing in the list), one time, or one time per shot.
Codec<std::vector<double>> start()
{
    const std::string needs = "\"auto\", a time in seconds or a list of one time per shot";
    const Codec<std::vector<double>> times = list(anyNumber(), 1);
    const auto read = [=](const JsonAt &at) -> Result<std::vector<double>> {
        if (at.value == "auto")
            return std::vector<double>();
        if (at.value.is_number())
            return std::vector<double>{at.value.get<double>()};
        if (!at.value.is_array())
            return mismatch(at, needs);
        return times.read(at);
    };
    const auto write = [times](const std::vector<double> &values) {
        if (values.empty())
            return Json("auto");
        return values.size() == 1 ? Json(values.front()) : times.write(values);
    };
    return {needs, read, write};
}

/// null = nothing is subtracted; two members share the key.
Field<WindowSettings> baseline()
{
    const auto codec = valueOr(Json(nullptr), orAuto(interval()));
    return {"baseline_s",
        [codec](const JsonAt &at, WindowSettings &window) -> Result<void> {
            const Result<std::optional<Auto<Interval>>> value = codec.read(at);
            if (!value)
                return tl::unexpected<Error>(value.error());
            window.subtractBaseline = value->has_value();
            window.baseline_s = value->value_or(Auto<Interval>());
            return {};
        },
        [codec](const WindowSettings &window) {
            return codec.write(
                window.subtractBaseline ? std::optional(window.baseline_s) : std::nullopt);
        }};
}

/// "plateau" or a time after the start; two members share the key.
Field<WindowSettings> windowEnd()
{
    const auto codec = valueOr(Json("plateau"), orAuto(positiveNumber()));
    return {"end_s",
        [codec](const JsonAt &at, WindowSettings &window) -> Result<void> {
            const Result<std::optional<Auto<double>>> value = codec.read(at);
            if (!value)
                return tl::unexpected<Error>(value.error());
            window.endAtPlateau = !value->has_value();
            window.end_s = value->value_or(Auto<double>());
            return {};
        },
        [codec](const WindowSettings &window) {
            return codec.write(window.endAtPlateau ? std::nullopt : std::optional(window.end_s));
        }};
}

/// "auto" = search, "none", or the operator's own list; two members share the key.
Field<SpectrumSettings> resonance()
{
    const auto frequencies = list(positiveNumber());
    const std::string needs = "\"auto\", \"none\" or a list of frequencies in hertz";
    return {"resonance",
        [=](const JsonAt &at, SpectrumSettings &spectrum) -> Result<void> {
            const bool isWord = at.value == "auto" || at.value == "none";
            if (!isWord && !at.value.is_array())
                return mismatch(at, needs);
            spectrum.searchResonance = at.value == "auto";
            spectrum.resonances_Hz.clear();
            if (isWord)
                return {};
            Result<std::vector<double>> values = frequencies.read(at);
            if (!values)
                return tl::unexpected<Error>(values.error());
            spectrum.resonances_Hz = std::move(*values);
            return {};
        },
        [frequencies](const SpectrumSettings &spectrum) {
            if (spectrum.searchResonance)
                return Json("auto");
            return spectrum.resonances_Hz.empty() ? Json("none")
                                                  : frequencies.write(spectrum.resonances_Hz);
        }};
}

} // namespace

Codec<ShockSettings> shockCodec()
{
    using S = ShockSettings;
    return object<S>({
        field("enabled", &S::enabled, boolean()),
        field("p1_pa", &S::p1_Pa, orNull(positiveNumber())),
        field("t1_k", &S::T1_K, orNull(positiveNumber())),
        field("t4_k", &S::T4_K, orNull(positiveNumber())),
        field("driven_gas", &S::drivenGas, gas()),
        field("driver_gas", &S::driverGas, gas()),
        field("relative_humidity", &S::relativeHumidity, orNull(number(0.0, 1.0))),
        field("velocity_m_s", &S::velocity_m_s, orNull(positiveNumber())),
        field("step_pa", &S::step_Pa, orNull(positiveNumber())),
        field("arrival_sensors", &S::arrivalSensors, list(arrivalSensor())),
        field("driver_length_m", &S::driverLength_m, orNull(positiveNumber())),
        field("driven_length_m", &S::drivenLength_m, orNull(positiveNumber())),
        field("inner_diameter_m", &S::innerDiameter_m, orNull(positiveNumber())),
        field("dut_position", &S::dutPosition, oneOf({"end-wall", "side-wall"})),
        field("front_duration_s", &S::frontDuration_s, nonNegativeNumber()),
        field("u_front_duration_s", &S::u_frontDuration_s, nonNegativeNumber()),
        field("state_from", &S::stateFrom, oneOf({"velocity", "p2", "p4"})),
        field("p2_pa", &S::p2_Pa, orNull(positiveNumber())),
        field("p4_pa", &S::p4_Pa, orNull(positiveNumber())),
        field("carbon_dioxide_fraction", &S::carbonDioxide, number(0.0, 0.01)),
        field("counters", &S::counters, list(counterReading())),
        field("attenuation", &S::attenuation, oneOf({"auto", "none", "linear"})),
        field("use_dut_arrival", &S::useDutArrival, boolean()),
        field("dut_distance_to_end_wall_m", &S::dutDistance_m, orNull(positiveNumber())),
        field("dut_diameter_m", &S::dutDiameter_m, orNull(positiveNumber())),
        field("tube_length_m", &S::tubeLength_m, orNull(positiveNumber())),
        field("wall_sound_speed_m_s", &S::wallSoundSpeed_m_s, positiveNumber()),
        field("plateau_guard_s", &S::plateauGuard_s, nonNegativeNumber()),
    });
}

Codec<WindowSettings> windowCodec()
{
    using S = WindowSettings;
    return object<S>({
        field("start", &S::start_s, start()),
        baseline(),
        windowEnd(),
        field("settle_s", &S::settle_s, orAuto(interval())),
        field("exclude_stretches", &S::excludeStretches, list(excludedStretch())),
    });
}

Codec<SpectrumSettings> spectrumCodec()
{
    using S = SpectrumSettings;
    return object<S>({
        field("taper", &S::taper,
            choice<Taper>({{"rectangular", Taper::Rectangular}, {"hann", Taper::Hann}})),
        field("method", &S::method,
            choice<SpectrumMethod>(
                {{"periodogram", SpectrumMethod::Periodogram}, {"welch", SpectrumMethod::Welch}})),
        field("segment", &S::segment, orNull(whole(8, kMostSamples))),
        field("detrend", &S::detrend,
            choice<Detrend>(
                {{"none", Detrend::None}, {"mean", Detrend::Mean}, {"linear", Detrend::Linear}})),
        field("resonance_band_hz", &S::resonanceBand_Hz, orNull(interval())),
        resonance(),
    });
}

} // namespace dyncal
