// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Attributes as h5py and the library itself write them, in all the ways in which a text or a number
// may be stored.

#include "core/capture/formats/hdf5/hdf5_attributes.h"
#include "core/capture/formats/hdf5/hdf5_open.h"
#include "tests/core/capture/formats/hdf5/hdf5_test_file.h"
#include "tests/support/python_answer.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const char *const kScript = R"(
import h5py, numpy as np, sys
f = h5py.File(sys.argv[1], 'w')
a = f.attrs
def fixed(name, value, size, pad, cset=h5py.h5t.CSET_ASCII):
    t = h5py.h5t.C_S1.copy()
    t.set_size(size)
    t.set_strpad(pad)
    t.set_cset(cset)
    made = h5py.h5a.create(f.id, name.encode(), t, h5py.h5s.create(h5py.h5s.SCALAR))
    made.write(np.array(value, dtype='S%d' % size), mtype=t)
a['text'] = '\u00e5\u00df\u2116'
a['empty'] = ''
a['lines'] = 'one\ntwo'
a['long'] = 'x' * 300000
a['name of \u00e5/b.c'] = 'v'
fixed('zero end', b'abc', 8, h5py.h5t.STR_NULLTERM)
fixed('zero pad', b'abcdefgh', 8, h5py.h5t.STR_NULLPAD)
fixed('blank pad', b'ab      ', 8, h5py.h5t.STR_SPACEPAD)
fixed('blanks', b'  ab    ', 8, h5py.h5t.STR_SPACEPAD)
fixed('all blank', b'        ', 8, h5py.h5t.STR_SPACEPAD)
fixed('utf8', '\u00b5V'.encode(), 8, h5py.h5t.STR_NULLPAD, h5py.h5t.CSET_UTF8)
a['one text in a list'] = np.array(['x'], dtype=h5py.string_dtype())
a['list of texts'] = ['a', 'b']
for code in ['<i1', '<u1', '<i2', '>i2', '<u2', '>u4', '<i4', '>i8', '<f2', '>f4', '<f8', '>f8']:
    a['number ' + code] = np.array(-8 if 'u' not in code else 200, dtype=code)
a['most'] = np.uint64(2 ** 64 - 1)
a['nan'] = np.nan
a['infinite'] = -np.inf
a['tenth'] = 0.1
a['list'] = np.arange(64.0)
a['too long'] = np.arange(65.0)
a['table'] = np.arange(6, dtype='>i4').reshape(2, 3)
a['none'] = h5py.Empty('f8')
a['empty list'] = np.zeros(0)
a['flag'] = True
a['complex'] = 1 + 2j
a['compound'] = np.zeros(1, dtype=[('a', 'i4')])
a['reference'] = f.ref
f.close()
)";

/// The file's own library, for calls that a helper process makes otherwise.
hid_t openedFile(const std::string &path)
{
    return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
}

} // namespace

class TestHdf5Attributes : public QObject
{
    Q_OBJECT

private:
    ScratchFolder m_folder;
    Hdf5Object m_root;

private slots:
    void initTestCase()
    {
        const std::string path = m_folder.file("attributes.h5");
        const PythonAnswer answer = python({"-c", kScript, QString::fromStdString(path)});
        QVERIFY2(answer.ran, answer.err.constData());
        const Result<Hdf5File> file = openHdf5(path, 20.0, {});
        QVERIFY(file);
        m_root = file->root();
        QVERIFY(m_root.tooManyAttributes == 0);
    }

    void texts_areReadHoweverTheyAreStored()
    {
        const std::map<std::string, std::string> all{{"text", "\xC3\xA5\xC3\x9F\xE2\x84\x96"},
            {"empty", ""}, {"lines", "one\ntwo"}, {"long", std::string(300000, 'x')},
            {"name of \xC3\xA5/b.c", "v"}, {"zero end", "abc"}, {"zero pad", "abcdefgh"},
            {"blank pad", "ab"}, {"blanks", "  ab"}, {"all blank", ""}, {"utf8", "\xC2\xB5V"},
            {"one text in a list", "x"}};
        for (const auto &[name, text] : all) {
            QVERIFY2(m_root.attributes.contains(name), name.c_str());
            QCOMPARE(m_root.attributes.at(name).kind, Hdf5ValueKind::Text);
            QCOMPARE(m_root.attributes.at(name).text, text);
        }
    }

