namespace Harvester.Cli.Terminals;

/// <summary>Options of a command that its help lists under one heading.</summary>
/// <param name="Heading">The heading, without a colon.</param>
/// <param name="Options">The names of the options, in the order of the help.</param>
internal sealed record OptionGroup(string Heading, IReadOnlyList<string> Options);
