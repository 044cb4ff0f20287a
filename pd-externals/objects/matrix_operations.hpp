// What the matrix objects calculate: values in, a value out, each row of the table an operation.
// No Pd in here.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace percussionist::objects {

using Value = Eigen::MatrixXd;

/// What an operand or a result is, and how it is written.
enum class Kind {
    kNumber,      ///< a number
    kVector,      ///< a list: a column
    kVector3,     ///< x y z
    kMatrix,      ///< matrix R C ..., by rows
    kSame,        ///< a vector or a matrix; as a result: as the first operand is
    kEuler,       ///< azimuth elevation roll [rad]
    kQuaternion,  ///< w x y z
    kPose         ///< x y z qw qx qy qz
};

struct Operation {
    std::string name;
    std::string summary;
    std::vector<Kind> operands;
    Kind result;
    Value (*apply)(std::span<const Value> operands);  ///< throws std::invalid_argument
};

std::span<const Operation> operations();

const char* kind_text(Kind kind);

/// A list as an operand of that kind. Throws std::invalid_argument if it is none.
Value operand(Kind kind, std::span<const double> numbers);
/// The same for rows * columns numbers of `matrix`.
Value operand(Kind kind, Eigen::Index rows, Eigen::Index columns, std::span<const double> numbers);

}  // namespace percussionist::objects
