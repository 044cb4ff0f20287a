#include "objects/matrix_objects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "objects/matrix_operations.hpp"
#include "pdx/object.hpp"

namespace percussionist::objects {

namespace {

using namespace pdx;

constexpr double kMostEntries = 65536;
constexpr std::array kFurther = {"right", "third"};  // what comes at the further inlets

class MatrixObject : public Object {
  public:
    MatrixObject(Box& box, const Arguments& creation, const Operation& operation)
        : Object(box), operation_(operation), values_(operation.operands.size()) {
        if (creation.size() == 0) {
            return;
        }
        if (operation.operands.size() < 2) {
            throw std::invalid_argument("expected no arguments, got " +
                                        std::to_string(creation.size()));
        }
        set(1, creation.atoms());
    }

    void list(const Arguments& a) {
        set(0, a.atoms());
        bang(a);
    }
    void matrix(const Arguments& a) {
        std::vector<Atom> atoms(a.atoms().begin(), a.atoms().end());
        atoms.insert(atoms.begin(), "matrix");
        set(0, atoms);
        bang(a);
    }
    void pose(const Arguments& a) {
        set(0, a.atoms().subspan(a.size() > 0 ? 1 : 0));
        bang(a);
    }
    void right(const Arguments& a) { set(1, a.atoms()); }
    void third(const Arguments& a) { set(2, a.atoms()); }

    void bang(const Arguments&) {
        std::vector<Value> operands;
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (!values_[i]) {
                throw std::invalid_argument(std::string("expected at the ") +
                                            (i == 0 ? "left" : kFurther.at(i - 1)) +
                                            " inlet first: " + kind_text(operation_.operands[i]));
            }
            operands.push_back(*values_[i]);
        }
        give(operation_.apply(operands));
    }

  private:
    static std::vector<double> numbers(std::span<const Atom> atoms) {
        std::vector<double> result;
        for (const Atom& atom : atoms) {
            const double* const value = std::get_if<double>(&atom);
            if (!value || !std::isfinite(*value)) {
                throw std::invalid_argument("expected numbers, got " + to_string(atom));
            }
            result.push_back(*value);
        }
        return result;
    }

    void set(std::size_t i, std::span<const Atom> atoms) {
        const Kind kind = operation_.operands[i];
        if (atoms.empty() || is_number(atoms[0])) {
            values_[i] = operand(kind, numbers(atoms));
            as_matrix_ = i == 0 ? false : as_matrix_;
            return;
        }
        if (to_string(atoms[0]) != "matrix") {
            throw std::invalid_argument(std::string("expected ") + kind_text(kind) + ", got " +
                                        to_string(atoms[0]));
        }
        const auto all = numbers(atoms.subspan(1));
        const bool sized =
            all.size() >= 2 && all[0] >= 1 && all[1] >= 1 && all[0] * all[1] <= kMostEntries &&
            std::floor(all[0]) * std::floor(all[1]) == static_cast<double>(all.size() - 2);
        if (!sized) {
            throw std::invalid_argument("expected matrix R C and R * C numbers");
        }
        values_[i] = operand(kind, static_cast<Eigen::Index>(all[0]),
                             static_cast<Eigen::Index>(all[1]), std::span(all).subspan(2));
        as_matrix_ = i == 0 ? true : as_matrix_;
    }

    /// A matrix message where it is one, or where the operand at the left came as one.
    void give(const Value& value) const {
        std::vector<Atom> atoms;
        for (Eigen::Index r = 0; r < value.rows(); ++r) {
            for (Eigen::Index c = 0; c < value.cols(); ++c) {
                atoms.emplace_back(value(r, c));
            }
        }
        if (operation_.result == Kind::kNumber) {
            return send(0, value(0));
        }
        const bool vector = value.cols() == 1 && operation_.result != Kind::kMatrix;
        const bool left_was_vector = operation_.operands[0] == Kind::kMatrix || !as_matrix_;
        if (vector && left_was_vector) {
            return send(0, atoms);
        }
        atoms.insert(atoms.begin(), static_cast<double>(value.cols()));
        atoms.insert(atoms.begin(), static_cast<double>(value.rows()));
        send(0, "matrix", atoms);
    }

    const Operation& operation_;
    std::vector<std::optional<Value>> values_;
    bool as_matrix_ = false;
};

const Operation& find(const std::string& name) {
    const auto all = operations();
    return *std::find_if(all.begin(), all.end(),
                         [&](const Operation& operation) { return operation.name == name; });
}

}  // namespace

void add_matrix_object(const char* name) {
    const Operation& operation = find(name);
    const std::string first = kind_text(operation.operands[0]);
    Describe<MatrixObject> table;
    table.name = operation.name;
    table.summary = operation.summary;
    if (operation.operands.size() > 1) {
        table.creation({anything("right")});
    }
    table.message("list", {anything("numbers")}, first, &MatrixObject::list)
        .message("float", {anything("number")}, "a list of one", &MatrixObject::list)
        .message("matrix", {anything("numbers")},
                 "R C and the numbers by rows, as iemmatrix has it", &MatrixObject::matrix)
        .message("bang", {}, "the result once more", &MatrixObject::bang);
    if (operation.operands[0] == Kind::kPose) {
        table.message("pose", {anything("numbers")}, "station and pose, as fastrak~ tells it",
                      &MatrixObject::pose);
    }
    for (std::size_t i = 1; i < operation.operands.size(); ++i) {
        table.message(kFurther.at(i - 1), {anything("numbers")},
                      std::string("what comes at the ") + (i == 1 ? "second" : "third") + " inlet",
                      i == 1 ? &MatrixObject::right : &MatrixObject::third);
        table.message_inlet(kFurther.at(i - 1), kind_text(operation.operands[i]));
    }
    table.outlet(operation.result == Kind::kMatrix ? "matrix R C and its rows"
                                                   : kind_text(operation.result));
    table.make = [&operation](Box& box, const Arguments& creation) -> std::unique_ptr<Object> {
        return std::make_unique<MatrixObject>(box, creation, operation);
    };
    add_class(table);
}

std::span<const std::string> matrix_object_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Operation& operation : operations()) {
            all.push_back(operation.name);
        }
        return all;
    }();
    return names;
}

}  // namespace percussionist::objects
