#include "objects/describe/abuse_patch.hpp"

#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include "pdx/object.hpp"

namespace percussionist::objects {

namespace {

using pdx::Argument;
using pdx::Description;

constexpr int kLength = 1000;  // of a long list
constexpr const char* kBlocks[] = {"64", "1", "2048", "64 1 4", "256 4 0.5"};
// What Pd itself says to objects, or a person to any.
constexpr const char* kSelectors[] = {"bang", "float",    "symbol", "list",      "pointer",
                                      "dsp",  "free",     "signal", "click",     "vis",
                                      "set",  "loadbang", "read",   "reference", "nonsense"};
constexpr const char* kArguments[] = {"",     "0",        "1",         "-1",
                                      "0.5",  "1e+30",    "1e39",      "-1e39",
                                      "word", "1 word 2", "1 2 3 4 5", "a b c d e"};

std::string repeated(const std::string& atom, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += (i > 0 ? " " : "") + atom;
    }
    return text;
}

/// Boxes and cords of one canvas.
class Canvas {
  public:
    int add(const std::string& box) {
        boxes_ += "#X " + box + ";\n";
        return count_++;
    }
    /// A subpatch of that name.
    int add(const std::string& name, const Canvas& inside) {
        boxes_ += "#N canvas 50 50 450 300 " + name + " 0;\n" + inside.text();
        return add("restore 10 10 pd " + name);
    }
    void connect(int from, int to, int inlet = 0) {
        cords_ += "#X connect " + std::to_string(from) + " 0 " + std::to_string(to) + " " +
                  std::to_string(inlet) + ";\n";
    }
    std::string text() const { return boxes_ + cords_; }

  private:
    std::string boxes_, cords_;
    int count_ = 0;
};

enum class Edge { kLow, kHigh };

/// The least or the greatest that fits.
std::string value(const Argument& argument, Edge edge) {
    if (argument.kind != Argument::Kind::kNumber) {
        return "word";
    }
    double number = edge == Edge::kLow ? argument.low : argument.high;
    if (!std::isfinite(number)) {
        number = edge == Edge::kLow ? -1e6 : 1e6;
    }
    if (edge == Edge::kLow && argument.low_excluded) {
        number += 1e-9;
    }
    char text[32];
    std::snprintf(text, sizeof text, "%g", number);
    return text;
}

std::string values(const std::vector<Argument>& arguments, Edge edge) {
    std::string text;
    for (const Argument& argument : arguments) {
        text += " " + value(argument, edge);
    }
    return text;
}

/// What an object is made with where a person gives only what has to be given.
std::string needed(const Description& table) {
    std::string text = table.name;
    for (const Argument& argument : table.creation_arguments) {
        text += argument.optional ? "" : " " + value(argument, Edge::kHigh);
    }
    return text;
}

std::vector<std::string> bad_messages(const std::string& selector) {
    std::vector<std::string> all;
    for (const char* arguments : kArguments) {
        all.push_back(selector + " " + arguments);
    }
    all.push_back(selector + " " + repeated("7", kLength));
    all.push_back(selector + " " + repeated("word", kLength));
    return all;
}

std::vector<std::string> messages_to(const Description& table) {
    std::vector<std::string> all;
    const auto append = [&all](const std::vector<std::string>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const char* selector : kSelectors) {
        append(bad_messages(selector));
    }
    for (const auto& message : table.messages) {
        append(bad_messages(message.selector));
        all.push_back(message.selector + values(message.arguments, Edge::kLow));
        all.push_back(message.selector + values(message.arguments, Edge::kHigh));
    }
    return all;
}

std::string receiver(const Description& table) {
    return "abuse-" + table.name;
}

/// All objects in blocks of one size, each with signals and messages at all its inlets.
Canvas blocks(const std::string& size) {
    Canvas canvas;
    canvas.add("obj 10 10 block~ " + size);
    const int sound = canvas.add("obj 10 40 osc~ 3");
    for (const Description* table : pdx::all_classes()) {
        const int object = canvas.add("obj 10 100 " + needed(*table));
        const int hears = canvas.add("obj 10 70 r " + receiver(*table));
        canvas.connect(hears, object);
        const int signals = static_cast<int>(table->signal_inlets.size());
        for (int inlet = 0; inlet < signals; ++inlet) {
            canvas.connect(sound, object, inlet);
        }
        for (int i = 0; i < static_cast<int>(table->message_inlets.size()); ++i) {
            canvas.connect(hears, object, std::max(signals, 1) + i);
        }
    }
    return canvas;
}

/// What is done when, as [qlist] reads it.
class Story {
  public:
    /// So many ms after the last.
    void say(double later, const std::string& receiver, const std::string& message) {
        text_ += std::to_string(later) + " " + receiver + " " + message + ";\n";
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

void misuse_messages(Story& story, const Description& table) {
    for (const std::string& message : messages_to(table)) {
        story.say(0.2, receiver(table), message);
    }
    story.say(1, "pd", "dsp 0");
    story.say(1, "pd", "dsp 1");
}

void misuse_creation(Story& story, const Description& table, int copies) {
    const std::string box = "obj 10 10 " + table.name;
    for (const char* arguments : kArguments) {
        story.say(0.1, "pd-abuse-many", box + " " + arguments);
    }
    story.say(0.1, "pd-abuse-many", box + values(table.creation_arguments, Edge::kLow));
    story.say(0.1, "pd-abuse-many", box + values(table.creation_arguments, Edge::kHigh));
    story.say(1, "pd-abuse-many", box + " " + repeated("7", kLength));
    story.say(1, "pd-abuse-many", "clear");
    story.say(1, "pd", "dsp 0");
    for (int i = 0; i < copies; ++i) {
        story.say(0, "pd-abuse-many", "obj 10 10 " + needed(table));
    }
    story.say(1, "pd", "dsp 1");
    story.say(5, "pd-abuse-many", "clear");
}

}  // namespace

std::string abuse_patch() {
    Canvas canvas;
    int number = 0;
    for (const char* size : kBlocks) {
        canvas.add("blocks-" + std::to_string(++number), blocks(size));
    }
    canvas.add("abuse-many", Canvas());
    const int start = canvas.add("obj 10 10 loadbang");
    const int read = canvas.add("msg 10 40 read abuse.txt \\, bang");
    const int list = canvas.add("obj 10 70 qlist");
    canvas.connect(start, read);
    canvas.connect(read, list);
    return "#N canvas 50 50 450 300 12;\n" + canvas.text();
}

std::string abuse_story(int copies) {
    Story story;
    story.say(1, "pd", "dsp 1");
    // Those that sound last, for what they were asked may take them long.
    for (const bool sounds : {false, true}) {
        for (const Description* table : pdx::all_classes()) {
            if (sounds == !table->signal_inlets.empty()) {
                misuse_messages(story, *table);
            }
        }
    }
    for (std::size_t i = 1; i <= std::size(kBlocks); ++i) {
        story.say(1, "pd-blocks-" + std::to_string(i), "clear");
    }
    for (const Description* table : pdx::all_classes()) {
        misuse_creation(story, *table, copies);
    }
    story.say(5, "pd", "quit");
    return story.text();
}

}  // namespace percussionist::objects
