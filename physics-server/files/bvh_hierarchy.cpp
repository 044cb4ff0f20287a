#include "files/bvh_hierarchy.hpp"

#include <cctype>
#include <cmath>

#include "files/bvh_file.hpp"

namespace percussionist::files {

namespace {

constexpr std::size_t kMostJoints = 2000;
constexpr std::size_t kMostChannels = 6;
/// A longer bone is no bone, in any unit.
constexpr double kLongest = 1e7;

std::optional<BvhChannel> channel_named(std::string_view word) {
    if (word.empty()) return std::nullopt;
    const int axis = std::tolower(static_cast<unsigned char>(word.front())) - 'x';
    if (axis < 0 || axis > 2) return std::nullopt;
    word.remove_prefix(1);
    if (same_word(word, "rotation")) return BvhChannel{true, axis};
    if (same_word(word, "position")) return BvhChannel{false, axis};
    return std::nullopt;
}

class HierarchyReader {
  public:
    HierarchyReader(LineReader& lines, std::string_view name) : lines_(lines), name_(name) {}

    BvhHierarchy read() {
        if (!next_line() || !same_word(words_[0], "HIERARCHY")) {
            fail("HIERARCHY", words_.empty() ? "the end of the file" : in_quotes(words_[0]));
        }
        while (true) {
            if (!next_line()) fail("MOTION", "the end of the file");
            if (same_word(words_[0], "MOTION")) break;
            statement();
        }
        if (!open_.empty()) {
            fail("'}' of joint " + in_quotes(tree_.joints[open_.back()].name), "MOTION");
        }
        if (tree_.joints.empty()) fail("ROOT", "MOTION");
        if (tree_.channel_count == 0) fail("a joint with CHANNELS", "none");
        return std::move(tree_);
    }

  private:
    /// To the next line that is not empty; its words.
    bool next_line() {
        words_.clear();
        while (words_.empty()) {
            const auto line = lines_.next();
            if (!line) return false;
            line_ = trimmed(*line);
            split(line_, " \t", words_);
        }
        return true;
    }

    [[noreturn]] void fail(const std::string& expected, const std::string& got) const {
        throw_bvh_error(name_, lines_.number(), expected, got);
    }

    void statement() {
        const std::string_view word = words_[0];
        if (same_word(word, "ROOT") || same_word(word, "JOINT")) {
            add_joint(false);
        } else if (same_word(word, "End") && words_.size() > 1) {
            add_joint(true);
        } else if (word == "{") {
            if (!expects_brace_) fail("a joint, OFFSET, CHANNELS or '}'", "'{'");
            expects_brace_ = false;
        } else if (word == "}") {
            if (open_.empty() || expects_brace_) fail("ROOT, JOINT or MOTION", "'}'");
            open_.pop_back();
        } else if (same_word(word, "OFFSET")) {
            offset();
        } else if (same_word(word, "CHANNELS")) {
            channels();
        } else {
            fail("ROOT, JOINT, End Site, OFFSET, CHANNELS, MOTION or a brace", in_quotes(word));
        }
    }

    void add_joint(bool end) {
        if (expects_brace_) fail("'{'", in_quotes(words_[0]));
        if (end && open_.empty()) fail("End Site inside a joint", "it outside");
        if (tree_.joints.size() >= kMostJoints) {
            fail("at most " + std::to_string(kMostJoints) + " joints", "more");
        }
        // The name is the rest of the line: some have blanks in them.
        std::string_view rest = line_;
        rest.remove_prefix(words_[0].size());
        rest = trimmed(rest);
        if (!rest.empty() && rest.back() == '{') {
            rest = trimmed(rest.substr(0, rest.size() - 1));
            expects_brace_ = false;
        } else {
            expects_brace_ = true;
        }
        if (rest.empty()) fail("a name after " + in_quotes(words_[0]), "none");
        motion::CapturedJoint joint;
        joint.parent = open_.empty() ? -1 : static_cast<int>(open_.back());
        joint.end = end;
        joint.name = end ? tree_.joints[open_.back()].name + " end" : std::string(rest);
        open_.push_back(tree_.joints.size());
        tree_.joints.push_back(std::move(joint));
        tree_.channels.emplace_back();
    }

    std::size_t inside(const char* what) {
        if (open_.empty() || expects_brace_) fail(std::string(what) + " inside a joint", "outside");
        return open_.back();
    }

    void offset() {
        motion::CapturedJoint& joint = tree_.joints[inside("OFFSET")];
        if (words_.size() != 4) {
            fail("3 numbers after OFFSET", std::to_string(words_.size() - 1));
        }
        for (int a = 0; a < 3; ++a) {
            const auto value = number_in(words_[a + 1]);
            if (!value || !(std::abs(*value) < kLongest))
                fail("a length", in_quotes(words_[a + 1]));
            joint.offset[a] = *value;
        }
    }

    void channels() {
        const std::size_t joint = inside("CHANNELS");
        if (tree_.joints[joint].end) fail("OFFSET alone in an End Site", "CHANNELS");
        if (!tree_.channels[joint].empty()) fail("CHANNELS once a joint", "it again");
        const auto count = words_.size() > 1 ? number_in(words_[1]) : std::nullopt;
        const std::size_t named = words_.size() < 2 ? 0 : words_.size() - 2;
        if (!count || *count != static_cast<double>(named) || named > kMostChannels) {
            fail("CHANNELS, their number (0 to 6) and as many names", in_quotes(line_));
        }
        for (std::size_t i = 0; i < named; ++i) {
            const auto channel = channel_named(words_[i + 2]);
            if (!channel) {
                fail("Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation",
                     in_quotes(words_[i + 2]));
            }
            tree_.channels[joint].push_back(*channel);
        }
        tree_.channel_count += named;
    }

    LineReader& lines_;
    std::string_view name_;
    std::string_view line_;
    std::vector<std::string_view> words_;
    std::vector<std::size_t> open_;  ///< joints whose braces are open
    bool expects_brace_ = false;
    BvhHierarchy tree_;
};

}  // namespace

void throw_bvh_error(std::string_view name, int line, const std::string& expected,
                     const std::string& got) {
    throw BvhError(std::string(name) + ": line " + std::to_string(line) + ": expected " + expected +
                   ", got " + got);
}

bool same_word(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::tolower(static_cast<unsigned char>(a[i])) !=
            std::tolower(static_cast<unsigned char>(b[i]))) {
            return false;
        }
    }
    return true;
}

BvhHierarchy read_bvh_hierarchy(LineReader& lines, std::string_view name) {
    return HierarchyReader(lines, name).read();
}

}  // namespace percussionist::files
