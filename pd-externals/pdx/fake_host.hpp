// A stand-in for Pd, to test objects in: create them, send them messages at logical times, run
// blocks of samples, and read what they send and complain of. It defines the functions of m_pd.h
// that the seam calls; link it instead of Pd.
//
//     FakeHost host;
//     setup_modal0x2ddrum_tilde();
//     auto& drum = host.create("modal-drum~", {0.33});
//     host.advance_to(0.01);
//     drum.message("strike", {2.0});
//     host.run_tick();  drum.output(0)
//
// One host at a time.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pdx/atom.hpp"

namespace percussionist::pdx {

/// What came out of an outlet.
struct Sent {
    std::size_t outlet = 0;
    std::string selector;
    std::vector<Atom> atoms;
    double time = 0.0;  ///< logical [s]
};

class FakeHost;

class FakeObject {
  public:
    void message(const std::string& selector, std::vector<Atom> atoms = {});
    /// To a further inlet for messages, the first of them being 0.
    void message_at(std::size_t inlet, const std::string& selector, std::vector<Atom> atoms = {});
    /// What came since the last call.
    std::vector<Sent> sent();
    /// Samples of a signal outlet, all since start_dsp().
    const std::vector<Sample>& output(std::size_t i) const { return outputs_.at(i); }
    /// What the next blocks read at a signal inlet: a constant.
    void input(std::size_t i, Sample value) { inputs_.at(i) = value; }
    std::size_t outputs() const { return outputs_.size(); }

  private:
    friend class FakeHost;
    void* box_ = nullptr;
    std::vector<Sample> inputs_;
    std::vector<std::vector<Sample>> outputs_;
    std::size_t seen_ = 0;
};

class FakeHost {
  public:
    explicit FakeHost(double sample_rate = 48000);
    ~FakeHost();
    FakeHost(const FakeHost&) = delete;
    FakeHost& operator=(const FakeHost&) = delete;

    /// Null if the object refused; see errors().
    FakeObject* create(const std::string& name, std::vector<Atom> arguments = {});
    void destroy(FakeObject* object);
    /// Is called with all that any object sends, within its call; it may destroy the object.
    static void on_sent(std::function<void(const Sent&)> hearer);

    /// Turns signal processing on, the objects in blocks of this size; `over` times the sample
    /// rate.
    void start_dsp(std::size_t block_size = 64, std::size_t over = 1);

    /// Runs the clocks until then, ticks of signals included; messages sent afterwards come at that
    /// time.
    void advance_to(double seconds);
    void run_tick();  ///< to the end of the current tick of 64 samples, with its signals
    double now() const;

    /// An array of Pd.
    void set_array(const std::string& name, const std::vector<double>& values);

    /// Where the patch with all the objects is.
    void set_patch_folder(const std::string& path);

    std::vector<std::string> errors();  ///< since the last call
    std::vector<std::string> posts();

  private:
    void perform_tick();
    void run_clocks(double until);
    std::map<FakeObject*, std::unique_ptr<FakeObject>> objects_;
    std::vector<FakeObject*> order_;
    std::size_t block_size_ = 0;
    std::size_t over_ = 1;
    std::size_t tick_ = 0;
};

}  // namespace percussionist::pdx
