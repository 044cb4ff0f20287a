// The simulated drummer while the music plays: a key-framed one leads him, step by step, and what
// is heard are the contacts that his body makes.
//
// Each contact is that of the stroke of its limb on its object nearest in time, within kOwnContact;
// other contacts (bounces, a hat that closes) are of no stroke, and sound as hard as they were. A
// contact is known when it has ended, some milliseconds after its instant. A stroke without one is
// passed over.
//
// One thread.
#pragma once

#include <memory>
#include <vector>

#include "body/live_drummer.hpp"
#include "sim/kit_simulation.hpp"

namespace percussionist::sim {

class SimulatedDrummer : public body::LiveKit {
  public:
    /// Of the simulation, and of those that step() is called with [s].
    static constexpr double kStep = 0.001;

    /// `led` leads him and has to outlive him; it is stepped and loaded through this. `bodies`:
    /// what each object is made of, by object.
    SimulatedDrummer(body::LiveDrummer& led, std::vector<modal::Resonator> bodies);

    void load(std::vector<score::KitStroke> strokes) override;
    /// `now` is kStep after the step before, the first after 0.
    void step(double now, const score::SongStep& song) override;
    body::LiveStroke strike(std::size_t event, double velocity, bool sounded) override {
        return led_.strike(event, velocity, sounded);
    }

    [[nodiscard]] const body::Skeleton& skeleton() const override { return body_->skeleton(); }
    [[nodiscard]] const body::Placement& placement() const override { return body_->placement(); }
    [[nodiscard]] const std::vector<body::ObjectState>& objects() const override {
        return objects_;
    }
    /// Those that ended in the last step; a stroke's contact has the time it was asked for.
    [[nodiscard]] const std::vector<body::KitContact>& contacts() const override {
        return contacts_;
    }
    [[nodiscard]] int passed_over() const override { return led_.passed_over() + missed_; }

  private:
    struct Asked {
        body::KitContact stroke;
        bool made = false;
    };
    void begin(double now);
    void ask(double now);
    bool tell(const KitContact& made, const body::LimbForecasts& forecasts);

    body::LiveDrummer& led_;
    std::vector<modal::Resonator> bodies_;
    std::unique_ptr<KitSimulation> body_;
    std::vector<Asked> asked_;      ///< strokes of the last moments
    std::vector<KitContact> made_;  ///< not told yet
    std::vector<body::KitContact> contacts_;
    std::vector<body::ObjectState> objects_;
    int missed_ = 0;
};

}  // namespace percussionist::sim
