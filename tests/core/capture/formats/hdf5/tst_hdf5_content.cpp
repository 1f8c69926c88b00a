// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/capture/opening/capture_open.h"
#include "core/capture/opening/content_statement.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QFile>
#include <QTemporaryDir>

#include <random>
#include <sstream>
#include <tuple>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr unsigned int kSeed = 12;

/// Something in every kind of place, as few bytes as that takes.
CaptureSet smallSet()
{
    CaptureSet set;
    set.inputs = {{"/somewhere/a.lvm", "a.lvm", std::string(64, 'a'), "lvm"}};
    set.tube = {{"driver_length_m", "0.97"}, {"driver_gas", "air"}};
    set.sensors["p1"] = {{"serial", "0042"}, {"role", "dut"}};
    set.instruments["scope"] = {{"vendor", "NI"}};
    for (const char *label : {"low", "high"}) {
        Shot shot;
        shot.label = label;
        shot.level = shotLevelFromName(label);
        shot.environment.p1_Pa = 101325.0;
        shot.notes = {{"operator", "Elsa"}};
        for (const char *name : {"dut", "side"}) {
            Channel channel;
            channel.name = name;
            channel.role = channelRoleFromName(name);
            std::vector<std::int16_t> counts(40);
            for (std::size_t i = 0; i < counts.size(); ++i)
                counts[i] = static_cast<std::int16_t>(i * i + counts.size() * shot.label.size());
            channel.samples = RawSamples(std::move(counts));
            channel.sampleRate_Hz = 1e6;
            channel.quantity = "pressure";
            channel.sensorId = channel.role == ChannelRole::Dut ? "p1" : "";
            shot.channels.push_back(std::move(channel));
        }
        set.shots.push_back(std::move(shot));
    }
    return set;
}

void add(std::ostream &text, const Attributes &attributes)
{
    for (const auto &[key, value] : attributes)
        text << key << '=' << value << '\n';
}

/// Everything that was read, but for the hash of the file's bytes.
std::string everythingOf(const CaptureSet &set)
{
    std::ostringstream text;
    text.precision(17);
    add(text, set.tube);
    for (const auto *catalogue : {&set.sensors, &set.instruments})
        for (const auto &[id, attributes] : *catalogue) {
            text << id << '\n';
            add(text, attributes);
        }
    for (const InputFile &input : set.inputs)
        text << input.format << '\n';
    for (const Shot &shot : set.shots) {
        const Environment &e = shot.environment;
        text << shot.label << '|' << shotLevelName(shot.level) << '|' << shot.included << '|'
             << shot.excludeReason << '|' << e.p1_Pa << '|' << e.u_p1_Pa << '|' << e.T1_K << '|'
             << e.u_T1_K << '|' << e.p4_Pa << '|' << e.T4_K << '|' << e.ambientPressure_Pa << '|'
             << e.ambientT_K << '|' << e.relativeHumidity << '\n';
        add(text, shot.notes);
        for (const Channel &c : shot.channels) {
            text << c.name << '|' << channelRoleName(c.role) << '|' << c.samples.size() << '|'
                 << c.sha256 << '|' << c.sampleRate_Hz << '|' << c.t0_s << '|' << c.unit << '|'
                 << c.quantity << '|' << pressureReferenceName(c.reference) << '|' << c.adcBits
                 << '|' << c.adcMin.value_or(0.5) << '|' << c.adcMax.value_or(0.5) << '|'
                 << c.sensorId << '|' << c.polarity << '|' << c.userScale << '|' << c.recordedUnit;
            for (const double coefficient : c.polynomial)
                text << '|' << coefficient;
            text << '\n';
        }
    }
    for (const Finding &finding : set.findings)
        text << finding.id << '|' << english(finding.message) << '\n';
    return text.str();
}

bool isBlocked(const CaptureSet &set)
{
    return worstSeverity(set.findings) == Severity::Block;
}

} // namespace

/// Whether a changed capture is told from the one that was written.
class TestHdf5Content : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QByteArray m_bytes; ///< of the capture
    std::string m_everything;

    std::string path(const char *name) const { return m_folder.filePath(name).toStdString(); }

    /// Bytes of a capture, and what it says.
    std::pair<QByteArray, std::string> written(const char *name, const CaptureSet &set) const
    {
        if (!writeHdf5Capture(
                set, {path(name), true}, "2026-01-02T03:04:05Z", "Title", {{{"f0_Hz", 1e5}}}))
            qFatal("cannot write %s", name);
        QFile file(m_folder.filePath(name));
        const Result<CaptureSet> read = readCapture(path(name), {});
        if (!file.open(QIODevice::ReadOnly) || !read || !read->findings.empty())
            qFatal("cannot read %s", name);
        return {file.readAll(), everythingOf(*read)};
    }

    void put(const char *name, const QByteArray &bytes) const
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }

    /// The capture with one text in it changed, which must be there once.
    Result<CaptureSet> readWith(const QByteArray &before, const QByteArray &after) const
    {
        if (before.size() != after.size() || m_bytes.count(before) != 1)
            qFatal("%s is there %d times", before.data(), static_cast<int>(m_bytes.count(before)));
        put("changed.h5", QByteArray(m_bytes).replace(before, after));
        return readCapture(path("changed.h5"), {});
    }

    bool editWithPython(const char *body) const
    {
        put("edited.h5", m_bytes);
        return runPython("import sys, h5py, numpy as np\nf = h5py.File(sys.argv[1], 'r+')\n"
                + QString(body) + "\nf.close()\n",
            {QString::fromStdString(path("edited.h5"))});
    }

