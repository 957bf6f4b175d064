using System.CommandLine;
using System.CommandLine.Parsing;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Cli.Terminals;

/// <summary>Refuses a command line whose output file is one of its input files.</summary>
internal static class OutputOverInput
{
    private const string Output = "--out";

    private static readonly StringComparison PathComparison = OperatingSystem.IsLinux()
        ? StringComparison.Ordinal
        : StringComparison.OrdinalIgnoreCase;

    /// <summary>Checks the files that a command line names. Inputs within a folder are checked by the commands.</summary>
    /// <exception cref="UsageException">--out, with links resolved, is a file that another option or argument names.</exception>
    /// <exception cref="IOException">A path leads through a cycle of links.</exception>
    public static void Check(ParseResult parsed)
    {
        OptionResult[] options = [.. parsed.CommandResult.Children.OfType<OptionResult>()];
        string? output = options.FirstOrDefault(option => option.Option.Name == Output)?.Tokens is [var word, ..] ? word.Value : null;
        if (output is null || !File.Exists(output))
        {
            return;
        }

        string target = InnerPath.Resolve(output);
        bool isInput = options
            .Where(option => option.Option.Name != Output)
            .SelectMany(option => option.Tokens)
            .Concat(parsed.CommandResult.Children.OfType<ArgumentResult>().SelectMany(argument => argument.Tokens))
            .Any(named => File.Exists(named.Value) && InnerPath.Resolve(named.Value).Equals(target, PathComparison));
        if (isInput)
        {
            throw new UsageException($"{Output} '{output}' would replace an input of the command. Name another file.");
        }
    }
}
