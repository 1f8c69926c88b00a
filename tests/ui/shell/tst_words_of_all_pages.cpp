// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/session/example.h"
#include "ui/shell/main_window.h"
#include "ui/stages/frame/value_table.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr double kDuration_s = 0.006;
constexpr int kPatience_ms = 120'000;

/// All that a page and its surroundings say.
QStringList wordsOf(const QWidget &window)
{
    QStringList words;
    for (const auto *label : window.findChildren<QLabel *>())
        if (label->isVisible())
            words << label->text();
    for (const auto *button : window.findChildren<QAbstractButton *>())
        if (button->isVisible())
            words << button->text();
    for (const auto *edit : window.findChildren<QLineEdit *>())
        if (edit->isVisible())
            words << edit->text();
    for (const auto *list : window.findChildren<QListWidget *>())
        for (int i = 0; list->isVisible() && i < list->count(); ++i)
            words << list->item(i)->text();
    for (const auto *table : window.findChildren<ValueTable *>())
        for (int row = 0; row < table->rowCount(); ++row)
            for (int column = 0; column < table->columnCount(); ++column)
                if (const QTableWidgetItem *item = table->item(row, column))
                    words << item->text();
    words.removeDuplicates();
    return words;
}

/// "2,33 MHz" -> "MHz"; empty if it is no number with a unit.
QString unitOf(const QString &cell)
{
    static const QRegularExpression quantity(
        "^-?\\d+(?:,\\d+)? ([^\\d\\s,;]+)(?: ± .*| \\(u = .*)?$");
    return quantity.match(cell).captured(1);
}

/// Cells with different prefixes of one unit, in a row or column of a table.
bool mixesPrefixes(const QStringList &cells)
{
    QString first;
    for (const QString &cell : cells) {
        const QString unit = unitOf(cell);
        if (unit.isEmpty())
            continue;
        if (first.isEmpty())
            first = unit;
        const bool bothPrefixed = unit.size() > 1 && unit.mid(1) == first.mid(1);
        if (unit != first && (unit.mid(1) == first || first.mid(1) == unit || bothPrefixed))
            return true;
    }
    return false;
}

} // namespace

/// The words of every page in Swedish, on the example.
class TestWordsOfAllPages : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase() { QLocale::setDefault(QLocale::c()); }
    void noDecimalPoint_onAnyPage();
    void noProgrammersExponent_onAnyPage();
    void tables_haveOneUnitAColumnOrRow();
    void valueAndU_haveOnePlace();
    void standardButtons_areSwedish();

private:
    QTemporaryDir m_folder;
    Preferences m_preferences{m_folder.filePath("settings.ini")};
    Prompts m_prompts;
    Language m_language;
    std::unique_ptr<MainWindow> m_window;
    QVector<QStringList> m_words; ///< of every page
};

void TestWordsOfAllPages::initTestCase()
{
    m_language.install("sv");
    m_prompts.setScripted();
    const auto noon = [] { return Result<std::string>("2026-01-31T12:00:00Z"); };
    m_window
        = std::make_unique<MainWindow>(runPipeline, noon, m_preferences, m_prompts, m_language);
    m_window->resize(1600, 1000);
    m_window->show();
    m_window->files().setExampleDuration(kDuration_s);
    m_window->files().openExample();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->session().state().hasShots(), kPatience_ms);
    for (int page = 0; page < kPageCount; ++page) {
        m_window->showPage(page);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->session().isComputing(), kPatience_ms);
        QVERIFY(!m_window->session().error());
        m_words << wordsOf(*m_window);
        QVERIFY(m_words.last().size() > 20);
    }
}

void TestWordsOfAllPages::noDecimalPoint_onAnyPage()
{
    static const QRegularExpression point("(?<![\\d.])-?\\d+\\.\\d+(?![\\d.])");
    static const QRegularExpression reference("(ekv\\.|eq\\.|avsnitt|tabell) ?\\d+\\.\\d+");
    for (int page = 0; page < kPageCount; ++page)
        for (QString words : std::as_const(m_words[page]))
            QVERIFY2(!words.remove(reference).contains(point),
                qPrintable(QString("page %1: %2").arg(page).arg(words)));
}

