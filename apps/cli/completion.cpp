#include "completion.hpp"

#include <cstdio>
#include <string>
#include <string_view>

#include "bench/methods.hpp"
#include "export/exporter.hpp"
#include "scene/names.hpp"
#include "scene_source.hpp"
#include "validate.hpp"

namespace weft::cli {
namespace {

constexpr const char* kBash = R"(_weft() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}
  if [ "$COMP_CWORD" = 1 ]; then
    COMPREPLY=($(compgen -W "run view check scenes fabrics validate adapters schema bench export \
      completion --help --version" -- "$word")); return
  fi
  case "$previous" in
    --out|-o)
      if [ "$command" = export ]; then COMPREPLY=($(compgen -f -- "$word")); return; fi
      COMPREPLY=($(compgen -d -- "$word")); return ;;
    --solver) COMPREPLY=($(compgen -W "@SOLVERS@" -- "$word")); return ;;
    --json)
      if [ "$command" = bench ] && [ "${COMP_WORDS[2]}" != compare ]; then
        COMPREPLY=($(compgen -f -- "$word")); return
      fi ;;
    --view) COMPREPLY=($(compgen -W "@VIEWS@" -- "$word")); return ;;
    --resume|--picture) COMPREPLY=($(compgen -f -- "$word")); return ;;
    --format) COMPREPLY=($(compgen -W "@FORMATS@" -- "$word")); return ;;
    --mesh-format) COMPREPLY=($(compgen -W "obj ply" -- "$word")); return ;;
    --set|--nodes|--size|--frames|-n|--meshes-every|--checkpoint-every|--adapter|\
      --sides|--memory|--seconds|--first|--last|--every) return ;;
    --objects) COMPREPLY=($(compgen -W "sphere armadillo dragon" -- "$word")); return ;;
    --only)
      if [ "$command" = validate ]; then COMPREPLY=($(compgen -W "@LAWS@" -- "$word")); return; fi
      case "${COMP_WORDS[2]}" in
        pull) COMPREPLY=($(compgen -W "none bvh proximity proximity_self paper" -- "$word")) ;;
        multigrid) COMPREPLY=($(compgen -W "multigrid multigrid4 multigrid16 explicit null drape" -- "$word")) ;;
        methods) COMPREPLY=($(compgen -W "@METHODS@" -- "$word")) ;;
        *) COMPREPLY=($(compgen -W "grid mesh springs blocks" -- "$word")) ;;
      esac; return ;;
  esac
  case "$command" in
    run) local options="--set --solver --nodes --size --view --frames --out --no-pictures --no-measures --meshes-every"
      options+=" --mesh-format --checkpoint-every --resume --adapter --quiet --json --help"
      COMPREPLY=($(compgen -W "$options @SCENES@" -f -- "$word")) ;;
    view) local options="--set --solver --nodes --size --view --frames --out --paused --record --picture --adapter"
      COMPREPLY=($(compgen -W "$options --help @SCENES@" -f -- "$word")) ;;
    check) COMPREPLY=($(compgen -W "--set --solver --nodes --help @SCENES@" -f -- "$word")) ;;
    bench) local measure="--json --adapter --unchecked --help"
      case "${COMP_WORDS[2]}" in
        hanging) COMPREPLY=($(compgen -W "$measure --quick --sides --only" -- "$word")) ;;
        pull) COMPREPLY=($(compgen -W "$measure --quick --sides --only --objects" -- "$word")) ;;
        multigrid|methods) COMPREPLY=($(compgen -W "$measure --quick --sides --only" -- "$word")) ;;
        scene) COMPREPLY=($(compgen -W "$measure --set --solver --nodes --frames @SCENES@" -f -- "$word")) ;;
        contact|copy) COMPREPLY=($(compgen -W "$measure --quick" -- "$word")) ;;
        largest) COMPREPLY=($(compgen -W "$measure --only --memory --seconds" -- "$word")) ;;
        compare) COMPREPLY=($(compgen -W "--json --fail --help" -f -- "$word")) ;;
        *) local experiments="hanging pull contact multigrid methods scene copy largest compare"
          COMPREPLY=($(compgen -W "$experiments --help" -- "$word")) ;;
      esac ;;
    validate) COMPREPLY=($(compgen -W "--solver --only --adapter --json --help" -- "$word")) ;;
    scenes|fabrics) COMPREPLY=($(compgen -W "--json --help" -- "$word")) ;;
    export) COMPREPLY=($(compgen -W "--format --out --first --last --every --quiet --help" -d -- "$word")) ;;
    completion) COMPREPLY=($(compgen -W "bash zsh fish" -- "$word")) ;;
  esac
}
complete -o filenames -F _weft weft
)";

constexpr const char* kFish = R"(complete -c weft -f
complete -c weft -n __fish_use_subcommand \
  -a "run view check scenes fabrics validate adapters schema bench export completion"
