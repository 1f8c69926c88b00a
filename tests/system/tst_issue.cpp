// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/issued_job.h"

#include <QtTest>

#include <csignal>
#include <random>

/// Certificates issued, amended, withdrawn and verified by the built program.
class TestIssue : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;
    QString recording() const { return m_recordings.filePath("shot.h5"); }

    static QJsonObject firstOf(const Answer &verified)
    {
        return QJsonDocument::fromJson(verified.out).array().first().toObject();
    }

    /// What `dyncal run` finds of the job's recording by its recipe.
    static QJsonArray runFindings(const IssuedJob &job)
    {
        const QJsonObject recipe = fileJson(job.path("job.dyncal"))["recipe"].toObject();
        writeBytes(job.path("recipe.json"), QJsonDocument(recipe).toJson());
        runDyncal({"run", job.path("shot.h5"), "--recipe", job.path("recipe.json"), "-o",
            job.path("run")});
        return fileJson(job.path("run/results.json"))["findings"].toArray();
    }

private slots:
    void initTestCase()
    {
        QVERIFY(simulateShortCapture(recording(), 7));
        QVERIFY(simulateShortCapture(m_recordings.filePath("other.h5"), 8));
    }

    void issued_isFrozenNumberedAndVerified();
    void everyObstacle_isNamed_data();
    void everyObstacle_isNamed();
    void cautionWithReason_isInTheTrail();
    void issuedAgain_isTheSame();
    void copies_makeTheSameBytes();
    void nothingOfTheMachine_leaksOut();
    void changed_needsAnAmendment();
    void withdrawn_isRemarked();
    void damage_isFound_data();
    void damage_isFound();
    void singleFiles_areKnown();
    void killedAtAnyMoment_goesOn();
    void placesThatCannotBeWritten_keepTheNumber();
    void fullDisk_atEveryWrite_keepsTheNumber();
    void recheck_takesIssuedFolders();
    void assessorsWalk_holds();
    void cards_fillTheCertificate();
    void wrongUsage_isSaid();
};

void TestIssue::issued_isFrozenNumberedAndVerified()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    const Answer answer = job.issue();
    QVERIFY2(answer.exitCode == 0, answer.err + answer.out);
    QCOMPARE(answer.json()["number"].toInt(), 1);
    QCOMPARE(answer.json()["state"].toString(), "issued");
    const QString folder = job.output() + "/1";
    for (const char *name : {"project.dyncal", "recipe.json", "results.json", "certificate.pdf",
             "audit.jsonl", "manifest.json"})
        QVERIFY2(QFile::exists(folder + '/' + name), name);
    const QJsonObject fields
        = fileJson(folder + "/recipe.json")["certificate"].toObject()["fields"].toObject();
    QCOMPARE(fields["certificate_number"].toString(), "1");
    QCOMPARE(fields["date_issued"].toString(), "2026-01-01");
    const Answer verified = job.verify({folder, job.registry()});
    QVERIFY2(verified.exitCode == 1, verified.out);
    const QJsonArray rows = QJsonDocument::fromJson(verified.out).array();
    QCOMPARE(rows[0].toObject()["status"].toString(), "unsigned");
    QCOMPARE(rows[0].toObject()["state"].toString(), "issued");
    QCOMPARE(rows[0].toObject()["chain"].toObject()["head"], answer.json()["head"]);
    QCOMPARE(rows[1].toObject()["kind"].toString(), "registry");
    QCOMPARE(rows[1].toObject()["status"].toString(), "valid");
    QProcess text;
    text.start("pdftotext", {"-layout", folder + "/certificate.pdf", "-"});
    QVERIFY(text.waitForFinished());
    const QString pages = QString::fromUtf8(text.readAllStandardOutput());
    QVERIFY(pages.contains("No. 1"));
    QVERIFY(pages.contains("issued, not signed"));
    QVERIFY(!pages.contains("DRAFT") && !pages.contains("Draft"));
    QVERIFY(pages.contains(answer.json()["head"].toString().left(32)));
    QVERIFY(!pages.contains("to be filled in"));
}

