// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/atomic_file.h"
#include "core/base/writing/write_problem.h"
#include "core/capture/capture_seal.h"
#include "core/capture/opening/capture_open.h"
#include "tests/support/file_bytes.h"
#include "tests/support/same_samples.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "ui/session/capture_edit.h"
#include "ui/session/capture_reading.h"
#include "ui/session/example.h"
#include "ui/session/project_checksum.h"
#include "ui/session/project_file.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include <random>

using namespace dyncal;
using testing::writeBytes;

namespace {

QJsonObject readJson(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                          : QJsonObject();
}

QString said(const Error &error)
{
    return QString::fromStdString(english(error.message));
}

} // namespace

class TestProjectFile : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void example_savedAndOpened_isTheSame();
    void removedShot_staysOut();
    void recipe_everyNumber_survives();
    void fileOfTheReference_isReadBesideTheProject();
    void templateBelowTheProject_movesWithIt();
    void recordings_areNamedRelativeToTheProject();
    void frozenProject_namesNoFolder();
    void changedRecording_isReportedAndBlocks();
    void recordingInAFile_isOpenedUnsealedAndHeldAgainstItsHash();
    void movedRecording_isFoundInTheFolderGiven();
    void unsealedRecording_expectsNoHash();
    void missingRecordings_areAllNamed();
    void otherFiles_areRefusedByName_data();
    void otherFiles_areRefusedByName();
    void otherVersions_areRefusedWithWhatIsNeeded_data();
    void otherVersions_areRefusedWithWhatIsNeeded();
    void olderVersion_isOpenedAndSaid();
    void unwritablePlace_isSaidAndLeavesNothing();
    void editedProject_opensWithACautionThatNamesTheParts_data();
    void editedProject_opensWithACautionThatNamesTheParts();
    void reformattedProject_isTheSame();
    void projectOfAnOlderVersion_opensMarked();
    void everyFlippedBit_isSeenOrSaysTheSame();
    void otherFileInItsPlace_isNotReplaced();

private:
    /// Text of a project without recordings.
    QByteArray smallProject() const
    {
        ProjectState state;
        state.recipe = m_state.recipe;
        return projectBytes(state, m_folder.path());
    }
    QTemporaryDir m_folder;
    ProjectState m_state;
};

void TestProjectFile::initTestCase()
{
    const Result<CaptureSet> set = exampleCaptures();
    QVERIFY(set);
    m_state.captures = std::make_shared<const CaptureSet>(*set);
    m_state.recipe.realization.order = 3;
    m_state.recipe.window.end_s = 1.0 / 3.0;
    m_state.recipe.import.exclude = {{2, "diaphragm held; \"Ö\""}};
    m_state.recipe.certificate.fields["customer"] = "Åsa & Co";
}

