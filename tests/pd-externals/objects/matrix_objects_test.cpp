#include "objects/matrix_objects.hpp"

#include <doctest/doctest.h>

#include <string>

#include "objects/matrix_operations.hpp"
#include "pdx/fake_host.hpp"
#include "pdx/object.hpp"

using namespace percussionist;
using namespace percussionist::pdx;

namespace {

FakeObject& create(FakeHost& host, const char* name, std::vector<Atom> arguments = {}) {
    if (!find_class(name)) {
        objects::add_matrix_object(name);
    }
    FakeObject* const object = host.create(name, std::move(arguments));
    REQUIRE(object);
    return *object;
}

/// What came out, as a person reads it.
std::string heard(FakeObject& object) {
    std::string text;
    for (const Sent& sent : object.sent()) {
        text += (text.empty() ? "" : "; ") + sent.selector;
        for (const Atom& atom : sent.atoms) {
            const double* const value = std::get_if<double>(&atom);
            text += " " + to_string(value && std::abs(*value) < 1e-7 ? Atom(0.0) : atom);
        }
    }
    return text;
}

std::string result(const char* name, std::vector<Atom> left, std::vector<Atom> right = {}) {
    FakeHost host;
    FakeObject& object = create(host, name);
    if (!right.empty()) {
        object.message_at(0, "list", std::move(right));
    }
    object.message("list", std::move(left));
    const auto errors = host.errors();
    return errors.empty() ? heard(object) : errors[0];
}

}  // namespace

TEST_CASE("vectors: what school teaches") {
    CHECK(result("vec-add", {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}) == "list 5 7 9");
    CHECK(result("vec-sub", {1.0, 2.0}, {4.0, 1.0}) == "list -3 1");
    CHECK(result("vec-scale", {1.0, 2.0}, {3.0}) == "list 3 6");
    CHECK(result("vec-dot", {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}) == "float 32");
    CHECK(result("vec-cross", {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}) == "list 0 0 1");
    CHECK(result("vec-norm", {3.0, 4.0}) == "float 5");
    CHECK(result("vec-normalise", {0.0, 4.0}) == "list 0 1");
}

TEST_CASE("matrices: products, inverses and iemmatrix's messages") {
    CHECK(result("mat-mul", {1.0, 2.0, 3.0, 4.0}, {1.0, 1.0}) == "list 3 7");
    CHECK(result("mat-transpose", {1.0, 2.0, 3.0, 4.0}) == "matrix 2 2 1 3 2 4");
    CHECK(result("mat-inverse", {0.0, 2.0, 4.0, 0.0}) == "matrix 2 2 0 0.25 0.5 0");
    CHECK(result("mat-det", {1.0, 2.0, 3.0, 4.0}) == "float -2");
    FakeHost host;
    FakeObject& product = create(host, "mat-mul", {"matrix", 3.0, 1.0, 1.0, 2.0, 3.0});
    product.message("matrix", {2.0, 3.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0});
    CHECK(heard(product) == "list 1 5");
    product.message_at(0, "matrix", {3.0, 2.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0});
    product.message("bang");
    CHECK(heard(product) == "matrix 2 2 1 0 0 1");
    FakeObject& sum = create(host, "vec-add", {"matrix", 2.0, 1.0, 5.0, 6.0});
    sum.message("matrix", {2.0, 1.0, 1.0, 1.0});
    CHECK(heard(sum) == "matrix 2 1 6 7");
}

TEST_CASE("rotations: a quarter turn is the same in every form") {
    const double half = std::sqrt(0.5), quarter = 2 * std::atan(1.0);
    CHECK(result("euler-to-mat", {quarter, 0.0, 0.0}) == "matrix 3 3 0 -1 0 1 0 0 0 0 1");
    CHECK(result("euler-to-quat", {quarter, 0.0, 0.0}) == "list 0.707107 0 0 0.707107");
    CHECK(result("quat-to-mat", {half, 0.0, 0.0, half}) == "matrix 3 3 0 -1 0 1 0 0 0 0 1");
    CHECK(result("quat-to-euler", {half, 0.0, 0.0, half}) == "list 1.5708 0 0");
    CHECK(result("mat-to-quat", {0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0}) ==
          "list 0.707107 0 0 0.707107");
    CHECK(result("mat-to-euler", {0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0}) ==
          "list 1.5708 0 0");
    CHECK(result("quat-mul", {half, 0.0, 0.0, half}, {half, 0.0, 0.0, half}) == "list 0 0 0 1");
    FakeHost host;
    FakeObject& slerp = create(host, "quat-slerp");
    slerp.message_at(1, "float", {0.5});
    slerp.message_at(0, "list", {half, 0.0, 0.0, half});
    slerp.message("list", {1.0, 0.0, 0.0, 0.0});
    CHECK(heard(slerp) == "list 0.92388 0 0 0.382683");
}

