// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Datasets of every type and layout, written by h5py: what we say of them is held against what it
// says, and what we read against the numbers that numpy put in.

#include "core/capture/formats/hdf5/hdf5_columns.h"
#include "core/capture/formats/hdf5/hdf5_open.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/support/python_answer.h"
#include "tests/support/same_samples.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Every type in every layout; prints what h5py says of each dataset, and numpy's numbers.
const char *const kScript = R"(
import h5py, json, numpy as np, sys
f = h5py.File(sys.argv[1], 'w', userblock_size=int(sys.argv[2]))
layouts = {'whole': {}, 'blocks': dict(chunks=(7, 2)), 'packed': dict(chunks=(7, 2),
           compression='gzip', shuffle=True), 'summed': dict(chunks=(5, 3), fletcher32=True),
           'scaled': dict(chunks=(20, 1), compression=9)}
numbers = np.arange(60).reshape(20, 3)
out = {}
for code in ['i1', 'u1', 'i2', 'u2', 'i4', 'u4', 'i8', 'u8', 'f2', 'f4', 'f8']:
    for order in '<>':
        x = (numbers * 2 - (0 if code[0] == 'u' else 50)).astype(order + code)
        if code[0] == 'f':
            x = x / 4
            x = x.astype(order + code)
        for layout, how in layouts.items():
            name = order + code + ' ' + layout
            d = f.create_dataset(name, data=x, **how)
            bits = str(8 * x.dtype.itemsize)
            text = {'i': 'int', 'u': 'uint', 'f': 'float'}[code[0]] + bits
            text += ' big-endian' if order == '>' and code[1] != '1' else ''
            where = {}
            if d.chunks is None:
                where['0,0'] = d.id.get_offset()
            elif not int(sys.argv[2]):
                for i in range(d.id.get_num_chunks()):
                    c = d.id.get_chunk_info(i)
                    where[','.join(map(str, c.chunk_offset))] = c.byte_offset
            out[name] = dict(text=text, where=where, chunks=list(d.chunks or d.shape),
                             values=[float(v) for v in x.ravel()])
f.close()
print(json.dumps(out))
)";

/// Type in which the numbers are delivered, and how well.
std::pair<SampleType, Hdf5Fidelity> wanted(const QString &code)
{
    static const std::map<QString, std::pair<SampleType, Hdf5Fidelity>> all{
        {"i1", {SampleType::Int8, Hdf5Fidelity::Exact}},
        {"u1", {SampleType::UInt8, Hdf5Fidelity::Exact}},
        {"i2", {SampleType::Int16, Hdf5Fidelity::Exact}},
        {"u2", {SampleType::UInt16, Hdf5Fidelity::Exact}},
        {"i4", {SampleType::Int32, Hdf5Fidelity::Exact}},
        {"u4", {SampleType::Float64, Hdf5Fidelity::Widened}},
        {"i8", {SampleType::Float64, Hdf5Fidelity::MayRound}},
        {"u8", {SampleType::Float64, Hdf5Fidelity::MayRound}},
        {"f2", {SampleType::Float32, Hdf5Fidelity::Widened}},
        {"f4", {SampleType::Float32, Hdf5Fidelity::Exact}},
        {"f8", {SampleType::Float64, Hdf5Fidelity::Exact}}};
    return all.at(code);
}

Result<std::vector<std::vector<RawSamples>>> columnsOf(
    const Hdf5File &file, const std::string &name, Index axis)
{
    const Hdf5Object *object = memberOf(file.tree, file.root(), name);
    if (object == nullptr || object->isDataset == 0)
        qFatal("no dataset %s", name.c_str());
    return hdf5Columns(file, {{&object->dataset, object->address, name, axis}}, {});
}

/// Whether the dataset lies where h5py says.
bool liesThere(const Hdf5Dataset &dataset, const QJsonObject &where)
{
    const std::uint64_t columns
        = (dataset.shape[1] + dataset.blockShape[1] - 1) / dataset.blockShape[1];
    return static_cast<qsizetype>(dataset.blockOffsets.size()) == where.size()
        && std::ranges::all_of(where.keys(), [&](const QString &key) {
               const std::uint64_t row = key.split(',')[0].toULongLong() / dataset.blockShape[0];
               const std::uint64_t column = key.split(',')[1].toULongLong() / dataset.blockShape[1];
               return dataset.blockOffsets.at(row * columns + column)
                   == static_cast<std::uint64_t>(where[key].toInteger());
           });
}

} // namespace

class TestHdf5Dataset : public QObject
{
    Q_OBJECT

private:
    ScratchFolder m_folder;