void TestProjectFile::fileOfTheReference_isReadBesideTheProject()
{
    QFile file(m_folder.filePath("ref.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("abc") == 3);
    file.close();
    ProjectState state = m_state;
    state.recipe.comparison.source = "ref.csv";
    const QString path = m_folder.filePath("compared.dyncal");
    QVERIFY(saveProject(path, state, projectFileHash(path)));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(opened && opened->recipe.comparison.loaded);
    QCOMPARE(opened->recipe.comparison.loaded->content, std::string("abc"));
}

void TestProjectFile::templateBelowTheProject_movesWithIt()
{
    const auto written = [&](const QString &name) {
        ProjectState state = m_state;
        state.recipe.certificate.templateName = name.toStdString();
        const QJsonObject project
            = QJsonDocument::fromJson(projectBytes(state, m_folder.path())).object();
        return project["recipe"]["certificate"]["template"].toString();
    };
    QCOMPARE(written(m_folder.filePath("layout/lab.json")), QString("layout/lab.json"));
    QCOMPARE(written(m_folder.filePath("lab.json")), QString("lab.json"));
    for (const char *elsewhere : {"/somewhere/lab.json", "short", "lab.json"})
        QCOMPARE(written(elsewhere), QString(elsewhere));
    const QString above = m_folder.path() + "-beside/lab.json";
    QCOMPARE(written(above), above);

    const QTemporaryDir other;
    ProjectState state = m_state;
    state.recipe.certificate.templateName = m_folder.filePath("lab.json").toStdString();
    const QString path = m_folder.filePath("with template.dyncal");
    QVERIFY(saveProject(path, state, projectFileHash(path)));
    QVERIFY(QFile::copy(path, other.filePath("job.dyncal")));
    const Result<ProjectState> opened = openProject(other.filePath("job.dyncal"));
    QVERIFY(opened);
    QCOMPARE(opened->recipe.certificate.templateName, other.filePath("lab.json").toStdString());
}

void TestProjectFile::example_savedAndOpened_isTheSame()
{
    const QString path = m_folder.filePath("a.dyncal");
    QVERIFY(saveProject(path, m_state, projectFileHash(path)));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(opened);
    QVERIFY(opened->recipe == m_state.recipe);
    QCOMPARE(opened->captures->shots.size(), m_state.captures->shots.size());
    QCOMPARE(opened->captures->inputs[0].sha256, m_state.captures->inputs[0].sha256);
    QCOMPARE(opened->captures->findings.size(), m_state.captures->findings.size());
    for (std::size_t i = 0; i < 3; ++i)
        QCOMPARE(opened->captures->shots[i].channels[0].samples.at(12345),
            m_state.captures->shots[i].channels[0].samples.at(12345));
}

void TestProjectFile::removedShot_staysOut()
{
    const QString path = m_folder.filePath("removed.dyncal");
    const ProjectState state = withoutShot(m_state, 1);
    QCOMPARE(state.recipe.import.exclude.at(0).shot, Index(1)); // was shot 2
    QVERIFY(saveProject(path, state, projectFileHash(path)));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(opened);
    QCOMPARE(opened->captures->shots.size(), std::size_t(2));
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(opened->captures->shots[i].inFile, static_cast<Index>(i) + 2);
        QVERIFY(testing::sameSamples(opened->captures->shots[i].channels[0].samples,
            m_state.captures->shots[i + 1].channels[0].samples));
    }
    QVERIFY(opened->recipe == state.recipe);
}

void TestProjectFile::recipe_everyNumber_survives()
{
    const QString path = m_folder.filePath("numbers.dyncal");
    ProjectState state = m_state;
    // Numbers that need all 17 digits, and the smallest steps.
    state.recipe.shock.p1_Pa = 101325.00000000001;
    state.recipe.input.sampleRate_Hz = 1e7 / 3.0;
    state.recipe.window.start_s = {0.1, 1e-300, -2.0 / 7.0};
    QVERIFY(saveProject(path, state, projectFileHash(path)));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(opened);
    QVERIFY(opened->recipe == state.recipe);
}

/// Of an issued certificate: recordings by name and hash alone.
void TestProjectFile::frozenProject_namesNoFolder()
{
    ProjectState state = m_state;
    CaptureSet set = *state.captures;
    set.inputs = {{m_folder.filePath("data/low.h5").toStdString(), "low.h5", "00", "test"}};
    state.captures = std::make_shared<const CaptureSet>(set);
    const QByteArray frozen = frozenProjectBytes(state);
    QVERIFY(!frozen.contains(m_folder.path().toUtf8()));
    const QJsonObject project = QJsonDocument::fromJson(frozen).object();
    const QJsonObject entry = project["captures"].toArray().at(0).toObject();
    QCOMPARE(entry["path"].toString(), QString("low.h5"));
    QCOMPARE(entry["sha256"].toString(), QString("00"));
    QVERIFY(!entry.contains("absolute_path"));
    QVERIFY(checkProject(project, "project").empty());
    QVERIFY(recipeOfProject(project).value() == state.recipe);
}

void TestProjectFile::recordings_areNamedRelativeToTheProject()
{
    ProjectState state = m_state;
    CaptureSet set = *state.captures;
    set.inputs = {{m_folder.filePath("data/low.h5").toStdString(), "low.h5", "00", "test"}};
    state.captures = std::make_shared<const CaptureSet>(set);
    const QString path = m_folder.filePath("relative.dyncal");
    QVERIFY(saveProject(path, state, projectFileHash(path)));
    const QJsonObject json = readJson(path);
    QCOMPARE(json["format"].toString(), QString("dyncal-project"));
    const QJsonObject entry = json["captures"].toArray().at(0).toObject();
    QCOMPARE(entry["path"].toString(), QString("data/low.h5"));
    QCOMPARE(entry["sha256"].toString(), QString("00"));
}

void TestProjectFile::changedRecording_isReportedAndBlocks()
{
    const QString path = m_folder.filePath("changed.dyncal");
    QVERIFY(saveProject(path, m_state, projectFileHash(path)));
    QJsonObject json = readJson(path);
    QJsonArray captures = json["captures"].toArray();
    QJsonObject entry = captures[0].toObject();
    entry["sha256"] = QString(64, '0');
    captures[0] = entry;
    json["captures"] = captures;
    QVERIFY(writeBytes(path, QJsonDocument(json).toJson()));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(opened);
    const Findings &findings = opened->captures->findings;
    QVERIFY(!findings.empty());
    QCOMPARE(findings.back().id, std::string("CAP-015"));
    QCOMPARE(findings.back().severity, Severity::Block);
}

void TestProjectFile::recordingInAFile_isOpenedUnsealedAndHeldAgainstItsHash()
{
    const QString recording = m_folder.filePath("own.csv");
    QVERIFY(writeBytes(recording, "time (s),p (bar)\n0,1\n1e-6,2\n2e-6,3\n"));
    ProjectState state;
    const Result<CaptureSet> read = readCaptures({recording.toStdString()}, {});
    QVERIFY(read);
    state.captures = std::make_shared<const CaptureSet>(*read);
    const QString path = m_folder.filePath("own.dyncal");
    QVERIFY(saveProject(path, state, projectFileHash(path)));

    const auto sealedAgain = [&] {
        const Result<ProjectState> opened = openProject(path);
        if (!opened || !opened->captures->inputs[0].sha256.empty())
            return CaptureSet();
        // Reading it anew, as under other import settings, does not forget what is expected.
        const Result<CapturesRead> again = readAgain(*opened->captures, {}, {});
        const Result<CaptureSet> sealed = sealCaptures(again->set);
        return sealed ? *sealed : CaptureSet();
    };
    const CaptureSet same = sealedAgain();
    QCOMPARE(same.shots.size(), std::size_t(1));
    QCOMPARE(same.inputs[0].sha256, read->inputs[0].sha256);
    QVERIFY(same.findings == read->findings);

    QVERIFY(writeBytes(recording, "time (s),p (bar)\n0,1\n1e-6,2\n2e-6,4\n"));
    const CaptureSet changed = sealedAgain();
    QCOMPARE(changed.shots.size(), std::size_t(1));
    QCOMPARE(changed.findings.back().id, std::string("CAP-015"));
    QCOMPARE(changed.findings.back().severity, Severity::Block);

    // Saving the project does not make the changed recording the right one.
    QVERIFY(saveProject(
        path, {std::make_shared<const CaptureSet>(changed), {}}, projectFileHash(path)));
    QCOMPARE(sealedAgain().findings.back().id, std::string("CAP-015"));
}

void TestProjectFile::movedRecording_isFoundInTheFolderGiven()
{
    const QString recording = m_folder.filePath("moved.csv");
    QVERIFY(writeBytes(recording, "time (s),p (bar)\n0,1\n1e-6,2\n2e-6,3\n"));
    const Result<CaptureSet> read = readCaptures({recording.toStdString()}, {});
    QVERIFY(read);
    const QString path = m_folder.filePath("moved.dyncal");
    QVERIFY(
        saveProject(path, {std::make_shared<const CaptureSet>(*read), {}}, projectFileHash(path)));
    QVERIFY(QDir(m_folder.path()).mkpath("elsewhere"));
    const QString there = m_folder.filePath("elsewhere/moved.csv");
    QVERIFY(QFile::rename(recording, there));

    const Result<ProjectState> missing = openProject(path);
    QVERIFY(!missing);
    QVERIFY(said(missing.error()).contains(recording)); // where it should be
    const Result<ProjectState> opened
        = openProject(path, {}, {m_folder.filePath("nowhere"), m_folder.filePath("elsewhere")});
    QVERIFY(opened);
    QCOMPARE(opened->captures->inputs[0].path, there.toStdString());
    QCOMPARE(*opened->captures->inputs[0].expectedSha256, read->inputs[0].sha256);
}

void TestProjectFile::unsealedRecording_expectsNoHash()
{
    const QString recording = m_folder.filePath("unsealed.csv");
    QVERIFY(writeBytes(recording, "time (s),p (bar)\n0,1\n1e-6,2\n2e-6,3\n"));
    const Result<CaptureSet> opened = openCaptures({recording.toStdString()}, {});
    QVERIFY(opened);
    const QString path = m_folder.filePath("unsealed.dyncal");
    const ProjectState state{std::make_shared<const CaptureSet>(*opened), {}};
    QVERIFY(writeBytes(path, projectBytes(state, m_folder.path(), {{"more", 1}})));
    const Result<ProjectState> back = openProject(path);
    QVERIFY(back);
    QVERIFY(!back->captures->inputs[0].expectedSha256);
    // A hash that was taken out of a project is no such thing.
    QJsonObject json = readJson(path);
    json["captures"] = QJsonArray{QJsonObject{{"path", "unsealed.csv"}}};
    QVERIFY(writeBytes(path, QJsonDocument(json).toJson()));
    QCOMPARE(*openProject(path)->captures->inputs[0].expectedSha256, std::string());
}

void TestProjectFile::missingRecordings_areAllNamed()
{
    ProjectState state = m_state;
    CaptureSet set = *state.captures;
    set.inputs = {
        {"/nowhere/low.h5", "low.h5", "00", "test"}, {"/nowhere/high.h5", "high.h5", "11", "test"}};
    state.captures = std::make_shared<const CaptureSet>(set);
    const QString path = m_folder.filePath("missing.dyncal");
    QVERIFY(saveProject(path, state, projectFileHash(path)));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(!opened);
    QCOMPARE(opened.error().kind, ErrorKind::FileUnreadable);
    QVERIFY(said(opened.error()).contains("low.h5"));
    QVERIFY(said(opened.error()).contains("high.h5"));
}

void TestProjectFile::otherFiles_areRefusedByName_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("pdf") << QByteArray("%PDF-1.7");
    QTest::newRow("json of another kind") << QByteArray("{\"a\": 1}");
    QTest::newRow("list") << QByteArray("[1, 2]");
    QTest::newRow("cut short") << QByteArray("{\"format\": \"dyncal-project\", \"ver");
    QTest::newRow("zeros") << QByteArray(1000, '\0');
    QTest::newRow("deep") << QByteArray(5000, '[');
}

