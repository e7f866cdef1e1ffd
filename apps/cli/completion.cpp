#include "completion.hpp"

#include <cstdio>

namespace weft::cli {
namespace {

constexpr const char* kBash = R"(_weft() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}
  if [ "$COMP_CWORD" = 1 ]; then
    COMPREPLY=($(compgen -W "run check adapters schema bench completion --help --version" -- "$word")); return
  fi
  case "$previous" in
    --out) COMPREPLY=($(compgen -d -- "$word")); return ;;
    --solver) COMPREPLY=($(compgen -W "mass_spring multigrid auto" -- "$word")); return ;;
    --json) [ "$command" = bench ] && { COMPREPLY=($(compgen -f -- "$word")); return; } ;;
    --set|--frames|--adapter) return ;;
  esac
  case "$command" in
    run) COMPREPLY=($(compgen -W "--set --solver --frames --out --adapter --json --help" -f -- "$word")) ;;
    check) COMPREPLY=($(compgen -W "--set --solver --help" -f -- "$word")) ;;
    bench) COMPREPLY=($(compgen -W "hanging pull --quick --json --adapter --unchecked --help" -- "$word")) ;;
    completion) COMPREPLY=($(compgen -W "bash zsh fish" -- "$word")) ;;
  esac
}
complete -o filenames -F _weft weft
)";

constexpr const char* kFish = R"(complete -c weft -f
complete -c weft -n __fish_use_subcommand -a "run check adapters schema bench completion"
complete -c weft -n "__fish_seen_subcommand_from run check" -F -l set -x -d "KEY=JSON"
complete -c weft -n "__fish_seen_subcommand_from run check" -l solver -x -a 'mass_spring multigrid auto'
complete -c weft -n "__fish_seen_subcommand_from run" -l frames -x
complete -c weft -n "__fish_seen_subcommand_from run" -l out -r
complete -c weft -n "__fish_seen_subcommand_from run bench" -l adapter -x
complete -c weft -n "__fish_seen_subcommand_from run bench" -l json
complete -c weft -n "__fish_seen_subcommand_from bench" -a "hanging pull"
complete -c weft -n "__fish_seen_subcommand_from bench" -l quick
complete -c weft -n "__fish_seen_subcommand_from bench" -l unchecked
complete -c weft -n "__fish_seen_subcommand_from completion" -a "bash zsh fish"
)";

}  // namespace

int print_completion(const std::string& shell) {
  if (shell == "zsh") std::fputs("autoload -U +X bashcompinit && bashcompinit\n", stdout);
  std::fputs(shell == "fish" ? kFish : kBash, stdout);
  return 0;
}

}  // namespace weft::cli