private slots:
    void initTestCase() { std::tie(m_bytes, m_everything) = written("small.h5", smallSet()); }

    void statedHashes_ofManyFiles_areInOrder()
    {
        write(QString::fromStdString(path("cut.h5")), m_bytes.left(m_bytes.size() / 2));
        const std::vector<std::string> hashes = statedContentHashes(
            {path("small.h5"), path("cut.h5"), path("missing.h5"), path("small.h5")})
                                                    .value();
        QCOMPARE(hashes.size(), std::size_t(4));
        QCOMPARE(hashes[0].size(), std::size_t(64));
        QVERIFY(hashes[1].empty() && hashes[2].empty());
        QCOMPARE(hashes[3], hashes[0]);
        QVERIFY(statedContentHashes({}).value().empty());
    }

    void changedText_isNamedByItsPlace_data()
    {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::addColumn<QString>("named");
        QTest::addColumn<int>("shot");
        QTest::newRow("label") << QByteArray("high\0\0\0\0", 8) << QByteArray("hogh\0\0\0\0", 8)
                               << "shot 2 (/shots/002)" << 2;
        QTest::newRow("gas") << QByteArray("air") << QByteArray("aia") << "/setup/tube" << 0;
        QTest::newRow("serial") << QByteArray("0042") << QByteArray("0043") << "/setup/sensors/p1"
                                << 0;
        QTest::newRow("title") << QByteArray("Title") << QByteArray("title") << " in / is" << 0;
    }

    void changedText_isNamedByItsPlace()
    {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, after);
        QFETCH(QString, named);
        QFETCH(int, shot);
        if (before.startsWith("high")) { // label and level of the shot: the first is the label
            const qsizetype at = m_bytes.indexOf(before);
            put("changed.h5", QByteArray(m_bytes).replace(at, before.size(), after));
        } else {
            QVERIFY(readWith(before, after));
        }
        const Result<CaptureSet> read = readCapture(path("changed.h5"), {});
        QVERIFY2(read, sentence(read).c_str());
        QCOMPARE(read->findings.size(), std::size_t(1));
        const Finding &finding = read->findings.front();
        QCOMPARE(finding.id, std::string("CAP-015"));
        QVERIFY(finding.severity == Severity::Block);
        QCOMPARE(finding.shot, static_cast<Index>(shot));
        const QString said = QString::fromStdString(english(finding.message));
        QVERIFY2(said.contains(named), qPrintable(said));
    }

    void statedHashes_thatContradictEachOther_block()
    {
        const QByteArray hash
            = QByteArray::fromStdString(statedContentHashes({path("small.h5")}).value().at(0));
        QByteArray other = hash;
        other[0] = other[0] == 'a' ? 'b' : 'a';
        const Result<CaptureSet> read = readWith(hash, other);
        QVERIFY(read && isBlocked(*read));
        QVERIFY(english(read->findings.front().message).find("contradict") != std::string::npos);
    }

    void noLongerNamedCapture_isDamagedNotForeign()
    {
        const Result<CaptureSet> read = readWith("dyncal-capture", "dyncal-kapture");
        QVERIFY(!read);
        QCOMPARE(read.error().findingId, std::string("CAP-018"));
    }

    /// Changes of other programs, which know nothing of the hashes.
    void editOfAnotherProgram_isNamed_data()
    {
        QTest::addColumn<QString>("body");
        QTest::addColumn<QStringList>("named");
        QTest::newRow("scale") << "f['shots/002/channels/side'].attrs['scale'] = 2.0"
                               << QStringList{"channel 'side' of shot 2"};
        QTest::newRow("rate") << "f['shots/001/channels/dut'].attrs['sample_rate_Hz'] = 1e5"
                              << QStringList{"channel 'dut' of shot 1"};
        QTest::newRow("environment") << "f['shots/001/environment'].attrs['p1_Pa'] = 1e5"
                                     << QStringList{"shot 1 (/shots/001/environment)"};
        QTest::newRow("added") << "f['shots/001'].attrs['comment'] = 'x'"
                               << QStringList{"shot 1 (/shots/001)"};
        QTest::newRow("removed") << "del f['setup/tube'].attrs['driver_gas']"
                                 << QStringList{"/setup/tube"};
        QTest::newRow("renamed channel")
            << "g = f['shots/001/channels']; g.move('side', 'other')"
            << QStringList{"(/shots/001/channels)", "'other'", "'side'"};
        QTest::newRow("truth") << "f['truth/shot_001'].attrs['f0_Hz'] = 2e5"
                               << QStringList{"/truth/shot_001"};
        QTest::newRow("new group") << "f.create_group('more')" << QStringList{"in / is", "/more"};
        QTest::newRow("list gone") << "del f.attrs['content_list']" << QStringList{"contradict"};
        QTest::newRow("hash gone") << "del f.attrs['content_sha256']" << QStringList{"contradict"};
    }

    void editOfAnotherProgram_isNamed()
    {
        QFETCH(QString, body);
        QFETCH(QStringList, named);
        QVERIFY(editWithPython(qPrintable(body)));
        const Result<CaptureSet> read = readCapture(path("edited.h5"), {});
        QVERIFY2(read, sentence(read).c_str());
        QVERIFY(isBlocked(*read));
        QString said;
        for (const Finding &finding : read->findings)
            said += QString::fromStdString(english(finding.message)) + '\n';
        for (const QString &name : named)
            QVERIFY2(said.contains(name), qPrintable(said));
    }

    void touchedOnly_isTheSameCapture()
    {
        QVERIFY(editWithPython("f.attrs['x'] = 1; del f.attrs['x']"));
        const Result<CaptureSet> read = readCapture(path("edited.h5"), {});
        QVERIFY2(read, sentence(read).c_str());
        QCOMPARE(everythingOf(*read), m_everything);
    }

    /// The hashes as docs/method/captures.md describes them, by an independent reader.
    void hashes_areAsDocumented()
    {
        put("edited.h5", m_bytes);
        QVERIFY(runPython(R"(
import sys, h5py, hashlib, struct, numpy as np
f = h5py.File(sys.argv[1], 'r')
def field(x):
    x = x if isinstance(x, bytes) else str(x).encode()
    return str(len(x)).encode() + b':' + x + b','
def value(v):
    if isinstance(v, str): return field('text') + field(v)
    return field('numbers') + field(''.join('%016x' % struct.unpack('<Q', struct.pack('<d', x))[0]
                                            for x in np.atleast_1d(v).astype(float)))
lines = {}
def visit(path, o):
    isGroup = isinstance(o, h5py.Group)
    b = field('group' if isGroup else 'dataset')
    for name in sorted(o.attrs):
        if path == '/' and name in ('content_list', 'content_sha256'): continue
        b += field('attribute') + field(name) + value(o.attrs[name])
    if isGroup:
        for name in o: b += field('member') + field(name)
    else:
        b += field(o.dtype.name) + b''.join(field(n) for n in o.shape)
    lines[path] = hashlib.sha256(b).hexdigest()
visit('/', f)
f.visititems(lambda name, o: visit('/' + name, o))
text = ''.join(lines[p] + '  ' + p + '\n' for p in sorted(lines))
assert text == f.attrs['content_list'], text + f.attrs['content_list']
assert hashlib.sha256(text.encode()).hexdigest() == f.attrs['content_sha256']
)",
            {QString::fromStdString(path("edited.h5"))}));
    }

    void everyFlippedBit_isSeenOrSaysTheSame()
    {
        CaptureSet set = smallSet();
        set.shots.resize(1);
        set.shots[0].channels.resize(1);
        const auto [bytes, everything] = written("least.h5", set);
        const int bits = static_cast<int>(8 * bytes.size());
        const int count = std::min(trials::count(1200, bits), bits);
        std::mt19937 random(kSeed);
        int refused = 0;
        int blocked = 0;
        int same = 0;
        for (int trial = 0; trial < count; ++trial) {
            const int bit = count == bits
                ? trial
                : static_cast<int>(random() % static_cast<unsigned int>(bits));
            QByteArray flipped = bytes;
            flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
            put("flipped.h5", flipped);
            const Result<CaptureSet> read = readCapture(path("flipped.h5"), {});
            if (!read)
                ++refused;
            else if (isBlocked(*read))
                ++blocked;
            else if (everythingOf(*read) == everything)
                ++same;
            else
                QFAIL(qPrintable(QString("bit %1 of byte %2: %3")
                                     .arg(bit % 8)
                                     .arg(bit / 8)
                                     .arg(QString::fromStdString(everythingOf(*read)))));
        }
        qInfo("%d of %d bits: %d refused, %d blocked, %d say the same", count, bits, refused,
            blocked, same);
        QVERIFY(refused > 0 && blocked > 0 && same > 0);
    }
};

DYNCAL_TEST(TestHdf5Content)
#include "tst_hdf5_content.moc"
