// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// S30: from the form with an empty field to a signed certificate, its verification and its
// amendment. What is done with mouse and keys is done in the window; the signature is made by the
// program as it is built, and read by programs of others.

#include "tests/support/test_program.h"
#include "tests/system/dcc_judges.h"
#include "tests/system/signed_job.h"
#include "tests/ui/scenarios/scenario_bench.h"
#include "tests/ui/scenarios/scenario_words.h"
#include "ui/shell/registry/issue_dialog.h"

#include <QListWidget>
#include <QRegularExpression>
#include <QToolButton>

using namespace dyncal;
using namespace dyncal::test;
using dyncal::testing::answerOf;
using dyncal::testing::MadeKeys;

namespace {

/// The complete recipe, but: no customer's address, a reference that ended on the day before, two
/// cautions (few codes of the converter; an order with states of noise), a second person demanded,
/// and a statement of conformity.
QJsonObject recipeWithFaults()
{
    QJsonObject recipe = completeRecipe();
    QJsonObject fields = completeFields();
    fields.remove("customer_address");
    recipe["certificate"] = QJsonObject{{"fields", fields},
        {"decision",
            QJsonObject{
                {"rule", "simple"}, {"within_percent", 5}, {"from_hz", 1000}, {"to_hz", 60000}}}};
    QJsonObject uncertainty = recipe["uncertainty"].toObject();
    QJsonArray budget = uncertainty["budget"].toArray();
    QJsonObject pressure = budget[0].toObject();
    pressure["due"] = "2026-01-06";
    budget[0] = pressure;
    uncertainty["budget"] = budget;
    recipe["uncertainty"] = uncertainty;
    recipe["checks"] = QJsonObject{{"min_codes", 100000}};
    recipe["realization"] = QJsonObject{{"order", 4}};
    recipe["profile"] = QJsonObject{{"name", "lab"}, {"version", "3"}, {"sha256", QString(64, 'a')},
        {"sections", QJsonObject{{"issue", QJsonObject{{"second_name", true}}}}}};
    return recipe;
}

/// The window with a laboratory's folder, and what issues in it.
struct Bench : ScenarioBench
{
    IssuedJob job;
    QPointer<IssueDialog> issuing;

    Bench()
    {
        preferences.setIssuing(Preferences::Issuing::Registry, job.registry());
        preferences.setIssuing(Preferences::Issuing::Folder, job.output());
    }
    void openJob() const
    {
        window->files().openProjectFile(job.path("job.dyncal"));
        settle();
    }
    void showIssuing()
    {
        find<QAction>("issueAction")->trigger();
        issuing = find<IssueDialog>("issueDialog");
        issuing->setProgram(qEnvironmentVariable("DYNCAL_BINARY"));
        issuing->lookUp();
        QTRY_VERIFY_WITH_TIMEOUT(!issuing->isBusy(), kPatience_ms);
    }
    /// The ids of what keeps it from being issued.
    QStringList obstacles() const
    {
        static const QRegularExpression id("^■.*?(CER-\\d+)"); // a caution is no obstacle
        QStringList ids;
        const auto *list = find<QListWidget>("issueObstacles");
        for (int row = 0; row < list->count(); ++row)
            if (const auto match = id.match(list->item(row)->text()); match.hasMatch())
                ids << match.captured(1);
        return ids;
    }
    void review(const QString &name) const
    {
        auto *field = find<QLineEdit>("issueReviewedBy");
        field->clear();
        QTest::keyClicks(field, name);
    }
    /// Clicks on the link of the line "What next" with these words; false where there is none.
    bool follow(const QString &words) const
    {
        for (auto *link : window->findChildren<QToolButton *>())
            if (link->objectName().startsWith("nextStep") && link->isVisible()
                && link->text().contains(words)) {
                QTest::mouseClick(link, Qt::LeftButton);
                return true;
            }
        return false;
    }
    void accept(const QString &id, const QString &reason)
    {
        prompts.setNextSentence(reason);
        clickOffer("reason", id);
    }
    bool save() const
    {
        const bool isWritten = window->files().save();
        settle();
        return isWritten && !window->files().isModified();
    }
};

QString textOfPdf(const QString &path)
{
    return QString::fromUtf8(answerOf("pdftotext", {"-layout", path, "-"}).out);
}

} // namespace

class TestSignedCertificate : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;
    MadeKeys m_keys;
    Bench *m_bench = nullptr;
    QString folder(int number = 1) const
    {
        return m_bench->job.output() + '/' + QString::number(number);
    }
    QString trust() const { return m_keys.path("root.pem"); }
    QStringList byKey() const
    {
        return {"--key", m_keys.path("lab.all.pem"), "--reviewed-by", "B. Ek"};
    }

private slots:
    void initTestCase();
    void cleanupTestCase() { delete m_bench; }
    void s30a_whatIsMissing_isNamedAndLedTo();
    void s30b_cautions_needReasons();
    void s30c_ownWork_isNotReviewed();
    void s30d_signed_saysEverything();
    void s30e_dcc_saysTheSame();
    void s30f_verified_andOneByteChanged();
    void s30g_issuedAgain_isTheSame();
    void s30h_laterEdit_isAnAmendment();
};

