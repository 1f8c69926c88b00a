// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/bytes/expansion_budget.h"
#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/core/capture/formats/hdf5/hdf5_test_file.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>

#include <sys/stat.h>

#include <numeric>

using namespace dyncal;
using namespace dyncal::testing;

class TestExpansionBudget : public QObject
{
    Q_OBJECT

private:
    static constexpr std::uint64_t kMebibyte = 1 << 20;
    static constexpr hsize_t kSamples = 200;

    QTemporaryDir m_folder;

    std::string path(const char *name) const { return m_folder.filePath(name).toStdString(); }

    static std::vector<std::int16_t> counts()
    {
        std::vector<std::int16_t> values(kSamples);
        std::iota(values.begin(), values.end(), std::int16_t(0));
        return values;
    }

private slots:
    void take_upToTheLimit_notOneByteMore()
    {
        ExpansionBudget budget(kMebibyte, 20.0);
        QCOMPARE(budget.allowed(), 84 * kMebibyte);
        QVERIFY(budget.take(80 * kMebibyte) && budget.take(4 * kMebibyte));
        QVERIFY(!budget.take(1));
        budget.giveBack(kMebibyte);
        QVERIFY(!budget.take(kMebibyte + 1) && budget.take(kMebibyte));
        QVERIFY(!budget.take(~std::uint64_t(0)));
    }

    void allowed_absurdSizes_doNotOverflow()
    {
        const ExpansionBudget budget(~std::uint64_t(0), 1e4);
        QVERIFY(budget.allowed() > (std::uint64_t(1) << 61));
    }

    void exceeded_saysWhatHowMuchAndWhatToDo()
    {
        const auto error = ExpansionBudget(kMebibyte).exceededBy(
            "a.h5", Expanding::Channel, "x", std::uint64_t(3) << 30);
        QCOMPARE(english(error.value().message),
            std::string(
                "a.h5: channel x would take 3 GiB of memory, more than the 84 MiB that a file of this size may; if you trust the file, raise import.max_expansion in the recipe."));
        QCOMPARE(error.value().findingId, std::string("CAP-018"));
    }

    void open_recipesFactor_decides()
    {
        const std::string file = path("zeros.h5");
        {
            const Hdf5TestFile made(file);
            const std::vector<std::int16_t> zeros(40 * kMebibyte);
            made.dataset("/a", {zeros.size()}, {H5T_STD_I16LE, {kMebibyte}, false, 9},
                H5T_NATIVE_INT16, zeros.data());
        }
        const auto refused = openCapture(file, {});
        QCOMPARE(findingId(refused), std::string("CAP-018"));
        QVERIFY2(contains(sentence(refused), "80 MiB"), sentence(refused).c_str());
        ImportSettings trusting;
        trusting.maxExpansion = 2000.0;
        const auto read = openCapture(file, trusting);
        QVERIFY2(read, sentence(read).c_str());
        QCOMPARE(read->shots[0].channels[0].samples.size(), Index(40 * kMebibyte));
    }

    void open_samplesInAnotherFile_itIsNamedAndNotOpened()
    {
        const std::string pipe = path("elsewhere"); // whoever opens it waits for a writer
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        const std::string file = path("external.h5");
        {
            const Hdf5TestFile made(file);
            const hsize_t size = 100 * kMebibyte; // more than this file has
            const hid_t space = H5Screate_simple(1, &size, nullptr);
            const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
            H5Pset_external(creation, pipe.c_str(), 0, 2 * size);
            H5Dclose(H5Dcreate2(
                made.id(), "a", H5T_STD_I16LE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
            H5Pclose(creation);
            const hid_t virtualCreation = H5Pcreate(H5P_DATASET_CREATE);
            H5Pset_virtual(virtualCreation, space, pipe.c_str(), "/a", space);
            H5Dclose(H5Dcreate2(
                made.id(), "b", H5T_STD_I16LE, space, H5P_DEFAULT, virtualCreation, H5P_DEFAULT));
            H5Pclose(virtualCreation);
            H5Sclose(space);
        }
        QElapsedTimer timer;
        timer.start();
        const auto refused = openCapture(file, {});
        QVERIFY(timer.elapsed() < 5000);
        QCOMPARE(findingId(refused), std::string("CAP-018"));
        QVERIFY2(contains(sentence(refused), pipe), sentence(refused).c_str());
        QVERIFY2(contains(sentence(refused), "not opened"), sentence(refused).c_str());
    }

    void open_oneAttributeOfManyObjects_refused()
    {
        const std::string file = path("shared.h5");
        {
            const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
            const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
            H5Pset_shared_mesg_nindexes(creation, 1);
            H5Pset_shared_mesg_index(creation, 0, H5O_SHMESG_ATTR_FLAG, 50);
            H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
            const hid_t made = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, access);
            const hid_t text = H5Tcopy(H5T_C_S1);
            const std::string value(60'000, 'x');
            H5Tset_size(text, value.size());
            const hid_t space = H5Screate(H5S_SCALAR);
            for (int i = 0; i < 1000; ++i) {
                const hid_t group
                    = H5Gcreate2(made, std::string("g").append(std::to_string(i)).c_str(),
                        H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
                const hid_t attribute
                    = H5Acreate2(group, "a", text, space, H5P_DEFAULT, H5P_DEFAULT);
                H5Awrite(attribute, text, value.data());
                H5Aclose(attribute);
                H5Gclose(group);
            }
            H5Tclose(text);
            H5Sclose(space);
            H5Pclose(creation);
            H5Pclose(access);
            H5Fclose(made);
        }
        QVERIFY(QFileInfo(m_folder.filePath("shared.h5")).size() < qint64(kMebibyte));
        const auto refused = openCapture(file, {});
        QCOMPARE(findingId(refused), std::string("CAP-018"));
        QVERIFY2(contains(sentence(refused), "names and attributes"), sentence(refused).c_str());
    }
};

DYNCAL_TEST(TestExpansionBudget)
#include "tst_expansion_budget.moc"
