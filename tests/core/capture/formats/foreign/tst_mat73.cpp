// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/foreign/mat73.h"
#include "core/capture/formats/preview/foreign_datasets.h"
#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/core/capture/formats/foreign/mat73_test_file.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QTemporaryDir>

#include <functional>

using namespace dyncal;
using namespace dyncal::testing;
using namespace testing::mat73;

namespace {

using Names = std::vector<std::string>;

std::vector<double> ramp(Index count, double step = 1.0, double first = 0.0)
{
    std::vector<double> values;
    for (Index i = 0; i < count; ++i)
        values.push_back(first + static_cast<double>(i) * step);
    return values;
}

std::vector<double> valuesOf(const Channel &channel)
{
    std::vector<double> values;
    for (Index i = 0; i < channel.samples.size(); ++i)
        values.push_back(channel.samples.at(i));
    return values;
}

Names namesOf(const Result<CaptureSet> &set)
{
    Names names;
    if (set) {
        for (const Channel &channel : set->shots.at(0).channels)
            names.push_back(channel.name);
    }
    return names;
}

} // namespace

class TestMat73 : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::string path() const { return m_folder.filePath("f.mat").toStdString(); }

    Result<CaptureSet> readMade(
        const std::function<void(const MatFile &)> &make, const ImportSettings &settings = {}) const
    {
        {
            const MatFile file(path());
            make(file);
        }
        writeHead(path());
        return openCapture(path(), settings); // with the reader that recognises it
    }

