// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/stated_quantities.h"

#include "core/base/number_text.h"
#include "core/results/results_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace dyncal {
namespace {

using Json = nlohmann::json;
using Pairs = std::vector<QuantityPair>;

constexpr double kSameFrequency = 1e-9;
constexpr int kDigitsOfPlace = 6;

/// Where an object keeps a quantity.
struct QuantityKeys
{
    const char *value;
    const char *u;
    const char *k; ///< of results that state it
    const char *unit; ///< the unit itself, as issued
    const char *unitNow = unit; ///< the same as always, where it is not stated
};

/// Both of a quantity whose unit is stated beside it.
struct StatedUnits
{
    std::string issued;
    std::string now;

    StatedUnits(const Json &then, const Json &later, const char *key = "unit")
        : issued(textAt(then, key))
        , now(textAt(later, key))
    {
    }

    QuantityKeys keys(const char *value, const char *u, const char *k) const
    {
        return {value, u, k, issued.c_str(), now.c_str()};
    }
};

QuantityPair pairOf(const std::string &of, const std::string &where, const QuantityKeys &keys)
{
    QuantityPair pair{of, where, keys.unit};
    pair.unitNow = keys.unitNow;
    return pair;
}

constexpr std::array<QuantityKeys, 5> kOfShock{
    {{"velocity_m_s", "u_velocity_m_s", "velocity_k", "m/s"}, {"mach", "u_mach", "", "1"},
        {"p2_pa", "u_p2_pa", "", "Pa"}, {"p5_pa", "u_p5_pa", "", "Pa"},
        {"step_pa", "u_step_pa", "step_k", "Pa"}}};

constexpr std::array<QuantityKeys, 3> kOfBands{{{"within_5_percent_hz", "", "", "Hz"},
    {"within_10_percent_hz", "", "", "Hz"}, {"minus_3_db_hz", "", "", "Hz"}}};

/// Nothing where the earlier results have no such key: then they do not state the quantity.
void addQuantity(Pairs &pairs, const std::string &of, const std::string &where, const Json &issued,
    const Json &now, const QuantityKeys &keys)
{
    if (!issued.is_object() || !issued.contains(keys.value))
        return;
    QuantityPair pair = pairOf(of, where, keys);
    pair.issued = numberAt(issued, keys.value);
    pair.u = numberAt(issued, keys.u);
    pair.k = numberAt(issued, keys.k);
    pair.now = numberAt(now, keys.value);
    pair.uNow = numberAt(now, keys.u);
    pairs.push_back(std::move(pair));
}

/// The entry of the list whose `identity` is that of `entry`; null where there is none.
const Json &sameEntry(const Json &list, const Json &entry, const char *identity)
{
    static const Json none;
    for (const Json &other : list)
        if (!valueAt(entry, identity).is_null()
            && valueAt(other, identity) == valueAt(entry, identity))
            return other;
    return none;
}

std::string placed(const std::string &list, std::size_t i)
{
    return list + '[' + std::to_string(i) + ']';
}

std::string ofShot(const Json &entry)
{
    return "shot " + numberText(numberAt(entry, "shot"));
}

void addCharacteristic(Pairs &pairs, const Json &entry, const Json &issued, const Json &now)
{
    const StatedUnits units(entry, now);
    addQuantity(pairs, textAt(entry, "quantity"), {}, issued, now, units.keys("value", "u", "k"));
}

/// A list of what could be determined: one that is in the later one alone was not, then.
void addCharacteristics(Pairs &pairs, const Json &issued, const Json &now)
{
    const Json undetermined{{"value", nullptr}};
    for (const Json &one : issued)
        addCharacteristic(pairs, one, one, sameEntry(now, one, "quantity"));
    for (const Json &one : now)
        if (one.is_object() && sameEntry(issued, one, "quantity").is_null())
            addCharacteristic(pairs, one, undetermined, one);
}

void addLevels(Pairs &pairs, const Json &issued, const Json &now, const StatedUnits &units)
{
    for (std::size_t i = 0; issued.is_array() && i < issued.size(); ++i)
        addQuantity(pairs, placed("sensitivity.per_level", i), textAt(issued[i], "level"),
            issued[i], sameEntry(now, issued[i], "level"), units.keys("value", "u", "k"));
}

void addSensitivities(Pairs &pairs, const Json &issued, const Json &now)
{
    const StatedUnits units(issued, now);
    addQuantity(pairs, "sensitivity", {}, issued, now, units.keys("value", "u", "k"));
    addLevels(pairs, valueAt(issued, "per_level"), valueAt(now, "per_level"), units);
    addQuantity(pairs, "sensitivity.linearity_per_pa", {}, issued, now,
        {"linearity_per_pa", "u_linearity_per_pa", "", "1/Pa"});
}

void addShots(Pairs &pairs, const Json &issued, const Json &now)
{
    for (std::size_t i = 0; issued.is_array() && i < issued.size(); ++i) {
        const Json &shotNow = sameEntry(now, issued[i], "shot");
        const StatedUnits units(issued[i], shotNow, "sensitivity_unit");
        addQuantity(pairs, placed("shots", i) + ".sensitivity", ofShot(issued[i]), issued[i],
            shotNow, units.keys("sensitivity", "u_sensitivity", "k_sensitivity"));
    }
}

void addShocks(Pairs &pairs, const Json &issued, const Json &now)
{
    for (std::size_t i = 0; issued.is_array() && i < issued.size(); ++i)
        for (const QuantityKeys &keys : kOfShock)
            addQuantity(pairs, placed("shock", i) + '.' + keys.value, ofShot(issued[i]), issued[i],
                sameEntry(now, issued[i], "shot"), keys);
}

/// The place of the frequency in an ascending list; -1 where it is not there.
Index placeOf(const Eigen::VectorXd &frequencies_Hz, double f_Hz)
{
    const double *end = frequencies_Hz.data() + frequencies_Hz.size();
    const double *at = std::lower_bound(frequencies_Hz.data(), end, f_Hz * (1.0 - kSameFrequency));
    return at != end && *at <= f_Hz * (1.0 + kSameFrequency) ? at - frequencies_Hz.data() : -1;
}

double valueIn(const Eigen::VectorXd &values, Index i)
{
    return i >= 0 && i < values.size() ? values[i] : kUnknown;
}

/// One column of rows over frequency.
void addColumn(Pairs &pairs, const std::string &of, const Json &issued, const Json &now,
    const QuantityKeys &keys)
{
    const Eigen::VectorXd f_Hz = numbersAt(issued, "frequency_hz");
    const Eigen::VectorXd fNow_Hz = numbersAt(now, "frequency_hz");
    const Eigen::VectorXd value = numbersAt(issued, keys.value), u = numbersAt(issued, keys.u),
                          k = numbersAt(issued, keys.k), after = numbersAt(now, keys.value),
                          uAfter = numbersAt(now, keys.u);
    for (Index i = 0; i < std::min(f_Hz.size(), value.size()); ++i) {
        const Index at = placeOf(fNow_Hz, f_Hz[i]);
        QuantityPair pair = pairOf(placed(of + '.' + keys.value, static_cast<std::size_t>(i)),
            numberWithUnit(f_Hz[i], "Hz", kDigitsOfPlace), keys);
        pair.issued = value[i];
        pair.u = valueIn(u, i);
        pair.k = valueIn(k, i);
        pair.now = valueIn(after, at);
        pair.uNow = valueIn(uAfter, at);
        pairs.push_back(std::move(pair));
    }
}

/// Before the budget was complete, u of a magnitude per pressure did not hold that of the step.
bool isOfNoiseAlone(const Json &response)
{
    return valueAt(response, "u_contains_step") == Json(false)
        && textAt(response, "unit").ends_with("/Pa");
}

void addRows(Pairs &pairs, const std::string &of, const Json &issued, const Json &now)
{
    const std::size_t first = pairs.size();
    const StatedUnits units(issued, now);
    addColumn(pairs, of, issued, now, units.keys("magnitude", "u_magnitude", "k_magnitude"));
    for (std::size_t i = first; i < pairs.size(); ++i)
        pairs[i].isOfNoiseAlone = isOfNoiseAlone(issued);
    const std::size_t second = pairs.size();
    addColumn(pairs, of, issued, now, {"phase_rad", "u_phase_rad", "k_phase", "rad"});
    for (std::size_t i = second; i < pairs.size(); ++i)
        pairs[i].isAngle = true;
}

void addComparison(Pairs &pairs, const Json &issued, const Json &now)
{
    addRows(pairs, "comparison", issued, now);
    addQuantity(pairs, "comparison.difference_relative", {}, issued, now,
        {"difference_relative", "u_difference_relative", "", "1"});
}

/// A pair counts once.
bool isListedAs(const Json &pole, const std::string &poleClass)
{
    return textAt(pole, "class") == poleClass && numberAt(pole, "im") >= 0.0
        && numberAt(pole, "frequency_hz") > 0.0;
}

/// The pole of the same class at the nearest frequency; null where there is none.
const Json &nearestPole(const Json &poles, const Json &like)
{
    const double f_Hz = numberAt(like, "frequency_hz");
    static const Json none;
    const Json *nearest = &none;
    double least = std::numeric_limits<double>::infinity();
    for (const Json &pole : poles) {
        const double distance = std::abs(std::log(numberAt(pole, "frequency_hz") / f_Hz));
        if (isListedAs(pole, textAt(like, "class")) && distance < least) {
            least = distance;
            nearest = &pole;
        }
    }
    return *nearest;
}

/// Of results without characteristics; they had no u then.
void addBands(Pairs &pairs, const Json &issued, const Json &now)
{
    for (const QuantityKeys &keys : kOfBands)
        addQuantity(pairs, std::string("bands.") + keys.value, {}, issued, now, keys);
}

std::string atPole(const Json &pole)
{
    return "pole at " + numberWithUnit(numberAt(pole, "frequency_hz"), "Hz", kDigitsOfPlace);
}

/// Earlier results stated amplitudes without u.
void addAmplitudes(Pairs &pairs, const Json &issued, const Json &now)
{
    for (std::size_t i = 0; issued.is_array() && i < issued.size(); ++i)
        if (const Json &pole = issued[i];
            isListedAs(pole, textAt(pole, "class")) && pole.contains("u_amplitude"))
            addQuantity(pairs, placed("model.poles", i) + ".amplitude", atPole(pole), pole,
                nearestPole(now, pole), {"amplitude", "u_amplitude", "k_amplitude", "1"});
}

/// What results without characteristics have instead; their u is that of the noise.
void addPoles(Pairs &pairs, const Json &issued, const Json &now)
{
    const std::size_t first = pairs.size();
    for (std::size_t i = 0; issued.is_array() && i < issued.size(); ++i) {
        if (!isListedAs(issued[i], "sensor"))
            continue;
        const Json &near = nearestPole(now, issued[i]);
        const std::string of = placed("model.poles", i);
        const std::string where = atPole(issued[i]);
        addQuantity(pairs, of + ".frequency_hz", where, issued[i], near,
            {"frequency_hz", "u_frequency_hz", "", "Hz"});
        addQuantity(pairs, of + ".damping_ratio", where, issued[i], near,
            {"damping_ratio", "u_damping_ratio", "", "1"});
    }
    for (std::size_t i = first; i < pairs.size(); ++i)
        pairs[i].isOfNoiseAlone = true;
}

} // namespace

std::vector<QuantityPair> statedQuantities(const Json &issued, const Json &now)
{
    Pairs pairs;
    const auto both
        = [&](const char *key, auto add) { add(pairs, valueAt(issued, key), valueAt(now, key)); };
    const Json &poles = valueAt(valueAt(issued, "model"), "poles");
    const Json &polesNow = valueAt(valueAt(now, "model"), "poles");
    if (valueAt(issued, "characteristics").is_array()) {
        both("characteristics", addCharacteristics);
        addAmplitudes(pairs, poles, polesNow);
    } else {
        addPoles(pairs, poles, polesNow);
        both("bands", addBands);
    }
    both("sensitivity", addSensitivities);
    both("shots", addShots);
    both("shock", addShocks);
    addRows(pairs, "response", valueAt(issued, "response"), valueAt(now, "response"));
    both("comparison", addComparison);
    return pairs;
}

} // namespace dyncal
