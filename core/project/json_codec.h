// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/auto_value.h"
#include "core/base/interval.h"
#include "core/base/message.h"
#include "core/project/recipe_key.h"
#include "core/project/strict_json.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dyncal {

/// A JSON value and where it stands, for messages. Internal to core/project.
struct JsonAt
{
    const Json &value;
    std::string path; ///< "window.end_s", "import.exclude[0].shot", "import.channels{DUT}.unit"
    const std::vector<std::string> &knownPaths; ///< of the whole document, list places as "[]",
                                                ///< free words as "{}"
};

/// How a value of type T is read from JSON and written as JSON. Values are checked only when they
/// are read; whatever is written can be read again.
template <typename T>
struct Codec
{
    std::string needs; ///< what it accepts, in words: "a number above 0"
    std::function<Result<T>(const JsonAt &)> read;
    std::function<Json(const T &)> write;
    std::vector<RecipeKey> keys = {}; ///< below: ".gamma", "[].shot"
};

/// "Recipe key %1 is %2; it needs %3."
tl::unexpected<Error> mismatch(const JsonAt &at, const std::string &needs);
/// "Recipe key %1 is unknown; ..." with the nearest known one.
tl::unexpected<Error> unknownKey(const JsonAt &at);
/// The value at `key` of an object.
JsonAt child(const JsonAt &object, const std::string &key);
/// The value at `key` of an object whose keys are free words.
JsonAt entry(const JsonAt &object, const std::string &key);

enum class Bound { Inclusive, Exclusive };

/// A finite number between two limits; the limits themselves count unless Exclusive.
Codec<double> number(double least, double most, Bound bound = Bound::Inclusive);
Codec<double> anyNumber();
Codec<double> positiveNumber();
Codec<double> nonNegativeNumber();
/// A whole number; 1e6 and 1000.0 count as whole, because many programs write whole numbers so.
Codec<Index> whole(Index least, Index most);
Codec<bool> boolean();
Codec<std::string> nonEmptyText();
Codec<std::string> anyText();
/// One of the words; "" stands for null in the JSON where `words` holds it.
Codec<std::string> oneOf(std::vector<std::string> words);
/// Two numbers, the smaller first.
Codec<Interval> interval();

template <typename E>
Codec<E> choice(std::vector<std::pair<std::string, E>> names)
{
    std::vector<std::string> words;
    words.reserve(names.size());
    for (const auto &[word, value] : names)
        words.push_back(word);
    Codec<std::string> inner = oneOf(words);
    const auto read = [inner, names](const JsonAt &at) -> Result<E> {
        const Result<std::string> found = inner.read(at);
        if (!found)
            return tl::unexpected<Error>(found.error());
        for (const auto &[word, value] : names) {
            if (word == *found)
                return value;
        }
        return mismatch(at, inner.needs);
    };
    const auto write = [names](const E &value) -> Json {
        for (const auto &[word, known] : names) {
            if (known == value)
                return word;
        }
        return nullptr;
    };
    return {inner.needs, read, write};
}

/// A word of its own that stands for "no value", or a value.
template <typename T>
Codec<std::optional<T>> valueOr(const Json &word, Codec<T> inner)
{
    const std::string needs = word.dump() + " or " + inner.needs;
    const auto read = [word, inner, needs](const JsonAt &at) -> Result<std::optional<T>> {
        if (at.value == word)
            return std::optional<T>();
        Result<T> value = inner.read(at);
        if (!value && !at.value.is_structured())
            return mismatch(at, needs); // the inner message would not name the word
        return value.map([](const T &v) { return std::optional<T>(v); });
    };
    const auto write = [word, inner](const std::optional<T> &value) {
        return value ? inner.write(*value) : word;
    };
    return {needs, read, write, inner.keys};
}

template <typename T>
Codec<std::optional<T>> orNull(Codec<T> inner)
{
    return valueOr(Json(nullptr), std::move(inner));
}

template <typename T>
Codec<Auto<T>> orAuto(Codec<T> inner)
{
    const Codec<std::optional<T>> plain = valueOr(Json("auto"), std::move(inner));
    const auto read = [plain](const JsonAt &at) -> Result<Auto<T>> {
        return plain.read(at).map([](const std::optional<T> &v) {
            Auto<T> setting;
            setting.value = v;
            return setting;
        });
    };
    const auto write = [plain](const Auto<T> &setting) { return plain.write(setting.value); };
    return {plain.needs, read, write, plain.keys};
}

/// A text that is not empty; its absence, "" in the struct, is written as null.
Codec<std::string> textOrNull();
/// The same where the text must have a form; `needs` says which, with the null.
Codec<std::string> formedTextOrNull(std::string needs, bool (*hasForm)(std::string_view));
Codec<std::string> dateOrNull(); ///< a day, as 2026-01-31

