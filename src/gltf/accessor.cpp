// SPDX-License-Identifier: MIT
#include "gltf/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "gltf/little_endian.hpp"

namespace vitrine {
namespace {

struct Shape {
    std::string_view name;
    int components;
    int columns;  // of a matrix; 1 else
};
constexpr std::array<Shape, 7> kShapes{{{"SCALAR", 1, 1},
                                        {"VEC2", 2, 1},
                                        {"VEC3", 3, 1},
                                        {"VEC4", 4, 1},
                                        {"MAT2", 4, 2},
                                        {"MAT3", 9, 3},
                                        {"MAT4", 16, 4}}};

size_t bytesOf(ComponentType type) {
    switch (type) {
        case ComponentType::kByte:
        case ComponentType::kUnsignedByte:
            return 1;
        case ComponentType::kShort:
        case ComponentType::kUnsignedShort:
            return 2;
        case ComponentType::kUnsignedInt:
        case ComponentType::kFloat:
            return 4;
    }
    return 0;
}

std::optional<ComponentType> componentType(const JsonValue& object) {
    const auto number = object.requiredWhole("componentType");
    if (!number) return {};
    if (*number <= 0xffff)
        if (const auto type = static_cast<ComponentType>(*number); bytesOf(type) != 0) return type;
    object.error("componentType", fmt::format("{} is no component type", *number));
    return {};
}

std::optional<Shape> shapeOf(const JsonValue& object) {
    const std::string name = object.text("type");
    for (const Shape& shape : kShapes)
        if (shape.name == name) return shape;
    object.error("type", fmt::format("{} is no type of accessor", inQuotes(name)));
    return {};
}

/// The columns of a matrix begin at multiples of four bytes.
size_t elementBytes(const Shape& shape, ComponentType type) {
    const size_t column = shape.components / shape.columns * bytesOf(type);
    return shape.columns == 1 ? column : shape.columns * ((column + 3) / 4 * 4);
}

/// Where `count` elements begin in a bufferView; null, with an error, if they are not inside of it.
const char* locate(const JsonValue& object, const BufferView& view, uint64_t count, uint64_t stride,
                   size_t element, size_t component) {
    const uint64_t offset = object.whole("byteOffset", 0);
    if (offset % component != 0 || (view.offset + offset) % component != 0) {
        object.error("byteOffset",
                     fmt::format("{} (byte {} of the buffer) is not a multiple of the "
                                 "component's {} bytes",
                                 offset, view.offset + offset, component));
        return nullptr;
    }
    if (stride < element) {
        object.error(fmt::format("an element has {} bytes, but the bufferView's byteStride is {}",
                                 element, stride));
        return nullptr;
    }
    // count < 2^32, stride <= 252, offset <= 2^53: nothing can wrap.
    const uint64_t end = offset + (count - 1) * stride + element;
    if (end > view.bytes.size()) {
        object.error(fmt::format("{} elements end at byte {} of a bufferView of {}", count, end,
                                 view.bytes.size()));
        return nullptr;
    }
    return view.bytes.data() + offset;
}

template <typename T>
uint32_t loadWhole(const char* from) {
    return loadLittleEndian<T>(from);
}

std::vector<uint32_t> loadWholes(const char* from, size_t count, size_t stride,
                                 ComponentType type) {
    auto* load = &loadWhole<uint8_t>;
    if (type == ComponentType::kUnsignedShort) load = &loadWhole<uint16_t>;
    if (type == ComponentType::kUnsignedInt) load = &loadWhole<uint32_t>;
    std::vector<uint32_t> result(count);
    for (size_t i = 0; i < count; ++i) result[i] = load(from + i * stride);
    return result;
}

template <typename T>
float loadFloat(const char* from) {
    return static_cast<float>(loadLittleEndian<T>(from));
}

/// The largest number stands for 1, and so does the smallest for -1, though it is one further.
template <typename T>
float loadNormalized(const char* from) {
    return std::max(loadFloat<T>(from) / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

using LoadFloat = float (*)(const char*);

LoadFloat floatLoader(ComponentType type, bool isNormalized) {
    switch (type) {
        case ComponentType::kByte:
            return isNormalized ? loadNormalized<int8_t> : loadFloat<int8_t>;
        case ComponentType::kUnsignedByte:
            return isNormalized ? loadNormalized<uint8_t> : loadFloat<uint8_t>;
        case ComponentType::kShort:
            return isNormalized ? loadNormalized<int16_t> : loadFloat<int16_t>;
        case ComponentType::kUnsignedShort:
            return isNormalized ? loadNormalized<uint16_t> : loadFloat<uint16_t>;
        case ComponentType::kUnsignedInt:
            return loadFloat<uint32_t>;
        case ComponentType::kFloat:
            break;
    }
    return loadFloat<float>;
}

class AccessorReader {
  public:
    AccessorReader(ReadContext& context, const Buffers& buffers)
        : context_(context), buffers_(buffers) {}

    Accessor read(const JsonValue& object) {
        Accessor result;
        if (!object.exists()) return result;
        const auto type = componentType(object);
        const auto shape = shapeOf(object);
        const auto count = readCount(object);
        result.isNormalized = object.flag("normalized", false);
        if (!type || !shape || !count) return result;
        if (result.isNormalized && bytesOf(*type) == 4) {
            object.error("normalized", "only bytes and shorts can be normalized");
            return result;
        }
        result.count = *count;
        result.type = *type;
        result.components = shape->components;
        result.isMatrix = shape->columns > 1;
        const size_t element = elementBytes(*shape, *type);
        result.stride = static_cast<uint32_t>(element);
        if (object.has("bufferView")) {
            const BufferView* view = buffers_.findView(object);
            if (view == nullptr) return result;
            result.isInterleaved = view->stride != 0;
            if (result.isInterleaved) result.stride = view->stride;
            result.data = locate(object, *view, *count, result.stride, element, bytesOf(*type));
            if (result.data == nullptr) return result;
        } else if (!context_.spend(&GltfLimits::emptyElements, *count,
                                   "elements without a bufferView", object)) {
            return result;
        }
        const JsonValue sparse = object.object("sparse");
        result.isValid = !sparse.exists() || readSparse(sparse, element, result);
        return result;
    }

  private:
    static std::optional<uint32_t> readCount(const JsonValue& object) {
        const auto count = object.requiredWhole("count");
        if (!count) return {};
        if (*count >= 1 && *count <= std::numeric_limits<uint32_t>::max())
            return static_cast<uint32_t>(*count);
        object.error("count", fmt::format("{} is not from 1 to 2^32 - 1", *count));
        return {};
    }

    bool readSparse(const JsonValue& sparse, size_t element, Accessor& result) {
        const auto count = readCount(sparse);
        const JsonValue indices = sparse.object("indices"), values = sparse.object("values");
        if (!indices.exists() || !values.exists())
            sparse.error("'indices' and 'values' must both be there");
        if (!count || !indices.exists() || !values.exists()) return false;
        if (*count > result.count) {
            sparse.error("count",
                         fmt::format("{} elements of {} cannot be replaced", *count, result.count));
            return false;
        }
        const auto type = componentType(indices);
        const BufferView* indexView = buffers_.findView(indices);
        const BufferView* valueView = buffers_.findView(values);
        if (!type || indexView == nullptr || valueView == nullptr) return false;
        if (*type != ComponentType::kUnsignedByte && *type != ComponentType::kUnsignedShort &&
            *type != ComponentType::kUnsignedInt) {
            indices.error("componentType", "indices are whole numbers without sign");
            return false;
        }
        const size_t indexBytes = bytesOf(*type);
        const char* from = locate(indices, *indexView, *count, indexBytes, indexBytes, indexBytes);
        result.sparse.values =
            locate(values, *valueView, *count, element, element, bytesOf(result.type));
        if (from == nullptr || result.sparse.values == nullptr ||
            !context_.spend(&GltfLimits::vertices, *count, "vertices and replaced elements",
                            sparse))
            return false;
        result.sparse.count = *count;
        result.sparse.indices = loadWholes(from, *count, indexBytes, *type);
        return areGood(indices, result);
    }

    static bool areGood(const JsonValue& place, const Accessor& accessor) {
        const std::vector<uint32_t>& indices = accessor.sparse.indices;
        for (size_t i = 0; i < indices.size(); ++i) {
            if (i > 0 && indices[i] <= indices[i - 1]) {
                place.error(fmt::format("index {} at {} does not grow", indices[i], i));
                return false;
            }
            if (indices[i] >= accessor.count) {
                place.error(fmt::format("index {} at {} is out of range: there are {} elements",
                                        indices[i], i, accessor.count));
                return false;
            }
        }
        return true;
    }

    ReadContext& context_;
    const Buffers& buffers_;
};

}  // namespace

void Accessor::readInto(uint32_t first, uint32_t length, int n, float* to) const {
    const LoadFloat load = floatLoader(type, isNormalized);
    const size_t componentBytes = bytesOf(type);
    const int both = std::min(n, components);
    const auto readElement = [&](const char* from, float* target) {
        for (int c = 0; c < both; ++c) target[c] = load(from + c * componentBytes);
    };
    for (uint32_t i = 0; i < length; ++i) {
        float* target = to + static_cast<size_t>(i) * n;
        if (data != nullptr)
            readElement(data + static_cast<size_t>(first + i) * stride, target);
        else
            std::fill_n(target, both, 0.0f);
    }
    const size_t valueBytes = components * componentBytes;
    const auto begin = std::lower_bound(sparse.indices.begin(), sparse.indices.end(), first);
    for (auto it = begin; it != sparse.indices.end() && *it - first < length; ++it)
        readElement(sparse.values + (it - sparse.indices.begin()) * valueBytes,
                    to + static_cast<size_t>(*it - first) * n);
}

std::vector<uint32_t> Accessor::readWhole() const {
    std::vector<uint32_t> result =
        data != nullptr ? loadWholes(data, count, stride, type) : std::vector<uint32_t>(count, 0);
    if (sparse.count == 0) return result;
    const auto values = loadWholes(sparse.values, sparse.count, bytesOf(type), type);
    for (size_t i = 0; i < values.size(); ++i) result[sparse.indices[i]] = values[i];
    return result;
}

Accessors::Accessors(ReadContext& context, const Buffers& buffers) {
    const JsonValue list = context.root.array("accessors");
    AccessorReader reader(context, buffers);
    for (size_t i = 0; i < list.size(); ++i) accessors_.push_back(reader.read(list.objectAt(i)));
}

const Accessor* Accessors::find(const JsonValue& object, std::string_view key) const {
    const int index = object.index(key, accessors_.size());
    return index != kNoIndex && accessors_[index].isValid ? &accessors_[index] : nullptr;
}

}  // namespace vitrine
