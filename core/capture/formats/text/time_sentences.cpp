// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/time_sentences.h"

#include "core/base/number_text.h"
#include "core/capture/formats/text/time_words.h"

namespace dyncal {
namespace {

constexpr int kRateDigits = 7; ///< of rates, enough to see 0.1 %

tl::unexpected<Error> failure(const char *id, const char *text, std::vector<std::string> words)
{
    return fail(ErrorKind::FileUnreadable, {text, std::move(words)}, id);
}

std::string hertz(double rate_Hz)
{
    return numberWithUnit(rate_Hz, "Hz", kRateDigits);
}

} // namespace

TimeSentences::Failure TimeSentences::frequencies(const ColumnTitle &title) const
{
    return failure("CAP-001",
        DYNCAL_TEXT("core",
            "%1 is no recording over time: its first column, \"%2\", holds frequencies. If it holds samples, say so under columns in the recipe's import section."),
        {path, title.name});
}

TimeSentences::Failure TimeSentences::headerContradictsItself(
    const HeaderRate &a, const HeaderRate &b) const
{
    return failure("CAP-003",
        DYNCAL_TEXT("core",
            "%1: line %2 of the header (\"%3\") means %4, but line %5 (\"%6\") means %7. Which one is right? State sample_rate_hz in the recipe's import section."),
        {path, std::to_string(a.line), a.text, hertz(a.rate_Hz), std::to_string(b.line), b.text,
            hertz(b.rate_Hz)});
}

TimeSentences::Failure TimeSentences::headerAgainstTimes(
    const HeaderRate &header, double times_Hz) const
{
    return failure("CAP-003",
        DYNCAL_TEXT("core",
            "%1: line %2 of the header (\"%3\") means %4, but the column of times steps at %5. Which one is right? State sample_rate_hz in the recipe's import section; to go against the times, name only the columns of samples there, too."),
        {path, std::to_string(header.line), header.text, hertz(header.rate_Hz), hertz(times_Hz)});
}

TimeSentences::Failure TimeSentences::recipeAgainstTimes(double recipe_Hz, double times_Hz) const
{
    return failure("CAP-003",
        DYNCAL_TEXT("core",
            "%1: the recipe states a sample rate of %2, but the column of times steps at %3. Which one is right? Take sample_rate_hz out of the recipe, or say in sample_rate_reason why the times are wrong."),
        {path, hertz(recipe_Hz), hertz(times_Hz)});
}

TimeSentences::Failure TimeSentences::noUnitAgrees(double step, double known_Hz) const
{
    return failure("CAP-003",
        DYNCAL_TEXT("core",
            "%1: the stated sample rate is %2, but the times, which have no unit, step by %3: that fits neither in s nor in ms, us or ns. Correct the rate, or name only the columns of samples in the recipe's import section."),
        {path, hertz(known_Hz), numberText(step, kRateDigits)});
}

TimeSentences::Failure TimeSentences::otherTimes(
    const std::string &name, const std::string &timeName) const
{
    return failure("CAP-003",
        DYNCAL_TEXT("core",
            "%1: column \"%2\" holds other times than column \"%3\", and one shot has one "
            "sample rate. Save each with its samples in a file of its own, or name the columns "
            "of one of them, time included, in the recipe's import section."),
        {path, name, timeName});
}

TimeSentences::Failure TimeSentences::irregular(
    const std::vector<double> &times, const TimeAxis &axis) const
{
    const auto row = static_cast<std::size_t>(*axis.irregular);
    if (axis.drift_steps != 0.0)
        return failure("CAP-016",
            DYNCAL_TEXT("core",
                "%1: the times drift: line %2 is %3 steps off a straight line from the first time to the last (allowed is %4), so no one sample rate is that of all samples. Record anew, or name only the columns of samples and give the sample rate in the recipe's import section."),
            {path, std::to_string(headerLines + *axis.irregular + 1),
                numberText(axis.drift_steps, 3), numberText(kMostDrift_steps)});
    return failure("CAP-016",
        DYNCAL_TEXT("core",
            "%1: the times are not uniform: line %2 follows its predecessor by %3, others by %4 (allowed is 1 %). Record anew, or name only the columns of samples and give the sample rate in the recipe's import section."),
        {path, std::to_string(headerLines + *axis.irregular + 1),
            numberText(times[row] - times[row - 1], 6), numberText(axis.step, 6)});
}

TimeSentences::Failure TimeSentences::unknownUnit(const std::string &unit) const
{
    return failure("CAP-016",
        DYNCAL_TEXT("core",
            "%1: the unit \"%2\" of the column of times is unknown; write s, ms, us or ns."),
        {path, unit});
}

Finding TimeSentences::headerOverruled(const HeaderRate &header, double times_Hz) const
{
    return {.id = "CAP-003",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1: line %2 of the header (\"%3\") means %4, but recipe and column of times agree on %5, which was taken."),
            {path, std::to_string(header.line), header.text, hertz(header.rate_Hz),
                hertz(times_Hz)}}};
}

Finding TimeSentences::headerUnitAssumed(const HeaderRate &header) const
{
    return {.id = "CAP-003",
        .severity = Severity::Info,
        .message
        = {DYNCAL_TEXT("core",
               "%1: line %2 of the header (\"%3\") has no unit; in Hz or s it means %4, which was taken as the sample rate."),
            {path, std::to_string(header.line), header.text, hertz(header.rate_Hz)}}};
}

Finding TimeSentences::ratePassedOver(double recipe_Hz, double times_Hz) const
{
    return {.id = "CAP-003",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1: the recipe's sample rate of %2 was taken although the file's column of times steps at %3."),
            {path, hertz(recipe_Hz), hertz(times_Hz)}}};
}

Finding TimeSentences::unitUnknown(const std::string &name, double step, bool counter) const
{
    return {.id = "CAP-003",
        .severity = Severity::Caution,
        .message
        = {counter ? DYNCAL_TEXT("core",
               "%1: column \"%2\" only counts the rows, so the sample rate is unknown; state sample_rate_hz in the recipe's import section.")
                   : DYNCAL_TEXT("core",
                       "%1: column \"%2\" steps by %3 without a unit, so the sample rate is unknown; state sample_rate_hz in the recipe's import section."),
            {path, name, numberText(step, kRateDigits)}}};
}

Finding TimeSentences::secondsAssumed(
    const std::string &name, double rate_Hz, Severity severity) const
{
    return {.id = "CAP-003",
        .severity = severity,
        .message
        = {DYNCAL_TEXT("core",
               "%1: column \"%2\" has no unit; its numbers were taken as seconds, which makes the sample rate %3. If that is wrong, write the unit into the title."),
            {path, name, hertz(rate_Hz)}}};
}

Finding TimeSentences::irregularPassedOver(const TimeAxis &axis) const
{
    return {.id = "CAP-016",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1: the recipe leaves the column of times out, but at line %2 it is not uniform; if samples are missing there, all behind them is shifted."),
            {path, std::to_string(headerLines + *axis.irregular + 1)}}};
}

Finding TimeSentences::looksLikeTimes(const ColumnTitle &title) const
{
    return {.id = "CAP-016",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1: column \"%2\" rises from row to row like times, but neither title nor unit says so; it was read as samples. If it holds times, name it time under columns in the recipe's import section."),
            {path, title.name}}};
}

} // namespace dyncal
