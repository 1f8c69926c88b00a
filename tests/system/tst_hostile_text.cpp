// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/message.h"
#include "core/capture/formats/hdf5_capture.h"
#include "core/pipeline/mat_writer.h"
#include "core/synthesis/shot_generator.h"
#include "tests/core/capture/hdf5_test_file.h"
#include "tests/support/hostile_text.h"
#include "tests/support/tdms_writer.h"
#include "tests/support/trial_count.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/window_process.h"

#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <nlohmann/json.hpp>

#include <cmath>
#include <sys/stat.h>

using namespace dyncal;
using namespace dyncal::test;
using namespace dyncal::testing;

namespace {

constexpr int kRows = 300;
constexpr const char *kCreated = "2026-01-31T12:00:00Z";

double signalAt(int row)
{
    return (row < kRows / 3 ? 0.0 : 1.0) + 1e-3 * std::sin(12.9898 * row * row);
}

/// What a link or a file may be called.
std::string asName(std::string text)
{
    std::erase(text, '\0');
    std::ranges::replace(text, '/', '|');
    return text.substr(0, 200);
}

QByteArray csv(const QByteArray &text)
{
    QByteArray table = "# " + text + "\ntime [s]," + text + " [V]," + text + "\n";
    for (int row = 0; row < kRows; ++row)
        table += QByteArray::number(1e-6 * row, 'g', 9) + ',' + QByteArray::number(signalAt(row))
            + ",0.5\n";
    return table;
}

QByteArray lvm(const QByteArray &text)
{
    QByteArray file = "LabVIEW Measurement\t\r\nWriter_Version\t2\r\nSeparator\tTab\r\n"
                      "Multi_Headings\tYes\r\nX_Columns\tNo\r\nOperator\t"
        + text + "\r\nProject\t" + text
        + "\r\n***End_of_Header***\t\r\n\t\r\nChannels\t1\r\nSamples\t" + QByteArray::number(kRows)
        + "\r\nY_Unit_Label\t" + text
        + "\r\nX0\t0.0\r\nDelta_X\t1.0E-6\r\n***End_of_Header***\t\r\nX_Value\t" + text
        + "\tComment\r\n";
    for (int row = 0; row < kRows; ++row)
        file
            += '\t' + QByteArray::number(signalAt(row), 'f', 6) + (row ? "" : '\t' + text) + "\r\n";
    return file;
}

std::string tdms(const std::string &text)
{
    std::string quoted = text;
    for (std::size_t at = quoted.find('\''); at != std::string::npos;
         at = quoted.find('\'', at + 2))
        quoted.insert(at, 1, '\'');
    TdmsSegment segment;
    segment.object("/").property("name", text.c_str()).property(text, text.c_str());
    segment.object("/'" + quoted + "'").property("comment", text.c_str());
    segment.channel<double>("/'" + quoted + "'/'" + quoted + "'", kRows)
        .property("wf_increment", 1e-6)
        .property("unit_string", text.c_str())
        .property(text, text.c_str());
    for (int row = 0; row < kRows; ++row)
        segment.data().add(signalAt(row));
    return segment.bytes();
}

void writeForeignHdf5(const std::string &path, const std::string &text)
{
    const Hdf5TestFile file(path);
    std::vector<double> values;
    for (int row = 0; row < kRows; ++row)
        values.push_back(signalAt(row));
    const std::string name = asName(text);
    const std::string data = "/" + name + "/" + name;
    file.doubles(data, values);
    file.number(data, "sample_rate_hz", 1e6);
    file.text(data, "units", text);
    file.text(data, name, text);
    file.text("/", name, text);
}

QByteArray mat(const std::string &text)
{
    MatWriter writer;
    Eigen::MatrixXd values(kRows, 1);
    for (int row = 0; row < kRows; ++row)
        values(row, 0) = signalAt(row);
    writer.add(text.substr(0, 60), values);
    writer.add("sample_rate_hz", 1e6);
    return QByteArray::fromStdString(writer.bytes());
}

/// A sound calibration whose every text is this one.
bool writeCapture(const std::string &path, const std::string &text)
{
    SimulationSettings settings;
    settings.shots = {ShotLevel::Low};
    settings.sampleRate_Hz = 2e7;
    settings.duration_s = 0.005;
    const auto sensor = sensorPreset("optic3");
    if (!sensor)
        return false;
    settings.sensor = *sensor;
    auto made = simulateShots(settings);
    if (!made)
        return false;
    CaptureSet &set = made->set;
    set.tube[asName(text)] = text;
    set.instruments[asName(text)]["model"] = text;
    for (Shot &shot : set.shots) {
        shot.label = text;
        shot.notes["comment"] = text;
        for (Channel &channel : shot.channels) {
            channel.name = text + (channel.role == ChannelRole::Dut ? "" : " 2");
            channel.sensorId = text;
            channel.quantity = text;
        }
    }
    set.sensors[asName(text)]["serial"] = text;
    return writeHdf5Capture(set, {path, true}, kCreated, text).has_value();
}

QByteArray recipe(const std::string &text)
{
    const nlohmann::json json{{"import", {{"exclude", nlohmann::json::array()}}},
        {"certificate",
            {{"fields",
                {{"customer", text}, {"remarks", text + "\nsecond line"}, {"number", text},
                    {"laboratory", text}}}}},
        {"acknowledge", {{{"finding", "SHK-001"}, {"shot", 1}, {"reason", text}}}}};
    return QByteArray::fromStdString(
        json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

} // namespace

/// Hostile text in files, recipes and arguments, as the built program shows it.
class TestHostileText : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    std::vector<std::string> texts() const { return hostileTexts(path("bait").toStdString()); }

    /// Nothing of it acts on a terminal, and it came to its end.
    static void judge(const Answer &answer, const std::string &text)
    {
        const QByteArray about = answer.out.left(2000) + "|" + answer.err.left(2000) + "|"
            + QByteArray::fromStdString(text).toHex().left(200);
        QVERIFY2(answer.exitCode >= 0, about);
        QVERIFY2(isFitToShow(answer.out.toStdString(), LineBreaks::Keep), about.toHex());
        QVERIFY2(isFitToShow(answer.err.toStdString(), LineBreaks::Keep), about.toHex());
        QVERIFY2(!answer.err.contains("\nDone.\n") && !answer.out.contains("\nDone.\n"), about);
    }

    QString makeFolder(const std::string &text) const
    {
        const QString folder = path("files");
        QDir(folder).removeRecursively();
        QDir().mkpath(folder);
        const QByteArray bytes = QByteArray::fromStdString(text);
        writeBytes(folder + "/a.csv", csv(bytes));
        writeBytes(folder + "/b.lvm", lvm(bytes));
        writeBytes(folder + "/c.tdms", QByteArray::fromStdString(tdms(text)));
        writeForeignHdf5((folder + "/d.h5").toStdString(), text);
        writeBytes(folder + "/e.mat", mat(text));
        const std::string named = folder.toStdString() + "/" + asName(text) + ".csv";
        if (FILE *file = std::fopen(named.c_str(), "wb")) {
            std::fputs(csv("p").constData(), file);
            std::fclose(file);
        }
        return folder;
    }

private slots:
    void folders_ofAllFormats_areShownAsText()
    {
        int asked = 0;
        for (const std::string &text : texts()) {
            const QString folder = makeFolder(text);
            for (const QStringList &verb :
                {QStringList{"info"}, {"info", "--json"}, {"check"}, {"check", "--json"}}) {
                judge(runDyncal(verb + QStringList{folder}), text);
                ++asked;
                if (QTest::currentTestFailed())
                    return;
            }
        }
        qInfo("%d answers of folders", asked);
    }

    void files_oneByOne_areShownAsText()
    {
        const auto all = texts();
        const int count = trials::count(8, static_cast<int>(all.size()));
        int asked = 0;
        for (int i = 0; i < count; ++i) {
            const std::string &text
                = all[static_cast<std::size_t>(i) * all.size() / static_cast<std::size_t>(count)];
            const QDir folder(makeFolder(text));
            for (const QString &file : folder.entryList(QDir::Files))
                for (const QStringList &verb : {QStringList{"info"}, {"check"}, {"compare"}}) {
                    judge(runDyncal(verb + QStringList{folder.filePath(file)}), text);
                    ++asked;
                    if (QTest::currentTestFailed())
                        return;
                }
            judge(runDyncal({"import", folder.filePath("a.csv"), "-o", path("imported.h5")}), text);
            QFile::remove(path("imported.h5"));
        }
        qInfo("%d answers of files", asked);
    }

    void arguments_areShownAsText()
    {
        const auto all = texts();
        const int perText = trials::count(2, 7);
        writeBytes(path("p.csv"), csv("p"));
        for (std::size_t i = 0; i < all.size(); ++i) {
            // Not longer than the system lets an argument be, and it ends at a NUL anyway.
            const QString word = QFile::decodeName(QByteArray::fromStdString(all[i]).left(20000));
            const QList<QStringList> calls{{"info", word}, {"info", "--" + word},
                {"compare", path("p.csv"), "--orders", word},
                {"run", path("p.csv"), "-o", "/dev/null/" + word},
                {"simulate", "-o", path("s.h5"), "--defect", word},
                {"simulate", "-o", path("s.h5"), "--preset", word},
                {"check", path("p.csv"), "--recipe", word}};
            for (int k = 0; k < perText; ++k) {
                judge(runDyncal(calls[(int(i) + 3 * k) % calls.size()]), all[i]);
                if (QTest::currentTestFailed())
                    return;
            }
        }
    }

    void recipes_brokenOrFull_areShownAsText()
    {
        writeBytes(path("p.csv"), csv("p"));
        for (const std::string &text : texts()) {
            const nlohmann::json broken{{text, 1}};
            const nlohmann::json wrong{{"import", {{"format", text}, {"unit", text}}}};
            for (const auto &json : {broken, wrong}) {
                writeBytes(path("r.json"),
                    QByteArray::fromStdString(
                        json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
                judge(runDyncal({"check", path("p.csv"), "--recipe", path("r.json")}), text);
            }
            writeBytes(path("r.json"), QByteArray::fromStdString(text));
            judge(runDyncal({"check", path("p.csv"), "--recipe", path("r.json")}), text);
            writeBytes(path("j.dyncal"), QByteArray::fromStdString(text));
            judge(runDyncal({"export", path("j.dyncal"), "-o", path("out")}), text);
            if (QTest::currentTestFailed())
                return;
        }
    }

    void run_everyFile_holdsTextOnly()
    {
        const auto all = texts();
        const int count = trials::count(5, static_cast<int>(all.size()));
        for (int i = 0; i < count; ++i) {
            const std::string &text
                = all[static_cast<std::size_t>(i) * all.size() / static_cast<std::size_t>(count)];
            const QString out = path(QString("out%1").arg(i));
            QVERIFY(writeCapture(path("c.h5").toStdString(), text));
            writeBytes(path("r.json"), recipe(text));
            const Answer answer
                = runDyncal({"run", path("c.h5"), "--recipe", path("r.json"), "-o", out});
            judge(answer, text);
            QVERIFY2(answer.exitCode <= 1, answer.err);
            QDirIterator files(out, QDir::Files, QDirIterator::Subdirectories);
            while (files.hasNext())
                judgeFile(files.next(), text);
            if (QTest::currentTestFailed())
                return;
        }
        qInfo("%d runs", count);
    }

    void window_opensNothingThatTextNames()
    {
        // A name that is no markup is among them: the window shows it, and is still alive.
        const QString bait = path("bait");
        QCOMPARE(::mkfifo(QFile::encodeName(bait).constData(), 0600), 0);
        const QByteArray image = "<img src='file://" + bait.toUtf8() + "'>";
        writeBytes(path("image.csv"), csv(image));
        QVERIFY(writeCapture(path("image.h5").toStdString(), image.toStdString()));
        writeBytes(path("strace"),
            "#!/bin/sh\nexec strace -f -qq -e "
            "trace=open,openat,openat2,access,stat,newfstatat,statx -o '"
                + path("opened").toUtf8() + "' '" + qgetenv("DYNCAL_BINARY") + "' \"$@\"\n");
        QFile(path("strace"))
            .setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        const QByteArray program = qgetenv("DYNCAL_BINARY");
        qputenv("DYNCAL_BINARY", path("strace").toUtf8());
        for (const char *file : {"image.csv", "image.h5"}) {
            WindowProcess window(path("home"), {path(file)});
            QVERIFY2(window.waitFor("title", "Dyncal"), window.last());
            QTest::qWait(3000);
            for (int page = 1; page <= 9; ++page)
                QCOMPARE(window.ask(QString("key Alt+%1").arg(page)), QString("done"));
            QVERIFY(!window.ask("list findingsPanel").isEmpty());
            window.stop(SIGTERM);
            const QByteArray opened = fileBytes(path("opened"));
            QVERIFY2(opened.contains(file), "strace must have seen the recording opened");
            QVERIFY2(!opened.contains(bait.toUtf8() + '"'), opened.right(2000));
        }
        qputenv("DYNCAL_BINARY", program);
        QFile::remove(bait);
    }

    void commandLine_opensNothingThatTextNames()
    {
        const QByteArray image = "<img src='file://" + path("bait").toUtf8() + "'>";
        QVERIFY(writeCapture(path("image.h5").toStdString(), image.toStdString()));
        writeBytes(path("r.json"), recipe(image.toStdString()));
        QProcess strace;
        strace.start("strace",
            {"-f", "-qq", "-e", "trace=open,openat,openat2", "-o", path("opened"),
                qEnvironmentVariable("DYNCAL_BINARY"), "run", path("image.h5"), "--recipe",
                path("r.json"), "-o", path("traced")});
        QVERIFY(strace.waitForFinished(240000));
        QVERIFY2(strace.exitCode() <= 1, strace.readAllStandardError());
        const QByteArray opened = fileBytes(path("opened"));
        QVERIFY(opened.contains("image.h5") && !opened.contains(path("bait").toUtf8() + '"'));
    }

    void numbersThatAreNone_areNoWords_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("where");
        QTest::addColumn<double>("interval_s");
        const double inf = std::numeric_limits<double>::infinity();
        for (const QString where : {"all", "first", "tail", "one", "side"})
            for (const double value : {std::nan(""), inf, -inf, 1e300, -1e300, 1e-300, 0.0})
                QTest::newRow(qPrintable(QString("%1 %2").arg(where).arg(value)))
                    << value << where << 1e-6;
        for (const double interval_s : {1e-300, 1e300, 1e-12, 1.0, 0.0, -1e-6, inf, std::nan("")})
            QTest::addRow("interval %g", interval_s) << 0.0 << QString("none") << interval_s;
    }
    void numbersThatAreNone_areNoWords()
    {
        QFETCH(double, value);
        QFETCH(QString, where);
        QFETCH(double, interval_s);
        constexpr int kLong = 3000;
        TdmsSegment segment;
        segment.object("/'g'");
        for (const char *name : {"/'g'/'dut'", "/'g'/'side'"})
            segment.channel<double>(name, kLong)
                .property("wf_increment", interval_s)
                .property("unit_string", "V");
        for (const bool dut : {true, false})
            for (int row = 0; row < kLong; ++row) {
                const bool here = where == "all" || (where == "first" && row < kLong / 3)
                    || (where == "tail" && row > kLong / 2) || (where == "one" && row == kLong / 2);
                const double usual
                    = (row < (dut ? 1000 : 980) ? 0.0 : 1.0) + 1e-3 * std::sin(12.9898 * row * row);
                segment.data().add((dut && here) || (!dut && where == "side") ? value : usual);
            }
        writeBytes(path("n.tdms"), QByteArray::fromStdString(segment.bytes()));
        writeBytes(
            path("n.json"), R"({"import": {"channels": {"dut": "dut", "side": "driven_side"}}})");
        static const QRegularExpression word("(?<![\\w.%])[-+]?(nan|inf|infinity)(?![\\w])",
            QRegularExpression::CaseInsensitiveOption);
        for (const QStringList &call : {QStringList{"info", path("n.tdms")},
                 {"check", path("n.tdms"), "--recipe", path("n.json")},
                 {"run", path("n.tdms"), "--recipe", path("n.json"), "-o", path("n_out")}}) {
            const Answer answer = runDyncal(call);
            QVERIFY2(answer.exitCode >= 0, answer.err);
            for (const QByteArray &text : {answer.out, answer.err})
                QVERIFY2(!QString::fromUtf8(text).contains(word), text.left(3000));
        }
        const QString results = QString::fromUtf8(fileBytes(path("n_out/results.json")));
        QVERIFY2(!results.contains(word), qPrintable(word.match(results).captured()));
    }

private:
    void judgeFile(const QString &file, const std::string &text) const
    {
        const QByteArray about = file.toUtf8() + " " + QByteArray::fromStdString(text).left(60);
        if (file.endsWith(".mat")) // binary, and holds numbers alone
            return;
        QByteArray bytes = fileBytes(file);
        if (file.endsWith(".pdf")) {
            QProcess toText;
            toText.start("pdftotext", {"-layout", file, "-"});
            QVERIFY(toText.waitForFinished(60000));
            bytes = toText.readAllStandardOutput().replace('\f', "");
            QVERIFY(!bytes.isEmpty());
        }
        QVERIFY2(isFitToShow(bytes.toStdString(), LineBreaks::Keep), about);
        if (file.endsWith(".json"))
            QVERIFY2(!QJsonDocument::fromJson(bytes).isNull(), about);
        if (file.endsWith(".svg")) {
            QXmlStreamReader xml(bytes);
            while (!xml.atEnd()) {
                xml.readNext();
                for (const char *foreign : {"script", "img", "b", "a", "table", "h1"})
                    QVERIFY2(!xml.isStartElement() || xml.name() != QLatin1String(foreign), about);
            }
            QVERIFY2(!xml.hasError(), about);
        }
        if (file.endsWith(".csv"))
            for (const QByteArray &line : bytes.split('\n'))
                for (const QByteArray &cell : line.split(','))
                    QVERIFY2(cell.isEmpty() || !QByteArray("=@").contains(cell.front()), about);
    }
};

QTEST_GUILESS_MAIN(TestHostileText)
#include "tst_hostile_text.moc"
