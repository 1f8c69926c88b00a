// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a helper process hands over about a file: it comes back whole, and whatever else arrives is
// not believed.

#include "core/capture/formats/hdf5/hdf5_tree.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace dyncal;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Hdf5Value text(const std::string &value)
{
    return {Hdf5ValueKind::Text, value, {}};
}

Hdf5Value numbers(std::vector<double> values)
{
    return {Hdf5ValueKind::Numbers, {}, std::move(values)};
}

/// A root with two groups, a circle and a dataset with something in every field.
Hdf5Tree someTree()
{
    Hdf5Tree tree;
    tree.objects.resize(4);
    tree.objects[0].links = {{"shots", 1}, {"setup", 2}, {"away", Hdf5Link::kElsewhere}};
    tree.objects[0].attributes = {{"format", text("x")}, {"list", numbers({1.0, -0.0, kNan})},
        {"", {}}, {"\xC3\xA5", text(std::string("a\0b", 3))}};
    tree.objects[1].links = {{"dut", 3}, {"up", 0}, {"deep", Hdf5Link::kNotRead}};
    tree.objects[1].address = ~std::uint64_t(0);
    tree.objects[2].tooManyAttributes = 1;
    tree.objects[3].isDataset = 1;
    Hdf5Dataset &dataset = tree.objects[3].dataset;
    dataset = {"uint16 big-endian", {100, 2}, Hdf5Obstacle::None, 307, "other.h5", 11, 12, 13,
        Hdf5Storage::InFile, SampleType::UInt16, Hdf5Fidelity::MayRound, 1, {50, 1},
        {1000, 2000, 3000, 4000}};
    tree.tooManyBytes = 5;
    return tree;
}

void isSame(const Hdf5Object &a, const Hdf5Object &b)
{
    QCOMPARE(a.isDataset, b.isDataset);
    QCOMPARE(a.tooManyAttributes, b.tooManyAttributes);
    QCOMPARE(a.address, b.address);
    QCOMPARE(a.links.size(), b.links.size());
    for (std::size_t i = 0; i < a.links.size(); ++i) {
        QCOMPARE(a.links[i].name, b.links[i].name);
        QCOMPARE(a.links[i].target, b.links[i].target);
    }
    QCOMPARE(a.attributes.size(), b.attributes.size());
    for (const auto &[name, value] : a.attributes) {
        const Hdf5Value &other = b.attributes.at(name);
        QCOMPARE(other.kind, value.kind);
        QCOMPARE(other.text, value.text);
        QCOMPARE(other.numbers.size(), value.numbers.size());
        for (std::size_t i = 0; i < value.numbers.size(); ++i)
            QCOMPARE(std::bit_cast<std::uint64_t>(other.numbers[i]),
                std::bit_cast<std::uint64_t>(value.numbers[i]));
    }
    const Hdf5Dataset &one = a.dataset;
    const Hdf5Dataset &two = b.dataset;
    QCOMPARE(one.typeText, two.typeText);
    QCOMPARE(one.elsewhere, two.elsewhere);
    QVERIFY(one.shape == two.shape && one.blockShape == two.blockShape);
    QVERIFY(one.blockOffsets == two.blockOffsets && one.missingFilter == two.missingFilter);
    QVERIFY(one.obstacle == two.obstacle && one.storage == two.storage && one.type == two.type);
    QVERIFY(one.fidelity == two.fidelity && one.bigEndian == two.bigEndian);
    QVERIFY(one.unpackedBytes == two.unpackedBytes && one.allowedBytes == two.allowedBytes
        && one.chunkBytes == two.chunkBytes);
}

