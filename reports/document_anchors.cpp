// SPDX-License-Identifier: MIT
#include "reports/document_anchors.hpp"

namespace phytobench {

namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::string joined(std::string_view kind, std::string_view first, std::string_view second) {
  return std::string(kind) + "-" + slug(first) + "-" + slug(second);
}

}  // namespace

std::string slug(std::string_view text) {
  std::string slug;
  for (const char c : text) {
    if (is_plain(c))
      slug += c;
    else if (!slug.empty() && slug.back() != '-')
      slug += '-';
  }
  if (!slug.empty() && slug.back() == '-') slug.pop_back();
  return slug;
}

std::string claim_anchor(std::string_view claim_id) {
  return "claim-" + slug(claim_id);
}

std::string erratum_anchor(std::string_view paper, std::string_view id) {
  return joined("erratum", paper, id);
}

std::string assumption_anchor(std::string_view paper, std::string_view id) {
  return joined("assumption", paper, id);
}

std::string topic_anchor(std::string_view paper, std::string_view topic) {
  return joined("topic", paper, topic);
}

std::string experiment_anchor(std::string_view experiment) {
  return "experiment-" + slug(experiment);
}

std::string short_claim_id(std::string_view claim_id) {
  const std::size_t slash = claim_id.find('/');
  return std::string(slash == std::string_view::npos ? claim_id : claim_id.substr(slash + 1));
}

}  // namespace phytobench