void TestProjectFile::otherFiles_areRefusedByName()
{
    QFETCH(QByteArray, bytes);
    const QString path = m_folder.filePath("other.dyncal");
    QVERIFY(writeBytes(path, bytes));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(!opened);
    QCOMPARE(opened.error().kind, ErrorKind::FileUnreadable);
    QVERIFY(said(opened.error()).contains("other.dyncal"));
}

void TestProjectFile::otherVersions_areRefusedWithWhatIsNeeded_data()
{
    QTest::addColumn<QByteArray>("version");
    QTest::addColumn<QString>("words");
    const QByteArray next = QByteArray::number(kProjectVersion + 1);
    QTest::newRow("next") << next
                          << QString("written by a newer program: it has version %1, and this "
                                     "program reads up to version %2; open it with the newer "
                                     "program.")
                                 .arg(kProjectVersion + 1)
                                 .arg(kProjectVersion);
    QTest::newRow("far") << QByteArray("1e300") << QString("newer program");
    QTest::newRow("minor") << QByteArray::number(kProjectVersion) + ".5"
                           << QString("newer program");
    for (const char *none : {"0", "-1", "1.5", "\"2\"", "null", "[2]"})
        QTest::newRow(none) << QByteArray(none)
                            << QString("version %1, which no program").arg(none);
}