void TestIssue::everyObstacle_isNamed_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QJsonObject>("recipe");
    const auto with = [](const QString &name, const QString &value) {
        QJsonObject recipe = completeRecipe();
        QJsonObject fields = completeFields();
        if (value.isNull())
            fields.remove(name);
        else
            fields[name] = value;
        recipe["certificate"] = QJsonObject{{"fields", fields}};
        return recipe;
    };
    const auto withReference = [](int place, const QString &key, const QJsonValue &value) {
        QJsonObject recipe = completeRecipe();
        QJsonArray budget = recipe["uncertainty"].toObject()["budget"].toArray();
        QJsonObject entry = budget[place].toObject();
        entry[key] = value;
        budget[place] = entry;
        recipe["uncertainty"] = QJsonObject{{"budget", budget}, {"monte_carlo_trials", 1000}};
        return recipe;
    };
    QTest::newRow("empty field") << "CER-001" << with("customer_address", {});
    QTest::newRow("no date") << "CER-001" << with("date_received", "31/12");
    QTest::newRow("expired") << "CER-003" << withReference(0, "due", "2026-01-06");
    QTest::newRow("no certificate") << "CER-009" << withReference(1, "certificate", QJsonValue());
    QJsonObject lacking = withReference(0, "certificate", "R-1");
    lacking["shock"] = QJsonObject{{"step_pa", 172530.0}};
    QTest::newRow("no U") << "CER-008" << lacking;
    QJsonObject open = completeRecipe();
    open["checks"] = QJsonObject{{"min_codes", 100000}};
    QTest::newRow("caution") << "CER-002" << open;
    QJsonObject blocked = completeRecipe();
    blocked["shock"] = QJsonObject{{"t1_k", 21.0}};
    QTest::newRow("block") << "SHK-004" << blocked;
    QJsonObject second = completeRecipe();
    second["profile"] = QJsonObject{{"name", "lab"}, {"version", "3"}, {"sha256", QString(64, '0')},
        {"sections", QJsonObject{{"issue", QJsonObject{{"second_name", true}}}}}};
    QTest::newRow("second name") << "CER-005" << second;
}

void TestIssue::everyObstacle_isNamed()
{
    QFETCH(QString, id);
    QFETCH(QJsonObject, recipe);
    const IssuedJob job;
    QVERIFY(job.begin(recording(), recipe));
    const Answer answer = job.issue();
    QCOMPARE(answer.exitCode, 2);
    QStringList ids;
    for (const QJsonValue &finding : answer.json()["findings"].toArray())
        ids << finding["id"].toString();
    QVERIFY2(ids.contains(id), answer.out + answer.err);
    QVERIFY2(answer.err.contains(id.toUtf8()), answer.err);
    QVERIFY(!QFile::exists(job.output()));
    QVERIFY(!QFile::exists(job.registry()));
    if (id == "CER-005") {
        QCOMPARE(job.issue({"--reviewed-by", "A. Berg"}).exitCode, 2);
        QCOMPARE(job.issue({"--reviewed-by", "B. Ek"}).exitCode, 0);
    }
}

void TestIssue::cautionWithReason_isInTheTrail()
{
    const IssuedJob job;
    QJsonObject recipe = completeRecipe();
    recipe["checks"] = QJsonObject{{"min_codes", 100000}};
    QVERIFY(job.begin(recording(), recipe));
    const Answer refused = job.issue();
    QJsonArray accepted;
    for (const QJsonValue &finding : runFindings(job))
        if (finding["severity"].toString() == "caution")
            accepted << QJsonObject{
                {"finding", finding["id"]}, {"reason", "looked at by " + finding["id"].toString()}};
    recipe["acknowledge"] = accepted;
    QVERIFY(job.writeProject(recipe));
    const Answer issued = job.issue({"--reviewed-by", "B. Ek"});
    QVERIFY2(issued.exitCode == 0, issued.err);
    QCOMPARE(refused.exitCode, 2);
    QCOMPARE(accepted.size(), 1);
    const QByteArray trail = bytesOf(job.output() + "/1/audit.jsonl");
    for (const QJsonValue &one : accepted)
        QVERIFY(trail.contains("looked at by " + one["finding"].toString().toUtf8()));
    QVERIFY(trail.contains("reviewed") && trail.contains("B. Ek"));
}