TEST_CASE("poses: from a receiver's frame to the transmitter's, and back") {
    const double half = std::sqrt(0.5);
    const std::vector<Atom> pose = {1.0, 2.0, 3.0, half, 0.0, 0.0, half};
    CHECK(result("pose-point", pose, {0.1, 0.0, 0.0}) == "list 1 2.1 3");
    CHECK(result("pose-inverse", pose) == "list -2 1 -3 0.707107 0 0 -0.707107");
    CHECK(result("pose-mul", pose, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}) ==
          "list 1 2 3 0.707107 0 0 0.707107");
    FakeHost host;
    FakeObject& point = create(host, "pose-point", {0.1, 0.0, 0.0});
    point.message("pose", {2.0, 1.0, 2.0, 3.0, half, 0.0, 0.0, half});
    CHECK(heard(point) == "list 1 2.1 3");
}

TEST_CASE("the paper's patch from receiver to absolute position is mat-mul and vec-add") {
    FakeHost host;
    FakeObject& turned = create(host, "mat-mul", {0.1, 0.0, 0.0});
    FakeObject& moved = create(host, "vec-add");
    moved.message_at(0, "list", {1.0, 2.0, 3.0});
    turned.message("matrix", {3.0, 3.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0});
    moved.message("list", turned.sent().at(0).atoms);
    CHECK(heard(moved) == "list 1 2.1 3");
}

TEST_CASE("sizes that do not fit get one error that names them, and nothing comes out") {
    CHECK(result("vec-add", {1.0, 2.0}, {1.0, 2.0, 3.0}) ==
          "vec-add: list: expected two of the same size, got 2 x 1 and 3 x 1");
    CHECK(result("vec-cross", {1.0, 2.0}, {1.0, 2.0, 3.0}) ==
          "vec-cross: list: expected a vector: x y z, got 2 numbers");
    CHECK(result("mat-mul", {1.0, 2.0, 3.0, 4.0}, {1.0, 1.0, 1.0}) ==
          "mat-mul: list: expected as many columns on the left as rows on the right, got 2 x 2 and "
          "3 x 1");
    CHECK(result("mat-inverse", {1.0, 2.0, 2.0, 4.0}) ==
          "mat-inverse: list: expected a matrix that has an inverse, got a singular one");
    CHECK(result("mat-det", {1.0, 2.0, 3.0}).find("got a list of 3") != std::string::npos);
    CHECK(result("vec-add", {1.0}).find("expected at the right inlet first") != std::string::npos);
    CHECK(result("vec-normalise", {0.0, 0.0}).find("is not 0") != std::string::npos);
    CHECK(result("mat-to-quat", {1.0, 1.0, 0.0, 0.0}).find("rotation matrix") != std::string::npos);
    CHECK(result("quat-mul", {1.0, 0.0}, {1.0}).find("w x y z") != std::string::npos);
    CHECK(result("vec-norm", {"x"}).find("expected a vector: a list, got x") != std::string::npos);
    FakeHost host;
    FakeObject& det = create(host, "mat-det");
    for (const auto& bad : std::vector<std::vector<Atom>>{{},
                                                          {2.0},
                                                          {2.0, 2.0, 1.0},
                                                          {0.0, 0.0},
                                                          {-1.0, -4.0, 1.0, 1.0, 1.0, 1.0},
                                                          {1e9, 1e9},
                                                          {2.5, 2.0, 1.0, 1.0, 1.0, 1.0, 1.0},
                                                          {2.0, 2.0, 1.0, 1.0, 1.0, "x"}}) {
        det.message("matrix", bad);
        CHECK(host.errors().size() == 1);
    }
    CHECK(det.sent().empty());
}

TEST_CASE("whatever comes to whichever of them gives a result or one error") {
    const std::vector<std::vector<Atom>> anything = {
        {},
        {0.0},
        {1.0, 2.0},
        {0.0, 0.0, 0.0},
        {1.0, 0.0, 0.0, 0.0},
        {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
        {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0},
        {1e38, 1e38, 1e38, 1e38, 1e38, 1e38, 1e38, 1e38, 1e38},
        {"matrix"},
        {"matrix", 2.0, 1.0, 3.0, 4.0},
        {"matrix", 3.0, 3.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
        {"nonsense", 1.0},
        {1.0, "x"},
    };
    for (const std::string& name : objects::matrix_object_names()) {
        CAPTURE(name);
        FakeHost host;
        FakeObject& object = create(host, name.c_str());
        const std::size_t further = find_class(name)->message_inlets.size();
        for (const auto& right : anything) {
            for (std::size_t inlet = 0; inlet < further; ++inlet) {
                object.message_at(inlet, "list", right);
                CHECK(host.errors().size() <= 1);
            }
            for (const auto& left : anything) {
                object.sent();
                object.message("list", left);
                CHECK(host.errors().size() + object.sent().size() == 1);
            }
        }
    }
}
