// What Pd holds of an object, and how the seam talks to Pd about it. Only for the files of pdx that
// include m_pd.h.
#pragma once

#include <m_pd.h>

#include <algorithm>
#include <exception>
#include <string>
#include <string_view>

#include "pdx/object.hpp"

namespace percussionist::pdx {

constexpr std::size_t kMaxSignals = 16;

/// A description, and what Pd made of it.
struct Known {
    Description table;
    t_class* pd_class = nullptr;
};

/// Allocated by Pd, which sets the header and fills the rest with zeros: no constructor may run.
struct Box {
    t_object header;
    t_float unconnected_inlet;
    const Known* known;
    t_glist* canvas;  ///< of the patch that it is in
    Object* object;
    t_outlet** outlets;
    std::size_t outlet_count;
    std::size_t channels;  ///< of the last outlet, if it is one cord for all; else 0
    t_pd** inlets;         ///< what listens at the further inlets for messages
    const Sample* inputs[kMaxSignals];
    Sample* outputs[kMaxSignals];
    std::size_t output_count;
    double sample_rate;
    double tick_time;   ///< logical time at the last block [s]
    double next_start;  ///< of the next block within that tick [s]
};

/// What is known of outlet i: the last of the table stands for all that follow.
inline const Port& port_of_outlet(const Box* box, std::size_t i) {
    const auto& outlets = box->known->table.outlets;
    return outlets[std::min(i, outlets.size() - 1)];
}

inline double logical_seconds() {
    return clock_gettimesince(0) / 1000.0;
}

inline void print_error(const void* box, const std::string& text) {
    pd_error(box, "%s", text.c_str());
}

/// An object at work. Pd may free its box meanwhile, for a message that it sends may have it
/// deleted: then the object goes with the last of its calls.
class Call {
  public:
    explicit Call(Object& object) : object_(object), known_(object.box_->known) {
        ++object_.calls_;
    }
    ~Call() {
        if (--object_.calls_ == 0 && !object_.box_) {
            delete &object_;
        }
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    /// Instead of its deletion: once it is not called.
    static void forsake(Object* object) {
        object->box_ = nullptr;
        if (object->calls_ == 0) {
            delete object;
        }
    }
    const Description& table() const { return known_->table; }
    const Box* box() const { return object_.box_; }  ///< null if it is gone

  private:
    Object& object_;
    const Known* known_;
};

/// Before there is an object.
struct Making {
    const Box* made;
    const Description& table() const { return made->known->table; }
    const Box* box() const { return made; }
};

/// Runs what must not throw into Pd, of a Call or a Making.
template <class Doing, class Action>
void guarded(const Doing& doing, const std::string& place, Action action) noexcept {
    const std::string where = doing.table().name + (place.empty() ? "" : ": " + place);
    try {
        action();
    } catch (const std::exception& e) {
        // What the core throws often names the same thing first.
        const std::string_view what = e.what();
        const bool named = !place.empty() && what.starts_with(place + ": ");
        print_error(doing.box(), (named ? doing.table().name : where) + ": " + e.what());
    } catch (...) {
        print_error(doing.box(), where + ": failed for an unknown reason");
    }
}

}  // namespace percussionist::pdx