void TestIssue::issuedAgain_isTheSame()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    const Answer first = job.issue();
    const auto before = bytesBelow(job.folder.path());
    const Answer again = job.issue({}, {"SOURCE_DATE_EPOCH=1768000000"});
    QCOMPARE(again.exitCode, 0);
    QCOMPARE(again.out, first.out);
    QVERIFY(bytesBelow(job.folder.path()) == before);
    QVERIFY(QDir(job.output() + "/1").removeRecursively());
    const Answer gone = job.issue();
    QCOMPARE(gone.exitCode, 4);
    QVERIFY2(gone.err.contains("was issued as certificate 1"), gone.err);
}

/// From copies of project and registry taken before, with the same clock: the same bytes.
void TestIssue::copies_makeTheSameBytes()
{
    const IssuedJob one;
    QVERIFY(one.begin(m_recordings.filePath("other.h5")));
    QCOMPARE(one.issue().exitCode, 0);
    const IssuedJob copy;
    QVERIFY(QFile::copy(one.registry(), copy.registry()));
    QVERIFY(one.path("job.dyncal") != copy.path("job.dyncal"));
    QVERIFY(QFile::remove(one.path("shot.h5")) && one.begin(recording()));
    QVERIFY(copy.begin(recording()));
    QCOMPARE(one.issue().exitCode, 0);
    QCOMPARE(copy.issue().exitCode, 0);
    QVERIFY(bytesBelow(one.output() + "/2") == bytesBelow(copy.output() + "/2"));
    QCOMPARE(bytesOf(one.registry()), bytesOf(copy.registry()));
}

/// Neither names of folders, nor the account, nor the machine.
void TestIssue::nothingOfTheMachine_leaksOut()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    QCOMPARE(job.issue({}, {"SOURCE_DATE_EPOCH=1767225600", "USER=leakyuser", "LOGNAME=leakyuser"})
                 .exitCode,
        0);
    QProcess plain;
    plain.start("qpdf",
        {"--qdf", "--object-streams=disable", job.output() + "/1/certificate.pdf",
            job.path("plain.pdf")});
    QVERIFY(plain.waitForFinished());
    QByteArray all = bytesOf(job.path("plain.pdf"));
    for (const QByteArray &bytes : bytesBelow(job.output()))
        all += bytes;
    QProcess text;
    text.start("pdftotext", {job.output() + "/1/certificate.pdf", "-"});
    QVERIFY(text.waitForFinished());
    all += text.readAllStandardOutput();
    const QString folder = QFileInfo(job.folder.path()).fileName();
    constexpr int kTellable = 4; // shorter names stand in any bytes
    for (const QString &word : {folder, QString("leakyuser"), QSysInfo::machineHostName(),
             QString("/tmp"), QString("/home"), QString("/root"), QString("/work")})
        QVERIFY2(word.size() < kTellable || !all.contains(word.toUtf8()), qPrintable(word));
}

void TestIssue::changed_needsAnAmendment()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    QCOMPARE(job.issue().exitCode, 0);
    const auto before = bytesBelow(job.output());
    QJsonObject recipe = completeRecipe();
    QJsonObject fields = completeFields();
    fields["sensor_serial"] = "18";
    recipe["certificate"] = QJsonObject{{"fields", fields}};
    QVERIFY(job.writeProject(recipe));
    const Answer refused = job.issue();
    QCOMPARE(refused.exitCode, 4);
    QVERIFY2(refused.err.startsWith("CER-006: "), refused.err);
    QVERIFY(bytesBelow(job.output()) == before);
    const Answer amended = job.issue({"--amends", "1", "--reason", "serial number corrected"});
    QVERIFY2(amended.exitCode == 0, amended.err);
    QCOMPARE(amended.json()["state"].toString(), "amended");
    const QJsonArray numbers = job.numbers();
    QCOMPARE(numbers[0].toObject()["state"].toString(), "replaced");
    QCOMPARE(numbers[1].toObject()["amends"].toInt(), 1);
    QProcess text;
    text.start("pdftotext", {"-layout", job.output() + "/2/certificate.pdf", "-"});
    QVERIFY(text.waitForFinished());
    const QString pages = QString::fromUtf8(text.readAllStandardOutput()).simplified();
    QVERIFY2(pages.contains("certificate 1, which is no longer valid"), qPrintable(pages));
    QVERIFY(pages.contains("serial number corrected"));
    const QJsonObject old = firstOf(job.verify({job.output() + "/1"}));
    QCOMPARE(old["status"].toString(), "unsigned");
    QCOMPARE(old["state"].toString(), "replaced");
    const auto after = bytesBelow(job.output());
    for (auto file = before.begin(); file != before.end(); ++file)
        QCOMPARE(after[file.key()], file.value());
}

