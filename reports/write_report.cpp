#include "reports/write_report.hpp"
namespace phytobench { ReportSummary write_report(const ReportRequest&) { return {}; } }
