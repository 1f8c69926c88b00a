// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Every template and language, every kind of calibration, one to ten shots: the DCC of a run by the
// built program is valid for xmllint and by our own rules, and has every number of PDF and
// results.json for a script of its own (python3-lxml).

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/dcc_judges.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <vector>

namespace {

/// Of tests/audit/cases.py but for the first two: a step with and without what the shock says;
/// comparisons by table, model and chain, each decision rule, CMC; a free decay.
const QStringList kKinds{
    "step", "unknown", "table", "model", "chain", "chain_transducer", "cmc", "decay"};
const QStringList kLayouts{"accredited", "full", "short", "research"};
const QStringList kLanguages{
    "en", "sv", "de", "en,sv", "sv,en", "en,de", "de,en", "sv,de", "de,sv"};
constexpr int kMostShots = 10;

struct Case
{
    QString kind;
    QString layout;
    QString languages;
    int shots = 1;

    QByteArray name() const
    {
        return QString("%1, %2, %3, %4 shots").arg(kind, layout, languages).arg(shots).toUtf8();
    }
};

Case caseOf(qsizetype kind, qsizetype layout, qsizetype languages, qsizetype shots)
{
    return {kKinds[kind % kKinds.size()], kLayouts[layout % kLayouts.size()],
        kLanguages[languages % kLanguages.size()], int(shots % kMostShots) + 1};
}

/// Each of every list at least once, few shots rather than many.
std::vector<Case> fewCases()
{
    constexpr qsizetype kShots[] = {0, 1, 2, 0, 3, 1, 0, 9, 4, 5, 6, 7, 8};
    std::vector<Case> cases;
    for (qsizetype i = 0; i < std::ssize(kShots); ++i) // 5 and 8 have no common factor
        cases.push_back(caseOf(5 * i, i + i / kLayouts.size(), i, kShots[i]));
    return cases;
}

/// Every kind with every number of shots and every template, the languages in turn; and every
/// template with every language, with and without what the shock says.
std::vector<Case> manyCases()
{
    std::vector<Case> cases;
    for (qsizetype shots = 0; shots < kMostShots; ++shots)
        for (qsizetype kind = 0; kind < kKinds.size(); ++kind)
            for (qsizetype layout = 0; layout < kLayouts.size(); ++layout)
                cases.push_back(caseOf(kind, layout, static_cast<qsizetype>(cases.size()), shots));
    for (qsizetype layout = 0; layout < kLayouts.size(); ++layout)
        for (qsizetype languages = 0; languages < kLanguages.size(); ++languages)
            for (const qsizetype kind : {0, 1})
                cases.push_back(caseOf(kind, layout, languages, languages % 3));
    return cases;
}

} // namespace

class TestDccMatrix : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QString path(int shots, const QString &name) const
    {
        return m_folder.filePath(QString("%1/%2").arg(shots).arg(name));
    }

    /// Recordings and recipes of tests/audit/cases.py.
    bool makeRecordings(int shots) const
    {
        QStringList levels;
        for (int i = 0; i < shots; ++i)
            levels << QStringList({"low", "medium", "high"})[i % 3];
        const auto simulate = [&](const char *preset, const char *noise, const char *file) {
            return runDyncal({"simulate", "-o", path(shots, file), "--preset", preset, "--noise",
                                 noise, "--shots", levels.join(','), "--seed", "3", "--duration-s",
                                 "0.003", "--sample-rate-hz", "1e7"})
                       .exitCode
                == 0;
        };
        return QFile::exists(path(shots, "both.h5"))
            || (QDir(m_folder.path()).mkpath(QString::number(shots))
                && simulate("piezo", "0.01", "dut.h5") && simulate("optic1", "0.002", "ref.h5")
                && dyncal::testing::python(
                    {sourcePath("/tests/audit/cases.py"), path(shots, "dut.h5"),
                        path(shots, "ref.h5"), path(shots, "")})
                       .ran);
    }

    /// Path of the case's recipe; nothing here asks for many trials.
    QString recipe(const Case &one) const
    {
        QJsonObject recipe = fileJson(path(one.shots, one.kind + ".json"));
        if (recipe.isEmpty())
            recipe["uncertainty"] = QJsonObject{{"monte_carlo_trials", 1000}};
        if (one.kind == "unknown")
            recipe["shock"] = QJsonObject{{"enabled", false}};
        QJsonObject certificate = recipe["certificate"].toObject();
        certificate["languages"] = QJsonArray::fromStringList(one.languages.split(','));
        recipe["certificate"] = certificate;
        const QString file = path(one.shots, "recipe.json");
        return writeBytes(file, QJsonDocument(recipe).toJson()) ? file : QString();
    }

