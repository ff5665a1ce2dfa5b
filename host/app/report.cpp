#include "host/app/report.h"

#include "host/base/output_file.h"

namespace shadertwin::app {

void write_report(const std::string& file, const nlohmann::json& report) {
  write_file(file, report.dump(2) + '\n');
}

}  // namespace shadertwin::app
