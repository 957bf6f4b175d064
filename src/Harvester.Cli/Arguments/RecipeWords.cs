using System.CommandLine;
using System.CommandLine.Parsing;
using Harvester.Datasets.Recipes;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Cli.Arguments;

/// <summary>
/// The words of the commands of a recipe. A recipe may come from a stranger: its commands may read only the inputs that the user names and
/// the folders of earlier steps, and write only a folder of their own.
/// </summary>
internal static class RecipeWords
{
    private const char Reference = '@';
    private const string Output = "--out";
    private const string Resume = ResumeOption.Name;

    private static readonly string[][] Allowed =
    [
        ["harvest"],
        ["counterfactual"],
        ["plan", "run"],
        ["scenario", "run"],
        ["relabel"],
        ["merge"],
        ["export"],
        ["pairs"],
    ];

    // Whoever rebuilds decides about these.
    private static readonly string[] Refused = [Output, Resume, "--overwrite", "--jobs", MinFreeOption.Name];

    // The type of an option's value, or else its form in the help, says whether it is a path.
    private static readonly string[] PathForms = ["FILE", "DIR", "FILE|DIR", "PATH"];

    /// <summary>Checks the command of a step.</summary>
    /// <param name="step">The step.</param>
    /// <param name="known">The inputs and the folders of the steps before it.</param>
    /// <param name="parse">Parses a command line.</param>
    /// <exception cref="DatasetFormatException">It is no command of a recipe.</exception>
    public static void Check(RecipeStep step, IReadOnlyCollection<string> known, Func<string[], ParseResult> parse)
    {
        string[] words = [.. step.Command];
        if (!Array.Exists(Allowed, allowed => words.AsSpan().StartsWith(allowed)))
        {
            string names = string.Join(", ", Allowed.Select(allowed => string.Join(' ', allowed)));
            throw new DatasetFormatException($"step '{step.Folder}': '{words[0]}' cannot be a step; {names} can.");
        }

        if (words.Select(word => word.Split('=')[0]).FirstOrDefault(Refused.Contains) is { } refused)
        {
            throw new DatasetFormatException($"step '{step.Folder}': {refused} is chosen when the dataset is rebuilt. Remove it.");
        }

        // A word that is no path must not begin with the sign either: the parser would read the file of that name for more words.
        CheckReferences(step, known, words.Select(ValueOf).Where(value => value.StartsWith(Reference)));
        try
        {
            CheckReferences(step, known, PathsIn(parse([.. words, Output, step.Folder])));
        }
        catch (UsageException e)
        {
            throw new DatasetFormatException($"step '{step.Folder}': {e.Message}", e);
        }
    }

    /// <summary>The command line of a step.</summary>
    /// <param name="step">The step, checked.</param>
    /// <param name="paths">The path of each input and each folder, by name.</param>
    /// <param name="folder">The folder to write.</param>
    /// <param name="parse">Parses a command line.</param>
    public static string[] LineOf(
        RecipeStep step,
        IReadOnlyDictionary<string, string> paths,
        string folder,
        Func<string[], ParseResult> parse
    )
    {
        string[] line = [.. step.Command.Select(word => Resolved(word, paths)), Output, folder];
        bool resumes = parse(line).CommandResult.Command.Options.Any(option => option.Name == Resume);
        return resumes ? [.. line, Resume] : line;
    }

    private static void CheckReferences(RecipeStep step, IReadOnlyCollection<string> known, IEnumerable<string> references)
    {
        foreach (string reference in references)
        {
            if (!reference.StartsWith(Reference) || !known.Contains(reference[1..]))
            {
                throw new DatasetFormatException(
                    $"step '{step.Folder}': '{reference}' must be @NAME, the name of an input or of the folder of an earlier step."
                );
            }
        }
    }

    private static string Resolved(string word, IReadOnlyDictionary<string, string> paths)
    {
        string value = ValueOf(word);
        return value.StartsWith(Reference) ? word[..^value.Length] + paths[value[1..]] : word;
    }

    /// <summary>What of a word is a value: all of it, or what follows the sign of equality of an option.</summary>
    private static string ValueOf(string word) => word.StartsWith('-') ? word[(word.IndexOf('=', StringComparison.Ordinal) + 1)..] : word;

    private static IEnumerable<string> PathsIn(ParseResult parsed)
    {
        IEnumerable<Token> ofOptions = parsed
            .CommandResult.Children.OfType<OptionResult>()
            .Where(result => result.Option.Name != Output && IsPath(result.Option))
            .SelectMany(result => result.Tokens);
        IEnumerable<Token> ofArguments = parsed.CommandResult.Children.OfType<ArgumentResult>().SelectMany(result => result.Tokens);
        return ofOptions.Concat(ofArguments).Select(token => token.Value);
    }

    private static bool IsPath(Option option) =>
        typeof(FileSystemInfo).IsAssignableFrom(option.ValueType.GetElementType() ?? option.ValueType)
        || PathForms.Contains(option.HelpName);
}
