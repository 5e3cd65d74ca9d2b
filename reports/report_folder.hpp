// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace phytobench {

/// The files of a report: name below its folder ("tables/claims.tex") -> content.
using ReportFiles = std::map<std::string, std::string>;

inline constexpr const char* checksums_name = "SHA256SUMS";

/// SHA256SUMS of the files, in the form that `sha256sum -c` reads in the report's folder.
std::string checksum_lines(const ReportFiles& files);

/// The digests that such a text holds, by file name. Lines of another form, and names that lead out
/// of the folder, are left out.
std::map<std::string, std::string> checksums_in(std::string_view text);

/// Makes the folder hold this report, SHA256SUMS with it. All files are written under temporary
/// names before the first is renamed. A file of an earlier report that this one does not have is
/// removed if the earlier SHA256SUMS names it and nobody changed it since; what else lies there
/// stays, and a file of that name which no report wrote is an InputError. Signals that end the
/// program wait until the report is whole. Throws EnvironmentError, too; what was there is
/// unchanged then.
void put_report(const std::filesystem::path& folder, ReportFiles files);

}  // namespace phytobench
