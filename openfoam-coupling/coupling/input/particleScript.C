// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleScript.H"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{

using Words = std::vector<std::string>;

//- Files that include each other end here
constexpr int deepest = 10;


bool inName(const char letter)
{
    return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_';
}


//- A line without its comment: what follows a # outside quotes
std::string withoutComment(const std::string& line)
{
    char quote = 0;
    for (std::size_t k = 0; k < line.size(); ++k)
    {
        if (quote)
        {
            quote = line[k] == quote ? 0 : quote;
        }
        else if (line[k] == '"' || line[k] == '\'')
        {
            quote = line[k];
        }
        else if (line[k] == '#')
        {
            return line.substr(0, k);
        }
    }
    return line;
}


//- The words between blanks and quotes: what stands in quotes may be a command
Words wordsOf(std::string line)
{
    std::replace_if(line.begin(), line.end(), [](const char c) { return c == '"' || c == '\''; }, ' ');
    std::istringstream stream(line);
    Words words;
    for (std::string word; stream >> word; )
    {
        words.push_back(word);
    }
    return words;
}


//- A text with the values of variables in braces
std::string withValues(std::string text, const std::map<std::string, std::string>& variables)
{
    for (const auto& [name, value] : variables)
    {
        const std::string reference("${" + name + "}");
        const std::size_t at = text.find(reference);
        if (at != std::string::npos)
        {
            text.replace(at, reference.size(), value);
        }
    }
    return text;
}


//- The number, if the whole text is one
std::optional<double> numberOf(const std::string& text)
{
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return text.size() && end == text.c_str() + text.size() ? std::optional<double>(value) : std::nullopt;
}


//- Whether the name stands at a place of the word as a whole one. A single letter may follow a $ without braces.
bool standsAt(const std::string& word, const std::size_t at, const std::string& name)
{
    const std::size_t end = at + name.size();
    const bool begins =
        at == 0 || !inName(word[at - 1]) || (at > 1 && word.compare(at - 2, 2, "v_") == 0);
    const bool byDollar = name.size() == 1 && at > 0 && word[at - 1] == '$';
    return byDollar || (begins && (end == word.size() || !inName(word[end])));
}

} // End anonymous namespace


Foam::particleScript::particleScript
(
    const std::string& folder,
    const std::string& file,
    const std::map<std::string, std::string>& variables
)
:
    variables_(variables)
{
    read(folder, file, 0);
}


void Foam::particleScript::read(const std::string& folder, const std::string& file, const int depth)
{
    std::ifstream stream(file.size() && file[0] == '/' ? file : folder + '/' + file);
    if (!stream || depth > deepest)
    {
        all_ = false;
        return;
    }
    std::string command;
    for (std::string line; std::getline(stream, line); )
    {
        command += withoutComment(line);
        const std::size_t last = command.find_last_not_of(" \t\r");
        if (last != std::string::npos && command[last] == '&')
        {
            command[last] = ' ';
            continue;
        }
        const Words words(wordsOf(command));
        command.clear();
        if (words.empty())
        {
            continue;
        }
        commands_.push_back(words);
        const auto include = std::find(words.begin(), words.end(), "include");
        if (include != words.end() && include + 1 != words.end())
        {
            read(folder, withValues(*(include + 1), variables_), depth + 1);
        }
        // What these do to the script is not in its text.
        for (const char* const other : {"jump", "python", "read_restart", "shell"})
        {
            all_ = all_ && std::find(words.begin(), words.end(), other) == words.end();
        }
    }
}


bool Foam::particleScript::has(const std::string& name) const
{
    for (const Words& words : commands_)
    {
        for (const std::string& word : words)
        {
            for (std::size_t at = word.find(name); at != std::string::npos; at = word.find(name, at + 1))
            {
                if (standsAt(word, at, name))
                {
                    return true;
                }
            }
        }
    }
    return false;
}


std::vector<std::string> Foam::particleScript::wordsBehind(const std::string& command) const
{
    Words found;
    for (const Words& words : commands_)
    {
        for (std::size_t k = 1; k < words.size(); ++k)
        {
            if (words[k - 1] == command)
            {
                found.push_back(words[k]);
            }
        }
    }
    return found;
}


std::optional<double> Foam::particleScript::number(const std::string& command) const
{
    const Words found(wordsBehind(command));
    if (found.size() != 1 || !all_)
    {
        return {};
    }
    return numberOf(withValues(found[0], variables_));
}


std::vector<std::string> Foam::particleScript::argumentsOf(const std::string& command, const std::string& first) const
{
    Words arguments;
    for (const Words& words : commands_)
    {
        for (std::size_t k = 0; k + 1 < words.size(); ++k)
        {
            if (words[k] != command || !(first.empty() || words[k + 1] == first))
            {
                continue;
            }
            if (arguments.size())
            {
                return {};
            }
            for (std::size_t n = k + 1; n < words.size(); ++n)
            {
                arguments.push_back(withValues(words[n], variables_));
            }
        }
    }
    return arguments;
}


std::optional<cohesion::coupling::DemEngine::SimulationBox> Foam::particleScript::box() const
{
    // With these commands the text does not determine order, length unit of the region, or final box.
    for (const char* const other : {"jump", "python", "shell", "lattice", "change_box", "read_data", "displace_box"})
    {
        if (has(other))
        {
            return {};
        }
    }
    const Words create(argumentsOf("create_box"));
    const Words region(create.size() > 1 ? argumentsOf("region", create[1]) : Words());
    Words ends(argumentsOf("boundary"));
    if (ends.empty() && !has("boundary"))
    {
        ends = {"p", "p", "p"};
    }
    if (region.size() < 8 || region[1] != "block" || ends.size() < 3)
    {
        return {};
    }
    cohesion::coupling::DemEngine::SimulationBox box;
    for (int d = 0; d < 3; ++d)
    {
        const auto low = numberOf(region[2 + 2*d]);
        const auto high = numberOf(region[3 + 2*d]);
        if (!low || !high)
        {
            return {};
        }
        box.low[d] = *low;
        box.high[d] = *high;
        box.periodic[d] = ends[d] == "p" || ends[d] == "pp";
        box.fixed[d] = ends[d] == "f" || ends[d] == "ff";
        if (!box.periodic[d] && !box.fixed[d])
        {
            return {};
        }
    }
    return box;
}


std::vector<std::string> Foam::particleScript::variables() const
{
    Words names;
    const auto add = [&](const std::string& word, const std::size_t start)
    {
        std::size_t end = start;
        while (end < word.size() && inName(word[end]))
        {
            ++end;
        }
        const std::string name(word.substr(start, end - start));
        if (name.size() && std::find(names.begin(), names.end(), name) == names.end())
        {
            names.push_back(name);
        }
    };
    for (const Words& words : commands_)
    {
        if (words.size() > 1 && (words[0] == "variable" || words[0] == "next"))
        {
            add(words[1], 0);
        }
        for (const std::string& word : words)
        {
            for (std::size_t at = word.find("${"); at != std::string::npos; at = word.find("${", at + 2))
            {
                add(word, at + 2);
            }
            for (std::size_t at = word.find("v_"); at != std::string::npos; at = word.find("v_", at + 2))
            {
                add(word, at + 2);
            }
        }
    }
    return names;
}
