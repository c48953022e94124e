// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/help_formatter.h"

#include <cstddef>
#include <sstream>
#include <utility>

namespace handcraft::tools {
namespace {

constexpr std::size_t kFirstColumnWidth = 32;
constexpr std::size_t kDescriptionWidth = 64;

// Breaks lines between words; CLI11 indents what follows a line feed.
std::string Wrap(const std::string& text) {
  std::istringstream words(text);
  std::string wrapped;
  std::size_t line_width = 0;
  for (std::string word; words >> word;) {
    if (line_width > 0 && line_width + 1 + word.size() > kDescriptionWidth) {
      wrapped += '\n';
      line_width = 0;
    } else if (line_width > 0) {
      wrapped += ' ';
      ++line_width;
    }
    wrapped += word;
    line_width += word.size();
  }
  return wrapped;
}

}  // namespace

HelpFormatter::HelpFormatter() {
  column_width(kFirstColumnWidth);
  label("Positionals", "Arguments");
  label("SUBCOMMAND", "COMMAND");
}

// CLI11 puts two empty lines between groups.
std::string HelpFormatter::make_help(const CLI::App* app,
                                     std::string name,
                                     CLI::AppFormatMode mode) const {
  const std::string help = Formatter::make_help(app, std::move(name), mode);
  return CLI::detail::find_and_replace(help, "\n\n\n", "\n\n");
}

// CLI11 heads them by the name of their group, "Subcommands".
std::string HelpFormatter::make_subcommands(const CLI::App* app,
                                            CLI::AppFormatMode /*mode*/) const {
  std::string text;
  for (const CLI::App* command : app->get_subcommands({})) text += make_subcommand(command);
  return text.empty() ? "" : "\nCommands:\n" + text;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  std::ostringstream text;
  CLI::detail::format_help(
      text, command->get_name(), Wrap(command->get_description()), kFirstColumnWidth);
  return text.str();
}

// The names of validators, which CLI11 puts behind a colon, say nothing that the text does not.
std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size() == 0) return "";
  const bool takes_many = option->get_expected_max() == CLI::detail::expected_max_vector_size;
  std::string many = takes_many ? "..." : "";
  if (!option->nonpositional()) return many;  // the name of a positional says what it is
  const std::string type = option->get_type_name();
  return " " + get_label(type.substr(0, type.find(':'))) + many;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  const bool may_stand_alone = option->get_items_expected_min() == 0;  // the default is then said
  if (!option->get_default_str().empty() && !may_stand_alone)
    text += " [" + option->get_default_str() + "]";
  if (option->get_required() && option->nonpositional()) text += " (required)";
  return Wrap(text);
}

}  // namespace handcraft::tools
