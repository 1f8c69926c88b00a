// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/comparison_json.h"

#include "core/base/json_text.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/results/json_record.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

void addModelNumbers(JsonRecord &record, const ComparedOrder &compared)
{
    const SensorModel &model = *compared.model;
    const char *diverges = "The simulation of the model diverges.";
    const auto main = sensorResonance(model.diverges ? nullptr : &model, compared.assessment.get());
    const char *noPole
        = model.diverges ? diverges : "The model has no oscillating pole of the sensor.";
    const char *noUncertainty = main ? "The poles of this order were not refined." : noPole;
    const auto ofPole = [&main](double SensorResonance::*value) {
        return main ? std::optional<double>((*main).*value) : std::nullopt;
    };
    record.set("diverges", model.diverges);
    record.number("fit_percent",
        model.diverges ? std::nullopt : std::optional<double>(model.fit_percent), diverges);
    record.number("fit_attainable_percent", model.fitAttainable_percent,
        "There is too little record before the start to know the noise.");
    record.number("frequency_hz", ofPole(&SensorResonance::frequency_Hz), noPole);
    record.number("u_frequency_hz", ofPole(&SensorResonance::u_frequency_Hz), noUncertainty);
    record.number("damping_ratio", ofPole(&SensorResonance::dampingRatio), noPole);
    record.number("u_damping_ratio", ofPole(&SensorResonance::u_dampingRatio), noUncertainty);
    record.set("unstable_poles", countPoles(model, PoleClass::Unstable));
    record.set("nyquist_poles", countPoles(model, PoleClass::Nyquist));
    record.number("whiteness_p", compared.whiteness_p,
        model.diverges ? diverges : "The series are too short to be tested.");
    record.number("sensitivity",
        compared.response && !model.diverges ? compared.response->sensitivity : std::nullopt,
        model.diverges ? diverges : "No pressure step is known.");
    Json ids = Json::array();
    for (const Finding &finding : model.findings)
        ids.push_back(finding.id);
    for (const Finding &finding : compared.assessment ? compared.assessment->findings : Findings())
        ids.push_back(finding.id);
    record.set("findings", std::move(ids));
}

Json orderJson(const ComparedOrder &compared)
{
    JsonRecord record;
    record.set("order", compared.order);
    record.text("note", compared.note, "The recipe has no note on this order.");
    record.number("bic", compared.bic,
        "BIC is formed for the low orders only, among which one is suggested.");
    if (compared.model) {
        addModelNumbers(record, compared);
        return record.take();
    }
    static constexpr std::array<const char *, 10> kNumbers{"fit_percent", "fit_attainable_percent",
        "frequency_hz", "u_frequency_hz", "damping_ratio", "u_damping_ratio", "unstable_poles",
        "nyquist_poles", "whiteness_p", "sensitivity"};
    for (const char *key : kNumbers)
        record.missing(key, english(compared.error->message));
    record.set("diverges", false);
    record.set("findings", Json::array());
    return record.take();
}

} // namespace

Index countPoles(const SensorModel &model, PoleClass poleClass)
{
    return std::count_if(model.poles.begin(), model.poles.end(),
        [poleClass](const Pole &pole) { return pole.poleClass == poleClass; });
}

std::string comparisonJson(
    const CalibrationResults &results, const std::vector<ComparedOrder> &orders)
{
    JsonRecord root;
    root.set("schema", "dyncal-compare/1");
    const OrderSuggestion &suggestion = results.decomposition->suggestion;
    if (suggestion.order > 0)
        root.set("suggested_order", suggestion.order);
    else
        root.missing("suggested_order", english(suggestion.reason));
    root.set("suggestion_reason", english(suggestion.reason));
    Json list = Json::array();
    for (const ComparedOrder &compared : orders)
        list.push_back(orderJson(compared));
    root.set("orders", std::move(list));
    return jsonText(root.take());
}

} // namespace dyncal
