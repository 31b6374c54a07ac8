#include "built_in.hpp"

#include "base/errors.hpp"
#include "config_directories.hpp"

#include <filesystem>
#include <vector>

namespace brdfplot::cli {

std::string built_in_config(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<fs::path> folders;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  if (!error) folders.push_back((executable.parent_path() / config_directory_from_executable).lexically_normal());
  folders.insert(folders.end(), config_directories.begin(), config_directories.end());
  for (const auto& folder : folders)
    if (fs::exists(folder / name, error)) return (folder / name).string();
  throw FileError((folders.back() / name).string(), "cannot read: the built-in configs are not installed");
}

} // namespace brdfplot::cli