void TestIssue::withdrawn_isRemarked()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    QCOMPARE(job.issue().exitCode, 0);
    const QStringList withdraw{"withdraw", "1", "--registry", job.registry()};
    QCOMPARE(runDyncal(withdraw).exitCode, 4); // no reason
    QCOMPARE(runDyncal(withdraw + QStringList{"--reason", "reference damaged"}).exitCode, 0);
    QCOMPARE(runDyncal(withdraw + QStringList{"--reason", "again"}).exitCode, 4);
    const QJsonObject row = firstOf(job.verify({job.output()}));
    QCOMPARE(row["state"].toString(), "withdrawn");
    QVERIFY(QJsonDocument(row).toJson().contains("reference damaged"));
    QCOMPARE(job.issue().exitCode, 4);
}

void TestIssue::damage_isFound_data()
{
    QTest::addColumn<QString>("file");
    for (const char *file : {"certificates/1/project.dyncal", "certificates/1/recipe.json",
             "certificates/1/results.json", "certificates/1/certificate.pdf",
             "certificates/1/audit.jsonl", "certificates/1/manifest.json",
             "certificates/1/written.json", "shot.h5", "copy.dyncal"})
        QTest::newRow(file) << QString(file);
}

/// Bytes flipped at random: each is reported by the program, with exit code 2 or 3.
void TestIssue::damage_isFound()
{
    QFETCH(QString, file);
    static const IssuedJob job;
    if (!QFile::exists(job.path("copy.dyncal"))) {
        QVERIFY(job.begin(recording()));
        QCOMPARE(job.issue().exitCode, 0);
        QVERIFY(QFile::copy(job.output() + "/1/project.dyncal", job.path("copy.dyncal")));
    }
    const QByteArray whole = bytesOf(job.path(file));
    const auto mended = qScopeGuard([&] { writeBytes(job.path(file), whole); });
    std::mt19937_64 random(static_cast<std::uint64_t>(whole.size()));
    for (int i = 0; i < dyncal::trials::count(3, 110); ++i) {
        QByteArray bytes = whole;
        const auto at = static_cast<qsizetype>(random() % static_cast<std::uint64_t>(bytes.size()));
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << (random() % 8)));
        QVERIFY(writeBytes(job.path(file), bytes));
        const Answer answer = runDyncal({"verify", job.output(), job.path("copy.dyncal"),
            "--registry", job.registry(), "--recordings", job.folder.path()});
        if (file == "copy.dyncal" && answer.exitCode == 1) // white space
            QCOMPARE(QJsonDocument::fromJson(bytes), QJsonDocument::fromJson(whole));
        else
            QVERIFY2(answer.exitCode == 2 || answer.exitCode == 3,
                qPrintable(QString("byte %1: %2").arg(at).arg(QString(answer.out))));
    }
}

void TestIssue::singleFiles_areKnown()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    QCOMPARE(job.issue().exitCode, 0);
    const QString pdf = job.output() + "/1/certificate.pdf";
    QCOMPARE(firstOf(job.verify({pdf}))["number"].toInt(), 1);
    const Answer alone = runDyncal({"verify", pdf, "--json"}); // by itself nothing is known of it
    QCOMPARE(alone.exitCode, 1);
    QCOMPARE(firstOf(alone)["status"].toString(), "unsigned");
    QVERIFY(writeBytes(job.path("copy.pdf"), bytesOf(pdf) + "x"));
    const Answer changed = job.verify({job.path("copy.pdf")});
    QCOMPARE(changed.exitCode, 2);
    QCOMPARE(job.verify({job.path("shot.h5")}).exitCode, 0);
    QCOMPARE(job.verify({job.path("none.pdf")}).exitCode, 3);
    QCOMPARE(job.verify({job.folder.filePath("none")}).exitCode, 3);
}

