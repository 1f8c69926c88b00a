// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>

using namespace dyncal;

/// docs/recipe.md and the program must say the same.
class TestRecipeTable : public QObject
{
    Q_OBJECT

private:
    struct Row
    {
        QString key;
        QString defaultText; ///< JSON, "needed", "none" or empty for a section
    };
    QList<Row> m_rows;

    /// The text between the first pair of backquotes, or all of it.
    static QString unquoted(const QString &cell)
    {
        const QString text = cell.trimmed();
        return text.startsWith('`') ? text.section('`', 1, 1) : text;
    }

    QStringList documentedKeys() const
    {
        QStringList keys;
        for (const Row &row : m_rows)
            keys << row.key;
        return keys;
    }

    /// The value at a dotted key of a document, undefined if it is not there.
    static QJsonValue valueAt(const QJsonObject &root, const QString &key)
    {
        QJsonValue value = root;
        for (const QString &part : key.split('.'))
            value = value.toObject().value(part);
        return value;
    }

    /// The first block of JSON behind these words.
    static std::string exampleBehind(const char *words)
    {
        QFile file(qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/docs/recipe.md");
        const bool isOpen = file.open(QIODevice::ReadOnly);
        const QString text = isOpen ? QString::fromUtf8(file.readAll()) : QString();
        return text.section(words, 1).section("```json\n", 1).section("```", 0, 0).toStdString();
    }

private slots:
    void initTestCase()
    {
        QFile file(qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/docs/recipe.md");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        const QString table = text.section("\n## Keys", 1).section("\n## ", 0, 0);
        for (const QString &line : table.split('\n')) {
            const QStringList cells = QString(line).replace("\\|", "/").split('|');
            if (line.startsWith("| `") && cells.size() == 7)
                m_rows.append({unquoted(cells[1]), unquoted(cells[3])});
            else
                QVERIFY2(!line.startsWith("| `"), qPrintable("not five columns: " + line));
        }
        QVERIFY(m_rows.size() > 80);
    }

    void everyKeyOfTheProgram_isInTheTable()
    {
        const QStringList documented = documentedKeys();
        for (const std::string &path : recipeKeyPaths())
            QVERIFY2(documented.contains(QString::fromStdString(path)), path.c_str());
    }

    void everyKeyOfTheTable_isInTheProgram()
    {
        const std::vector<std::string> &known = recipeKeyPaths();
        for (const QString &key : documentedKeys())
            QVERIFY2(std::find(known.begin(), known.end(), key.toStdString()) != known.end(),
                qPrintable(key));
        QCOMPARE(static_cast<std::size_t>(m_rows.size()), known.size());
    }

    void defaultsOfTheTable_areThoseOfTheProgram()
    {
        const QByteArray json = QByteArray::fromStdString(recipeJson(Recipe()));
        const QJsonObject defaults = QJsonDocument::fromJson(json).object();
        int compared = 0;
        for (const Row &row : m_rows) {
            if (row.defaultText.isEmpty() || row.defaultText == "none" || row.key.contains("[]")
                || row.key.contains("{}"))
                continue;
            const QByteArray wrapped = "[" + row.defaultText.toUtf8() + "]";
            const QJsonArray documented = QJsonDocument::fromJson(wrapped).array();
            QVERIFY2(documented.size() == 1, qPrintable(row.key));
            const QJsonValue written = valueAt(defaults, row.key);
            QVERIFY2(documented.first() == (written.isUndefined() ? QJsonValue() : written),
                qPrintable(row.key)); // a later key is left out while null
            ++compared;
        }
        QVERIFY(compared > 60);
    }

    void everyValueOfTheProgram_hasItsDefaultInTheTable()
    {
        const QByteArray json = QByteArray::fromStdString(recipeJson(Recipe()));
        const QJsonObject defaults = QJsonDocument::fromJson(json).object();
        for (const Row &row : m_rows) {
            const QJsonValue value = valueAt(defaults, row.key);
            const bool isSection = value.isObject() && !value.toObject().isEmpty();
            if (!value.isUndefined() && !isSection)
                QVERIFY2(!row.defaultText.isEmpty(), qPrintable(row.key));
        }
    }

    void neededKeysOfTheTable_areNeededByTheProgram()
    {
        // Each element given without one key: refused if and only if the table says "needed".
        const QMap<QString, QString> complete{
            {"import.exclude", R"({"shot": 1, "reason": "x"})"},
            {"import.shots", R"({"shot": 1, "channels": {}})"},
            {"shock.arrival_sensors",
                R"({"channel": "a", "distance_to_end_wall_m": 1, "u_distance_m": 0,
                    "arrival_s": null, "u_arrival_s": 0, "delay_s": null, "u_delay_s": 0})"},
            {"shock.counters",
                R"({"far_m": 1, "near_m": 0, "time_s": 1, "u_distance_m": 0, "u_time_s": 0})"},
            {"window.exclude_stretches", R"({"shot": 1, "from_s": 0, "to_s": 1, "reason": "x"})"},
            {"realization.nuisance_modes",
                R"({"frequency_hz": 1, "shot": 0, "kind": "tube", "label": "", "reason": "x"})"},
            {"realization.candidate_notes", R"({"order": 3, "note": "x"})"},
            {"response.known",
                R"({"label": "a", "frequency_hz": 0, "magnitude": 1, "u": 1, "unit": "V/Pa",
                    "dof": null, "certificate": null})"},
            {"uncertainty.budget",
                R"({"quantity": "a", "u": 1, "distribution": "normal", "dof": null,
                    "certificate": null, "due": null})"},
            {"uncertainty.correlations", R"({"quantity": "p1_pa", "with": "t1_k", "r": 0})"},
            {"uncertainty.cmc",
                R"({"of": "f0_hz", "expanded": 1, "relative": true, "from_hz": 0, "to_hz": null})"},
            {"acknowledge", R"({"finding": "a", "shot": 0, "reason": "x"})"},
        };
        int checked = 0;
        for (const Row &row : m_rows) {
            if (!row.key.contains("[]."))
                continue;
            const QString list = row.key.section("[].", 0, 0);
            QJsonObject element = QJsonDocument::fromJson(complete.value(list).toUtf8()).object();
            QVERIFY2(element.contains(row.key.section("[].", 1)), qPrintable(row.key));
            element.remove(row.key.section("[].", 1));
            QJsonValue nested = QJsonArray{element};
            QStringList parts = list.split('.');
            while (!parts.isEmpty())
                nested = QJsonObject{{parts.takeLast(), nested}};
            const QByteArray json = QJsonDocument(nested.toObject()).toJson();
            const bool accepted = parseRecipe(json.toStdString()).has_value();
            QVERIFY2(accepted == (row.defaultText != "needed"), qPrintable(row.key));
            ++checked;
        }
        QCOMPARE(checked, 51);
    }

    void example_isARecipe()
    {
        const Result<Recipe> recipe = parseRecipe(exampleBehind("## Example\n"));
        QVERIFY(recipe.has_value());
        QVERIFY(recipe->window.endAtPlateau);
    }

    void exampleOfAProfile_isOne()
    {
        const std::string profile = exampleBehind("## A laboratory's profile\n");
        const testing::ScratchFolder folder;
        const Result<Recipe> recipe
            = readRecipeFiles({}, folder.write("p.json", profile.data(), profile.size()));
        QVERIFY(recipe.has_value());
        QCOMPARE(recipe->profile->name, "Shock tube 2");
    }
};

DYNCAL_TEST(TestRecipeTable)
#include "tst_recipe_table.moc"