    void numbers_areReadWhateverTheirType()
    {
        int count = 0;
        for (const auto &[name, value] : m_root.attributes) {
            if (!name.starts_with("number "))
                continue;
            ++count;
            const double wanted
                = name.find('u') == std::string::npos || name[8] != 'u' ? -8.0 : 200.0;
            QVERIFY2(value.numbers == std::vector{wanted}, name.c_str());
        }
        QCOMPARE(count, 12);
        QCOMPARE(numberAttribute(m_root, "most"), std::optional(0x1p64));
        QCOMPARE(numberAttribute(m_root, "tenth"), std::optional(0.1));
        QVERIFY(std::isnan(numberAttribute(m_root, "nan").value()));
        QVERIFY(std::isinf(numberAttribute(m_root, "infinite").value()));
        std::vector<double> list(64);
        for (std::size_t i = 0; i < list.size(); ++i)
            list[i] = static_cast<double>(i);
        QVERIFY(numbersAttribute(m_root, "list") == list);
        QVERIFY(numbersAttribute(m_root, "table") == (std::vector<double>{0, 1, 2, 3, 4, 5}));
    }

    /// They are there, so that nobody takes their absence for granted, but they say nothing.
    void otherValues_areNamedAndUnreadable()
    {
        for (const char *name : {"list of texts", "too long", "none", "empty list", "flag",
                 "complex", "compound", "reference"}) {
            QVERIFY2(m_root.attributes.contains(name), name);
            const Hdf5Value &value = m_root.attributes.at(name);
            QVERIFY2(value.kind == Hdf5ValueKind::Unreadable, name);
            QVERIFY2(value.text.empty() && value.numbers.empty(), name);
            QVERIFY2(isNoNumber(m_root, name), name);
        }
        QCOMPARE(m_root.attributes.size(), std::size_t(38));
    }

    void texts_ofTheRecord_areThoseThatSaySomething()
    {
        const auto texts = attributeTexts(m_root);
        QCOMPARE(texts.at("tenth"), std::string("0.1"));
        QCOMPARE(texts.at("number >i2"), std::string("-8"));
        QCOMPARE(texts.at("most"), std::string("18446744073709551616"));
        for (const char *name : {"nan", "list", "flag", "none"})
            QVERIFY2(!texts.contains(name), name);
    }

    /// One stored text may be an attribute of thousands of objects: it counts every time.
    void described_bytesAreCountedAndEndTheReading()
    {
        const std::string path = m_folder.file("many.h5");
        std::uint64_t content = 0;
        {
            const Hdf5TestFile file(path);
            for (int i = 0; i < 100; ++i) {
                const std::string name = std::string("attribute ").append(std::to_string(i));
                const std::string text(static_cast<std::size_t>(10 * i), 't');
                file.text("/", name, text);
                content += name.size() + text.size();
            }
        }
        const hid_t file = openedFile(path);
        const hid_t root = H5Gopen2(file, "/", H5P_DEFAULT);
        DescribedBytes all{0, ~std::uint64_t(0)};
        QCOMPARE(readAttributes(root, all).size(), std::size_t(100));
        QVERIFY(all.count >= content && all.count < content + 100 * 512 && !all.tooMany());
        std::size_t before = 101;
        for (const std::uint64_t most :
            {all.count, all.count - 1, all.count / 2, std::uint64_t(0)}) {
            DescribedBytes some{0, most};
            const std::size_t read = readAttributes(root, some).size();
            QVERIFY(read > 0 && read <= before);
            QCOMPARE(some.tooMany(), most < all.count);
            QVERIFY(some.count <= most + 2048); // never more than the one it ended with
            before = read;
        }
        H5Gclose(root);
        H5Fclose(file);
    }

    void names_thatAreNoneOrOfNoObject_giveNothing()
    {
        DescribedBytes bytes{0, 1000};
        QVERIFY(readAttributes(-1, bytes).empty());
        QCOMPARE(bytes.count, std::uint64_t(0));
        QVERIFY(hdf5RootAttributes(m_folder.file("none.h5")).empty());
        QVERIFY(hdf5RootAttributes(m_folder.write("text.h5", "no HDF5", 7)).empty());
        QCOMPARE(
            hdf5RootAttributes(m_folder.file("attributes.h5")).size(), m_root.attributes.size());
    }
};

DYNCAL_TEST(TestHdf5Attributes)
#include "tst_hdf5_attributes.moc"
