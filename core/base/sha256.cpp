// SPDX-License-Identifier: MIT
#include "core/base/sha256.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

#include <openssl/evp.h>

#include "core/base/error.hpp"

namespace planum {

struct Sha256::State {
    EVP_MD_CTX* context = EVP_MD_CTX_new();
};

Sha256::Sha256() : state_(std::make_unique<State>()) {
    if (state_->context == nullptr || EVP_DigestInit_ex(state_->context, EVP_sha256(), nullptr) != 1) {
        throw Error(ErrorCode::Internal, "libcrypto gives no SHA-256");
    }
}

Sha256::~Sha256() { EVP_MD_CTX_free(state_->context); }

void Sha256::add(std::string_view bytes) { EVP_DigestUpdate(state_->context, bytes.data(), bytes.size()); }

std::string Sha256::finish() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    EVP_DigestFinal_ex(state_->context, digest.data(), &length);
    constexpr std::string_view digits = "0123456789abcdef";
    std::string hex;
    for (unsigned int i = 0; i < length; ++i) {
        hex.push_back(digits[digest.at(i) >> 4U]);
        hex.push_back(digits[digest.at(i) & 0xFU]);
    }
    return hex;
}

std::string sha256(std::string_view bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.finish();
}

std::string sha256_of_file(const std::filesystem::path& file, Progress& progress) {
    constexpr std::uintmax_t report_every = 64U << 20U;
    std::error_code ignored;
    // A pipe would be waited for without end.
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) {
        throw Error(ErrorCode::BadInput, file.string() + ": not an ordinary file");
    }
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error(ErrorCode::Io, file.string() + ": cannot be opened for reading");
    const std::uintmax_t size = std::filesystem::file_size(file, ignored);
    std::uintmax_t done = 0;
    Sha256 hash;
    std::vector<char> buffer(1U << 20U);
    while (in) {
        in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        hash.add({buffer.data(), static_cast<std::size_t>(in.gcount())});
        done += static_cast<std::uintmax_t>(in.gcount());
        if (done % report_every != 0) continue;
        progress.check();
        progress.fraction(static_cast<double>(done) / static_cast<double>(size));
    }
    if (in.bad()) throw Error(ErrorCode::Io, file.string() + ": reading failed half-way");
    return hash.finish();
}

} // namespace planum