/// Killed at any moment, then started again: one number, its folder, nothing else.
void TestIssue::killedAtAnyMoment_goesOn()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    QElapsedTimer whole;
    whole.start();
    {
        const IssuedJob other;
        QVERIFY(other.begin(recording()));
        QCOMPARE(other.issue().exitCode, 0);
    }
    const auto longest = static_cast<std::uint64_t>(whole.elapsed()) * 1000 + 1;
    std::mt19937_64 random(20261126);
    for (int i = 0; i < dyncal::trials::count(4, 60); ++i) {
        QProcess process;
        process.start(qEnvironmentVariable("DYNCAL_BINARY"),
            {"issue", job.path("job.dyncal"), "-o", job.output(), "--registry", job.registry(),
                "--unsigned"});
        QVERIFY(process.waitForStarted());
        QThread::usleep(static_cast<unsigned long>(random() % longest));
        process.kill();
        process.waitForFinished();
    }
    QVERIFY(job.issue().exitCode == 0);
    QCOMPARE(job.numbers().size(), 1);
    QCOMPARE(job.numbers()[0].toObject()["state"].toString(), "issued");
    QCOMPARE(QDir(job.output()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
        QStringList{"1"});
    QCOMPARE(job.verify({job.output(), job.registry()}).exitCode, 1);
}

void TestIssue::placesThatCannotBeWritten_keepTheNumber()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    QVERIFY(writeBytes(job.output(), "a file is here"));
    const Answer refused = job.issue();
    QVERIFY(refused.exitCode == 4 || refused.exitCode == 5);
    QCOMPARE(refused.complaints().size(), 1);
    QCOMPARE(job.numbers()[0].toObject()["state"].toString(), "reserved");
    QVERIFY(QFile::remove(job.output()));
    QCOMPARE(job.issue().json()["number"].toInt(), 1);
    QCOMPARE(job.numbers().size(), 1);
}

/// The disk is full from the k-th write on (system/full_disk), for k up to the one that no longer
/// fails: one sentence each time, the registry stays whole, and then all is as if nothing had been.
void TestIssue::fullDisk_atEveryWrite_keepsTheNumber()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    const int step = dyncal::trials::count(9, 1);
    int failed = 0;
    for (int from = 0;; from += step) {
        const Answer answer = job.issue({},
            {"SOURCE_DATE_EPOCH=1767225600", "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0",
                "LD_PRELOAD=" + qEnvironmentVariable("DYNCAL_FULL_DISK"),
                "DYNCAL_FULL_FROM=" + QString::number(from)});
        if (answer.exitCode == 0)
            break;
        ++failed;
        const QByteArray about = QByteArray::number(from) + ": " + answer.err;
        QVERIFY2(answer.exitCode == 4 || answer.exitCode == 5, about);
        QVERIFY2(answer.complaints().size() == 1, about);
        if (QFile::exists(job.registry()) && QFileInfo(job.registry()).size() > 0)
            QVERIFY2(runDyncal({"verify", job.registry()}).exitCode == 0 || job.numbers().isEmpty(),
                about);
    }
    QVERIFY2(failed > 0, "no write was refused");
    QCOMPARE(job.issue().json()["number"].toInt(), 1);
    QCOMPARE(job.numbers().size(), 1);
    QCOMPARE(QDir(job.output()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
        QStringList{"1"});
    QCOMPARE(job.verify({job.output(), job.registry()}).exitCode, 1);
}

void TestIssue::recheck_takesIssuedFolders()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    QCOMPARE(job.issue().exitCode, 0);
    const Answer answer
        = runDyncal({"recheck", job.output(), "--recordings", job.folder.path(), "--json"});
    QVERIFY2(answer.exitCode == 0, answer.err + answer.out);
    for (const QJsonValue row : QJsonDocument::fromJson(answer.out).array())
        QVERIFY2(!row["amendment_needed"].toBool(), answer.out);
}

