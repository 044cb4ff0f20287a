// The drum as an object of Pd: what its messages do.
#pragma once

#include <array>
#include <optional>

#include "core/modal/modal_drum.hpp"
#include "pdx/object.hpp"
#include "pdx/timed_queue.hpp"

namespace percussionist::objects {

class ModalDrum : public pdx::Object {
  public:
    ModalDrum(pdx::Box& box, const pdx::Arguments& creation);

    void bang(const pdx::Arguments&);
    void strike(const pdx::Arguments& a);
    void mallet(const pdx::Arguments& a);
    void slide(const pdx::Arguments& a);
    void position(const pdx::Arguments& a);

    void radius(const pdx::Arguments& a);
    void tension(const pdx::Arguments& a);
    void density(const pdx::Arguments& a);
    void bending(const pdx::Arguments& a);
    void stretch(const pdx::Arguments& a);
    void air(const pdx::Arguments& a);
    void plate(const pdx::Arguments& a);
    void membrane(const pdx::Arguments&);
    void read(const pdx::Arguments& a);
    void given(const pdx::Arguments& a);
    void arrays(const pdx::Arguments& a);
    void decay(const pdx::Arguments& a);
    void losses(const pdx::Arguments& a);
    void modes(const pdx::Arguments& a);
    void band(const pdx::Arguments& a);

    void pickup(const pdx::Arguments& a);
    void pickup_position(const pdx::Arguments& a);
    void pickup_pressure(const pdx::Arguments& a);
    void hand(const pdx::Arguments& a);
    void lift(const pdx::Arguments& a);
    void follow(const pdx::Arguments& a);
    void unfollow(const pdx::Arguments&);
    void force_at(const pdx::Arguments& a);
    void mute(const pdx::Arguments& a);
    void reset(const pdx::Arguments&);
    void print(const pdx::Arguments&);

    void prepare(double sample_rate, std::size_t) override;
    void process(const pdx::Block& block) noexcept override;

  private:
    struct Place {
        double r;      ///< [m]
        double theta;  ///< [rad]
    };

    template <class... Numbers>
    void say(const char* format, Numbers... numbers) const;
    Place position() const;
    const modal::Loss& loss() const;
    void change(double modal::Membrane::*field, double value);
    void use(const modal::Membrane& membrane);
    void tune(const modal::Body& body, const modal::Loss& loss);
    void retune();
    void listen(modal::Pickup::Hears hears, const pdx::Arguments& a);
    void place(std::size_t i, const modal::Pickup& pickup);
    void lay(std::size_t i, const modal::Hand& hand);
    void follow_place();
    void play(modal::Stroke stroke, const Place& place);

    modal::Membrane membrane_;  // the last there was
    modal::ModalDrum drum_;
    modal::Mallet mallet_;
    double slide_x_ = 0.0, slide_y_ = 0.0;  // [m/s]
    std::optional<Place> position_, follows_;
    Place force_at_{0.0, 0.0};
    std::array<std::optional<modal::Hand>, modal::StruckHead::kMaxHands> hands_;
    std::array<bool, modal::ModalDrum::kMaxPickups> placed_pickups_{};
    double pickups_of_ = 0.0;  // radius they were placed on [m]
    pdx::TimedQueue<modal::Stroke, modal::ModalDrum::kQueue> waiting_;
};

}  // namespace percussionist::objects
