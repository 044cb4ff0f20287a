#include <array>

#include "core/linear/euler.hpp"
#include "core/motion/fastrak_items.hpp"

namespace percussionist::motion {

namespace {

using Numbers = std::array<double, 4>;

Numbers numbers_of(const FastrakReading& reading, What what, bool cosine_rows) {
    const auto triple = [](const Vector3& v) { return Numbers{v.x(), v.y(), v.z(), 0.0}; };
    const auto cosines = [&](int i) {
        const linear::Matrix3 m = reading.pose.orientation.toRotationMatrix();
        return triple(cosine_rows ? Vector3(m.row(i)) : Vector3(m.col(i)));
    };
    switch (what) {
        case What::kPosition:
            return triple(reading.pose.position);
        case What::kRelative:
            return triple(reading.relative);
        case What::kEuler: {
            const auto e = linear::to_euler(reading.pose.orientation);
            return {e.azimuth, e.elevation, e.roll, 0.0};
        }
        case What::kX:
            return cosines(0);
        case What::kY:
            return cosines(1);
        case What::kZ:
            return cosines(2);
        default: {
            const Quaternion& q = reading.pose.orientation;
            return {q.w(), q.x(), q.y(), q.z()};
        }
    }
}

void put_item(const FastrakReading& reading, const Item& item, const FastrakLayout& layout,
              Bytes& out) {
    switch (item.what) {
        case What::kBlank:
            out.push_back(' ');
            return;
        case What::kLineEnd:
            out.insert(out.end(), {'\r', '\n'});
            return;
        case What::kButton:
            out.insert(out.end(), {' ', static_cast<std::uint8_t>(reading.button ? '1' : '0')});
            return;
        default:
            break;
    }
    const Scale scale = scale_of(item.what, layout.centimetres);
    const Numbers values = numbers_of(reading, item.what, layout.cosine_rows);
    const Notation notation = notation_of(item, layout.binary);
    for (std::size_t i = 0; i < numbers_in(item.what); ++i) {
        put_number(values[i] / scale.unit, notation, scale.full, out);
    }
}

}  // namespace

void encode(const FastrakReading& reading, const FastrakLayout& layout, Bytes& out) {
    out.insert(out.end(), {'0', static_cast<std::uint8_t>('0' + reading.station),
                           static_cast<std::uint8_t>(reading.error)});
    bool synced = false;
    for (const int code : layout.items) {
        const Item* const item = find_item(code);
        if (!item) {
            continue;
        }
        const std::size_t start = out.size();
        put_item(reading, *item, layout, out);
        if (item->is_16bit && !synced) {
            out[start] |= 0x80;
            synced = true;
        }
    }
}

}  // namespace percussionist::motion