void TestSignedCertificate::initTestCase()
{
    QVERIFY(simulateShortCapture(m_recordings.filePath("shot.h5"), 7));
    QVERIFY(m_keys.make("lab", "Example Laboratory"));
    m_bench = new Bench;
    QVERIFY(m_bench->job.begin(m_recordings.filePath("shot.h5"), recipeWithFaults()));
    m_bench->openJob();
    QVERIFY(m_bench->session().state().hasShots());
    m_bench->showIssuing();
    QCOMPARE(m_bench->obstacles(), QStringList({"CER-001", "CER-003", "CER-002", "CER-005"}));
    QVERIFY(!m_bench->find<QPushButton>("issueNow")->isEnabled());
    // Neither address has a country, which the DCC wants.
    const auto *list = m_bench->find<QListWidget>("issueObstacles");
    QCOMPARE(list->findItems("▲ Caution CER-010", Qt::MatchStartsWith).size(), 2);
}

/// CER-001 names the field, the line "What next" leads to it; CER-003 the reference and its day.
void TestSignedCertificate::s30a_whatIsMissing_isNamedAndLedTo()
{
    const auto *list = m_bench->find<QListWidget>("issueObstacles");
    DYNCAL_SAYS(list->item(0)->text(), "Address of the customer");
    DYNCAL_SAYS(list->item(1)->text(), "2026-01-06");
    m_bench->issuing->close();
    m_bench->show(Page::Captures);
    QVERIFY(m_bench->follow("Address of the customer"));
    auto *field = m_bench->find<QLineEdit>("field_customer_address");
    QVERIFY(field->isVisible() && m_bench->window->focusWidget() == field);
    QTest::keyClicks(field, "2 Test Street");
    QTest::keyClick(field, Qt::Key_Return);
    m_bench->settle();
    m_bench->showIssuing();
    QCOMPARE(m_bench->obstacles(), QStringList({"CER-003", "CER-002", "CER-005"}));
    // The budget is the laboratory's, of the recipe: the window shows it, and edits it nowhere.
    Recipe next = m_bench->recipe();
    next.uncertainty.budget.front().due = "2027-01-31";
    m_bench->session().apply(next, "due");
    m_bench->settle();
    QCOMPARE(m_bench->obstacles(), QStringList({"CER-002", "CER-005"}));
}

void TestSignedCertificate::s30b_cautions_needReasons()
{
    m_bench->issuing->close();
    m_bench->accept("CAP-014", "the small range was not free");
    m_bench->showIssuing();
    QCOMPARE(m_bench->obstacles(), QStringList({"CER-002", "CER-005"})); // one is left
    m_bench->issuing->close();
    m_bench->accept("ORD-003", "the customer asks for this order");
    m_bench->showIssuing();
    QCOMPARE(m_bench->obstacles(), QStringList("CER-005"));
}

void TestSignedCertificate::s30c_ownWork_isNotReviewed()
{
    m_bench->review("A. Berg"); // who calibrated, and issues
    QCOMPARE(m_bench->obstacles(), QStringList("CER-005"));
    m_bench->review("B. Ek");
    QCOMPARE(m_bench->obstacles(), QStringList());
    QVERIFY(m_bench->find<QPushButton>("issueNow")->isEnabled());
    m_bench->issuing->close();
    m_bench->prompts.setNextFile(m_bench->job.path("draft.pdf"));
    m_bench->show(Page::Certificate);
    m_bench->find<QAbstractButton>("exportCertificate")->click();
    QTRY_VERIFY_WITH_TIMEOUT(
        !m_bench->window->files().isBusy() && QFile::exists(m_bench->job.path("draft.pdf")),
        kPatience_ms);
    QVERIFY(textOfPdf(m_bench->job.path("draft.pdf")).contains("Draft, not valid"));
    QVERIFY(m_bench->save());
    QVERIFY(!QFile::exists(m_bench->job.registry())); // nothing is written before
}

