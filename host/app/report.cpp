#include "host/app/report.h"

#include <fstream>

#include "host/base/error.h"
#include "host/base/output_file.h"

namespace shadertwin::app {

void write_report(const std::string& file, const nlohmann::json& report) {
  OutputFile output(file);
  std::ofstream stream(output.path());
  stream << report.dump(2) << '\n';
  stream.close();
  if (!stream) throw Error(ExitStatus::file, file + ": can't be written");
  output.commit();
}

}  // namespace shadertwin::app
