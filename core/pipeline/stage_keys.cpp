// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_keys.h"

#include "core/base/constants.h"
#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "core/pipeline/stage_table.h"

#include <mutex>

namespace dyncal {
namespace {

std::string surroundingsOf(const Environment &e)
{
    std::string text;
    for (const double value : {e.p1_Pa, e.u_p1_Pa, e.T1_K, e.u_T1_K, e.p4_Pa, e.T4_K,
             e.ambientPressure_Pa, e.ambientT_K, e.relativeHumidity})
        text += exactNumber(value) + ' ';
    return text + '\n';
}

std::string scalingOf(const Channel &channel)
{
    std::string text = channel.unit + ' ' + pressureReferenceName(channel.reference);
    for (const double value : {channel.polarity, channel.userScale,
             channel.adcMin.value_or(kUnknown), channel.adcMax.value_or(kUnknown)})
        text += ' ' + exactNumber(value);
    for (const double coefficient : channel.polynomial)
        text += ' ' + exactNumber(coefficient);
    return text + '\n';
}

/// Replaces the hash of a file that is opened but not yet sealed.
std::string stampOf(const InputFile &input)
{
    return input.path + ' ' + std::to_string(input.bytes) + ' ' + std::to_string(input.changed_ns);
}

std::string attributesOf(const Attributes &attributes)
{
    std::string text;
    for (const auto &[key, value] : attributes)
        text += key + '=' + value + '\n';
    return text;
}

std::string attributesOf(const std::map<std::string, Attributes> &named)
{
    std::string text;
    for (const auto &[name, attributes] : named)
        text += name + '\n' + attributesOf(attributes);
    return text;
}

/// Findings of reading and sealing belong to the key: a project may expect the same bytes or others
/// (CAP-015).
std::string wordsOf(const Findings &findings)
{
    std::string text;
    for (const Finding &finding : findings)
        text += finding.id + ' ' + severityName(finding.severity) + ' '
            + std::to_string(finding.shot) + ' ' + finding.channel + ' ' + english(finding.message)
            + '\n';
    return text;
}

std::string describedChannel(const Channel &channel)
{
    return channel.name + ' ' + channelRoleName(channel.role) + ' ' + channel.sha256 + ' '
        + channel.statedSha256 + ' ' + channel.quantity + ' ' + channel.recordedUnit + ' '
        + channel.sensorId + ' ' + std::to_string(channel.adcBits) + ' '
        + exactNumber(channel.sampleRate_Hz) + ' ' + exactNumber(channel.t0_s) + ' '
        + scalingOf(channel);
}

/// What identifies the recordings: hashes of the samples and their description in the files.
std::string identityOf(const CaptureSet &captures)
{
    std::string text;
    for (const InputFile &input : captures.inputs)
        text += (input.sha256.empty() ? stampOf(input) : input.sha256) + ' ' + input.file + ' '
            + input.format + '\n';
    for (const Shot &shot : captures.shots) {
        text += shot.label + '|' + shotLevelName(shot.level) + '|' + (shot.included ? "+" : "-")
            + shot.excludeReason + '|' + surroundingsOf(shot.environment)
            + attributesOf(shot.notes);
        for (const Channel &channel : shot.channels)
            text += describedChannel(channel);
    }
    return text + attributesOf(captures.tube) + attributesOf(captures.sensors)
        + attributesOf(captures.instruments) + wordsOf(captures.findings);
}

/// The recipe sections one stage reads, everything else at its default.
Recipe sectionsOf(const Stage &stage, const Recipe &recipe)
{
    Recipe part;
    stage.read(recipe, part);
    return part;
}

/// recipeJson() of the sections of each stage, as they were asked for last: of a drag that changes
/// one stage the others' are the same, and writing them all takes longer than fitting a model.
class WrittenSections
{
public:
    std::string of(const Stage &stage, const Recipe &recipe)
    {
        const Recipe part = sectionsOf(stage, recipe);
        const std::lock_guard lock(m_mutex);
        Written &last = m_last[static_cast<std::size_t>(stage.id)];
        if (last.json.empty() || !(last.part == part))
            last = {part, recipeJson(part)};
        return last.json;
    }

private:
    struct Written
    {
        Recipe part;
        std::string json;
    };
    std::mutex m_mutex;
    std::array<Written, kStageCount> m_last;
};

} // namespace

std::array<std::string, kStageCount> stageKeys(const CaptureSet &captures, const Recipe &recipe)
{
    static WrittenSections sections;
    std::array<std::string, kStageCount> keys;
    const std::string identity = identityOf(captures);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const Stage &stage = stageOf(static_cast<StageId>(i));
        const std::string &before
            = i == 0 ? identity : keys[static_cast<std::size_t>(stage.follows)];
        keys[i] = sha256Hex(before + stage.name + sections.of(stage, recipe));
    }
    return keys;
}

std::optional<StageId> firstDifferentStage(const Recipe &before, const Recipe &after)
{
    for (int i = 0; i < kStageCount; ++i) {
        const Stage &stage = stageOf(static_cast<StageId>(i));
        if (!(sectionsOf(stage, before) == sectionsOf(stage, after)))
            return stage.id;
    }
    return std::nullopt;
}

} // namespace dyncal
