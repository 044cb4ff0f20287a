#include "io/osc_packet.hpp"

#include <oscpack/osc/OscOutboundPacketStream.h>
#include <oscpack/osc/OscReceivedElements.h>

#include "io/osc_check.hpp"

namespace percussionist::io {

namespace {

constexpr std::size_t kLongestPacket = 65507;  // UDP's

void append_blob(const osc::ReceivedMessageArgument& argument, std::vector<OscValue>& values) {
    const void* data = nullptr;
    osc::osc_bundle_element_size_t size = 0;
    argument.AsBlobUnchecked(data, size);
    values.emplace_back(static_cast<double>(size));
    const auto* const bytes = static_cast<const std::uint8_t*>(data);
    for (osc::osc_bundle_element_size_t i = 0; i < size; ++i) {
        values.emplace_back(static_cast<double>(bytes[i]));
    }
}

void append_midi(std::uint32_t bytes, std::vector<OscValue>& values) {
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        values.emplace_back(static_cast<double>(bytes >> shift & 0xFFU));
    }
}

void append(const osc::ReceivedMessageArgument& argument, std::vector<OscValue>& values) {
    switch (argument.TypeTag()) {
        case osc::TRUE_TYPE_TAG:
            values.emplace_back(1.0);
            break;
        case osc::FALSE_TYPE_TAG:
            values.emplace_back(0.0);
            break;
        case osc::NIL_TYPE_TAG:
            values.emplace_back("nil");
            break;
        case osc::INFINITUM_TYPE_TAG:
            values.emplace_back("inf");
            break;
        case osc::INT32_TYPE_TAG:
            values.emplace_back(static_cast<double>(argument.AsInt32Unchecked()));
            break;
        case osc::FLOAT_TYPE_TAG:
            values.emplace_back(static_cast<double>(argument.AsFloatUnchecked()));
            break;
        case osc::CHAR_TYPE_TAG:
            values.emplace_back(std::string(1, argument.AsCharUnchecked()));
            break;
        case osc::RGBA_COLOR_TYPE_TAG:
            values.emplace_back(static_cast<double>(argument.AsRgbaColorUnchecked()));
            break;
        case osc::MIDI_MESSAGE_TYPE_TAG:
            append_midi(argument.AsMidiMessageUnchecked(), values);
            break;
        case osc::INT64_TYPE_TAG:
            values.emplace_back(static_cast<double>(argument.AsInt64Unchecked()));
            break;
        case osc::TIME_TAG_TYPE_TAG:
            values.emplace_back(static_cast<double>(argument.AsTimeTagUnchecked()) /
                                kTagsPerSecond);
            break;
        case osc::DOUBLE_TYPE_TAG:
            values.emplace_back(argument.AsDoubleUnchecked());
            break;
        case osc::STRING_TYPE_TAG:
            values.emplace_back(argument.AsStringUnchecked());
            break;
        case osc::SYMBOL_TYPE_TAG:
            values.emplace_back(argument.AsSymbolUnchecked());
            break;
        case osc::BLOB_TYPE_TAG:
            append_blob(argument, values);
            break;
        default:  // the brackets of arrays
            break;
    }
}

void append(const osc::ReceivedMessage& received, TimeTag tag, std::vector<OscBundle>& bundles) {
    if (bundles.empty() || bundles.back().tag != tag) {
        bundles.push_back({tag, {}});
    }
    OscMessage& message = bundles.back().messages.emplace_back();
    message.address = received.AddressPattern();
    if (received.TypeTags() == nullptr) {
        return;
    }
    for (auto i = received.ArgumentsBegin(); i != received.ArgumentsEnd(); ++i) {
        append(*i, message.arguments);
    }
}

void append(const osc::ReceivedBundle& received, std::vector<OscBundle>& bundles) {
    for (auto i = received.ElementsBegin(); i != received.ElementsEnd(); ++i) {
        if (i->IsBundle()) {
            append(osc::ReceivedBundle(*i), bundles);
        } else {
            append(osc::ReceivedMessage(*i), received.TimeTag(), bundles);
        }
    }
}

}  // namespace

OscPacket read_osc(std::span<const std::uint8_t> bytes) {
    check_osc(bytes);
    OscPacket packet;
    try {
        const osc::ReceivedPacket received(reinterpret_cast<const char*>(bytes.data()),
                                           bytes.size());
        if (received.IsBundle()) {
            const osc::ReceivedBundle bundle(received);
            packet.tag = bundle.TimeTag();
            append(bundle, packet.bundles);
        } else {
            append(osc::ReceivedMessage(received), kImmediately, packet.bundles);
        }
    } catch (const osc::Exception& e) {
        throw MalformedOsc(e.what());
    }
    return packet;
}

Bytes write_osc(const std::string& address, std::span<const OscValue> arguments, bool as_integers) {
    std::vector<char> buffer(kLongestPacket);
    osc::OutboundPacketStream stream(buffer.data(), buffer.size());
    try {
        stream << osc::BeginMessage(address.c_str());
        for (const auto& argument : arguments) {
            if (const auto* const word = std::get_if<std::string>(&argument)) {
                stream << word->c_str();
            } else if (as_integers) {
                stream << static_cast<osc::int32>(std::get<double>(argument));
            } else {
                stream << static_cast<float>(std::get<double>(argument));
            }
        }
        stream << osc::EndMessage;
    } catch (const osc::Exception&) {
        throw std::invalid_argument("expected what fits one packet of 65507 bytes");
    }
    return {buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(stream.Size())};
}

}  // namespace percussionist::io
