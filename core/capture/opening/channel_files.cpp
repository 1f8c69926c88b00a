// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/opening/channel_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// Formats whose files may hold one channel of several.
constexpr std::array<std::string_view, 5> kFormats{
    "lecroy-trc", "rigol-wfm", "rigol-bin", "keysight-bin", "rohde-bin"};

bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool startsWithWord(std::string_view text, std::string_view word)
{
    return text.size() >= word.size()
        && std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) {
               return a == b || (isLetter(b) && a == static_cast<char>(b | 0x20));
           });
}

/// Position of the digit of the channel name that begins at `at`; npos if none begins there.
std::size_t channelDigit(std::string_view name, std::size_t at)
{
    if (at > 0 && (isLetter(name[at - 1]) || isDigit(name[at - 1])))
        return std::string_view::npos;
    for (const std::string_view word : {"channel", "chan", "ch", "c"}) {
        const std::size_t digit = at + word.size();
        if (!startsWithWord(name.substr(at), word) || digit >= name.size())
            continue;
        const char behind = digit + 1 < name.size() ? name[digit + 1] : '.';
        const bool alone = !isDigit(behind) && (at == 0 || !isLetter(behind));
        return name[digit] >= '1' && name[digit] <= '8' && alone ? digit : std::string_view::npos;
    }
    return std::string_view::npos;
}

bool sameNote(const Shot &a, const Shot &b, const std::string &key)
{
    const auto noteOf = [&](const Shot &shot) {
        const auto found = shot.notes.find(key);
        return found != shot.notes.end() ? found->second : std::string();
    };
    return noteOf(a) == noteOf(b);
}

bool sameTimes(const Channel &a, const Channel &b)
{
    constexpr double kRounding = 1e-9; ///< of a rate that headers hold as an interval
    return a.samples.size() == b.samples.size() && a.sampleRate_Hz > 0.0
        && std::abs(a.sampleRate_Hz - b.sampleRate_Hz) <= kRounding * a.sampleRate_Hz
        && std::abs(a.t0_s - b.t0_s) * a.sampleRate_Hz <= 0.5;
}

bool areOneRecording(const Shot &a, const Shot &b)
{
    for (const Channel &channel : b.channels) {
        const bool fits = std::all_of(a.channels.begin(), a.channels.end(),
            [&](const Channel &c) { return c.name != channel.name && sameTimes(c, channel); });
        if (!fits)
            return false;
    }
    return sameNote(a, b, "recorded") && sameNote(a, b, "trigger_time_s");
}

/// The shots whose first file each input is.
std::vector<std::vector<std::size_t>> shotsOfInputs(const CaptureSet &set)
{
    std::vector<std::vector<std::size_t>> shots(set.inputs.size());
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const auto input = static_cast<std::size_t>(set.shots[i].input);
        if (input < shots.size())
            shots[input].push_back(i);
    }
    return shots;
}

/// Inputs that may be channels of one recording, by their names; each channel is there once.
std::vector<std::vector<std::size_t>> candidates(const CaptureSet &set)
{
    std::map<std::string, std::map<int, std::vector<std::size_t>>> byName;
    for (std::size_t i = 0; i < set.inputs.size(); ++i) {
        const InputFile &input = set.inputs[i];
        const bool known
            = std::find(kFormats.begin(), kFormats.end(), input.format) != kFormats.end();
        if (const auto name = known ? channelFileName(input.path) : std::nullopt)
            byName[input.format + ':' + name->others][name->channel].push_back(i);
    }
    std::vector<std::vector<std::size_t>> groups;
    for (const auto &[name, channels] : byName) {
        std::vector<std::size_t> group;
        const bool once = std::all_of(channels.begin(), channels.end(),
            [](const auto &files) { return files.second.size() == 1; });
        for (const auto &[channel, files] : channels)
            group.push_back(files.front());
        if (once && group.size() > 1)
            groups.push_back(std::move(group));
    }
    return groups;
}

/// Joins the shots of files and remembers which are left over.
class ChannelFileJoiner
{
public:
    explicit ChannelFileJoiner(CaptureSet &set)
        : m_set(set)
        , m_shots(shotsOfInputs(set))
        , m_gone(set.shots.size(), false)
    {
    }

