#include "objects/matrix_operations.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/linear/euler.hpp"
#include "core/linear/pose.hpp"

namespace percussionist::objects {

namespace {

using linear::Matrix3;
using linear::Pose;
using linear::Quaternion;
using linear::Vector3;
using Operands = std::span<const Value>;

std::string size_text(const Value& value) {
    return std::to_string(value.rows()) + " x " + std::to_string(value.cols());
}

[[noreturn]] void refuse(const std::string& expected, const std::string& got) {
    throw std::invalid_argument("expected " + expected + ", got " + got);
}

void require_same_size(Operands v) {
    if (v[0].rows() != v[1].rows() || v[0].cols() != v[1].cols()) {
        refuse("two of the same size", size_text(v[0]) + " and " + size_text(v[1]));
    }
}

void require_square(const Value& value) {
    if (value.rows() != value.cols()) {
        refuse("a square matrix", size_text(value));
    }
}

Matrix3 rotation(const Value& value) {
    const bool good = value.rows() == 3 && value.cols() == 3 &&
                      (value.transpose() * value - Value::Identity(3, 3)).norm() < 0.01 &&
                      Matrix3(value).determinant() > 0.0;
    if (!good) {
        refuse("a rotation matrix, 3 x 3", size_text(value) + " that is none");
    }
    return value;
}

Quaternion quaternion(const Value& value, Eigen::Index first = 0) {
    const Quaternion q(value(first), value(first + 1), value(first + 2), value(first + 3));
    if (!(q.norm() > 1e-6)) {
        refuse("a quaternion that is not 0", "0");
    }
    return q.normalized();
}

Value to_value(const Quaternion& q) {
    return Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
}

linear::EulerAngles euler(const Value& value) {
    return {value(0), value(1), value(2)};
}

Value to_value(const linear::EulerAngles& e) {
    return Vector3(e.azimuth, e.elevation, e.roll);
}

Pose pose(const Value& value) {
    return {Vector3(value(0), value(1), value(2)), quaternion(value, 3)};
}

Value to_value(const Pose& pose) {
    Value value(7, 1);
    value << pose.position, to_value(pose.orientation);
    return value;
}

Value number(double x) {
    return Value::Constant(1, 1, x);
}

Value add(Operands v) {
    require_same_size(v);
    return v[0] + v[1];
}
Value subtract(Operands v) {
    require_same_size(v);
    return v[0] - v[1];
}
Value scale(Operands v) {
    return v[0] * v[1](0);
}
Value dot(Operands v) {
    require_same_size(v);
    return number(v[0].cwiseProduct(v[1]).sum());
}
Value cross(Operands v) {
    return Vector3(v[0]).cross(Vector3(v[1]));
}
Value norm(Operands v) {
    return number(v[0].norm());
}
Value normalise(Operands v) {
    if (!(v[0].norm() > 0.0)) {
        refuse("a vector that is not 0", "0");
    }
    return v[0] / v[0].norm();
}
Value multiply(Operands v) {
    if (v[0].cols() != v[1].rows()) {
        refuse("as many columns on the left as rows on the right",
               size_text(v[0]) + " and " + size_text(v[1]));
    }
    return v[0] * v[1];
}
Value transpose(Operands v) {
    return v[0].transpose();
}
Value inverse(Operands v) {
    require_square(v[0]);
    const Eigen::FullPivLU<Value> lu(v[0]);
    if (!lu.isInvertible()) {
        refuse("a matrix that has an inverse", "a singular one");
    }
    return lu.inverse();
}
Value determinant(Operands v) {
    require_square(v[0]);
    return number(v[0].determinant());
}

Value euler_to_quaternion(Operands v) {
    return to_value(linear::to_quaternion(euler(v[0])));
}
Value quaternion_to_euler(Operands v) {
    return to_value(linear::to_euler(quaternion(v[0])));
}
Value euler_to_matrix(Operands v) {
    return linear::to_quaternion(euler(v[0])).toRotationMatrix();
}
Value matrix_to_euler(Operands v) {
    return to_value(linear::to_euler(rotation(v[0])));
}
Value quaternion_to_matrix(Operands v) {
    return quaternion(v[0]).toRotationMatrix();
}
Value matrix_to_quaternion(Operands v) {
    return to_value(Quaternion(rotation(v[0])).normalized());
}
Value multiply_quaternions(Operands v) {
    return to_value(quaternion(v[0]) * quaternion(v[1]));
}
Value slerp(Operands v) {
    const Pose a{Vector3::Zero(), quaternion(v[0])}, b{Vector3::Zero(), quaternion(v[1])};
    return to_value(interpolate(a, b, v[2](0)).orientation);
}
Value pose_point(Operands v) {
    return pose(v[0]) * Vector3(v[1]);
}
Value pose_inverse(Operands v) {
    return to_value(pose(v[0]).inverse());
}
Value multiply_poses(Operands v) {
    return to_value(pose(v[0]) * pose(v[1]));
}

const std::vector<Operation>& table() {
    using enum Kind;
    static const std::vector<Operation> rows = {
        {"vec-add", "the sum of two vectors or matrices", {kSame, kSame}, kSame, add},
        {"vec-sub", "left less right, vectors or matrices", {kSame, kSame}, kSame, subtract},
        {"vec-scale", "a vector or matrix times a number", {kSame, kNumber}, kSame, scale},
        {"vec-dot", "the scalar product of two vectors", {kVector, kVector}, kNumber, dot},
        {"vec-cross", "the vector product of two vectors", {kVector3, kVector3}, kVector3, cross},
        {"vec-norm", "the length of a vector", {kVector}, kNumber, norm},
        {"vec-normalise", "a vector of the same direction, 1 long", {kVector}, kVector, normalise},
        {"mat-mul", "a matrix times a matrix or a vector", {kMatrix, kSame}, kSame, multiply},
        {"mat-transpose", "rows become columns", {kMatrix}, kMatrix, transpose},
        {"mat-inverse", "the matrix that undoes a matrix", {kMatrix}, kMatrix, inverse},
        {"mat-det", "the determinant of a matrix", {kMatrix}, kNumber, determinant},
        {"euler-to-quat",
         "Euler angles to a quaternion",
         {kEuler},
         kQuaternion,
         euler_to_quaternion},
        {"quat-to-euler",
         "a quaternion to Euler angles",
         {kQuaternion},
         kEuler,
         quaternion_to_euler},
        {"euler-to-mat", "Euler angles to a rotation matrix", {kEuler}, kMatrix, euler_to_matrix},
        {"mat-to-euler", "a rotation matrix to Euler angles", {kMatrix}, kEuler, matrix_to_euler},
        {"quat-to-mat",
         "a quaternion to a rotation matrix",
         {kQuaternion},
         kMatrix,
         quaternion_to_matrix},
        {"mat-to-quat",
         "a rotation matrix to a quaternion",
         {kMatrix},
         kQuaternion,
         matrix_to_quaternion},
        {"quat-mul",
         "one rotation after another: left times right",
         {kQuaternion, kQuaternion},
         kQuaternion,
         multiply_quaternions},
        {"quat-slerp",
         "a rotation on the way between two",
         {kQuaternion, kQuaternion, kNumber},
         kQuaternion,
         slerp},
        {"pose-point",
         "a point of a posed thing, seen from outside",
         {kPose, kVector3},
         kVector3,
         pose_point},
        {"pose-inverse", "outside, seen from the posed thing", {kPose}, kPose, pose_inverse},
        {"pose-mul",
         "a pose within a pose: left times right",
         {kPose, kPose},
         kPose,
         multiply_poses},
    };
    return rows;
}

Eigen::Index fixed_size(Kind kind) {
    switch (kind) {
        case Kind::kNumber:
            return 1;
        case Kind::kVector3:
        case Kind::kEuler:
            return 3;
        case Kind::kQuaternion:
            return 4;
        case Kind::kPose:
            return 7;
        default:
            return 0;
    }
}

}  // namespace

std::span<const Operation> operations() {
    return table();
}

const char* kind_text(Kind kind) {
    switch (kind) {
        case Kind::kNumber:
            return "a number";
        case Kind::kVector:
            return "a vector: a list";
        case Kind::kVector3:
            return "a vector: x y z";
        case Kind::kMatrix:
            return "matrix R C and its rows, or a list of 4, 9 or 16: a square one";
        case Kind::kSame:
            return "a vector: a list, or matrix R C and its rows";
        case Kind::kEuler:
            return "azimuth elevation roll [rad]";
        case Kind::kQuaternion:
            return "w x y z";
        default:
            return "x y z [m] qw qx qy qz";
    }
}

Value operand(Kind kind, std::span<const double> numbers) {
    const auto count = static_cast<Eigen::Index>(numbers.size());
    if (kind == Kind::kMatrix) {
        const auto side = static_cast<Eigen::Index>(std::lround(std::sqrt(numbers.size())));
        if (side < 2 || side * side != count) {
            refuse(kind_text(kind), "a list of " + std::to_string(count));
        }
        return operand(kind, side, side, numbers);
    }
    const Eigen::Index expected = fixed_size(kind);
    if (count == 0 || (expected != 0 && count != expected)) {
        refuse(kind_text(kind), std::to_string(count) + (count == 1 ? " number" : " numbers"));
    }
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), count);
}

Value operand(Kind kind, Eigen::Index rows, Eigen::Index columns, std::span<const double> numbers) {
    if (kind != Kind::kMatrix && kind != Kind::kSame) {
        if (rows != 1 && columns != 1) {
            refuse(kind_text(kind),
                   "matrix " + std::to_string(rows) + " " + std::to_string(columns));
        }
        return operand(kind, numbers);
    }
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const Rows>(numbers.data(), rows, columns);
}

}  // namespace percussionist::objects