private slots:
    void initTestCase()
    {
        if (!dyncal::testing::python({"-c", "import lxml, h5py"}).ran)
            QSKIP("python3 with lxml and h5py is not installed: nothing was read.");
        if (schemas().isEmpty())
            qWarning("There are no schemas: xmllint was not asked.");
    }
    void cleanup() { QDir(m_folder.filePath("out")).removeRecursively(); }

    void dcc_isValid_andHasEveryNumber_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("layout");
        QTest::addColumn<QString>("languages");
        QTest::addColumn<int>("shots");
        for (const Case &one : dyncal::trials::count(0, 1) == 0 ? fewCases() : manyCases())
            QTest::newRow(one.name()) << one.kind << one.layout << one.languages << one.shots;
    }
    void dcc_isValid_andHasEveryNumber()
    {
        Case one;
        QFETCH(QString, kind);
        QFETCH(QString, layout);
        QFETCH(QString, languages);
        QFETCH(int, shots);
        one = {kind, layout, languages, shots};
        QVERIFY(makeRecordings(shots));
        const QString capture = kind == "decay"   ? "decay.h5"
            : kind == "step" || kind == "unknown" ? "dut.h5"
                                                  : "both.h5";
        const QString folder = m_folder.filePath("out");
        const Answer answer = runDyncal({"run", path(shots, capture), "--recipe", recipe(one),
            "--template", layout, "-o", folder});
        QVERIFY2(answer.exitCode == 0 || answer.exitCode == 1, answer.err);
        QCOMPARE(faultsOf(folder), QByteArray());
        if (!languages.contains(',')) // side by side the pages are no table of lines any more
            QCOMPARE(missingNumbers(folder, languages), QByteArray());
    }

    /// Refused: nothing is published, and so no DCC.
    void freeDecayToCompare_hasNone()
    {
        QVERIFY(makeRecordings(1));
        const QString folder = m_folder.filePath("out");
        const Answer answer = runDyncal(
            {"run", path(1, "decay.h5"), "--recipe", path(1, "decay_compared.json"), "-o", folder});
        QCOMPARE(answer.exitCode, 4);
        QVERIFY(!QFile::exists(folder + "/dcc.xml"));
    }

    void fewCases_haveEachOfEveryList()
    {
        const std::vector<Case> cases = fewCases();
        const auto has = [&](auto &&isThat) { return std::ranges::any_of(cases, isThat); };
        for (const QString &kind : kKinds)
            QVERIFY2(has([&](const Case &one) { return one.kind == kind; }), qPrintable(kind));
        for (const QString &layout : kLayouts)
            QVERIFY2(
                has([&](const Case &one) { return one.layout == layout; }), qPrintable(layout));
        for (const QString &languages : kLanguages)
            QVERIFY(has([&](const Case &one) { return one.languages == languages; }));
        for (int shots = 1; shots <= kMostShots; ++shots)
            QVERIFY(has([&](const Case &one) { return one.shots == shots; }));
    }
};

DYNCAL_TEST(TestDccMatrix)
#include "tst_dcc_matrix.moc"
