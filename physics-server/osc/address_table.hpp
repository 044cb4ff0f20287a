// The one table of what the server understands: dispatch, the errors a user reads and the answer to
// /describe all come from it.
//
// Pure functions over values: no socket here. Any thread.
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "osc/argument.hpp"
#include "osc/command.hpp"

namespace percussionist::osc {

struct Parameter {
    const char* name;
    const char* unit;   ///< "" where there is none
    bool text = false;  ///< a string; else a number
    bool required = true;
    double least = 0.0;        ///< of a number
    double most = 0.0;         ///< of a number; of a text its most letters, 0: 255
    bool rest = false;         ///< the last one: any number of words and numbers, read as a line
    const char* choices = "";  ///< of a text: the words it may be; "": any
};

struct Address {
    const char* path;
    const char* description;
    std::vector<Parameter> parameters;
    Command (*make)(std::span<const Argument> arguments);
};

const std::vector<Address>& address_table();

/// Its part on how the percussionist plays, with what, and where.
std::vector<Address> manner_addresses();
/// Its part on a drummer at a whole kit.
std::vector<Address> kit_addresses();

/// A message that could not be understood: one line that names it and says what was expected.
struct Refusal {
    std::string address, reason;
};

/// What a message says. Never throws for any input.
std::variant<Command, Refusal> understand(const std::string& path,
                                          std::span<const Argument> arguments);

/// "/tempo FACTOR (0.1 to 10): ..." for each address.
std::string usage(const Address& address);

}  // namespace percussionist::osc