/// What whoever walks the tree relies on.
bool isSafe(const Hdf5Tree &tree)
{
    const auto objects = static_cast<Index>(tree.objects.size());
    return !tree.objects.empty()
        && std::ranges::all_of(tree.objects, [&](const Hdf5Object &object) {
               const Hdf5Dataset &dataset = object.dataset;
               return std::ranges::all_of(object.links,
                          [&](const Hdf5Link &link) {
                              return link.target >= -2 && link.target < objects;
                          })
                   && dataset.type >= SampleType::Int16 && dataset.type <= SampleType::UInt16
                   && dataset.storage >= Hdf5Storage::Nowhere
                   && dataset.storage <= Hdf5Storage::Packed
                   && (dataset.storage == Hdf5Storage::Nowhere)
                   == (dataset.obstacle != Hdf5Obstacle::None);
           });
}

} // namespace

class TestHdf5Tree : public QObject
{
    Q_OBJECT

private slots:
    void tree_comesBackWhole()
    {
        const Hdf5Tree tree = someTree();
        const auto again = unpackedTree(packed(tree));
        QVERIFY(again);
        QCOMPARE(again->tooManyBytes, std::uint64_t(5));
        QCOMPARE(again->objects.size(), tree.objects.size());
        for (std::size_t i = 0; i < tree.objects.size(); ++i)
            isSame(again->objects[i], tree.objects[i]);
        QVERIFY(packed(*again) == packed(tree));
    }

    void tree_cutOrContinuedAnywhere_isNone()
    {
        std::vector<std::byte> bytes = packed(someTree());
        for (std::size_t size = 0; size < bytes.size(); ++size)
            QVERIFY(!unpackedTree(std::span(bytes).first(size)));
        bytes.push_back(std::byte{0});
        QVERIFY(!unpackedTree(bytes));
        QVERIFY(!unpackedTree(packed(Hdf5Tree()))); // without a root there is nothing to walk
    }

    void everyWrongByte_givesNoTreeOrASafeOne()
    {
        const std::vector<std::byte> whole = packed(someTree());
        int refused = 0;
        for (std::size_t at = 0; at < whole.size(); ++at)
            for (const int wrong : {0x00, 0x01, 0x07, 0x7f, 0x80, 0xff}) {
                std::vector<std::byte> bytes = whole;
                bytes[at] = static_cast<std::byte>(wrong);
                const auto tree = unpackedTree(bytes);
                refused += tree ? 0 : 1;
                QVERIFY(!tree || isSafe(*tree));
            }
        QVERIFY(refused > 500);
    }

    void manyWrongBytes_giveNoTreeOrASafeOne()
    {
        const std::vector<std::byte> whole = packed(someTree());
        std::mt19937 random(5);
        for (int trial = 0; trial < 20000; ++trial) {
            std::vector<std::byte> bytes = whole;
            for (auto count = 2 + random() % 6; count > 0; --count)
                bytes[random() % bytes.size()]
                    = static_cast<std::byte>(random() % 4 == 0 ? random() : random() % 3);
            const auto tree = unpackedTree(bytes);
            QVERIFY(!tree || isSafe(*tree));
        }
    }

    void targetsAndKindsBeyondTheirRange_areNotBelieved()
    {
        const auto isBelieved = [](auto &&change) {
            Hdf5Tree tree = someTree();
            change(tree);
            return unpackedTree(packed(tree)).has_value();
        };
        for (const Index target : {-3, 4, 1000})
            QVERIFY(!isBelieved([&](Hdf5Tree &tree) { tree.objects[1].links[0].target = target; }));
        for (const Index target : {-2, -1, 0, 3})
            QVERIFY(isBelieved([&](Hdf5Tree &tree) { tree.objects[1].links[0].target = target; }));
        const auto dataset
            = [](Hdf5Tree &tree) -> Hdf5Dataset & { return tree.objects[3].dataset; };
        for (const int wrong : {-1, 7, 1 << 20})
            QVERIFY(!isBelieved(
                [&](Hdf5Tree &tree) { dataset(tree).type = static_cast<SampleType>(wrong); }));
        QVERIFY(!isBelieved([&](Hdf5Tree &tree) { dataset(tree).storage = Hdf5Storage::Nowhere; }));
        QVERIFY(!isBelieved([&](Hdf5Tree &tree) { dataset(tree).obstacle = Hdf5Obstacle::Shape; }));
        QVERIFY(!isBelieved([&](Hdf5Tree &tree) {
            tree.objects[0].attributes["format"].kind = static_cast<Hdf5ValueKind>(3);
        }));
    }

