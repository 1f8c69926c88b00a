// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/defects.h"

#include "core/base/number_text.h"
#include "core/synthesis/defect_kinds.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace dyncal {
namespace {

std::optional<Index> wholeNumberFromOne(std::string_view text)
{
    Index number = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size() || number < 1)
        return std::nullopt;
    return number;
}

/// `text` up to the mark and what follows it, if the mark is there.
struct Divided
{
    std::string_view before;
    std::optional<std::string_view> after;
};

Divided dividedAt(char mark, std::string_view text)
{
    const std::size_t at = text.find(mark);
    if (at == std::string_view::npos)
        return {text, {}};
    return {text.substr(0, at), text.substr(at + 1)};
}

const DefectDescription *descriptionCalled(std::string_view name)
{
    for (const DefectDescription &description : defectDescriptions()) {
        if (description.name == name)
            return &description;
    }
    return nullptr;
}

/// The number typed behind `mark`; empty where none is.
Result<std::optional<double>> numberBehind(char mark, const std::optional<std::string_view> &typed,
    const std::optional<DefectNumber> &taken, const std::string &whole)
{
    if (!typed)
        return std::optional<double>();
    const std::string markText(1, mark);
    if (!taken)
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT("core", "Defect '%1': this kind takes no number behind '%2'."),
                {whole, markText}});
    const std::optional<double> number = parseNumber(*typed);
    if (!number)
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT("core", "Defect '%1': what follows '%2' must be a number."),
                {whole, markText}});
    return number;
}

Result<void> checkNumber(const DefectDescription &description, const std::optional<double> &number,
    const std::optional<DefectNumber> &range)
{
    if (!number || (range && *number >= range->lowest && *number <= range->highest))
        return {};
    const DefectNumber allowed = range.value_or(DefectNumber{});
    return fail(ErrorKind::Usage,
        Message{DYNCAL_TEXT("core", "Defect '%1' is asked for with %2; it must lie in %3 .. %4."),
            {description.name, numberText(*number), numberText(allowed.lowest),
                numberText(allowed.highest)}});
}

/// What can be said of a defect without knowing the shots.
Result<void> checkAlone(const Defect &defect)
{
    const DefectDescription &description = describedDefect(defect.kind);
    if (defect.shot != 0 && description.scope == DefectScope::Capture)
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT("core",
                        "Defect '%1' concerns the whole capture; it takes no number of a shot."),
                {description.name}});
    if (auto checked = checkNumber(description, defect.size, description.size); !checked)
        return checked;
    return checkNumber(description, defect.time_s, description.time_s);
}

Index middleShot(const SimulationSettings &settings)
{
    return (std::ssize(settings.shots) + 1) / 2;
}

bool concerns(const Defect &defect, const SimulationSettings &settings, Index shot)
{
    if (defect.shot != 0)
        return defect.shot == shot;
    return describedDefect(defect.kind).scope != DefectScope::MiddleShot
        || shot == middleShot(settings);
}

/// The next shot of another level, from the first again behind the last; empty where all are alike.
std::optional<std::size_t> nextOfAnotherLevel(
    const std::vector<ShotLevel> &levels, std::size_t shot)
{
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const std::size_t next = (shot + i) % levels.size();
        if (levels[next] != levels[shot])
            return next;
    }
    return std::nullopt;
}

} // namespace

Result<Defect> parseDefect(const std::string &text)
{
    const Divided shotPart = dividedAt('@', text);
    const Divided sizePart = dividedAt('=', shotPart.before);
    const DefectDescription *description = descriptionCalled(sizePart.before);
    if (!description)
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT("core", "There is no defect '%1'; choose one of %2."),
                {std::string(sizePart.before), defectNames()}});
    Defect defect{description->kind, 0};
    if (shotPart.after) {
        const auto shot = wholeNumberFromOne(*shotPart.after);
        if (!shot)
            return fail(ErrorKind::Usage,
                Message{DYNCAL_TEXT("core",
                            "Defect '%1': what follows '@' must be the number of a shot, from 1."),
                    {text}});
        defect.shot = *shot;
    }
    const Divided timePart = dividedAt(':', sizePart.after.value_or(std::string_view()));
    const auto size = numberBehind('=',
        sizePart.after ? std::optional(timePart.before) : std::nullopt, description->size, text);
    if (!size)
        return tl::unexpected(size.error());
    const auto time_s = numberBehind(':', timePart.after, description->time_s, text);
    if (!time_s)
        return tl::unexpected(time_s.error());
    defect.size = *size;
    defect.time_s = *time_s;
    if (auto checked = checkAlone(defect); !checked)
        return tl::unexpected(checked.error());
    return defect;
}

std::optional<Defect> defectOf(const SimulationSettings &settings, DefectKind kind, Index shot)
{
    const auto found = std::find_if(
        settings.defects.rbegin(), settings.defects.rend(), [&](const Defect &defect) {
            return defect.kind == kind && concerns(defect, settings, shot);
        });
    if (found == settings.defects.rend())
        return std::nullopt;
    const DefectDescription &description = describedDefect(kind);
    Defect defect = *found;
    if (description.size)
        defect.size = defect.size.value_or(description.size->standard);
    if (description.time_s)
        defect.time_s = defect.time_s.value_or(description.time_s->standard);
    return defect;
}

double defectSize(const SimulationSettings &settings, DefectKind kind, Index shot, double otherwise)
{
    const std::optional<Defect> defect = defectOf(settings, kind, shot);
    return defect ? *defect->size : otherwise;
}

std::vector<ShotLevel> notedLevels(const SimulationSettings &settings)
{
    std::vector<ShotLevel> noted = settings.shots;
    for (std::size_t i = 0; i < noted.size(); ++i) {
        if (!hasDefect(settings, DefectKind::Levels, static_cast<Index>(i) + 1))
            continue;
        if (const auto other = nextOfAnotherLevel(settings.shots, i))
            std::swap(noted[i], noted[*other]);
    }
    return noted;
}

Result<void> checkDefects(const SimulationSettings &settings)
{
    for (const Defect &defect : settings.defects) {
        if (auto checked = checkAlone(defect); !checked)
            return checked;
        if (defect.shot < 0 || defect.shot > std::ssize(settings.shots))
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "A defect is asked for in shot %1, but the shots to simulate are 1 to %2."),
                    {std::to_string(defect.shot), std::to_string(settings.shots.size())}});
        if (defect.kind == DefectKind::Levels && !nextOfAnotherLevel(settings.shots, 0))
            return fail(ErrorKind::Usage,
                Message{DYNCAL_TEXT(
                            "core", "Defect '%1' needs shots of two levels; all shots are of one."),
                    {describedDefect(defect.kind).name}});
    }
    return {};
}

} // namespace dyncal
