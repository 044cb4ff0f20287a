#include "core/motion/fastrak_items.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace percussionist::motion {

namespace {

constexpr std::size_t kHeader = 3;
constexpr double kDegree = std::numbers::pi / 180;

constexpr std::array kItems = {
    Item{0, What::kBlank, false, false},       Item{50, What::kBlank, false, false},
    Item{1, What::kLineEnd, false, false},     Item{51, What::kLineEnd, false, false},
    Item{2, What::kPosition, false, false},    Item{52, What::kPosition, true, false},
    Item{18, What::kPosition, false, true},    Item{3, What::kRelative, false, false},
    Item{53, What::kRelative, true, false},    Item{4, What::kEuler, false, false},
    Item{54, What::kEuler, true, false},       Item{19, What::kEuler, false, true},
    Item{5, What::kX, false, false},           Item{55, What::kX, true, false},
    Item{6, What::kY, false, false},           Item{56, What::kY, true, false},
    Item{7, What::kZ, false, false},           Item{57, What::kZ, true, false},
    Item{11, What::kQuaternion, false, false}, Item{61, What::kQuaternion, true, false},
    Item{20, What::kQuaternion, false, true},  Item{16, What::kButton, false, false},
    Item{66, What::kButton, false, false}};

}  // namespace

const Item* find_item(int code) {
    const auto* const found = std::find_if(kItems.begin(), kItems.end(),
                                           [code](const Item& item) { return item.code == code; });
    return found == kItems.end() ? nullptr : found;
}

std::size_t numbers_in(What what) {
    switch (what) {
        case What::kBlank:
        case What::kLineEnd:
        case What::kButton:
            return 0;
        case What::kQuaternion:
            return 4;
        default:
            return 3;
    }
}

Notation notation_of(const Item& item, bool binary) {
    if (item.is_16bit) {
        return Notation::k16Bit;
    }
    if (binary) {
        return Notation::kFloat32;
    }
    if (item.extended) {
        return Notation::kExtended;
    }
    const bool coarse =
        item.what == What::kPosition || item.what == What::kRelative || item.what == What::kEuler;
    return coarse ? Notation::kTwoDecimals : Notation::kFourDecimals;
}

std::size_t size_of(const Item& item, bool binary) {
    if (item.what == What::kBlank) {
        return 1;
    }
    const std::size_t numbers = numbers_in(item.what);
    return numbers == 0 ? 2 : numbers * size_of(notation_of(item, binary));
}

Scale scale_of(What what, bool centimetres) {
    switch (what) {
        case What::kPosition:
        case What::kRelative:
            return centimetres ? Scale{0.01, 300.0} : Scale{0.0254, 118.110};
        case What::kEuler:
            return {kDegree, 180.0};
        default:
            return {1.0, 1.0};
    }
}

bool is_fastrak_item(int item) {
    return find_item(item) != nullptr;
}

std::optional<std::size_t> record_size(const FastrakLayout& layout) {
    std::size_t size = kHeader;
    for (const int code : layout.items) {
        const Item* const item = find_item(code);
        if (!item) {
            return std::nullopt;
        }
        size += size_of(*item, layout.binary);
    }
    const bool fits = layout.items.size() <= kFastrakMostItems && size <= kFastrakMostBytes;
    return fits ? std::optional(size) : std::nullopt;
}

const char* error_name(char error) {
    if (error >= 'a' && error <= 'g') {
        return error <= 'c' ? "driver-limit" : error <= 'f' ? "gain" : "coil";
    }
    switch (error) {
        case ' ':
            return "none";
        case 'j':
            return "saturation";
        case 'k':
            return "low-signal";
        case 'l':
            return "zero-element";
        case 'm':
            return "eeprom";
        case 't':
        case 'u':
            return "compensation";
        case 'x':
            return "position-envelope";
        case 'y':
            return "angular-envelope";
        default:
            return "unknown";
    }
}

}  // namespace percussionist::motion
