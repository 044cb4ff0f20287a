// The arguments of a message: what is allowed, said once, and what came.
//
//     number("tension", "N/m").above(0)
//     number("theta", "rad").by_default(0)        may be left out
//     word("port")
//     anything("arguments")                       the rest, as it comes; only as the last
//
// check() compares a message with such a list; what it throws is what the user reads. Not for the
// audio thread.
#pragma once

#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "pdx/atom.hpp"

namespace percussionist::pdx {

struct Argument {
    enum class Kind { kNumber, kWord, kAnything };

    std::string name;
    std::string unit;
    Kind kind = Kind::kNumber;
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_excluded = false;
    bool optional = false;
    Atom standard = 0.0;  ///< where it is left out

    Argument above(double limit) const;
    Argument from(double limit) const;
    Argument to(double limit) const;
    /// May be left out and is this then.
    Argument by_default(double value) const;
    Argument by_default_word(const char* value) const;
    /// May be left out; Arguments::has() tells.
    Argument or_none() const;

    /// "a number above 0 [N/m]"
    std::string expected() const;
};

/// Finite always; NaN and infinity are refused.
Argument number(std::string name, std::string unit = "");
Argument word(std::string name);
Argument anything(std::string name);

/// The arguments of one message, checked; those left out with a default have it.
class Arguments {
  public:
    Arguments(std::vector<Atom> atoms, std::size_t given)
        : atoms_(std::move(atoms)), given_(given) {}

    double number(std::size_t i) const { return std::get<double>(atoms_.at(i)); }
    int integer(std::size_t i) const { return static_cast<int>(number(i)); }
    const char* word(std::size_t i) const { return std::get<const char*>(atoms_.at(i)); }
    /// Whether the sender gave it.
    bool has(std::size_t i) const { return i < given_; }
    std::size_t size() const { return atoms_.size(); }
    std::span<const Atom> atoms() const { return atoms_; }

  private:
    std::vector<Atom> atoms_;
    std::size_t given_;
};

/// Throws std::invalid_argument, its text "name: expected ..., got ..."; the name is left out where
/// it is that of the message. The defaults end at the first argument left out without one.
Arguments check(std::span<const Argument> expected, std::span<const Atom> given,
                const std::string& message);

/// "strike VELOCITY [m/s] (R [m])", optional ones in parentheses.
std::string usage(const std::string& message, std::span<const Argument> arguments);

}  // namespace percussionist::pdx