void TestWordsOfAllPages::noProgrammersExponent_onAnyPage()
{
    static const QRegularExpression exponent("\\d[eE][-+]?\\d");
    static const QRegularExpression hash("\\b[0-9a-f]{10,}\\b");
    for (int page = 0; page < kPageCount; ++page)
        for (QString words : std::as_const(m_words[page]))
            QVERIFY2(!words.remove(hash).contains(exponent),
                qPrintable(QString("page %1: %2").arg(page).arg(words)));
}

void TestWordsOfAllPages::tables_haveOneUnitAColumnOrRow()
{
    int tables = 0;
    for (const auto *table : m_window->findChildren<ValueTable *>()) {
        const auto text = [table](int row, int column) {
            const QTableWidgetItem *item = table->item(row, column);
            return item ? item->text() : QString();
        };
        bool byColumn = true;
        for (int column = 0; column < table->columnCount(); ++column) {
            QStringList cells;
            for (int row = 0; row < table->rowCount(); ++row)
                cells << text(row, column);
            byColumn = byColumn && !mixesPrefixes(cells);
        }
        bool byRow = true;
        for (int row = 0; row < table->rowCount(); ++row) {
            QStringList cells;
            for (int column = 0; column < table->columnCount(); ++column)
                cells << text(row, column);
            byRow = byRow && !mixesPrefixes(cells);
        }
        QVERIFY2(byColumn || byRow, qPrintable(table->objectName()));
        tables += table->rowCount() > 0;
    }
    QVERIFY(tables >= 8);
}

void TestWordsOfAllPages::valueAndU_haveOnePlace()
{
    static const QRegularExpression pair(
        "(\\d+)(?:,(\\d+))? ?([^\\d\\s,;±]*) (?:±|\\(u =|, u) ?(\\d+)(?:,(\\d+))? ?([^\\d\\s,;()]*)");
    int pairs = 0;
    for (const QStringList &page : std::as_const(m_words))
        for (const QString &words : page)
            for (auto match = pair.globalMatch(words); match.hasNext();) {
                const auto found = match.next();
                ++pairs;
                QVERIFY2(found.captured(2).size() == found.captured(5).size(), qPrintable(words));
                if (!found.captured(3).isEmpty()) // else a word may follow
                    QVERIFY2(found.captured(3) == found.captured(6), qPrintable(words));
            }
    QVERIFY(pairs > 5);
}

void TestWordsOfAllPages::standardButtons_areSwedish()
{
    QDialogButtonBox box(QDialogButtonBox::Save | QDialogButtonBox::Cancel | QDialogButtonBox::Close
        | QDialogButtonBox::Discard | QDialogButtonBox::Yes | QDialogButtonBox::No
        | QDialogButtonBox::Help | QDialogButtonBox::Apply);
    const auto text = [&](QDialogButtonBox::StandardButton button) {
        return box.button(button)->text().remove('&');
    };
    QCOMPARE(text(QDialogButtonBox::Save), QString("Spara"));
    QCOMPARE(text(QDialogButtonBox::Cancel), QString("Avbryt"));
    QCOMPARE(text(QDialogButtonBox::Close), QString("Stäng"));
    QCOMPARE(text(QDialogButtonBox::Discard), QString("Förkasta"));
    QCOMPARE(text(QDialogButtonBox::Yes), QString("Ja"));
    QCOMPARE(text(QDialogButtonBox::No), QString("Nej"));
    QCOMPARE(text(QDialogButtonBox::Help), QString("Hjälp"));
    QCOMPARE(text(QDialogButtonBox::Apply), QString("Verkställ"));
    // From Qt's own catalogue.
    QCOMPARE(QCoreApplication::translate("QLineEdit", "&Copy").remove('&'), QString("Kopiera"));
}

DYNCAL_TEST(TestWordsOfAllPages)
#include "tst_words_of_all_pages.moc"
