// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/finding_group.h"

#include "core/base/message_places.h"
#include "ui/text/core_text.h"
#include "ui/text/finding_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <string_view>

namespace dyncal {

namespace {

constexpr std::size_t kMostValues = 3; ///< of a place that differs; beyond, the first and the last
constexpr Index kShortestRange = 3; ///< "1 and 2", but "1 to 3"

/// Gives the sentences below their translation context.
struct GroupText
{
    Q_DECLARE_TR_FUNCTIONS(FindingGroup)
};

bool saySame(const Finding &a, const Finding &b)
{
    return a.id == b.id && a.severity == b.severity
        && std::string_view(a.message.text) == b.message.text
        && a.message.arguments.size() == b.message.arguments.size()
        && a.message.below.size() == countWithin(a.message)
        && b.message.below.size() == a.message.below.size() && !a.id.empty();
}

/// What stands in one place of the sentence, of all findings of a group.
std::string valuesAt(const FindingGroup &group, std::size_t place)
{
    std::vector<std::string> values;
    for (const Finding &finding : group)
        if (const std::string &value = finding.message.arguments[place];
            std::ranges::find(values, value) == values.end())
            values.push_back(value);
    if (values.size() > kMostValues)
        return values.front() + " / … / " + values.back();
    std::string text = values.front();
    for (std::size_t i = 1; i < values.size(); ++i)
        text.append(" / ").append(values[i]);
    return text;
}

/// The same for a sentence within the sentence.
Message sentencesAt(const FindingGroup &group, std::size_t place)
{
    std::vector<Message> sentences;
    for (const Finding &finding : group)
        if (const Message &one = finding.message.below[place];
            std::ranges::find(sentences, one) == sentences.end())
            sentences.push_back(one);
    if (sentences.size() > kMostValues)
        return {"%M1 / … / %M2", {}, {sentences.front(), sentences.back()}};
    Message common = sentences.front();
    for (std::size_t i = 1; i < sentences.size(); ++i)
        common = {"%M1 / %M2", {}, {common, sentences[i]}};
    return common;
}

Message commonMessage(const FindingGroup &group)
{
    const Message &first = group.front().message;
    Message common{first.text, {}};
    for (std::size_t place = 0; place < first.arguments.size(); ++place)
        common.arguments.push_back(valuesAt(group, place));
    for (std::size_t place = 0; place < first.below.size(); ++place)
        common.below.push_back(sentencesAt(group, place));
    return common;
}

} // namespace

std::vector<FindingGroup> grouped(const Findings &findings)
{
    std::vector<FindingGroup> groups;
    for (const Finding &finding : findings) {
        const auto same = std::ranges::find_if(
            groups, [&](const FindingGroup &group) { return saySame(group.front(), finding); });
        if (same == groups.end())
            groups.push_back({finding});
        else
            same->push_back(finding);
    }
    std::ranges::stable_sort(groups, [](const FindingGroup &a, const FindingGroup &b) {
        return a.front().severity > b.front().severity;
    });
    return groups;
}

QString groupLine(const FindingGroup &group)
{
    const Finding &first = group.front();
    if (group.size() == 1)
        return findingLine(first);
    std::vector<Index> shots;
    shots.reserve(group.size());
    for (const Finding &finding : group)
        if (finding.shot > 0)
            shots.push_back(finding.shot);
    const QString head = severityGlyph(first.severity) + " " + severityWord(first.severity) + " "
        + QString::fromStdString(first.id);
    const QString where = shots.size() == group.size()
        ? GroupText::tr("shots %1").arg(shotList(shots))
        : GroupText::tr("%n time(s)", nullptr, static_cast<int>(group.size()));
    return head + ", " + where + ": " + translated(commonMessage(group));
}

QString shotList(std::vector<Index> shots)
{
    std::ranges::sort(shots);
    shots.erase(std::unique(shots.begin(), shots.end()), shots.end());
    QStringList parts;
    for (std::size_t begin = 0; begin < shots.size();) {
        std::size_t end = begin + 1;
        while (end < shots.size() && shots[end] == shots[end - 1] + 1)
            ++end;
        if (static_cast<Index>(end - begin) < kShortestRange)
            end = begin + 1;
        parts << (end - begin == 1
                ? QString::number(shots[begin])
                : GroupText::tr("%1 to %2").arg(shots[begin]).arg(shots[end - 1]));
        begin = end;
    }
    if (parts.size() < 2)
        return parts.join(QString());
    const QString last = parts.takeLast();
    return GroupText::tr("%1 and %2").arg(parts.join(QStringLiteral(", ")), last);
}

} // namespace dyncal
