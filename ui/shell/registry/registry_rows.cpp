// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/registry_rows.h"

#include "ui/text/shown_text.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>

namespace dyncal {

namespace {

struct Word
{
    const char *key;
    const char *text;
};

constexpr std::array kStates{
    Word{"reserved", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "reserved")},
    Word{"issued", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "issued")},
    Word{"amended", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "issued as an amendment")},
    Word{"replaced", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "replaced")},
    Word{"withdrawn", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "withdrawn")},
    Word{"void", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "void")},
};

/// The sign says it without the word, as for findings.
constexpr std::array kStatuses{
    Word{"valid", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "● valid")},
    Word{"unsigned", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "▲ valid, not signed")},
    Word{"changed", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "■ changed")},
    Word{"missing", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "■ missing")},
    Word{"unknown-signer", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "▲ unknown signer")},
    Word{"expired", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "▲ expired")},
    Word{"unreadable", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "■ unreadable")},
};

constexpr std::array kKinds{
    Word{"certificate", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "certificate")},
    Word{"registry", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "registry")},
    Word{"project", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "project")},
    Word{"recording", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "recording")},
    Word{"file", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "file")},
    Word{"laboratory", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "laboratory")},
    Word{"customer", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "customer")},
    Word{"sensor", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "sensor")},
    Word{"reference", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "reference instrument")},
};

constexpr std::array kActions{
    Word{"added", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "added")},
    Word{"changed", QT_TRANSLATE_NOOP("dyncal::RegistryRows", "changed")},
};

template <std::size_t n>
QString wordOf(const std::array<Word, n> &words, const QString &key)
{
    for (const Word &word : words)
        if (key == QLatin1String(word.key))
            return QCoreApplication::translate("dyncal::RegistryRows", word.text);
    return shownText(key);
}

QString text(const QJsonValue &value)
{
    return shownText(value.toString());
}

/// What was done, of a certificate or of a card.
QString actionText(const QString &action)
{
    const auto isThis = [&](const Word &word) { return action == QLatin1String(word.key); };
    return std::ranges::any_of(kStates, isThis) ? wordOf(kStates, action)
                                                : wordOf(kActions, action);
}

/// "certificate 7", "customer 3" in the language of the window.
QString objectText(const QString &object)
{
    const QString kind = object.section(' ', 0, 0);
    return (wordOf(kKinds, kind) + ' ' + shownText(object.section(' ', 1))).trimmed();
}

/// Nothing in place of 0, which stands for none.
QVariant numberOrNone(const QJsonValue &value)
{
    const qint64 number = value.toInteger();
    return number > 0 ? QVariant(number) : QVariant();
}

QString remarksOf(const QJsonValue &verified)
{
    if (verified["first_difference"].isString())
        return text(verified["first_difference"]);
    QStringList remarks;
    for (const QJsonValue remark : verified["remarks"].toArray())
        remarks << text(remark);
    return remarks.join(' ');
}

template <typename Row>
std::vector<QVariantList> rowsOf(const QJsonArray &list, const Row &row)
{
    std::vector<QVariantList> rows;
    for (const QJsonValue one : list)
        rows.push_back(row(one));
    return rows;
}

} // namespace

QJsonArray listOf(const QByteArray &json)
{
    return QJsonDocument::fromJson(json).array();
}

std::vector<QVariantList> certificateRows(const QJsonArray &records)
{
    return rowsOf(records, [](const QJsonValue &one) {
        return QVariantList{one["number"].toInteger(),
            certificateStateText(one["state"].toString()), text(one["sensor"]),
            text(one["customer"]), timeText(one["issued_utc"].toString()), text(one["by"]),
            text(one["reviewed_by"]), numberOrNone(one["amends"]), numberOrNone(one["replaced_by"]),
            text(one["reason"])};
    });
}

std::vector<QVariantList> trailRows(const QJsonArray &entries)
{
    return rowsOf(entries, [](const QJsonValue &one) {
        return QVariantList{one["sequence"].toInteger(), timeText(one["utc"].toString()),
            text(one["who"]), actionText(one["action"].toString()),
            objectText(one["object"].toString()), text(one["reason"])};
    });
}

std::vector<QVariantList> verifiedRows(const QJsonArray &verified)
{
    return rowsOf(verified, [](const QJsonValue &one) {
        return QVariantList{text(one["file"]), wordOf(kKinds, one["kind"].toString()),
            wordOf(kStatuses, one["status"].toString()), numberOrNone(one["number"]),
            one["state"].isString() ? certificateStateText(one["state"].toString()) : QString(),
            text(one["signer"]), timeText(one["signed_utc"].toString()),
            timeText(one["stamped_utc"].toString()), remarksOf(one)};
    });
}

VerifiedCounts countsOf(const QJsonArray &verified)
{
    VerifiedCounts counts;
    for (const QJsonValue one : verified) {
        const QString status = one["status"].toString();
        const bool isValid = status == QLatin1String("valid");
        const bool isBad = status == QLatin1String("changed") || status == QLatin1String("missing")
            || status == QLatin1String("unreadable");
        ++(isValid ? counts.valid : isBad ? counts.bad : counts.doubtful);
    }
    return counts;
}

QString certificateStateText(const QString &state)
{
    return wordOf(kStates, state);
}

bool isInForce(const QString &state)
{
    return state == QLatin1String("issued") || state == QLatin1String("amended");
}

QString timeText(const QString &utc)
{
    return shownText(utc).replace('T', ' ').remove('Z');
}

} // namespace dyncal
