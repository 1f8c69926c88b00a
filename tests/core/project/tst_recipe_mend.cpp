// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_mend.h"

#include <QTest>

using namespace dyncal;

/// What a finding proposes changes one key of the recipe and nothing else.
class TestRecipeMend : public QObject
{
    Q_OBJECT

private slots:
    void number_isSetAndNothingElse();
    void object_isMergedIntoWhatIsThere();
    void keyOrValueThatTheRecipeDoesNotTake_isRefused();

private:
    static Mend mendOf(const std::string &key, const std::string &value)
    {
        return {{}, key, value};
    }
};

void TestRecipeMend::number_isSetAndNothingElse()
{
    Recipe recipe;
    recipe.import.channels["A.1"] = "dut";
    recipe.shock.T1_K = 21.0;
    const Result<Recipe> mended = mendedRecipe(recipe, mendOf("shock.t1_k", "294.15"));
    QVERIFY(mended.has_value());
    QCOMPARE(*mended->shock.T1_K, 294.15);
    recipe.shock.T1_K = 294.15;
    QVERIFY(*mended == recipe);
}

void TestRecipeMend::object_isMergedIntoWhatIsThere()
{
    Recipe recipe;
    recipe.import.channels = {{"a", "dut"}, {"b", "driven_side"}, {"c", "trigger"}};
    const Result<Recipe> mended
        = mendedRecipe(recipe, mendOf("import.channels", R"({"a": "driven_side", "b": "dut"})"));
    QVERIFY(mended.has_value());
    const std::map<std::string, std::string> expected{
        {"a", "driven_side"}, {"b", "dut"}, {"c", "trigger"}};
    QVERIFY(mended->import.channels == expected);
}

void TestRecipeMend::keyOrValueThatTheRecipeDoesNotTake_isRefused()
{
    for (const Mend &mend : {mendOf("shock.t1", "294.15"), mendOf("shock.t1_k", "\"warm\""),
             mendOf("shock.t1_k", "294.15 K"), mendOf("nothing.at.all", "1")}) {
        const Result<Recipe> refused = mendedRecipe({}, mend);
        QVERIFY(!refused.has_value());
        QVERIFY(refused.error().kind == ErrorKind::Usage);
    }
}

QTEST_APPLESS_MAIN(TestRecipeMend)
#include "tst_recipe_mend.moc"