    /// A file that this body writes with h5py, opened; `f` is the file, `x` 0 to 99.
    Result<Hdf5File> made(const QString &body) const
    {
        const std::string path = m_folder.file("made.h5");
        const QString script = "import h5py, numpy as np, sys\nf = h5py.File(sys.argv[1], 'w')\n"
                               "x = np.arange(100)\n"
            + body + "\nf.close()\n";
        const PythonAnswer answer = python({"-c", script, QString::fromStdString(path)});
        if (!answer.ran)
            qFatal("%s", answer.err.constData());
        return openHdf5(path, kUsualExpansion, {});
    }

private slots:
    void everyTypeAndLayout_isDescribedAndReadAsIndependentlyWritten_data()
    {
        QTest::addColumn<int>("userBlock");
        QTest::newRow("from the beginning") << 0;
        QTest::newRow("behind a user block") << 1024;
    }
    void everyTypeAndLayout_isDescribedAndReadAsIndependentlyWritten()
    {
        QFETCH(int, userBlock);
        const std::string path = m_folder.file("all.h5");
        const PythonAnswer answer
            = python({"-c", kScript, QString::fromStdString(path), QString::number(userBlock)});
        QVERIFY2(answer.ran, answer.err.constData());
        const QJsonObject all = QJsonDocument::fromJson(answer.out).object();
        QCOMPARE(all.size(), qsizetype(110));
        const Result<Hdf5File> file = openHdf5(path, kUsualExpansion, {});
        QVERIFY2(file, sentence(file).c_str());
        for (const QString &name : all.keys()) {
            const QJsonObject said = all[name].toObject();
            const Hdf5Object *object = memberOf(file->tree, file->root(), name.toStdString());
            QVERIFY2(object, qPrintable(name));
            compareDescription(object->dataset, name, said, userBlock > 0);
            compareNumbers(*file, name.toStdString(), said["values"].toArray());
        }
    }

    void whatIsNoSignal_isToldApart()
    {
        const Result<Hdf5File> file = made(
            "f['text'] = 'words'\nf['texts'] = np.array([b'a', b'b'])\n"
            "f['flags'] = x > 5\nf['pairs'] = np.zeros(5, dtype=[('a', 'i4'), ('b', 'f8')])\n"
            "f['complex'] = x * 1j\nf['cube'] = np.zeros((2, 3, 4))\n"
            "f['null'] = h5py.Empty('f8')\nf.create_dataset('never', (50,), 'i2')\n"
            "d = f.create_dataset('parts', (50,), 'i2', chunks=(10,))\nd[0:10] = 1\n"
            "f['one'] = 3.5\nf.create_dataset('none', (0,), 'i2')\n"
            "g = f.create_dataset('grown', (10,), 'i2', chunks=(8,), maxshape=(None,))\n"
            "g[:] = x[:10]\ng.resize((30,))\n"
            "s = f.create_dataset('shrunk', (30,), 'i2', chunks=(8,), maxshape=(None,))\n"
            "s[:] = x[:30]\ns.resize((11,))\n");
        QVERIFY2(file, sentence(file).c_str());
        const std::map<std::string, Hdf5Obstacle> all{{"text", Hdf5Obstacle::NotNumbers},
            {"texts", Hdf5Obstacle::NotNumbers}, {"flags", Hdf5Obstacle::NotNumbers},
            {"pairs", Hdf5Obstacle::NotNumbers}, {"complex", Hdf5Obstacle::NotNumbers},
            {"cube", Hdf5Obstacle::Shape}, {"null", Hdf5Obstacle::Shape},
            {"never", Hdf5Obstacle::Incomplete}, {"parts", Hdf5Obstacle::Incomplete},
            {"grown", Hdf5Obstacle::Incomplete}, {"one", Hdf5Obstacle::None},
            {"none", Hdf5Obstacle::None}, {"shrunk", Hdf5Obstacle::None}};
        for (const auto &[name, obstacle] : all)
            QVERIFY2(memberOf(file->tree, file->root(), name)->dataset.obstacle == obstacle,
                name.c_str());
        QCOMPARE(columnsOf(*file, "one", 0)->at(0).at(0).at(0), 3.5);
        QCOMPARE(columnsOf(*file, "none", 0)->at(0).at(0).size(), Index(0));
        const auto shrunk = columnsOf(*file, "shrunk", 0);
        QVERIFY2(shrunk, sentence(shrunk).c_str());
        QCOMPARE(shrunk->at(0).at(0).size(), Index(11));
        for (Index i = 0; i < 11; ++i)
            QCOMPARE(shrunk->at(0).at(0).at(i), static_cast<double>(i));
    }

