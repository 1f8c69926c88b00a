// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/findings/finding_corrections.h"

#include "ui/session/capture_edit.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace dyncal {

namespace {

struct Corrections
{
    Q_DECLARE_TR_FUNCTIONS(Corrections)
};

constexpr Index kLongestGap = 5; ///< samples; longer ones hide what happened
constexpr std::size_t kMostChannels = 6; ///< as buttons; beyond, the list of roles is clearer
constexpr std::size_t kUnitArgument = 3; ///< of CAP-013: the unit that fits, or ""

using Apply = std::function<void(ImportSettings &, const std::string &)>;

OfferedCorrection edit(const QString &label, const QString &step, Apply apply)
{
    return {label, step, {}, std::move(apply), {}, {}};
}

const Shot *shotOf(const Finding &finding, const CaptureSet &set)
{
    const auto position = static_cast<std::size_t>(finding.shot - 1);
    return finding.shot > 0 && position < set.shots.size() ? &set.shots[position] : nullptr;
}

const InputFile *fileOf(const Shot *shot, const CaptureSet &set)
{
    const auto input = static_cast<std::size_t>(shot ? shot->input : 0);
    return shot && input < set.inputs.size() ? &set.inputs[input] : nullptr;
}

OfferedCorrection excludeShot(Index shot)
{
    const QString step = Corrections::tr("Exclude shot %1").arg(shot);
    return {step + QStringLiteral("..."), step,
        Corrections::tr("Why is this shot not used? The certificate prints the reason."),
        [shot](ImportSettings &settings, const std::string &reason) {
            setShotExcluded(settings, shot, reason);
        },
        {}, {}};
}

std::vector<OfferedCorrection> chooseDut(const Shot *shot)
{
    std::vector<OfferedCorrection> corrections;
    for (const Channel &channel : shot ? shot->channels : std::vector<Channel>()) {
        if (corrections.size() == kMostChannels)
            break;
        const QString name = shownText(channel.name);
        corrections.push_back(edit(Corrections::tr("\"%1\" is the DUT").arg(name),
            Corrections::tr("Choose %1 as the DUT").arg(name),
            [name = channel.name](ImportSettings &settings, const std::string &) {
                settings.channels[name] = channelRoleName(ChannelRole::Dut);
            }));
    }
    return corrections;
}

/// The roles for this shot alone; an entry is made where there is none.
std::map<std::string, std::string> &ownRoles(ImportSettings &settings, Index shot)
{
    const auto found = std::ranges::find(settings.shots, shot, &ShotImport::shot);
    if (found != settings.shots.end())
        return found->channels;
    settings.shots.push_back({shot, {}});
    return settings.shots.back().channels;
}

/// Whether every shot that could be swapped is said to be.
bool areAllSwapped(const CaptureSet &set, const Findings &all)
{
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Shot &shot = set.shots[i];
        const bool couldBe = shot.included && shot.channelWithRole(ChannelRole::Dut)
            && shot.channelWithRole(ChannelRole::DrivenSide);
        const bool isSaid = std::ranges::any_of(all, [&](const Finding &finding) {
            return finding.id == "CAP-010" && finding.shot == static_cast<Index>(i) + 1;
        });
        if (couldBe && !isSaid)
            return false;
    }
    return true;
}

/// In the file of the shot, in this shot alone if its file has several, or in all where all are
/// swapped: right shots are never offered to be made wrong.
std::vector<OfferedCorrection> swapChannels(
    const Shot *shot, const CaptureSet &set, const Findings &all)
{
    const Channel *dut = shot ? shot->channelWithRole(ChannelRole::Dut) : nullptr;
    const Channel *side = shot ? shot->channelWithRole(ChannelRole::DrivenSide) : nullptr;
    if (!dut || !side || dut->name == side->name)
        return {};
    const auto swapIn
        = [first = dut->name, second = side->name](std::map<std::string, std::string> &roles) {
              roles[first] = channelRoleName(ChannelRole::DrivenSide);
              roles[second] = channelRoleName(ChannelRole::Dut);
          };
    std::vector<OfferedCorrection> corrections;
    const QString step = Corrections::tr("Swap DUT and driven side");
    const InputFile *file = fileOf(shot, set);
    const bool isAlone = std::ranges::count(set.shots, shot->input, &Shot::input) == 1;
    if (file && isAlone && set.shots.size() > 1)
        corrections.push_back(edit(Corrections::tr("Swap in %1").arg(shownText(file->file)), step,
            [swapIn, name = file->file](ImportSettings &settings, const std::string &) {
                swapIn(settings.files[name].channels);
            }));
    if (!isAlone) {
        const Index number = shot - set.shots.data() + 1;
        corrections.push_back(edit(Corrections::tr("Swap in shot %1").arg(number), step,
            [swapIn, number](ImportSettings &settings, const std::string &) {
                swapIn(ownRoles(settings, number));
            }));
    }
    if (!areAllSwapped(set, all))
        return corrections;
    corrections.push_back(edit(Corrections::tr("Swap in all shots"), step,
        [swapIn](ImportSettings &settings, const std::string &) {
            swapIn(settings.channels);
            for (auto &[name, own] : settings.files)
                own.channels.clear();
            settings.shots.clear();
        }));
    return corrections;
}