    void objects_areFoundByTheirPaths()
    {
        const Hdf5Tree tree = someTree();
        const auto found = [&](const char *path) -> Index {
            const Hdf5Object *object = objectAt(tree, path);
            return object != nullptr ? object - tree.objects.data() : -1;
        };
        QCOMPARE(found(""), Index(0));
        QCOMPARE(found("/shots"), Index(1));
        QCOMPARE(found("/shots/dut"), Index(3));
        QCOMPARE(found("/shots/up/shots/up/setup"), Index(2)); // through the circle
        for (const char *path : {"/none", "/shots/none", "/shots/dut/x", "/away", "/away/x",
                 "/shots/deep", "/shot", "/shots2", "//shots", "/shots/"})
            QCOMPARE(found(path), Index(-1));
    }

    void attributes_areTakenAsWhatIsAskedFor()
    {
        Hdf5Object object;
        object.attributes = {{"word", text("DUT")}, {"digits", text("2.5e3")},
            {"one", numbers({0.1})}, {"two", numbers({1.0, 2.0})}, {"nan", numbers({kNan})},
            {"other", {}}, {"empty", text("")}, {"comma", text("2,5")}};
        QCOMPARE(textAttribute(object, "word"), std::optional<std::string>("DUT"));
        QCOMPARE(textAttribute(object, "one"), std::optional<std::string>("0.1"));
        QVERIFY(!textAttribute(object, "two") && !textAttribute(object, "other"));
        QVERIFY(!textAttribute(object, "none") && textAttribute(object, "empty") == "");
        QCOMPARE(numberAttribute(object, "digits"), std::optional(2500.0));
        QCOMPARE(numberAttribute(object, "one"), std::optional(0.1));
        QVERIFY(std::isnan(numberAttribute(object, "nan").value()));
        for (const char *name : {"word", "two", "other", "empty", "comma"}) {
            QVERIFY2(!numberAttribute(object, name), name);
            QVERIFY2(isNoNumber(object, name), name);
        }
        for (const char *name : {"digits", "one", "nan", "none"})
            QVERIFY2(!isNoNumber(object, name), name);
        QVERIFY(numbersAttribute(object, "two") == (std::vector{1.0, 2.0}));
        QVERIFY(numbersAttribute(object, "none").empty());
        const auto texts = attributeTexts(object); // NaN says that nothing was recorded
        QCOMPARE(texts,
            (std::map<std::string, std::string>{{"word", "DUT"}, {"digits", "2.5e3"},
                {"one", "0.1"}, {"empty", ""}, {"comma", "2,5"}}));
    }

    void elements_doNotOverflow()
    {
        Hdf5Dataset dataset;
        QCOMPARE(dataset.elements(), std::uint64_t(1));
        constexpr std::uint64_t kMost = ~std::uint64_t(0);
        constexpr std::uint64_t kHalf = std::uint64_t(1) << 32;
        for (const auto &[shape, elements] :
            std::vector<std::pair<std::vector<std::uint64_t>, std::uint64_t>>{{{7}, 7}, {{7, 0}, 0},
                {{0, kMost}, 0}, {{kMost, 0, kMost}, 0}, {{kHalf, kHalf}, kMost},
                {{kHalf, kHalf - 1}, kHalf * (kHalf - 1)}, {{kMost, 1}, kMost}, {{kMost, 2}, kMost},
                {{3, kMost / 3}, kMost}}) {
            dataset.shape = shape;
            QCOMPARE(dataset.elements(), elements);
        }
    }
};

DYNCAL_TEST(TestHdf5Tree)
#include "tst_hdf5_tree.moc"
