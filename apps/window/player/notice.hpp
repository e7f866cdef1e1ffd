#pragma once

#include <string>

namespace weft::window {

/// A plain one goes by itself. An error or a warning stays until it is closed or another scene is opened.
enum class Tone { Plain, Warning, Error };

/// The sentence that is shown over the cloth.
class Notice {
 public:
  /// A warning does not take the place of an error.
  void say(const std::string& sentence, Tone tone) {
    if (tone == Tone::Warning && standing_.tone == Tone::Error && !standing_.sentence.empty()) return;
    (tone == Tone::Plain ? passing_ : standing_) = {sentence, tone};
    if (tone == Tone::Plain)
      age_ = 0;
    else
      passing_ = {};
  }
  /// So much time has passed [s].
  void wait(double seconds) {
    if (!passing_.sentence.empty() && (age_ += seconds) >= kPlainStays) passing_ = {};
  }
  void close() { (passing_.sentence.empty() ? standing_ : passing_) = {}; }
  void clear() { passing_ = standing_ = {}; }
  /// What made the cloth stop has been read, or is no longer so.
  void clear_error() {
    if (standing_.tone == Tone::Error) standing_ = {};
  }

  const std::string& sentence() const { return shown().sentence; }  // empty: none
  Tone tone() const { return shown().tone; }

 private:
  struct Said {
    std::string sentence;
    Tone tone = Tone::Plain;
  };
  static constexpr double kPlainStays = 5;  // [s]
  const Said& shown() const { return passing_.sentence.empty() ? standing_ : passing_; }

  Said standing_, passing_;
  double age_ = 0;  // of the passing one [s]
};

}  // namespace weft::window
