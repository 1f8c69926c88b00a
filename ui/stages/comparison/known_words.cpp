// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/comparison/known_words.h"

#include "ui/text/core_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct KnownWords
{
    Q_DECLARE_TR_FUNCTIONS(KnownWords)
};

const QString kNothing = QStringLiteral("–");

QString frequencyText(const KnownSensitivity &stated)
{
    return stated.frequency_Hz > 0.0 ? shownQuantity(stated.frequency_Hz, QStringLiteral("Hz"), 4)
                                     : KnownWords::tr("static");
}

QString withExpandedU(const ReportedValue &value)
{
    return std::isfinite(value.value)
        ? shownWithU(value.value, value.expanded().value_or(kUnknown), shownText(value.unit))
        : kNothing;
}

QString verdictText(const KnownValue &known)
{
    if (!known.isCompared())
        return KnownWords::tr("not compared: %1").arg(translated(known.missing));
    return known.isJoined() ? KnownWords::tr("agrees, joined")
                            : KnownWords::tr("differs, not joined");
}

QString differenceText(const KnownValue &known)
{
    if (!known.isCompared())
        return kNothing;
    return shownNumber(100.0 * known.difference_relative(), 2) + QStringLiteral(" %");
}

} // namespace

QString knownText(const KnownSensitivity &stated)
{
    constexpr double kUsual = 2.0;
    return KnownWords::tr("%1, %2: %3 (k = 2)")
        .arg(shownText(stated.label), frequencyText(stated),
            shownWithU(stated.magnitude, kUsual * stated.u, shownText(stated.unit)));
}

QString knownVerdict(const std::vector<KnownValue> &known)
{
    if (known.empty())
        return {};
    const auto joined = std::ranges::count_if(known, &KnownValue::isJoined);
    return KnownWords::tr("Of %1 values of other calibrations %2 agree with this one within U.")
        .arg(known.size())
        .arg(joined);
}

ShownTable knownTable(const std::vector<KnownValue> &known)
{
    ShownTable table{
        {KnownWords::tr("Calibration"), KnownWords::tr("Frequency"),
            KnownWords::tr("Its value ± U"), KnownWords::tr("Here ± U"),
            KnownWords::tr("Difference"), KnownWords::tr("Eₙ"), KnownWords::tr("Verdict")},
        {}};
    for (const KnownValue &one : known)
        table.rows.push_back({shownText(one.stated.label), frequencyText(one.stated),
            withExpandedU(one.other), withExpandedU(one.here), differenceText(one),
            one.isCompared() ? shownNumber(one.e_n, 2) : kNothing, verdictText(one)});
    return table;
}

} // namespace dyncal