    void join(std::vector<std::size_t> group)
    {
        std::erase_if(group, [this](std::size_t input) { return m_shots[input].empty(); });
        std::sort(group.begin(), group.end(),
            [this](std::size_t a, std::size_t b) { return m_shots[a] < m_shots[b]; });
        bool any = false;
        for (std::size_t k = 1; k < group.size(); ++k)
            any = joinPair(group.front(), group[k]) || any;
        if (any)
            say(m_shots[group.front()].front());
    }

    /// Drops the shots whose channels another shot has taken.
    void finish()
    {
        std::vector<Shot> kept;
        std::vector<Index> numbers;
        for (std::size_t i = 0; i < m_set.shots.size(); ++i) {
            numbers.push_back(static_cast<Index>(kept.size()) + 1);
            if (!m_gone[i])
                kept.push_back(std::move(m_set.shots[i]));
            else
                numbers.back() = numbers[m_joinedTo.at(i)];
        }
        m_set.shots = std::move(kept);
        for (Finding &finding : m_set.findings) {
            if (finding.shot > 0)
                finding.shot = numbers[static_cast<std::size_t>(finding.shot - 1)];
        }
    }

private:
    bool joinPair(std::size_t first, std::size_t other)
    {
        const auto &into = m_shots[first];
        const auto &from = m_shots[other];
        bool one = into.size() == from.size();
        for (std::size_t k = 0; one && k < from.size(); ++k)
            one = areOneRecording(m_set.shots[into[k]], m_set.shots[from[k]]);
        if (!one)
            return false;
        for (std::size_t k = 0; k < from.size(); ++k) {
            for (Channel &channel : m_set.shots[from[k]].channels) {
                channel.input = inputOf(m_set.shots[from[k]], channel);
                m_set.shots[into[k]].channels.push_back(std::move(channel));
            }
            m_gone[from[k]] = true;
            m_joinedTo[from[k]] = into[k];
        }
        return true;
    }

    /// Reports all files of the shot, also those that joined it earlier.
    void say(std::size_t shot)
    {
        const Index number = static_cast<Index>(shot) + 1;
        std::erase_if(m_set.findings, [&](const Finding &finding) {
            return finding.id == "CAP-029" && finding.shot == number;
        });
        std::string files;
        for (const Channel &channel : m_set.shots[shot].channels) {
            const auto input = static_cast<std::size_t>(inputOf(m_set.shots[shot], channel));
            files.append(files.empty() ? "" : ", ").append(m_set.inputs[input].file);
        }
        m_set.findings.push_back({.id = "CAP-029",
            .severity = Severity::Info,
            .shot = number,
            .message
            = {DYNCAL_TEXT("core",
                   "%1 were taken as the channels of one recording, as name, time, rate and length agree. Set channel_files to \"apart\" in the recipe's import section if they are not."),
                {files}}});
    }

    CaptureSet &m_set;
    std::vector<std::vector<std::size_t>> m_shots; ///< of each input
    std::vector<bool> m_gone;
    std::map<std::size_t, std::size_t> m_joinedTo;
};

} // namespace

std::optional<ChannelFileName> channelFileName(const std::string &path)
{
    const std::size_t begin = path.find_last_of('/') + 1;
    const std::string_view name = std::string_view(path).substr(begin);
    std::optional<ChannelFileName> found;
    for (std::size_t at = 0; at < name.size(); ++at) {
        const std::size_t digit = channelDigit(name, at);
        if (digit == std::string_view::npos)
            continue;
        if (found)
            return std::nullopt;
        found = ChannelFileName{path, begin + digit, name[digit] - '0'};
        found->others[found->digit] = '?';
    }
    return found;
}

std::vector<std::string> channelFilesBeside(const std::string &path)
{
    const std::optional<ChannelFileName> own = channelFileName(path);
    std::vector<std::string> files;
    for (char channel = '1'; own && channel <= '8'; ++channel) {
        std::string file = own->others;
        file[own->digit] = channel;
        std::error_code unknown;
        if (fs::is_regular_file(file, unknown))
            files.push_back(std::move(file));
    }
    return files.size() > 1 ? files : std::vector<std::string>();
}

void joinChannelFiles(CaptureSet &set)
{
    const std::vector<std::vector<std::size_t>> groups = candidates(set);
    if (groups.empty())
        return;
    ChannelFileJoiner joiner(set);
    for (const std::vector<std::size_t> &group : groups)
        joiner.join(group);
    joiner.finish();
}

} // namespace dyncal
