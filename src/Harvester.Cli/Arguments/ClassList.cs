using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Arguments;

/// <summary>A list of classes on the command line, the same wherever a command has it.</summary>
internal static class ClassList
{
    private static readonly string Names = string.Join(", ", JsonNames.All<ObjectClass>());

    /// <summary>The option.</summary>
    /// <param name="purpose">What happens to these classes only, as in "Label".</param>
    public static Option<string?> Option(string purpose) => new("--classes")
    {
        Description = $"{purpose} only these classes, separated by commas: {Names}",
        HelpName = "A,B",
    };

    /// <summary>The classes that a text names; null for none given.</summary>
    /// <exception cref="UsageException">A name is not a class's.</exception>
    public static IReadOnlyList<ObjectClass>? Parse(string? text) =>
        text is null ? null : [.. text.Split(',').Select(name => ParseOne(name.Trim()))];

    private static ObjectClass ParseOne(string name) =>
        JsonNames.TryRead(name, out ObjectClass kind) ? kind
            : throw new UsageException($"--classes takes a comma-separated list of {Names}, not '{name}'.");
}