set -l of_scenes "__fish_seen_subcommand_from run view check scene"
complete -c weft -n $of_scenes -F -l set -x -d "KEY=JSON"
complete -c weft -n "__fish_seen_subcommand_from run view check scene validate" -l solver -x -a '@SOLVERS@'
complete -c weft -n $of_scenes -F -a "@SCENES@"
complete -c weft -n $of_scenes -l nodes -x -d "N or NxM"
complete -c weft -n "__fish_seen_subcommand_from run view" -l size -x -d "WxH"
complete -c weft -n "__fish_seen_subcommand_from run view" -l view -x -a "@VIEWS@"
complete -c weft -n "__fish_seen_subcommand_from run view scene" -s n -l frames -x
complete -c weft -n "__fish_seen_subcommand_from run view" -s o -l out -r
complete -c weft -n "__fish_seen_subcommand_from view" -l paused
complete -c weft -n "__fish_seen_subcommand_from view" -l record
complete -c weft -n "__fish_seen_subcommand_from view" -l picture -r -F
complete -c weft -n "__fish_seen_subcommand_from run" -l no-pictures
complete -c weft -n "__fish_seen_subcommand_from run" -l no-measures
complete -c weft -n "__fish_seen_subcommand_from run" -l meshes-every -x
complete -c weft -n "__fish_seen_subcommand_from run" -l mesh-format -x -a "obj ply"
complete -c weft -n "__fish_seen_subcommand_from run" -l checkpoint-every -x
complete -c weft -n "__fish_seen_subcommand_from run" -l resume -r -F
complete -c weft -n "__fish_seen_subcommand_from run" -s q -l quiet
complete -c weft -n "__fish_seen_subcommand_from run view bench validate" -l adapter -x
complete -c weft -n "__fish_seen_subcommand_from run bench" -l json
complete -c weft -n "__fish_seen_subcommand_from scenes fabrics validate" -l json
complete -c weft -n "__fish_seen_subcommand_from validate" -l only -x -a "@LAWS@"
set -l experiments hanging pull contact multigrid methods scene copy largest compare
complete -c weft -n "__fish_seen_subcommand_from bench; and not __fish_seen_subcommand_from $experiments" \
  -a "$experiments"
complete -c weft -l quick \
  -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from hanging pull contact multigrid methods copy"
complete -c weft -l sides -x \
  -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from hanging pull multigrid methods"
complete -c weft -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from hanging largest" \
  -l only -x -a "grid mesh springs blocks"
complete -c weft -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from pull" \
  -l only -x -a "none bvh proximity proximity_self paper"
complete -c weft -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from multigrid" \
  -l only -x -a "multigrid multigrid4 multigrid16 explicit null drape"
complete -c weft -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from methods" \
  -l only -x -a "@METHODS@"
complete -c weft -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from pull" \
  -l objects -x -a "sphere armadillo dragon"
complete -c weft -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from largest" -l memory -x
complete -c weft -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from largest" -l seconds -x
complete -c weft -n "__fish_seen_subcommand_from bench; and __fish_seen_subcommand_from compare" -F -l fail
complete -c weft -n "__fish_seen_subcommand_from bench; and not __fish_seen_subcommand_from compare" -l unchecked
complete -c weft -n "__fish_seen_subcommand_from export" -F
complete -c weft -n "__fish_seen_subcommand_from export" -l format -x -a "@FORMATS@"
complete -c weft -n "__fish_seen_subcommand_from export" -s o -l out -r -F
complete -c weft -n "__fish_seen_subcommand_from export" -l first -x
complete -c weft -n "__fish_seen_subcommand_from export" -l last -x
complete -c weft -n "__fish_seen_subcommand_from export" -l every -x
complete -c weft -n "__fish_seen_subcommand_from export" -s q -l quiet
complete -c weft -n "__fish_seen_subcommand_from completion" -a "bash zsh fish"
)";

/// The script with words where it has a mark for them.
template <class Words>
std::string with_words(std::string script, std::string_view mark, const Words& all) {
  std::string words;
  for (const auto& word : all) words += (words.empty() ? "" : " ") + std::string(word);
  for (std::size_t at = script.find(mark); at != std::string::npos; at = script.find(mark, at))
    script.replace(at, mark.size(), words);
  return script;
}

}  // namespace

int print_completion(const std::string& shell) {
  if (shell == "zsh") std::fputs("autoload -U +X bashcompinit && bashcompinit\n", stdout);
  std::string script = with_words(shell == "fish" ? kFish : kBash, "@SOLVERS@", scene::kSolverKindNames);
  script = with_words(std::move(script), "@METHODS@", bench::method_names());
  script = with_words(std::move(script), "@VIEWS@", scene::kViewNames);
  script = with_words(std::move(script), "@FORMATS@", export_formats());
  script = with_words(std::move(script), "@SCENES@", shipped_scenes());
  std::fputs(with_words(std::move(script), "@LAWS@", law_names()).c_str(), stdout);
  return 0;
}

}  // namespace weft::cli
