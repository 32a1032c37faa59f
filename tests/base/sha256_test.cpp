// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/sha256.hpp>

#include <gtest/gtest.h>

namespace fretwork::base {
namespace THIS_TEST {

/// The examples that FIPS 180-4 gives (and, for the empty text, RFC 6234).
TEST(Sha256, GivesTheStandardsExamples) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnHowTheBytesAreCut) {
    const std::string text(200, 'x');
    for (std::size_t cut = 0; cut <= text.size(); ++cut) {
        Sha256 hash;
        hash.update(std::string_view(text).substr(0, cut));
        EXPECT_EQ(hash.hexadecimal().size(), 64U);
        hash.update(std::string_view(text).substr(cut));
        ASSERT_EQ(hash.hexadecimal(), sha256(text)) << cut;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
