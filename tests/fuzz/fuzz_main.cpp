// SPDX-License-Identifier: GPL-3.0-or-later
// The program that libFuzzer drives: fretwork_fuzz --reader=NAME [libFuzzer's options] CORPUS..
#include "fuzz/readers.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

const fretwork::fuzz::Reader* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    constexpr std::string_view kOption = "--reader=";
    for (int i = 1; i < *count; ++i) {
        const std::string_view argument = (*arguments)[i];
        if (argument == "--list") {
            for (const auto& reader : fretwork::fuzz::readers())
                std::printf("%.*s\n", static_cast<int>(reader.name.size()), reader.name.data());
            std::exit(0);
        }
        if (argument.starts_with(kOption))
            chosen = fretwork::fuzz::find_reader(argument.substr(kOption.size()));
    }
    if (chosen == nullptr) {
        std::fputs("fretwork_fuzz: --reader=NAME is needed, with a name that --list prints\n", stderr);
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    (void)fretwork::fuzz::feed(*chosen, {reinterpret_cast<const char*>(data), size});
    return 0;
}
