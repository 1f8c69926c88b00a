// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_correction.h"
#include "tests/core/project/full_recipe.h"
#include "tests/support/test_program.h"

#include <nlohmann/json.hpp>

#include <QTest>

using namespace dyncal;

/// What a finding proposes changes one key of the recipe and nothing else.
class TestRecipeCorrection : public QObject
{
    Q_OBJECT

private slots:
    void number_isSetAndNothingElse();
    void object_isMergedIntoWhatIsThere();
    void roleOfAChannel_leavesWhatElseIsKnownOfIt();
    void keyOrValueThatTheRecipeDoesNotTake_isRefused_data();
    void keyOrValueThatTheRecipeDoesNotTake_isRefused();
    void everyKeyByItself_makesTheWholeRecipe();

private:
    static Correction correctionOf(const std::string &key, const std::string &value)
    {
        return {{}, key, value};
    }
};

void TestRecipeCorrection::number_isSetAndNothingElse()
{
    Recipe recipe;
    recipe.import.channels["A.1"] = "dut";
    recipe.shock.T1_K = 21.0;
    recipe.comparison.loaded // what a file held is kept, though it is no key
        = std::make_shared<const ReferenceSource>(ReferenceSource{"1", "content"});
    const Result<Recipe> corrected = correctedRecipe(recipe, correctionOf("shock.t1_k", "294.15"));
    QVERIFY(corrected.has_value());
    QCOMPARE(*corrected->shock.T1_K, 294.15);
    recipe.shock.T1_K = 294.15;
    QVERIFY(*corrected == recipe);
}

void TestRecipeCorrection::object_isMergedIntoWhatIsThere()
{
    Recipe recipe;
    recipe.import.channels = {{"a", "dut"}, {"b", "driven_side"}, {"c", "trigger"}};
    const Result<Recipe> corrected = correctedRecipe(
        recipe, correctionOf("import.channels", R"({"a": "driven_side", "b": "dut"})"));
    QVERIFY(corrected.has_value());
    const std::map<std::string, std::string> expected{
        {"a", "driven_side"}, {"b", "dut"}, {"c", "trigger"}};
    QVERIFY(corrected->import.channels == expected);
}

/// The button that exchanges two roles must not take the sensitivity with it: volts would be left.
void TestRecipeCorrection::roleOfAChannel_leavesWhatElseIsKnownOfIt()
{
    Recipe recipe;
    recipe.import.channels = {{"a", "dut"}, {"b", "driven_side"}};
    recipe.import.channelDetails["a"].sensitivity = 5e-6;
    recipe.import.channelDetails["c"].gain = 10.0;
    const Result<Recipe> corrected = correctedRecipe(recipe,
        correctionOf("import.channels", R"({"a": "driven_side", "b": "dut", "c": "trigger"})"));
    QVERIFY(corrected.has_value());
    recipe.import.channels = {{"a", "driven_side"}, {"b", "dut"}, {"c", "trigger"}};
    QVERIFY(*corrected == recipe);
}

void TestRecipeCorrection::keyOrValueThatTheRecipeDoesNotTake_isRefused_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("value");
    const auto row = [](const char *key, const char *value) {
        QTest::addRow("%s = %s", key, value) << QByteArray(key) << QByteArray(value);
    };
    row("shock.t1", "294.15");
    row("shock.t1_k", "\"warm\"");
    row("shock.t1_k", "294.15 K");
    row("shock.t1_k", "");
    row("nothing.at.all", "1");
    row("", "1");
    row(".", "1");
    row("shock.", "1");
    row("shock.t1_k.x", "1"); // below a number
    row("remap.x", "1"); // below a word
    row("import.exclude.x", "1"); // below a list
    row("import.exclude.0", "1");
    row("import.exclude.9999999999", "1");
    row("import/scale", "2");
    row("shock~2t1_k", "1");
    row("shock", "[]");
}

void TestRecipeCorrection::keyOrValueThatTheRecipeDoesNotTake_isRefused()
{
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, value);
    Recipe recipe;
    recipe.shock.T1_K = 294.0;
    const Result<Recipe> refused
        = correctedRecipe(recipe, correctionOf(key.toStdString(), value.toStdString()));
    QVERIFY(!refused.has_value());
    QVERIFY(refused.error().kind == ErrorKind::Usage);
    QVERIFY(english(refused.error().message).size() > 20);
}

/// From the default to a recipe in which nothing has its default, one correction after the other.
void TestRecipeCorrection::everyKeyByItself_makesTheWholeRecipe()
{
    const nlohmann::json full = nlohmann::json::parse(recipeJson(fullRecipe()));
    Recipe recipe;
    for (const auto &[section, values] : full.items()) {
        if (!values.is_object() || section == "profile") { // its keys belong together
            const Result<Recipe> corrected
                = correctedRecipe(recipe, correctionOf(section, values.dump()));
            QVERIFY2(corrected.has_value(), section.c_str());
            recipe = *corrected;
            continue;
        }
        for (const auto &[key, value] : values.items()) {
            const std::string path = std::string(section).append(".").append(key);
            const Result<Recipe> corrected
                = correctedRecipe(recipe, correctionOf(path, value.dump()));
            QVERIFY2(corrected.has_value(), path.c_str());
            recipe = *corrected;
        }
    }
    QVERIFY(recipe == fullRecipe());
}

DYNCAL_TEST(TestRecipeCorrection)
#include "tst_recipe_correction.moc"
