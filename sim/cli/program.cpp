// SPDX-License-Identifier: Apache-2.0
// The commands as one program, and what each failure is to the shell.
#include <cstdio>

#include "castray_commit.hpp"
#include "castray_records.hpp"
#include "command.hpp"
#include "driver.hpp"
#include "picture.hpp"
#include "scene/scene.hpp"
#include "scene/text.hpp"

namespace castray::cli {
namespace {

constexpr const char* kFooter =
    "Exit codes: 0 all is well, 1 something that must be equal is not, 2 bad input,\n"
    "3 the core ended with an error code, 4 the core hangs, is not there or is not of this build,\n"
    "5 the core broke a rule of its bus, 6 an output cannot be written, 7 internal error.";

int complain(ExitCode code, const char* what) {
  std::fprintf(stderr, "castray: %s\n", one_line(what).c_str());
  return code;
}

// What went to standard output has arrived, unless the command failed in any case.
int flushed(int code) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return code;
  return code == kOk ? complain(kBadOutput, "standard output cannot be written") : code;
}

int run(int argc, const char* const* argv, const sim::RunRtl& run_rtl, const sim::QueryRtl& query_rtl, const OpenBoard& open_board) {
  Context context{argc > 0 ? argv[0] : "castray", run_rtl, query_rtl, open_board};
  CLI::App app("castray: a ray tracer in hardware, simulated or on a board", "castray");
  const std::string version =
      std::to_string(VersionMajor) + "." + std::to_string(VersionMinor) + "." + std::to_string(VersionPatch);
  app.set_version_flag("--version", "castray " + version + " (" + kCommit + ")");
  app.footer(kFooter);
  app.require_subcommand(1);
  if (argc <= 1) throw InputError("a subcommand is required; castray --help lists them");
  add_render(app, context);
  add_ray(app, context);
  add_info(app, context);
  add_compare(app, context);
  add_compile(app, context);
  add_query(app, context);
  const auto named = [&](const CLI::App* command) { return command->get_name() == argv[1]; };
  if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(named).empty())
    throw InputError("'" + std::string(argv[1]) + "' is not a command; castray --help lists them");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app.exit(e);  // --help, --version
  } catch (const CLI::ParseError& e) {
    const auto given = app.get_subcommands();
    const std::string help = "; castray " + (given.empty() ? "" : given[0]->get_name() + " ") + "--help says what there is";
    return complain(kBadInput, (e.what() + help).c_str());
  }
  return flushed(context.code);
}

}  // namespace

int program(int argc, const char* const* argv, const sim::RunRtl& run_rtl, const sim::QueryRtl& query_rtl, const OpenBoard& open_board) {
  try {
    return run(argc, argv, run_rtl, query_rtl, open_board);
  } catch (const SceneError& e) {
    return complain(kBadInput, e.what());
  } catch (const InputError& e) {
    return complain(kBadInput, e.what());
  } catch (const std::invalid_argument& e) {
    return complain(kBadInput, e.what());
  } catch (const sim::PictureError& e) {
    return complain(kBadOutput, e.what());
  } catch (const sim::DeviceError& e) {
    return complain(kHang, e.what());
  } catch (const std::exception& e) {
    return complain(kInternal, e.what());
  }
}

}  // namespace castray::cli