void TestProjectFile::otherVersions_areRefusedWithWhatIsNeeded()
{
    QFETCH(QByteArray, version);
    QFETCH(QString, words);
    const QString path = m_folder.filePath("versions.dyncal");
    QVERIFY(writeBytes(path, "{\"format\": \"dyncal-project\", \"version\": " + version + "}"));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(!opened);
    QCOMPARE(opened.error().kind, ErrorKind::FileUnreadable);
    QVERIFY2(said(opened.error()).contains(words), qPrintable(said(opened.error())));
    QVERIFY(said(opened.error()).contains("versions.dyncal"));
}

void TestProjectFile::olderVersion_isOpenedAndSaid()
{
    const QString path = m_folder.filePath("version.dyncal");
    QVERIFY(saveProject(path, m_state, projectFileHash(path)));
    QVERIFY(!olderVersion(*readProjectFile(path)));
    for (int version = 1; version < kProjectVersion; ++version) {
        QJsonObject json = readJson(path);
        json["version"] = version;
        QVERIFY(writeBytes(path, QJsonDocument(withChecksums(json)).toJson()));
        const Result<ProjectFile> file = readProjectFile(path);
        QVERIFY(file);
        const std::optional<Finding> older = olderVersion(*file);
        QVERIFY(older);
        QCOMPARE(older->id, std::string("FIL-003"));
        const QString sentence = QString::fromStdString(english(older->message));
        QVERIFY2(sentence.contains(QString("as version %1;").arg(version)), qPrintable(sentence));
        const Result<ProjectState> opened = openProject(*file);
        QVERIFY(opened);
        QVERIFY(opened->recipe == m_state.recipe);
        QVERIFY(
            opened->captures->findings == m_state.captures->findings); // no result depends on it
    }
}