/// The recipe's details of the channel of a finding, or null: they win over what it says of the DUT
/// of all files.
ChannelImport *detailsOf(
    ImportSettings &settings, const std::string &file, const std::string &channel)
{
    const auto own = settings.files.find(file);
    if (own != settings.files.end() && own->second.channelDetails.contains(channel))
        return &own->second.channelDetails.at(channel);
    const auto found = settings.channelDetails.find(channel);
    return found == settings.channelDetails.end() ? nullptr : &found->second;
}

std::vector<OfferedCorrection> useUnit(const Finding &finding, const std::string &file)
{
    const auto &words = finding.message.arguments;
    if (words.size() <= kUnitArgument || words[kUnitArgument].empty())
        return {};
    const std::string unit = words[kUnitArgument];
    return {edit(Corrections::tr("The unit is %1").arg(shownText(unit)),
        Corrections::tr("Change the DUT's unit"),
        [unit, file, channel = finding.channel](ImportSettings &settings, const std::string &) {
            ChannelImport *details = detailsOf(settings, file, channel);
            (details && details->unit ? details->unit : settings.unit) = unit;
        })};
}

OfferedCorrection invertPolarity(const Finding &finding, const std::string &file)
{
    return edit(Corrections::tr("Invert polarity"), Corrections::tr("Change the DUT's polarity"),
        [file, channel = finding.channel](ImportSettings &settings, const std::string &) {
            ChannelImport *details = detailsOf(settings, file, channel);
            if (details && details->polarity)
                details->polarity = -*details->polarity;
            else
                settings.polarity = -settings.polarity;
        });
}

OfferedCorrection interpolate()
{
    return edit(Corrections::tr("Interpolate gaps of up to %1 samples").arg(kLongestGap),
        Corrections::tr("Interpolate invalid samples"),
        [](ImportSettings &settings, const std::string &) {
            settings.interpolateInvalid = kLongestGap;
        });
}

/// Offers the import of the file that the finding is about: that of its shot, or one that the
/// sentence names.
std::vector<OfferedCorrection> showImport(
    const Finding &finding, const Shot *shot, const CaptureSet &set)
{
    const InputFile *file = fileOf(shot, set);
    for (const InputFile &input : set.inputs)
        for (const std::string &word : finding.message.arguments)
            if (!file && word == input.path)
                file = &input;
    if (!file)
        return {};
    return {{Corrections::tr("Import settings..."), {}, {}, {}, rawText(file->path), {}}};
}

/// Corrections in the import section, for one shot or for all.
std::vector<OfferedCorrection> importCorrections(
    const Finding &finding, const Shot *shot, const CaptureSet &set, const Findings &all)
{
    const InputFile *file = fileOf(shot, set);
    const std::string fileName = file ? file->file : std::string();
    if (finding.id == "CAP-002")
        return chooseDut(shot);
    if (finding.id == "CAP-003" || finding.id == "CAP-016" || finding.id == "CAP-019")
        return showImport(finding, shot, set);
    if (finding.id == "CAP-006")
        return {interpolate()};
    if (finding.id == "CAP-010")
        return swapChannels(shot, set, all);
    if (finding.id == "CAP-012")
        return {invertPolarity(finding, fileName)};
    if (finding.id == "CAP-013")
        return useUnit(finding, fileName);
    return {};
}

} // namespace

std::vector<OfferedCorrection> correctionsOf(
    const Finding &finding, const CaptureSet &set, const Findings &all)
{
    const Shot *shot = shotOf(finding, set);
    std::vector<OfferedCorrection> corrections = importCorrections(finding, shot, set, all);
    if (finding.correction) {
        const QString label = translated(finding.correction->label);
        corrections.push_back({label, label, {}, {}, {}, finding.correction});
    }
    const bool canExclude
        = shot && shot->included && std::ranges::count_if(set.shots, &Shot::included) > 1;
    for (const char *id :
        {"CAP-006", "CAP-007", "CAP-008", "CAP-009", "CAP-010", "CAP-011", "CAP-020"})
        if (finding.id == id && canExclude)
            corrections.push_back(excludeShot(finding.shot));
    return corrections;
}

} // namespace dyncal
