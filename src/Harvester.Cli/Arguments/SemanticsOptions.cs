using System.CommandLine;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Semantics;

namespace Harvester.Cli.Arguments;

/// <summary>The options for class maps.</summary>
internal sealed class SemanticsOptions
{
    private Option<string?> Source { get; } =
        new("--semantics")
        {
            Description = "Also write class maps, and masks: rays, from what rays report; exact, from what the simulation drew",
            HelpName = "SOURCE",
        };

    private Option<FileInfo?> Table { get; } =
        new("--materials")
        {
            Description = "With --semantics rays, the table of the classes of materials [default: the built-in table]",
            HelpName = "FILE",
        };

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command)
    {
        command.Add(Source);
        command.Add(Table);
    }

    /// <summary>Where classes come from; null for no class maps.</summary>
    /// <exception cref="UsageException">The value is no source.</exception>
    public SemanticsMethod? Method(ParseResult parsed) =>
        parsed.GetValue(Source)?.ToLowerInvariant() switch
        {
            null => null,
            "rays" => SemanticsMethod.Rays,
            "exact" => SemanticsMethod.Exact,
            var other => throw new UsageException($"--semantics takes rays or exact, not '{other}'."),
        };

    /// <summary>The classes of materials.</summary>
    /// <exception cref="DatasetFormatException">The table cannot be read or has an invalid row.</exception>
    public MaterialTable Materials(ParseResult parsed)
    {
        if (parsed.GetValue(Table) is not { } file)
        {
            return MaterialTable.BuiltIn;
        }

        try
        {
            using var reader = new StreamReader(InputFile.OpenRead(file.FullName));
            return MaterialTable.Read(reader);
        }
        catch (FormatException e)
        {
            throw new DatasetFormatException($"'{file}', {e.Message}", e);
        }
    }
}
