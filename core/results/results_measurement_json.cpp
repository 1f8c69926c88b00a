// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_measurement_json.h"

#include "core/model_analysis/stated_characteristics.h"
#include "core/results/results_sensitivity_json.h"

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

/// Why an included shot has no response although the window stage is done.
constexpr const char *kNotUsed = "The shot was not used; see the findings.";

std::string whyNoResponse(const Shot &shot, const ResultsContext &context)
{
    if (!shot.included)
        return "The shot is excluded: " + shot.excludeReason;
    return context.results().window ? kNotUsed : context.whyMissing();
}

void addRecord(JsonRecord &record, const Shot &shot)
{
    const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
    const std::string reason = "No channel of the shot is the sensor under calibration.";
    if (!dut) {
        record.missing("sample_rate_hz", reason);
        record.missing("samples", reason);
        record.missing("unit", reason);
        return;
    }
    if (dut->sampleRate_Hz > 0.0)
        record.number("sample_rate_hz", dut->sampleRate_Hz, "The file states an impossible rate.");
    else
        record.missing("sample_rate_hz", "The file does not state it.");
    record.set("samples", dut->samples.size());
    record.text("unit", dut->unit, "The file does not state it.");
}

void addLevels(JsonRecord &record, const WindowedResponse &r)
{
    record.number("baseline", r.baseline, "The baseline could not be formed.");
    record.number("step", r.step, "The step could not be formed.");
    record.number("noise_sd", r.noiseSd, "There is no record before the start.");
    record.number("snr_db", r.snr_dB, "There is no noise before the start to compare with.");
    record.number("start_s", r.start_s, "The start could not be found.");
    const StatedValue rise = statedRise(r);
    record.number("rise_time_s", rise.value,
        rise.below ? "It is " + english(rise.words) + "."
                   : "The response does not rise from 10 % to 90 %.");
    record.number("rise_time_below_s", rise.below,
        rise.value ? "The value is stated." : "The response does not rise from 10 % to 90 %.");
    record.number("overshoot_percent", statedOvershoot_percent(r),
        rise.below ? "The response rises within two samples: its top lies between them."
                   : "The response has no step to overshoot.");
    record.number("settling_time_s", r.settlingTime_s,
        "The response does not stay within 5 % of the plateau before the window ends.");
}

void addOnset(JsonRecord &record, const WindowedResponse *response, const SeriesFit *fit,
    const std::string &reason)
{
    if (!response || !fit) {
        record.missing("onset_s", reason);
        record.missing("u_onset_s", reason);
        return;
    }
    record.number("onset_s", response->start_s + fit->onset_s, "The onset could not be fitted.");
    record.number("u_onset_s", fit->u_onset_s, kNoUncertainty);
}

Json shotJson(Index number, const Shot &shot, const ResultsContext &context)
{
    JsonRecord record;
    record.set("shot", number);
    record.text("label", shot.label, "The shot has no label.");
    record.text("level", shotLevelName(shot.level), "No level is given for the shot.");
    record.set("included", shot.included);
    addRecord(record, shot);
    const WindowedResponse *response = context.responseOf(number);
    const std::string reason = whyNoResponse(shot, context);
    if (response) {
        addLevels(record, *response);
    } else {
        for (const char *key : {"baseline", "step", "noise_sd", "snr_db", "start_s", "rise_time_s",
                 "rise_time_below_s", "overshoot_percent", "settling_time_s"})
            record.missing(key, reason);
    }
    const bool modelled = response && context.results().model;
    addOnset(record, response, context.fitOf(number),
        modelled ? "The model describes the average of the shots, which has no onset of its own."
                 : (response ? context.whyMissing() : reason));
    if (response) {
        addShotSensitivity(record, number, context);
    } else {
        record.missing("sensitivity", reason);
        record.missing("sensitivity_unit", reason);
        record.missing("u_sensitivity", reason);
        record.missing("k_sensitivity", reason);
        record.missing("u_level_relative", reason);
    }
    return record.take();
}

} // namespace

void addInputs(JsonRecord &root, const ResultsContext &context)
{
    if (!context.results().captures) {
        root.missing("inputs", context.whyMissing());
        return;
    }
    Json list = Json::array();
    for (const InputFile &input : context.results().captures->set.inputs) {
        JsonRecord record;
        record.set("file", input.file);
        record.text("sha256", input.sha256, "The file could not be read again.");
        record.set("format", input.format);
        list.push_back(record.take());
    }
    root.set("inputs", std::move(list));
}

void addShots(JsonRecord &root, const ResultsContext &context)
{
    if (!context.results().captures) {
        root.missing("shots", context.whyMissing());
        return;
    }
    const std::vector<Shot> &shots = context.results().captures->set.shots;
    Json list = Json::array();
    for (std::size_t i = 0; i < shots.size(); ++i)
        list.push_back(shotJson(static_cast<Index>(i) + 1, shots[i], context));
    root.set("shots", std::move(list));
}

} // namespace dyncal
