// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/raw_samples.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

// What an HDF5 file holds, as plain values: read by a helper process (hdf5_describe.h), passed on
// as bytes, and interpreted here without the library.

enum class Hdf5ValueKind { Text, Numbers, Unreadable };

/// Value of an attribute. Lists of texts, long lists and other types are Unreadable.
struct Hdf5Value
{
    Hdf5ValueKind kind = Hdf5ValueKind::Unreadable;
    std::string text;
    std::vector<double> numbers;
};

using Hdf5Attributes = std::map<std::string, Hdf5Value>;

/// Why a dataset cannot be samples.
enum class Hdf5Obstacle {
    None,
    NotNumbers, ///< text, compound, reference, ...
    Shape, ///< more than two dimensions
    Elsewhere, ///< in other files (external or virtual)
    Incomplete, ///< claims more than the file stores
    Filter, ///< a filter that is not installed
    LargeChunk, ///< compressed in chunks that must be unpacked over and over
    TooLarge, ///< more to unpack than the program accepts
    OverBudget, ///< more to unpack than a file of this size may (ExpansionBudget)
};

/// Where the numbers of a dataset are.
enum class Hdf5Storage {
    Nowhere, ///< see obstacle
    InFile, ///< as they are, in blocks
    Packed, ///< compressed, or of a type that must be converted: the library must unpack them
};

/// How exactly the numbers are those of the file.
enum class Hdf5Fidelity {
    Exact, ///< of the same type
    Widened, ///< of a type that keeps every value
    MayRound, ///< 64 bit integers as double: exact below 2^53, refused from there
};

struct Hdf5Dataset
{
    std::string typeText; ///< for people: "uint16 big-endian"
    std::vector<std::uint64_t> shape; ///< empty = one value
    Hdf5Obstacle obstacle = Hdf5Obstacle::NotNumbers;
    std::int32_t missingFilter = 0;
    std::string elsewhere; ///< the other file, where the samples are Elsewhere
    std::uint64_t unpackedBytes = 0; ///< what all chunks become; of Packed and OverBudget
    std::uint64_t allowedBytes = 0; ///< of OverBudget
    std::uint64_t chunkBytes = 0; ///< of Packed: a chunk, which is unpacked as a whole
    Hdf5Storage storage = Hdf5Storage::Nowhere;
    SampleType type = SampleType::Float64; ///< as in the file, or as unpacked
    Hdf5Fidelity fidelity = Hdf5Fidelity::Exact;
    std::uint8_t bigEndian = 0;
    /// InFile: shape of a block and where each begins in the file, row by row of blocks.
    std::vector<std::uint64_t> blockShape;
    std::vector<std::uint64_t> blockOffsets;

    std::uint64_t elements() const; ///< saturates
};

/// One member of a group.
struct Hdf5Link
{
    std::string name;
    Index target = 0; ///< position in Hdf5Tree::objects, or one of the two below

    static constexpr Index kElsewhere = -1; ///< a soft, external or user-defined link
    static constexpr Index kNotRead = -2; ///< nested too deep, too many, or no group nor dataset
};

struct Hdf5Object
{
    std::uint8_t isDataset = 0;
    std::uint8_t tooManyAttributes = 0; ///< then attributes is empty
    std::uint64_t address = 0; ///< for asking the helper again
    Hdf5Attributes attributes;
    std::vector<Hdf5Link> links; ///< of a group: in order of creation where known, else natural
    Hdf5Dataset dataset;
};

struct Hdf5Tree
{
    std::vector<Hdf5Object> objects; ///< the first is the root; hard links may make cycles
    /// If not 0: names and attributes have at least so many bytes, which is too much for a file of
    /// this size, and some objects are missing here.
    std::uint64_t tooManyBytes = 0;
};

/// Copies of a description in memory: as tree and as bytes, in helper and program; vectors double.
constexpr std::uint64_t kDescriptionCopies = 8;

std::vector<std::byte> packed(const Hdf5Tree &tree);

/// Empty if the bytes are no tree. All positions and kinds are checked, so that walking the tree is
/// safe except for cycles of links. The claims of datasets are not checked here.
std::optional<Hdf5Tree> unpackedTree(std::span<const std::byte> bytes);

/// Member of that name, or null.
const Hdf5Object *memberOf(const Hdf5Tree &tree, const Hdf5Object &group, const std::string &name);

/// The object at an absolute path like "/shots/001/channels/DUT", or null.
const Hdf5Object *objectAt(const Hdf5Tree &tree, std::string_view path);

// Attributes: empty if there is none of that name and kind.

/// Text; a number becomes its shortest round-trip text.
std::optional<std::string> textAttribute(const Hdf5Object &object, const std::string &name);
/// One number, or text that is a number.
std::optional<double> numberAttribute(const Hdf5Object &object, const std::string &name);
/// Whether there is an attribute of that name that holds no number; its absence is fine.
bool isNoNumber(const Hdf5Object &object, const std::string &name);
std::vector<double> numbersAttribute(const Hdf5Object &object, const std::string &name);
/// All that are one number or text. NaN (not recorded) is left out.
std::map<std::string, std::string> attributeTexts(const Hdf5Object &object);

} // namespace dyncal
