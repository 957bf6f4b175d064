using System.CommandLine;
using System.CommandLine.Parsing;

namespace Harvester.Cli.Terminals;

/// <summary>Suggests a command or option for a misspelt one.</summary>
internal static class Suggestion
{
    /// <summary>One mistake is allowed for this many letters of the word.</summary>
    private const int LettersPerMistake = 3;

    /// <summary>The most similar name among the subcommands and options of a command; null if none is similar.</summary>
    public static string? For(string word, CommandResult command)
    {
        string name = Bare(word.Split('=')[0]);
        int allowed = Math.Max(1, name.Length / LettersPerMistake);
        return NamesIn(command)
            .Select(known => (Name: known, Mistakes: IsPartOf(name, Bare(known)) ? 1 : Mistakes(name, Bare(known))))
            .Where(known => known.Mistakes <= allowed)
            .OrderBy(known => known.Mistakes)
            .ThenBy(known => known.Name.Length)
            .ThenBy(known => known.Name, StringComparer.Ordinal)
            .Select(known => known.Name)
            .FirstOrDefault();
    }

    /// <summary>A name without dashes and capitals, as it is compared.</summary>
    private static string Bare(string name) => name.TrimStart('-').ToLowerInvariant();

    /// <summary>Whether one of two names is the beginning of the other, as out is of output.</summary>
    private static bool IsPartOf(string name, string known) =>
        name.Length > 0
        && (
            known.StartsWith(name, StringComparison.Ordinal)
            || (known.Length >= LettersPerMistake && name.StartsWith(known, StringComparison.Ordinal))
        );

    /// <summary>
    /// The distance between two words: the smallest number of letters to insert, delete, replace or swap with their neighbour (optimal
    /// string alignment).
    /// </summary>
    internal static int Mistakes(string a, string b)
    {
        int[,] distance = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++)
        {
            for (int j = 0; j <= b.Length; j++)
            {
                distance[i, j] =
                    i == 0 ? j
                    : j == 0 ? i
                    : Math.Min(
                        Math.Min(distance[i - 1, j], distance[i, j - 1]) + 1,
                        distance[i - 1, j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)
                    );
                if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                {
                    distance[i, j] = Math.Min(distance[i, j], distance[i - 2, j - 2] + 1);
                }
            }
        }

        return distance[a.Length, b.Length];
    }

    private static IEnumerable<string> NamesIn(CommandResult command)
    {
        IEnumerable<Option> inherited = AncestorsOf(command)
            .SelectMany(ancestor => ancestor.Command.Options.Where(option => option.Recursive));
        return command
            .Command.Subcommands.Select(sub => sub.Name)
            .Concat(command.Command.Options.Concat(inherited).Where(option => !option.Hidden).Select(option => option.Name));
    }

    private static IEnumerable<CommandResult> AncestorsOf(CommandResult command)
    {
        for (SymbolResult? parent = command.Parent; parent is CommandResult ancestor; parent = ancestor.Parent)
        {
            yield return ancestor;
        }
    }
}
