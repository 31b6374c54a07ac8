/// \file
/// Numbers that are computed piece by piece, kept in a file for the run after one that did not end.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace brdfplot {

using Numbers = std::vector<double>;

/// The pieces of one piece of work: what tells a piece, and what came of it. The file is appended to, each record with
/// its hash: of a run that was killed all but the last record is whole, and what is not whole is cut off. What cannot
/// be read or written, and a file that another run holds, is as if there were none: it takes as long as it took.
class KeptPieces {
public:
  KeptPieces() = default;
  /// Those of `key`, a text that defines all numbers, in a folder that is made with the first piece. Empty folder:
  /// nothing is kept.
  KeptPieces(const std::string& folder, const std::string& key);
  ~KeptPieces();
  KeptPieces(const KeptPieces&) = delete;
  KeptPieces& operator=(const KeptPieces&) = delete;
  KeptPieces(KeptPieces&& other) noexcept { swap(other); }
  KeptPieces& operator=(KeptPieces&& other) noexcept {
    swap(other);
    return *this;
  }

  /// Whether there are pieces that are kept.
  explicit operator bool() const { return fd_ >= 0; }
  const Numbers* find(const Numbers& piece) const;
  void add(const Numbers& piece, const Numbers& result);
  /// The work is done: there is nothing to keep.
  void remove();

  static std::string path(const std::string& folder, const std::string& key);

private:
  void swap(KeptPieces& other) noexcept;
  void open_file();
  void give_up();

  std::string path_; ///< empty: nothing is kept
  std::string head_; ///< of the file
  int fd_ = -1;
  std::map<Numbers, Numbers> found_; ///< of the runs before
};

} // namespace brdfplot
