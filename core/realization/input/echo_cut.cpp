// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/echo_cut.h"

#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/realization/input/echo_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace dyncal {
namespace {

constexpr double kBefore = 0.98; ///< of the delay: the records end a little before the echo

/// Takes an echo in place of a later one of the same shot.
void take(const Echo &echo, std::vector<Echo> &list)
{
    const auto same = std::ranges::find(list, echo.shot, &Echo::shot);
    if (same == list.end())
        list.push_back(echo);
    else
        *same = echo;
}

double chiSquareOf(const Echo &echo)
{
    return std::pow(echo.relative / echo.u_relative, 2);
}

/// Noise happens to look like an echo in one shot or the other; what reflects the shock is there in
/// all of them, at a delay that the sound speed moves a little.
bool isConfirmed(const Echo &echo, const std::vector<Echo> &all)
{
    constexpr double kAlone = 64.0; // of one shot
    constexpr double kEach = 30.0; // of two or more, at delays alike
    constexpr double kTogether = 45.0; // at one delay
    constexpr double kAlike = 0.1;
    constexpr double kSame = 0.01;
    if (chiSquareOf(echo) >= kAlone)
        return true;
    double together = chiSquareOf(echo);
    for (const Echo &other : all) {
        if (other.shot == echo.shot || other.relative * echo.relative < 0.0)
            continue;
        const double apart = std::abs(other.delay_s / echo.delay_s - 1.0);
        if (apart < kAlike && std::min(chiSquareOf(echo), chiSquareOf(other)) >= kEach)
            return true;
        together += apart < kSame ? chiSquareOf(other) : 0.0;
    }
    return together >= kTogether;
}

std::vector<Echo> candidatesIn(const std::vector<WindowedResponse> &responses,
    const SensorTraits &traits, const JobControl &control)
{
    std::vector<Echo> found;
    for (const WindowedResponse &response : responses)
        if (const auto echo = findEcho(response, traits, control))
            found.push_back(*echo);
    return found;
}

std::vector<Echo> confirmedOf(const std::vector<Echo> &found)
{
    std::vector<Echo> confirmed;
    std::ranges::copy_if(found, std::back_inserter(confirmed),
        [&](const Echo &echo) { return isConfirmed(echo, found); });
    return confirmed;
}

void shorten(WindowedResponse &response, double end_s)
{
    const auto length = static_cast<Index>(std::floor(end_s * response.sampleRate_Hz));
    if (length >= response.length)
        return;
    response.length = length;
    response.end_s = end_s;
    response.values.conservativeResize(response.lead + length);
}

} // namespace

Echoes findEchoes(const std::vector<WindowedResponse> &responses, const SensorTraits &traits,
    bool mayShorten, const JobControl &control)
{
    Echoes echoes;
    std::vector<WindowedResponse> left; // copied where an echo ends them
    while (!control.stopRequested()) {
        const std::vector<WindowedResponse> &searched = left.empty() ? responses : left;
        const std::vector<Echo> found = confirmedOf(candidatesIn(searched, traits, control));
        if (found.empty())
            break;
        for (const Echo &echo : found)
            take(echo, echoes.ofShots);
        const double end_s = kBefore * std::ranges::min(found, {}, &Echo::delay_s).delay_s;
        left = endingAt(searched, end_s);
        if (mayShorten)
            echoes.recordsEnd_s = end_s;
    }
    std::ranges::sort(echoes.ofShots, {}, &Echo::shot);
    return echoes;
}

std::vector<WindowedResponse> endingAt(const std::vector<WindowedResponse> &responses, double end_s)
{
    std::vector<WindowedResponse> ended = responses;
    for (WindowedResponse &response : ended)
        shorten(response, end_s);
    return ended;
}

Findings judgeEchoes(const Echoes &echoes)
{
    Findings findings;
    for (const Echo &echo : echoes.ofShots) {
        const std::string size
            = roundedTextWithU(100.0 * echo.relative, 100.0 * echo.u_relative, "%");
        const std::string delay = numberWithUnit(echo.delay_s, "s", 4);
        Message message = echoes.recordsEnd_s
            ? Message{DYNCAL_TEXT("core",
                          "A copy of the step, %1 of it, follows after %2: an echo. The model and the response use the records up to %3 after the start; look for what reflects the shock."),
                {size, delay, numberWithUnit(*echoes.recordsEnd_s, "s", 4)}}
            : Message{
                DYNCAL_TEXT("core",
                    "A copy of the step, %1 of it, follows after %2: an echo, and the end of the window that was set lies behind it. Poles, damping and response contain it; end the window before it."),
                {size, delay}};
        findings.push_back({.id = "MIN-007",
            .severity = Severity::Caution,
            .shot = echo.shot,
            .message = std::move(message),
            .value = echo.relative,
            .causes = {FindingCause::Echo}});
    }
    return findings;
}

} // namespace dyncal
