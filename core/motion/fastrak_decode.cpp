#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/linear/euler.hpp"
#include "core/motion/fastrak_items.hpp"

namespace percussionist::motion {

namespace {

constexpr std::size_t kHeader = 3;
constexpr double kDegree = std::numbers::pi / 180;

using Numbers = std::array<double, 4>;

/// What has been read of a record so far.
struct Partial {
    FastrakReading reading;
    linear::Matrix3 cosines = linear::Matrix3::Zero();
    unsigned cosine_items = 0;
};

std::optional<Numbers> get_numbers(std::span<const std::uint8_t> bytes, const Item& item,
                                   const FastrakLayout& layout) {
    const Notation notation = notation_of(item, layout.binary);
    const Scale scale = scale_of(item.what, layout.centimetres);
    const std::size_t size = size_of(notation);
    Numbers values{};
    for (std::size_t i = 0; i < numbers_in(item.what); ++i) {
        const auto value = get_number(bytes.subspan(i * size, size), notation, scale.full);
        if (!value) {
            return std::nullopt;
        }
        values[i] = *value * scale.unit;
    }
    return values;
}

bool in_reach(const Vector3& v) {
    return v.cwiseAbs().maxCoeff() <= kFastrakReach;
}

/// Text of four decimals is off by 5e-5 a number, 16BIT by 6e-5, float32 by less.
constexpr double kUnitTolerance = 2e-3;

bool take_cosines(const Numbers& v, int i, Partial& partial) {
    const Vector3 axis(v[0], v[1], v[2]);
    partial.cosines.col(i) = axis;
    partial.cosine_items |= 1U << i;
    return std::abs(axis.norm() - 1.0) < kUnitTolerance;
}

bool take_numbers(const Numbers& v, What what, Partial& partial) {
    FastrakReading& reading = partial.reading;
    const Vector3 triple(v[0], v[1], v[2]);
    switch (what) {
        case What::kPosition:
            reading.pose.position = triple;
            reading.has_position = true;
            return in_reach(triple);
        case What::kRelative:
            reading.relative = triple;
            return in_reach(triple);
        case What::kEuler:
            reading.pose.orientation = linear::to_quaternion({v[0], v[1], v[2]});
            reading.has_orientation = true;
            return std::abs(v[0]) < 181 * kDegree && std::abs(v[1]) < 91 * kDegree &&
                   std::abs(v[2]) < 181 * kDegree;
        case What::kX:
            return take_cosines(v, 0, partial);
        case What::kY:
            return take_cosines(v, 1, partial);
        case What::kZ:
            return take_cosines(v, 2, partial);
        default: {
            const Quaternion q(v[0], v[1], v[2], v[3]);
            reading.pose.orientation = q.normalized();
            reading.has_orientation = true;
            return std::abs(q.norm() - 1.0) < kUnitTolerance;
        }
    }
}

bool take_item(std::span<const std::uint8_t> bytes, const Item& item, const FastrakLayout& layout,
               Partial& partial) {
    switch (item.what) {
        case What::kBlank:
            return bytes[0] == ' ';
        case What::kLineEnd:
            return bytes[0] == '\r' && bytes[1] == '\n';
        case What::kButton:
            partial.reading.button = bytes[1] == '1';
            return bytes[0] == ' ' && (bytes[1] == '0' || bytes[1] == '1');
        default: {
            const auto values = get_numbers(bytes, item, layout);
            return values && take_numbers(*values, item.what, partial);
        }
    }
}

/// Bit 7 is set on the first 16BIT byte of a record and on no other.
bool sync_bits_right(std::span<const std::uint8_t> bytes, bool first) {
    return ((bytes[0] & 0x80) != 0) == first &&
           std::none_of(bytes.begin() + 1, bytes.end(),
                        [](std::uint8_t byte) { return (byte & 0x80) != 0; });
}

bool same_again(std::span<const std::uint8_t> before, std::span<const std::uint8_t> again,
                bool is_16bit) {
    const int mask = is_16bit ? 0x7F : 0xFF;
    return std::equal(before.begin(), before.end(), again.begin(),
                      [mask](int a, int b) { return (a & mask) == (b & mask); });
}

bool settle_cosines(Partial& partial, bool rows) {
    if (partial.cosine_items == 0) {
        return true;
    }
    const linear::Matrix3& m = partial.cosines;
    const bool rotation =
        (m.transpose() * m - linear::Matrix3::Identity()).norm() < 0.01 && m.determinant() > 0.0;
    if (partial.cosine_items != 7U || !rotation) {
        return false;
    }
    partial.reading.pose.orientation =
        Quaternion(rows ? linear::Matrix3(m.transpose()) : m).normalized();
    partial.reading.has_orientation = true;
    return true;
}

bool header_right(std::span<const std::uint8_t> record) {
    const auto error = static_cast<char>(record[2]);
    const bool letter = (error >= 'a' && error <= 'z') || (error >= 'A' && error <= 'Z');
    return record[0] == '0' && record[1] >= '1' && record[1] < '1' + kFastrakStations &&
           (error == ' ' || letter);
}

/// Where an item stood first in the record, to compare when it comes again.
const std::uint8_t* first_copy(const FastrakLayout& layout, std::size_t index,
                               std::span<const std::uint8_t> record) {
    std::size_t at = kHeader;
    for (std::size_t i = 0; i < index; ++i) {
        if (layout.items[i] == layout.items[index]) {
            return record.data() + at;
        }
        at += size_of(*find_item(layout.items[i]), layout.binary);
    }
    return nullptr;
}

}  // namespace

std::optional<FastrakReading> decode(std::span<const std::uint8_t> record,
                                     const FastrakLayout& layout) {
    if (record.size() != record_size(layout) || !header_right(record)) {
        return std::nullopt;
    }
    Partial partial;
    partial.reading.station = record[1] - '0';
    partial.reading.error = static_cast<char>(record[2]);
    std::size_t at = kHeader;
    bool synced = false;
    for (std::size_t i = 0; i < layout.items.size(); ++i) {
        const Item& item = *find_item(layout.items[i]);
        const auto bytes = record.subspan(at, size_of(item, layout.binary));
        at += bytes.size();
        if (item.is_16bit && !sync_bits_right(bytes, !std::exchange(synced, true))) {
            return std::nullopt;
        }
        const std::uint8_t* const before = first_copy(layout, i, record);
        const bool good = before ? same_again({before, bytes.size()}, bytes, item.is_16bit)
                                 : take_item(bytes, item, layout, partial);
        if (!good) {
            return std::nullopt;
        }
    }
    return settle_cosines(partial, layout.cosine_rows) ? std::optional(partial.reading)
                                                       : std::nullopt;
}

}  // namespace percussionist::motion