void TestProjectFile::unwritablePlace_isSaidAndLeavesNothing()
{
    const QString path = m_folder.filePath("no/such/folder/a.dyncal");
    const Result<std::string> saved = saveProject(path, m_state, projectFileHash(path));
    QVERIFY(!saved);
    QVERIFY(said(saved.error()).contains("a.dyncal"));
    QVERIFY(!QFile::exists(path));
}

void TestProjectFile::editedProject_opensWithACautionThatNamesTheParts_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QString>("named");
    QTest::newRow("order") << QByteArray("\"order\": 3") << QByteArray("\"order\": 4")
                           << ": recipe.realization. ";
    QTest::newRow("text") << QByteArray("& Co") << QByteArray("& co") << ": recipe.certificate. ";
    QTest::newRow("recordings") << QByteArray("\"captures\": [\n")
                                << QByteArray("\"captures\": [null\n") << ": captures. ";
    QTest::newRow("another key") << QByteArray("\"captures\": [")
                                 << QByteArray("\"note\": 1, \"captures\": [") << ": note. ";
    QTest::newRow("checksum") << QByteArray("\"sha256\": \"") << QByteArray("\"sha256\": \"0")
                              << ": sha256. ";
}

void TestProjectFile::editedProject_opensWithACautionThatNamesTheParts()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(QString, named);
    QByteArray bytes = smallProject();
    QCOMPARE(bytes.count(before), 1);
    bytes.replace(before, after);
    const QJsonObject project = QJsonDocument::fromJson(bytes).object();
    QVERIFY(!project.isEmpty());
    const Findings findings = checkProject(project, "a.dyncal");
    QCOMPARE(findings.size(), std::size_t(1));
    QCOMPARE(findings[0].id, std::string("PRJ-001"));
    QCOMPARE(findings[0].severity, Severity::Caution);
    const QString sentence = QString::fromStdString(english(findings[0].message));
    QVERIFY2(sentence.contains(named), qPrintable(sentence));
}