    /// As a double 2^53 + 1 becomes 2^53: from there on nobody can tell what was recorded.
    void wideIntegers_areReadAsLongAsTheyAreExact()
    {
        const Result<Hdf5File> file
            = made("m = 2 ** 53\nf['fits'] = np.array([m - 1, 1 - m, 0], 'i8')\n"
                   "f['beyond'] = np.array([0, m + 1, 0], 'i8')\n"
                   "f['below'] = np.array([0, -m - 2], '>i8')\n"
                   "f['most'] = np.array([2 ** 64 - 1], 'u8')\nf['least'] = np.array([7], 'u8')\n");
        QVERIFY2(file, sentence(file).c_str());
        const auto fits = columnsOf(*file, "fits", 0);
        QVERIFY2(fits, sentence(fits).c_str());
        QCOMPARE(fits->at(0).at(0).at(0), 0x1p53 - 1.0);
        QCOMPARE(fits->at(0).at(0).at(1), 1.0 - 0x1p53);
        QCOMPARE(columnsOf(*file, "least", 0)->at(0).at(0).at(0), 7.0);
        for (const char *name : {"beyond", "below", "most"}) {
            const auto refused = columnsOf(*file, name, 0);
            QCOMPARE(findingId(refused), std::string("CAP-018"));
            QVERIFY2(contains(sentence(refused), "53 bits"), sentence(refused).c_str());
        }
    }

    /// Thousands of small chunks are unpacked and not looked up one by one; nothing else changes.
    void manySmallChunks_areReadAsFew()
    {
        const Result<Hdf5File> file = made("y = np.arange(20000).astype('i2')\n"
                                           "f.create_dataset('few', data=y, chunks=(5000,))\n"
                                           "f.create_dataset('many', data=y, chunks=(2,))\n");
        QVERIFY2(file, sentence(file).c_str());
        const auto few = columnsOf(*file, "few", 0);
        const auto many = columnsOf(*file, "many", 0);
        QVERIFY2(few && many, sentence(many).c_str());
        QVERIFY(!few->at(0).at(0).isInMemory() && many->at(0).at(0).isInMemory());
        QVERIFY(testing::sameSamples(few->at(0).at(0).inMemory(), many->at(0).at(0)));
        QCOMPARE(many->at(0).at(0).at(19999), 19999.0);
    }

private:
    static void compareDescription(const Hdf5Dataset &dataset, const QString &name,
        const QJsonObject &said, bool behindUserBlock)
    {
        const auto [type, fidelity] = wanted(name.mid(1, 2));
        QCOMPARE(QString::fromStdString(dataset.typeText), said["text"].toString());
        QVERIFY2(dataset.type == type && dataset.fidelity == fidelity, qPrintable(name));
        QVERIFY(dataset.obstacle == Hdf5Obstacle::None);
        QVERIFY(dataset.shape == (std::vector<std::uint64_t>{20, 3}));
        const bool isPlain = fidelity == Hdf5Fidelity::Exact;
        const bool isInFile
            = isPlain && (name.endsWith("whole") || (name.endsWith("blocks") && !behindUserBlock));
        QVERIFY2((dataset.storage == Hdf5Storage::InFile) == isInFile, qPrintable(name));
        if (!isInFile)
            return;
        QCOMPARE(dataset.bigEndian != 0, name.startsWith('>') && name[2] != '1');
        for (int d = 0; d < 2; ++d)
            QCOMPARE(static_cast<int>(dataset.blockShape[static_cast<std::size_t>(d)]),
                said["chunks"].toArray()[d].toInt());
        QVERIFY2(liesThere(dataset, said["where"].toObject()), qPrintable(name));
    }

    static void compareNumbers(
        const Hdf5File &file, const std::string &name, const QJsonArray &values)
    {
        for (const Index axis : {0, 1}) {
            const auto columns = columnsOf(file, name, axis);
            QVERIFY2(columns, sentence(columns).c_str());
            const Index samples = axis == 0 ? 20 : 3;
            QCOMPARE(std::ssize(columns->at(0)), 60 / samples);
            for (Index column = 0; column < 60 / samples; ++column)
                for (Index i = 0; i < samples; ++i) {
                    const Index place = axis == 0 ? 3 * i + column : 3 * column + i;
                    QCOMPARE(columns->at(0)[static_cast<std::size_t>(column)].at(i),
                        values[place].toDouble());
                }
        }
    }
};

DYNCAL_TEST(TestHdf5Dataset)
#include "tst_hdf5_dataset.moc"