/// docs/registry.md: from the page to the recording, by a script that others can run; and it ends
/// where something was changed.
void TestIssue::assessorsWalk_holds()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    QCOMPARE(job.issue().exitCode, 0);
    const auto walk = [&] {
        QProcess script;
        script.setProcessChannelMode(QProcess::MergedChannels);
        script.start("sh",
            {qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/audit/walk.sh",
                qEnvironmentVariable("DYNCAL_BINARY"), job.output() + "/1", job.registry(),
                job.folder.path()});
        script.waitForFinished(240000);
        return std::pair(script.exitCode(), script.readAll());
    };
    const auto whole = walk();
    QVERIFY2(whole.first == 0, whole.second);
    QVERIFY2(whole.second.contains("compared with results.json, 0 differ"), whole.second);
    QVERIFY(QFile::remove(job.path("shot.h5")));
    QVERIFY(QFile::copy(m_recordings.filePath("other.h5"), job.path("shot.h5")));
    const auto broken = walk();
    QVERIFY2(broken.first == 1 && broken.second.contains("The walk ends here"), broken.second);
}

void TestIssue::cards_fillTheCertificate()
{
    const IssuedJob job;
    QJsonObject recipe = completeRecipe();
    QJsonObject fields = completeFields();
    fields.remove("customer_address");
    recipe["certificate"] = QJsonObject{{"fields", fields}};
    QVERIFY(job.begin(recording(), recipe));
    QVERIFY(
        writeBytes(job.path("cards.csv"), "name,customer_address\nCustomer Ltd,9 Card Street\n"));
    const auto registry = [&](const QStringList &arguments) {
        return runDyncal(
            QStringList{"registry"} + arguments + QStringList{"--registry", job.registry()});
    };
    QCOMPARE(job.issue().exitCode, 2); // the address is missing
    const Answer taken
        = registry({"import", "customer", job.path("cards.csv"), "--reason", "old list"});
    QVERIFY2(taken.exitCode == 0, taken.err);
    QCOMPARE(registry({"cards", "customer"}).out, bytesOf(job.path("cards.csv")));
    QCOMPARE(registry({"cards", "sensor"}).out, "name\n");
    QCOMPARE(registry({"import", "sensor", job.path("none.csv"), "--reason", "x"}).exitCode, 3);
    const Answer issued = job.issue();
    QVERIFY2(issued.exitCode == 0, issued.err);
    QVERIFY(bytesOf(job.output() + "/1/recipe.json").contains("9 Card Street"));
    QCOMPARE(job.verify({job.registry()}).exitCode, 0);
}

void TestIssue::wrongUsage_isSaid()
{
    const IssuedJob job;
    QVERIFY(job.begin(recording()));
    for (const QStringList &more : {QStringList{"--amends", "1"}, QStringList{"--reason", "x"},
             QStringList{"--amends", "0", "--reason", "x"}, QStringList{"--languages", "xx"},
             QStringList{"--registry", "mysql://host/db"}}) {
        const Answer answer = runDyncal(
            QStringList{"issue", job.path("job.dyncal"), "-o", job.output(), "--unsigned"} + more,
            {"XDG_DATA_HOME=" + job.path("data")});
        QVERIFY2(answer.exitCode == 4, answer.err);
        QCOMPARE(answer.complaints().size(), 1);
    }
    QCOMPARE(job.issue({"--amends", "7", "--reason", "x"}).exitCode, 4);
    QVERIFY(!QFile::exists(job.output()));
    QCOMPARE(runDyncal({"registry", "list", "--registry", job.path("none")}).exitCode, 3);
    // What must be there is never made.
    for (const QStringList &change : {QStringList{"withdraw", "1"}, {"registry", "void", "1"}})
        QCOMPARE(runDyncal(change + QStringList{"--reason", "x", "--registry", job.path("none")})
                     .exitCode,
            3);
    QVERIFY(!QFile::exists(job.path("none")));
    QCOMPARE(
        runDyncal({"issue", job.path("shot.h5"), "-o", job.output(), "--unsigned"}).exitCode, 3);
}

DYNCAL_TEST(TestIssue)
#include "tst_issue.moc"