/// A list of at least `least` values.
template <typename T>
Codec<std::vector<T>> list(Codec<T> inner, std::size_t least = 0)
{
    const std::string needs
        = std::string(least > 0 ? "a list that is not empty, each value " : "a list, each value ")
        + inner.needs;
    const auto read = [inner, needs, least](const JsonAt &at) -> Result<std::vector<T>> {
        if (!at.value.is_array() || at.value.size() < least)
            return mismatch(at, needs);
        std::vector<T> values;
        for (std::size_t i = 0; i < at.value.size(); ++i) {
            Result<T> value
                = inner.read({at.value[i], at.path + "[" + std::to_string(i) + "]", at.knownPaths});
            if (!value)
                return tl::unexpected<Error>(value.error());
            values.push_back(std::move(*value));
        }
        return values;
    };
    const auto write = [inner](const std::vector<T> &values) {
        Json array = Json::array();
        for (const T &value : values)
            array.push_back(inner.write(value));
        return array;
    };
    std::vector<RecipeKey> keys;
    for (const RecipeKey &key : inner.keys)
        keys.push_back({"[]" + key.path, key.label});
    return {needs, read, write, keys};
}

/// An object whose keys are free words, or only those of `words` if that is not empty.
template <typename T>
Codec<std::map<std::string, T>> dictionary(
    Codec<T> inner, const std::string &keyName, const std::vector<RecipeKey> &words = {})
{
    const std::string needs = "an object from " + keyName + " to " + inner.needs;
    const auto read = [inner, needs, words](const JsonAt &at) -> Result<std::map<std::string, T>> {
        if (!at.value.is_object())
            return mismatch(at, needs);
        std::map<std::string, T> values;
        for (const auto &[key, json] : at.value.items()) {
            const JsonAt here = words.empty() ? entry(at, key) : child(at, key);
            const auto isKey = [&key = key](const RecipeKey &word) { return word.path == key; };
            if (!words.empty() && std::none_of(words.begin(), words.end(), isKey))
                return unknownKey(here);
            Result<T> value = inner.read(here);
            if (!value)
                return tl::unexpected<Error>(value.error());
            values.emplace(key, std::move(*value));
        }
        return values;
    };
    const auto write = [inner](const std::map<std::string, T> &values) {
        Json object = Json::object();
        for (const auto &[key, value] : values)
            object[key] = inner.write(value);
        return object;
    };
    std::vector<RecipeKey> keys;
    keys.reserve(words.size() + inner.keys.size());
    for (const RecipeKey &word : words)
        keys.push_back({"." + word.path, word.label});
    if (words.empty()) {
        for (const RecipeKey &key : inner.keys)
            keys.push_back({"{}" + key.path, key.label});
    }
    return {needs, read, write, keys};
}

/// One key of an object that becomes the struct S.
template <typename S>
struct Field
{
    std::string key;
    const char *label; ///< what the window calls it
    std::function<Result<void>(const JsonAt &, S &)> read;
    std::function<Json(const S &)> write;
    std::vector<RecipeKey> keys = {}; ///< below this one
    bool required = false;
    bool isLater = false; ///< see later()
};

/// A key that came after jobs had been issued: left out while it is null, so that what earlier
/// programs wrote, and the hash of an issued job with it, stays the same byte for byte.
template <typename S>
Field<S> later(Field<S> field)
{
    field.isLater = true;
    return field;
}

/// A key whose value is one member.
template <typename S, typename T>
Field<S> field(
    const char *key, const char *label, T S::*member, Codec<T> codec, bool required = false)
{
    // Shared: copies of what holds copies would grow with every level.
    const auto shared = std::make_shared<const Codec<T>>(std::move(codec));
    const auto read = [shared, member](const JsonAt &at, S &object) -> Result<void> {
        Result<T> value = shared->read(at);
        if (!value)
            return tl::unexpected<Error>(value.error());
        object.*member = std::move(*value);
        return {};
    };
    const auto write = [shared, member](const S &object) { return shared->write(object.*member); };
    return {key, label, read, write, shared->keys, required};
}

/// A key that is documented, and named in the window, elsewhere.
template <typename S, typename T>
Field<S> field(const char *key, T S::*member, Codec<T> codec, bool required = false)
{
    return field(key, "", member, std::move(codec), required);
}

/// An object with exactly these keys; one that is missing keeps the struct's own default.
template <typename S>
Codec<S> object(std::vector<Field<S>> fields)
{
    std::vector<RecipeKey> keys;
    for (const Field<S> &f : fields) {
        keys.push_back({"." + f.key, f.label});
        for (const RecipeKey &below : f.keys)
            keys.push_back({"." + f.key + below.path, below.label});
    }
    const auto shared = std::make_shared<const std::vector<Field<S>>>(std::move(fields));
    const auto read = [shared](const JsonAt &at) -> Result<S> {
        if (!at.value.is_object())
            return mismatch(at, "an object");
        for (const auto &[key, json] : at.value.items()) {
            const auto isKey = [&key = key](const Field<S> &f) { return f.key == key; };
            if (std::none_of(shared->begin(), shared->end(), isKey))
                return unknownKey(child(at, key));
        }
        S value;
        for (const Field<S> &f : *shared) {
            const bool given = at.value.contains(f.key);
            if (!given && f.required)
                return mismatch(at, "the key \"" + f.key + "\"");
            if (!given)
                continue;
            if (const Result<void> done = f.read(child(at, f.key), value); !done)
                return tl::unexpected<Error>(done.error());
        }
        return value;
    };
    const auto write = [shared](const S &value) {
        Json json = Json::object();
        for (const Field<S> &f : *shared)
            if (Json content = f.write(value); !f.isLater || !content.is_null())
                json[f.key] = std::move(content);
        return json;
    };
    return {"an object", read, write, keys};
}

} // namespace dyncal
