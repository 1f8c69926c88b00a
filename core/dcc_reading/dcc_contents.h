// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/dcc_reading/d_si_quantity.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// A quantity of the results, as the certificate names it.
struct StatedQuantity
{
    std::string id;
    std::string name; ///< in English, else as it stands first
    std::vector<std::string> refTypes;
    Index line = 0; ///< of the file
    DSiQuantity stated;

    bool hasRefType(std::string_view refType) const;
    bool isComplex() const { return stated.phases_rad.has_value(); }
};

/// A quantity of the results that is not understood: what it might be.
struct UnreadQuantity
{
    std::string name;
    std::vector<std::string> refTypes;
    Index line = 0;
    std::optional<DSiUnit> unit = {}; ///< empty: not known, or not one
    /// Whether that names what neither frequencies nor angles have: a volt, a pascal, a decibel.
    bool isNoAxis = false;

    bool hasRefType(std::string_view refType) const;
};

/// Words that stand in a list beside its quantities.
struct StatedWords
{
    std::vector<std::string> refTypes;
    std::vector<std::string> entries; ///< those in English, and those of no language
};

/// A list of the results: quantities side by side, row by row.
struct StatedTable
{
    std::string id;
    std::string name; ///< its own, else that of its result
    std::vector<std::string> refTypes; ///< its own, else those of its result
    Index line = 0;
    std::vector<StatedQuantity> columns = {};
    std::vector<StatedWords> words = {};
    std::vector<Message> notUnderstood = {}; ///< a sentence for each quantity that is left out
    std::vector<UnreadQuantity> unread = {}; ///< those that are left out
};

/// Something that was calibrated.
struct CalibratedItem
{
    std::string name, manufacturer, model;
    std::string serial; ///< empty: none is stated, or not which of its numbers it is
    std::vector<std::string> numbers; ///< all that identify it
};

/// A digital calibration certificate, as far as it is understood.
struct DccContents
{
    std::string version; ///< of its schema, "3.3.0"
    std::string software = {}; ///< that wrote it: the first that it names
    std::string number = {};
    /// Days of the calibration and of the issue; "" = none.
    std::string begun = {}, ended = {}, issued = {};
    std::string laboratory = {}, customer = {};
    std::vector<CalibratedItem> items = {};
    std::vector<StatedTable> tables = {};
    std::vector<StatedQuantity> single = {}; ///< results that stand in no list
    std::vector<Message> notUnderstood = {}; ///< of the single ones: a sentence for each left out
    std::vector<UnreadQuantity> unread = {}; ///< of the single ones: those that are left out
};

/// Reads a certificate of the PTB's schema, version 3.0 to 3.3, whatever prefixes its namespaces
/// have. Quantities are those of measurementResults/measurementResult/results/result/data, in lists
/// at any depth; what stands in influence conditions, metadata and equipment is not a result. Words
/// (noQuantity, charsXMLList) are no quantities. A relative uncertainty, which has no k, is not
/// taken, and named. A quantity with an element of another namespace in it is not understood, and
/// other elements of another one are none. A serial number is the identification with the refType
/// basic_serialNumber, else the only one whose name says so, else the only one of the manufacturer.
/// Fails (FileUnreadable) as readXml(), and where it is no certificate or of another version.
Result<DccContents> readDcc(std::string_view bytes);

} // namespace dyncal
