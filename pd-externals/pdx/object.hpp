// The seam to Pure Data: an object is a class derived from Object, described by one table.
//
//     class Metronome : public pdx::Object {
//       public:
//         Metronome(pdx::Box& box, const pdx::Arguments& creation)
//             : Object(box), clock_(*this, [this] { tick(); }), period_(creation.number(0)) {}
//         void start(const pdx::Arguments&) { tick(); }
//         void period(const pdx::Arguments& a) { period_ = a.number(0); }
//       private:
//         void tick() { send_bang(0); clock_.delay(period_); }
//         pdx::Clock clock_;
//         double period_;
//     };
//
//     PDX_SETUP(setup_metro0x2dnome) {          // - is 0x2d, a trailing ~ is _tilde
//         using namespace percussionist::pdx;
//         add_class(describe<Metronome>("metro-nome", "a bang at regular times")
//             .creation({number("period", "s").above(0).by_default(0.5)})
//             .message("bang", {}, "start", &Metronome::start)
//             .message("period", {number("period", "s").above(0)}, "", &Metronome::period)
//             .outlet("a bang at each tick"));
//     }
//
// Messages reach a handler only with arguments that fit the table; what a handler or the
// constructor throws is printed, "metro-nome: period: expected a number above 0 [s], got -1", and
// nothing else happens. float, list, symbol and bang are messages like any other. A message the
// table does not name gets an error that lists those it does; "reference" prints the table. A
// signal object overrides prepare() and process().
//
// All functions here are called in Pd's one thread; process() alone must not allocate, lock or
// print. An object that is deleted by what it sent itself lives on until its call has returned;
// nobody hears it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pdx/arguments.hpp"

struct _clock;  // NOLINT(bugprone-reserved-identifier): Pd's own name

namespace percussionist::pdx {

struct Box;  ///< what Pd holds of an object

/// One block of signals. An input and an output may be the same memory.
struct Block {
    std::span<const Sample* const> inputs;
    std::span<Sample* const> outputs;
    std::size_t size = 0;
    double start = 0.0;        ///< logical time of the first sample [s], as Object::now()
    double sample_rate = 0.0;  ///< [Hz]
};

class Object {
  public:
    explicit Object(Box& box) : box_(&box) {}
    virtual ~Object() = default;
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    /// Whenever Pd sorts its signals: may allocate.
    virtual void prepare(double /*sample_rate*/, std::size_t /*block_size*/) {}
    virtual void process(const Block&) noexcept {}

    /// Into the Pd window, with the object's name in front; error() lets the user find the object.
    void post(const std::string& text) const;
    void error(const std::string& text) const;

  protected:
    /// A file to write that a message names: beside the patch, unless the name says where.
    std::string path_of(const char* file) const;
    /// A file to read: beside the patch, or in the folders where Pd looks for objects.
    std::string find_file(const char* file) const;
    /// Logical time [s]: exact within a block, the same for all that happens at once.
    static double now();
    /// How far Pd moves logical time on at once [s].
    static double tick_length();

    void send_bang(std::size_t outlet) const;
    void send(std::size_t outlet, double number) const;
    void send(std::size_t outlet, std::span<const Atom> list) const;
    void send(std::size_t outlet, const char* selector, std::span<const Atom> arguments) const;

  private:
    friend class Clock;
    friend class Call;
    Box* box_;       // null once Pd has freed it
    int calls_ = 0;  // under way
};

/// The values of an array of Pd. Throws std::invalid_argument if there is none of that name.
std::vector<double> array_values(const char* name);

/// Calls back at a logical time; destroyed, it does not.
class Clock {
  public:
    Clock(Object& owner, std::function<void()> callback);
    ~Clock();
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;

    void delay(double seconds);  ///< from now; at once, but not within the call, if 0 or less
    void at(double time);        ///< as Object::now() tells it [s]
    void cancel();

  private:
    static void tick(Clock* clock);
    Object& owner_;
    std::function<void()> callback_;
    _clock* clock_;
};

struct Message {
    std::string selector;
    std::vector<Argument> arguments;
    std::string description;
    std::function<void(Object&, const Arguments&)> call;
};

struct Port {
    bool signal = false;
    std::string description;
};

/// A further inlet; whatever comes there is a message of its own name, its arguments what came (the
/// selector first, if it is not a list, a number or a symbol).
struct MessageInlet {
    std::string selector;
    std::string description;
};

/// The table: everything Pd, the user and the reference page know of an object.
struct Description {
    std::string name;
    std::string summary;
    std::vector<Argument> creation_arguments;
    std::vector<Message> messages;
    std::vector<Port> signal_inlets;  ///< the first also takes the messages
    std::vector<MessageInlet> message_inlets;
    std::vector<Port> outlets;
    /// The last outlet is there as often as this creation argument says; none: once.
    std::optional<std::size_t> last_outlets;
    std::function<std::unique_ptr<Object>(Box&, const Arguments&)> make;

    /// Name, creation arguments, messages with units, inlets and outlets, a line each.
    std::string reference() const;
};

/// Description, written as a sentence.
template <class T>
class Describe : public Description {
  public:
    Describe& creation(std::vector<Argument> arguments) {
        creation_arguments = std::move(arguments);
        return *this;
    }
    Describe& message(std::string selector, std::vector<Argument> arguments, std::string text,
                      void (T::*handler)(const Arguments&)) {
        messages.push_back({std::move(selector), std::move(arguments), std::move(text),
                            [handler](Object& object, const Arguments& given) {
                                (static_cast<T&>(object).*handler)(given);
                            }});
        return *this;
    }
    Describe& signal_inlet(std::string text) {
        signal_inlets.push_back({true, std::move(text)});
        return *this;
    }
    Describe& message_inlet(std::string selector, std::string text) {
        message_inlets.push_back({std::move(selector), std::move(text)});
        return *this;
    }
    Describe& signal_outlet(std::string text) {
        outlets.push_back({true, std::move(text)});
        return *this;
    }
    /// The last outlets, all alike: as many as creation argument `argument` says (at most 16 in
    /// all), or, with -m in front of the arguments, one outlet with as many channels.
    Describe& signal_outlets(std::string text, std::size_t argument) {
        last_outlets = argument;
        return signal_outlet(std::move(text));
    }
    Describe& outlet(std::string text) {
        outlets.push_back({false, std::move(text)});
        return *this;
    }
};

template <class T>
Describe<T> describe(std::string name, std::string summary) {
    Describe<T> table;
    table.name = std::move(name);
    table.summary = std::move(summary);
    table.make = [](Box& box, const Arguments& creation) -> std::unique_ptr<Object> {
        return std::make_unique<T>(box, creation);
    };
    return table;
}

/// Makes the object known to Pd, under its name and as percussionist/NAME. What is known already,
/// even by another file of this library, stays as it is.
void add_class(Description description);

/// What add_class() was given under a name, or null.
const Description* find_class(std::string_view name);
/// All of them, by name.
std::vector<const Description*> all_classes();

/// What an object with several like outlets says of them.
inline constexpr const char* kOneCord =
    "-m before the arguments: one outlet with a channel for each (Pd 0.54)";

}  // namespace percussionist::pdx

/// The function Pd calls when it loads the file: the only one the library shows.
#define PDX_SETUP(name) extern "C" __attribute__((visibility("default"))) void name()
