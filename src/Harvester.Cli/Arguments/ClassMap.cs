using System.CommandLine;
using Harvester.Exports;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Arguments;

/// <summary>--map: names for classes, e.g. bus=Car,truck=Car.</summary>
internal static class ClassMap
{
    /// <summary>Creates the option.</summary>
    public static Option<string?> Option() =>
        new("--map")
        {
            Description = "Names of classes in the dataset, e.g. bus=Car,truck=Car; classes with the same name are merged",
            HelpName = "CLASS=NAME,...",
        };

    /// <summary>Parses the option; empty if it is not given.</summary>
    /// <exception cref="UsageException">The text is not such a list, or the format does not allow a name.</exception>
    public static IReadOnlyDictionary<ObjectClass, string> Parse(string? text, DatasetFormat format)
    {
        var names = new Dictionary<ObjectClass, string>();
        foreach (string entry in text?.Split(',') ?? [])
        {
            string[] words = [.. entry.Split('=').Select(word => word.Trim())];
            if (words.Length != 2 || ValueParsers.ParseChoice<ObjectClass>(words[0]) is not { } kind || !IsName(words[1]))
            {
                string classes = string.Join(", ", JsonNames.All<ObjectClass>());
                throw new UsageException(
                    $"--map takes classes with names, e.g. bus=Car,truck=Car, not '{entry}'. "
                        + $"The classes are {classes}. Names consist of letters, digits, spaces, - and _."
                );
            }

            if (format.Names is { } known && !known.Contains(words[1]))
            {
                throw new UsageException($"--map: {format.Name} has no class '{words[1]}'. Its classes are {string.Join(", ", known)}.");
            }

            if (!names.TryAdd(kind, words[1]))
            {
                throw new UsageException($"--map names {words[0]} twice.");
            }
        }

        return names;
    }

    private static bool IsName(string name) => name.Length > 0 && name.All(c => char.IsAsciiLetterOrDigit(c) || c is ' ' or '-' or '_');
}