void TestSignedCertificate::s30d_signed_saysEverything()
{
    QCOMPARE(m_bench->job.issue({"--key", m_keys.path("lab.all.pem"), "--reviewed-by", "A. Berg"})
                 .exitCode,
        2);
    const auto issued = m_bench->job.issue(byKey());
    QVERIFY2(issued.exitCode == 0, issued.err);
    QVERIFY(issued.json()["signed"].toBool());
    const QString pdf = folder() + "/certificate.pdf";
    const QByteArray judged = answerOf("pdfsig", {pdf}).out;
    QVERIFY2(
        judged.contains("Signature is Valid") && judged.contains("Total document signed"), judged);
    const QString pages = textOfPdf(pdf);
    QVERIFY(!pages.contains("DRAFT") && !pages.contains("Draft"));
    QVERIFY(!pages.contains("to be filled in"));
    const int count = QRegularExpression("Pages: +(\\d+)")
                          .match(QString::fromUtf8(answerOf("pdfinfo", {pdf}).out))
                          .captured(1)
                          .toInt();
    QVERIFY(count > 1);
    for (int page = 1; page <= count; ++page)
        DYNCAL_SAYS(pages, QString("page %1 of %2").arg(page).arg(count));
    DYNCAL_SAYS(pages, "No. 1");
    // Value, U with two significant digits, k.
    static const QRegularExpression row(
        "natural frequency +[0-9.]+ kHz +([0-9.]+) k?Hz +2(\\s|\\.)");
    const auto f0 = row.match(pages);
    QVERIFY2(f0.hasMatch(), qPrintable(pages.left(6000)));
    static const QRegularExpression leading("^[0.]*|\\.");
    QCOMPARE(f0.captured(1).remove(leading).size(), 2);
    const QString words = pages.simplified();
    for (const char *said : {"simple acceptance", "CAP-014", "the small range was", "ORD-003",
             "the customer asks for", "B. Ek"}) // in columns: the reasons go on below
        DYNCAL_SAYS(words, said);
    const QByteArray attached = answerOf("pdfdetach", {"-list", pdf}).out;
    for (const char *name : {"dcc.xml", "results.json", "recipe.json"})
        QVERIFY2(attached.contains(name), attached);
}

/// Every number of PDF and results.json to the printed digit, and valid.
void TestSignedCertificate::s30e_dcc_saysTheSame()
{
    QCOMPARE(faultsOf(folder()), QByteArray());
    QCOMPARE(missingNumbers(folder(), "en"), QByteArray());
}

void TestSignedCertificate::s30f_verified_andOneByteChanged()
{
    const QString pdf = folder() + "/certificate.pdf";
    const auto whole = runDyncal({"verify", pdf, "--trust", trust()});
    QVERIFY2(whole.exitCode == 0, whole.out);
    QVERIFY(whole.out.contains("valid, signed by Example Laboratory"));
    QByteArray bytes = bytesOf(pdf);
    bytes[bytes.size() / 3] = static_cast<char>(bytes[bytes.size() / 3] ^ 1);
    const QString changed = m_bench->job.path("changed.pdf");
    QVERIFY(writeBytes(changed, bytes));
    const auto flipped = runDyncal({"verify", changed, "--trust", trust()});
    QCOMPARE(flipped.exitCode, 2);
    QVERIFY2(flipped.out.contains("it was changed") && flipped.out.contains("Signed are the bytes"),
        flipped.out);
    QVERIFY(!answerOf("pdfsig", {changed}).out.contains("Signature is Valid"));
}

void TestSignedCertificate::s30g_issuedAgain_isTheSame()
{
    const auto before = bytesBelow(m_bench->job.output());
    const auto again = m_bench->job.issue(byKey(), {"SOURCE_DATE_EPOCH=1768000000"});
    QVERIFY2(again.exitCode == 0, again.err);
    QCOMPARE(again.json()["number"].toInt(), 1);
    QVERIFY(bytesBelow(m_bench->job.output()) == before);
}

void TestSignedCertificate::s30h_laterEdit_isAnAmendment()
{
    const auto first = bytesBelow(folder());
    m_bench->show(Page::Certificate);
    m_bench->type("field_sensor_serial", "18");
    QVERIFY(m_bench->save());
    const auto refused = m_bench->job.issue(byKey());
    QCOMPARE(refused.exitCode, 4);
    QVERIFY2(refused.err.startsWith("CER-006: "), refused.err);
    m_bench->showIssuing(); // the window offers what the command asks for
    QTRY_VERIFY(m_bench->find<QLabel>("issueState")->text().contains("certificate 1"));
    QVERIFY(m_bench->find<QLineEdit>("issueReason")->isVisible());
    QVERIFY(!m_bench->find<QPushButton>("issueNow")->isEnabled());
    const auto amended = m_bench->job.issue(
        byKey() + QStringList{"--amends", "1", "--reason", "serial number corrected"});
    QVERIFY2(amended.exitCode == 0, amended.err);
    QCOMPARE(amended.json()["number"].toInt(), 2);
    const QString pages = textOfPdf(folder(2) + "/certificate.pdf").simplified();
    DYNCAL_SAYS(pages, "No. 2");
    DYNCAL_SAYS(pages, "certificate 1, which is no longer valid");
    DYNCAL_SAYS(pages, "serial number corrected");
    QVERIFY(bytesBelow(folder()) == first);
    const QJsonArray rows
        = verifyRows({folder(1), folder(2)}, trust(), {"--registry", m_bench->job.registry()});
    for (const QJsonValue row : rows)
        QCOMPARE(row["status"].toString(), QString("valid"));
    QCOMPARE(rows[0].toObject()["state"].toString(), QString("replaced"));
    QCOMPARE(rows[1].toObject()["state"].toString(), QString("amended"));
}

DYNCAL_TEST(TestSignedCertificate)
#include "tst_signed_certificate.moc"
