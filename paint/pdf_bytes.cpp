// SPDX-License-Identifier: MIT
#include "paint/pdf_bytes.hpp"

namespace planum::paint {

void set_creation_date(std::string& pdf, std::string_view created_at) {
    std::string digits;
    for (const char ch : created_at) {
        if (ch >= '0' && ch <= '9' && digits.size() < 14) digits += ch;
    }
    if (digits.size() < 14) digits = "19700101000000";
    constexpr std::string_view kKey = "/CreationDate (D:";
    for (std::size_t at = pdf.find(kKey); at != std::string::npos; at = pdf.find(kKey, at + 1)) {
        std::size_t i = at + kKey.size();
        for (std::size_t k = 0; k < digits.size() && i + k < pdf.size() && pdf[i + k] != ')'; ++k) {
            pdf[i + k] = digits[k];
        }
    }
}

} // namespace planum::paint