private slots:
    void read_columnAndRowVectors_areChannels()
    {
        for (const bool packed : {false, true}) {
            const auto set = readMade([&](const MatFile &file) {
                file.matrix("column", 300, 1, ramp(300), "double", -1, packed);
                file.matrix("row", 1, 300, ramp(300, 2.0), "double", -1, packed);
                file.matrix("short", 30, 1, ramp(30), "double", -1, packed);
            });
            QVERIFY2(set, sentence(set).c_str());
            QCOMPARE(set->inputs.at(0).format, std::string("mat73"));
            QVERIFY(namesOf(set) == (Names{"column", "row"}));
            QVERIFY(valuesOf(set->shots[0].channels[0]) == ramp(300));
            QVERIFY(valuesOf(set->shots[0].channels[1]) == ramp(300, 2.0));
            QCOMPARE(set->shots[0].channels[0].samples.isInMemory(), packed);
            QVERIFY(hasFinding(set->findings, "CAP-026"));
        }
    }

    void read_matrix_columnsAreChannels()
    {
        for (const bool packed : {false, true}) {
            const auto set = readMade([&](const MatFile &file) {
                file.matrix("x", 200, 3, ramp(600), "double", -1, packed);
            });
            QVERIFY2(set, sentence(set).c_str());
            QVERIFY(namesOf(set) == (Names{"x(:,1)", "x(:,2)", "x(:,3)"}));
            for (int c = 0; c < 3; ++c)
                QVERIFY(valuesOf(set->shots[0].channels[static_cast<std::size_t>(c)])
                    == ramp(200, 1.0, 200.0 * c));
        }
    }

    void read_wideMatrix_rowsAreChannels()
    {
        const auto set
            = readMade([&](const MatFile &file) { file.matrix("x", 2, 100, ramp(200)); });
        QVERIFY2(set, sentence(set).c_str());
        QVERIFY(namesOf(set) == (Names{"x(1,:)", "x(2,:)"}));
        QVERIFY(valuesOf(set->shots[0].channels[1]) == ramp(100, 2.0, 1.0));
    }

    void read_integerClasses_keepTheirType()
    {
        const auto set = readMade([&](const MatFile &file) {
            file.matrix("a", 50, 1, ramp(50), "int16", H5T_STD_I16LE);
            file.matrix("b", 50, 1, ramp(50), "uint8", H5T_STD_U8LE);
            file.matrix("c", 50, 1, ramp(50), "single", H5T_IEEE_F32LE);
            file.matrix("d", 50, 1, ramp(50), "uint32", H5T_STD_U32LE);
        });
        QVERIFY2(set, sentence(set).c_str());
        const std::vector<SampleType> types{
            SampleType::Int16, SampleType::UInt8, SampleType::Float32, SampleType::Float64};
        for (std::size_t i = 0; i < types.size(); ++i) {
            QVERIFY(set->shots[0].channels[i].samples.type() == types[i]);
            QVERIFY(valuesOf(set->shots[0].channels[i]) == ramp(50));
        }
    }

    void read_timeVectorOrRateVariable_giveTheRate()
    {
        const auto byTime = readMade([&](const MatFile &file) {
            file.matrix("p", 400, 1, ramp(400));
            file.matrix("t", 400, 1, ramp(400, 1.0 / 1024.0, -0.125));
        });
        QVERIFY2(byTime, sentence(byTime).c_str());
        QVERIFY(namesOf(byTime) == Names{"p"});
        QCOMPARE(byTime->shots[0].channels[0].sampleRate_Hz, 1024.0);
        QCOMPARE(byTime->shots[0].channels[0].t0_s, -0.125);
        const auto byRate = readMade([&](const MatFile &file) {
            file.matrix("p", 400, 1, ramp(400));
            file.matrix("Fs", 1, 1, {5e6});
        });
        QVERIFY2(byRate, sentence(byRate).c_str());
        QCOMPARE(byRate->shots[0].channels[0].sampleRate_Hz, 5e6);
    }

    void read_otherKinds_leftOutAndSaid()
    {
        const auto set = readMade([&](const MatFile &file) {
            file.matrix("p", 100, 1, ramp(100));
            file.matrix("title", 1, 100, ramp(100), "char", H5T_STD_U16LE);
            file.matrix("flags", 100, 1, ramp(100), "logical", H5T_STD_U8LE);
            file.hdf5().group("/s");
            file.hdf5().text("/s", "MATLAB_class", "struct");
            file.matrix("s/field", 100, 1, ramp(100));
        });
        QVERIFY2(set, sentence(set).c_str());
        QVERIFY(namesOf(set) == Names{"p"});
        const auto said = std::find_if(set->findings.begin(), set->findings.end(),
            [](const Finding &finding) { return finding.id == "CAP-026"; });
        QVERIFY(said != set->findings.end());
        QVERIFY(contains(english(said->message), "flags, s, title"));
    }

    void read_emptyVariable_isNone()
    {
        const auto set = readMade([&](const MatFile &file) {
            file.matrix("p", 100, 1, ramp(100));
            file.matrix("none", 2, 1, {0.0, 0.0}, "double", H5T_STD_U64LE); // holds its dimensions
            file.hdf5().number("/none", "MATLAB_empty", 1.0);
        });
        QVERIFY2(set, sentence(set).c_str());
        QVERIFY(namesOf(set) == Names{"p"});
    }

    void read_namedChannels_areThose()
    {
        ImportSettings settings;
        settings.channels = {{"x(:,2)", "dut"}};
        const auto set = readMade(
            [&](const MatFile &file) {
                file.matrix("p", 500, 1, ramp(500));
                file.matrix("x", 100, 2, ramp(200));
            },
            settings);
        QVERIFY2(set, sentence(set).c_str());
        QVERIFY(namesOf(set) == Names{"x(:,2)"});
        QVERIFY(valuesOf(set->shots[0].channels[0]) == ramp(100, 1.0, 100.0));
    }

    void list_variables_haveTheirChannelNames()
    {
        (void)readMade([&](const MatFile &file) {
            file.matrix("x", 100, 2, ramp(200));
            file.matrix("title", 1, 10, ramp(10), "char", H5T_STD_U16LE);
        });
        const auto list = listDatasets(path());
        QVERIFY2(list, sentence(list).c_str());
        QCOMPARE(list->size(), 2U);
        QVERIFY(list->at(0).channels.empty() && contains(english(list->at(0).whyNot), "char"));
        QVERIFY(list->at(1).channels == (Names{"x(:,1)", "x(:,2)"}));
    }

    void recognise_byHead_onlyVersion73()
    {
        std::string head = "MATLAB 7.3 MAT-file, Platform: PCWIN64";
        head.resize(124, ' ');
        head.append("\0\2IM", 4);
        head.resize(512, '\0');
        const std::string whole = head + std::string("\x89HDF\r\n\x1a\n", 8);
        QCOMPARE(recogniseMat73("x.mat", whole), 100);
        QCOMPARE(recogniseMat73("x.mat", head), 0);
        QCOMPARE(recogniseMat73("x.mat", "MATLAB 5.0 MAT-file"), 0);
        QCOMPARE(recogniseMat73("x.mat", whole.substr(512)), 0);
    }

    void read_cutAnywhere_neverAnotherNumber()
    {
        const auto whole = readMade([&](const MatFile &file) {
            file.matrix("p", 100, 1, ramp(100));
            file.matrix("q", 100, 1, ramp(100), "double", -1, true);
        });
        QVERIFY2(whole, sentence(whole).c_str());
        const QByteArray bytes = bytesOf(QString::fromStdString(path()));
        constexpr int kEvery = 97;
        for (int length = 0; length < bytes.size(); length += kEvery) {
            const auto set
                = readMat73(write(m_folder.filePath("cut.mat"), bytes.left(length)), {}, {});
            if (!set)
                continue;
            for (const Channel &channel : set->shots[0].channels)
                QVERIFY(valuesOf(channel) == ramp(100));
        }
    }

    void read_filesOfMatlab()
    {
        int covered = 0;
        QDirIterator files(
            recordingsFolder(), {"*.mat"}, QDir::Files, QDirIterator::Subdirectories);
        while (!recordingsFolder().isEmpty() && files.hasNext()) {
            const std::string file = files.next().toStdString();
            if (!isMat73(file))
                continue;
            const auto set = openCapture(file, {});
            QVERIFY2(set || !sentence(set).empty(), file.c_str());
            ++covered;
        }
        // A folder of recordings need not hold one: the cases above write their own.
        qInfo("%d MAT files of version 7.3 covered", covered);
    }
};

DYNCAL_TEST(TestMat73)

#include "tst_mat73.moc"
