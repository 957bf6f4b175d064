using System.CommandLine;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Arguments;

/// <summary>--classes: a list of object classes. Several commands share it.</summary>
internal static class ClassList
{
    private static readonly string Names = string.Join(", ", JsonNames.All<ObjectClass>());

    /// <summary>Creates the option.</summary>
    /// <param name="purpose">The verb of the description, such as "Label".</param>
    public static Option<string?> Option(string purpose) =>
        new("--classes") { Description = $"{purpose} only these classes, separated by commas: {Names}", HelpName = "A,B" };

    /// <summary>Parses a list; null if the option is not given.</summary>
    /// <exception cref="UsageException">A name is not that of a class.</exception>
    public static IReadOnlyList<ObjectClass>? Parse(string? text) =>
        text is null ? null : [.. text.Split(',').Select(name => ParseOne(name.Trim()))];

    private static ObjectClass ParseOne(string name) =>
        ValueParsers.ParseChoice<ObjectClass>(name)
        ?? throw new UsageException($"--classes takes a comma-separated list of {Names}, not '{name}'.");
}
