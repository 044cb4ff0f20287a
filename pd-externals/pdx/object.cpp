#include "pdx/object.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "pdx/box.hpp"

namespace percussionist::pdx {

namespace {

/// Pd's atoms of a list; a short one takes no memory from the heap.
class PdAtoms {
  public:
    explicit PdAtoms(std::span<const Atom> values) : size_(values.size()) {
        if (size_ > few_.size()) {
            many_.resize(size_);
        }
        for (std::size_t i = 0; i < size_; ++i) {
            if (is_number(values[i])) {
                SETFLOAT(data() + i, static_cast<t_float>(std::get<double>(values[i])));
            } else {
                SETSYMBOL(data() + i, gensym(std::get<const char*>(values[i])));
            }
        }
    }
    t_atom* data() { return many_.empty() ? few_.data() : many_.data(); }
    int size() const { return static_cast<int>(size_); }

  private:
    std::size_t size_;
    std::array<t_atom, 64> few_;
    std::vector<t_atom> many_;
};

}  // namespace

void Object::post(const std::string& text) const {
    if (box_) {
        ::post("%s: %s", box_->known->table.name.c_str(), text.c_str());
    }
}

void Object::error(const std::string& text) const {
    if (box_) {
        print_error(box_, box_->known->table.name + ": " + text);
    }
}

std::string Object::path_of(const char* file) const {
    std::array<char, MAXPDSTRING> path{};
    if (!box_) {
        return file;
    }
    canvas_makefilename(box_->canvas, file, path.data(), static_cast<int>(path.size()));
    return path.data();
}

std::string Object::find_file(const char* file) const {
    std::array<char, MAXPDSTRING> folder{};
    char* name = nullptr;
    const int found = box_ ? canvas_open(box_->canvas, file, "", folder.data(), &name,
                                         static_cast<unsigned int>(folder.size()), 1)
                           : -1;
    if (found < 0) {
        return path_of(file);
    }
    sys_close(found);
    return std::string(folder.data()) + "/" + name;
}

double Object::now() {
    return logical_seconds();
}

double Object::tick_length() {
    return sys_getblksize() / static_cast<double>(sys_getsr());
}

void Object::send_bang(std::size_t outlet) const {
    if (box_) {
        outlet_bang(box_->outlets[outlet]);
    }
}

void Object::send(std::size_t outlet, double number) const {
    if (box_) {
        outlet_float(box_->outlets[outlet], static_cast<t_float>(number));
    }
}

void Object::send(std::size_t outlet, std::span<const Atom> list) const {
    if (box_) {
        PdAtoms atoms(list);
        outlet_list(box_->outlets[outlet], &s_list, atoms.size(), atoms.data());
    }
}

void Object::send(std::size_t outlet, const char* selector, std::span<const Atom> arguments) const {
    if (box_) {
        PdAtoms atoms(arguments);
        outlet_anything(box_->outlets[outlet], gensym(selector), atoms.size(), atoms.data());
    }
}

std::vector<double> array_values(const char* name) {
    auto* const array = reinterpret_cast<t_garray*>(pd_findbyclass(gensym(name), garray_class));
    int size = 0;
    t_word* words = nullptr;
    if (!array || !garray_getfloatwords(array, &size, &words)) {
        throw std::invalid_argument(std::string("no array '") + name + "'");
    }
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(size));
    std::for_each(words, words + size,
                  [&](const t_word& word) { values.push_back(static_cast<double>(word.w_float)); });
    return values;
}

Clock::Clock(Object& owner, std::function<void()> callback)
    : owner_(owner),
      callback_(std::move(callback)),
      clock_(clock_new(this, reinterpret_cast<t_method>(&Clock::tick))) {}

Clock::~Clock() {
    clock_free(clock_);
}

void Clock::delay(double seconds) {
    clock_delay(clock_, std::max(seconds, 0.0) * 1000.0);
}

void Clock::at(double time) {
    delay(time - logical_seconds());
}

void Clock::cancel() {
    clock_unset(clock_);
}

void Clock::tick(Clock* clock) {
    Object& owner = clock->owner_;
    const Call call(owner);
    guarded(call, "", [clock] { clock->callback_(); });
}

}  // namespace percussionist::pdx