void TestProjectFile::reformattedProject_isTheSame()
{
    const QString path = m_folder.filePath("compact.dyncal");
    QVERIFY(saveProject(path, m_state, projectFileHash(path)));
    QVERIFY(writeBytes(path, QJsonDocument(readJson(path)).toJson(QJsonDocument::Compact)));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(opened);
    QVERIFY(opened->captures->findings == m_state.captures->findings);
}

void TestProjectFile::projectOfAnOlderVersion_opensMarked()
{
    const QString path = m_folder.filePath("older.dyncal");
    QVERIFY(saveProject(path, m_state, projectFileHash(path)));
    QJsonObject json = readJson(path);
    json.remove("sha256");
    json.remove("sha256_of");
    QVERIFY(writeBytes(path, QJsonDocument(json).toJson()));
    const Result<ProjectState> opened = openProject(path);
    QVERIFY(opened);
    QVERIFY(opened->recipe == m_state.recipe);
    QCOMPARE(opened->captures->findings.front().id, std::string("PRJ-002"));
    QCOMPARE(opened->captures->findings.front().severity, Severity::Info);
    json["sha256_of"] = QJsonObject(); // one of the two alone is no older version
    QCOMPARE(checkProject(json, "x")[0].id, std::string("PRJ-001"));
}

void TestProjectFile::everyFlippedBit_isSeenOrSaysTheSame()
{
    const QString path = m_folder.filePath("flipped.dyncal");
    const QByteArray bytes = smallProject();
    const auto contentOf = [](QJsonObject project) {
        project.remove("sha256");
        project.remove("sha256_of");
        return project;
    };
    const QJsonObject content = contentOf(QJsonDocument::fromJson(bytes).object());
    const auto bits = static_cast<int>(8 * bytes.size());
    int refused = 0;
    int cautioned = 0;
    int same = 0;
    const int count = std::min(trials::count(5000, bits), bits);
    std::mt19937 random(12);
    for (int trial = 0; trial < count; ++trial) {
        const int bit
            = count == bits ? trial : static_cast<int>(random() % static_cast<unsigned int>(bits));
        QByteArray flipped = bytes;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
        QVERIFY(writeBytes(path, flipped));
        const Result<ProjectFile> file = readProjectFile(path);
        if (!file || !recipeOfProject(file->content))
            ++refused;
        else if (worstSeverity(checkProject(file->content, "x")) == Severity::Caution)
            ++cautioned;
        else if (contentOf(file->content) == content)
            ++same;
        else
            QFAIL(qPrintable(QString("bit %1 of byte %2").arg(bit % 8).arg(bit / 8)));
    }
    qInfo("%d of %d bits: %d refused, %d cautions, %d say the same", count, bits, refused,
        cautioned, same);
    QVERIFY(refused > 0 && cautioned > 0);
}

void TestProjectFile::otherFileInItsPlace_isNotReplaced()
{
    const QString path = m_folder.filePath("own-or-not.dyncal");
    const Result<std::string> mine = saveProject(path, m_state, std::nullopt);
    QVERIFY(mine);
    QCOMPARE(*projectFileHash(path), *mine);
    QCOMPARE(readProjectFile(path)->sha256, *mine);
    QCOMPARE(
        saveProject(path, m_state, std::nullopt).error().findingId, std::string(kChangedMeanwhile));
    QVERIFY(writeBytes(path, "of another program"));
    QCOMPARE(saveProject(path, m_state, *mine).error().findingId, std::string(kChangedMeanwhile));
    QVERIFY(QFile::remove(path));
    QCOMPARE(saveProject(path, m_state, *mine).error().findingId, std::string(kChangedMeanwhile));
    QVERIFY(!QFile::exists(path));
}

DYNCAL_TEST(TestProjectFile)
#include "tst_project_file.moc"
