// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/recipe_labels.h"

#include "core/project/recipe.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>

namespace dyncal {

namespace {

/// "import.exclude[12].shot" -> "import.exclude[].shot", and so for free words in braces.
QString withoutPlaces(QString key)
{
    static const QRegularExpression place(QStringLiteral("\\[\\d*\\]"));
    static const QRegularExpression word(QStringLiteral("\\{[^}]*\\}"));
    return key.replace(place, QStringLiteral("[]")).replace(word, QStringLiteral("{}"));
}

/// By the whole key, and by its last part where that is no plain word ("sample_rate_hz").
const QHash<QString, const char *> &labels()
{
    static const QHash<QString, const char *> labels = [] {
        QHash<QString, const char *> made;
        for (const RecipeKey &one : recipeKeys()) {
            const QString key = QString::fromStdString(one.path);
            made.insert(key, one.label);
            const QString last = key.section('.', -1);
            if (last.contains('_') && !made.contains(last))
                made.insert(last, one.label);
        }
        return made;
    }();
    return labels;
}

} // namespace

QString recipeLabel(const QString &key)
{
    const char *label = labels().value(withoutPlaces(key), nullptr);
    return label ? QCoreApplication::translate("RecipeLabel", label) : QString();
}

QString withRecipeLabels(const QString &sentence)
{
    // Words with a '.' or '_' inside; a '.' that ends the sentence is none of a key.
    static const QRegularExpression word(QStringLiteral(
        "[a-z][a-z0-9_]*(?:\\[\\d*\\]|\\{[^}]*\\})?(?:[._][a-z0-9_]+(?:\\[\\d*\\]|\\{"
        "[^}]*\\})?)+"));
    QString shown;
    qsizetype taken = 0;
    for (auto match = word.globalMatch(sentence); match.hasNext();) {
        const auto found = match.next();
        const QString label = recipeLabel(found.captured());
        if (label.isEmpty())
            continue;
        shown += sentence.mid(taken, found.capturedStart() - taken);
        shown += QStringLiteral("“") + label + QStringLiteral("”");
        taken = found.capturedEnd();
    }
    return shown + sentence.mid(taken);
}

} // namespace dyncal
